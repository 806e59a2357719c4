/* LAMMPS as the wall asks it: see asperity::Engine. It is an object of its own, and no base of the
 * fix: in LAMMPS since 2022 a fix's destructor may throw, which forbids a second virtual one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_ENGINE_LAMMPS_H
#define LMP_ENGINE_LAMMPS_H

#include <string>
#include <vector>

#include "fix.h"
#include "dem/engine.h"

namespace LAMMPS_NS {

class EngineOfLammps : public asperity::Engine {
public:
  EngineOfLammps(LAMMPS *lammps, const Fix *fix) : lammps_(lammps), fix_(fix) {}

  MPI_Comm world() const override;
  std::string id() const override;
  std::string units() const override;
  std::string known_units() const override;
  int types() const override;
  int dimension() const override;
  double time() const override;
  void warn(const std::string &what) const override;
  void print(const std::string &what) const override;
  bool constants(const char *name, bool pairs, std::vector<double> &values) const override;
  std::string how_to_state(const char *name, bool pairs, const std::string &values) const override;
  void diameters(double &least, double &most) const override;
  std::vector<Kind> kinds() const override;

  /* The particles of this rank, for a step. */
  asperity::Spheres spheres() const;
  asperity::Box box() const;

private:
  double radius_to_come(int type) const;

  LAMMPS *lammps_;
  const Fix *fix_;
};

} // namespace LAMMPS_NS

#endif
