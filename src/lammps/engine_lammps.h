/* LAMMPS as the wall asks it: see asperity::Engine. It is no base of the fix: in LAMMPS since 2022
 * a fix's destructor may throw, which forbids a second virtual one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <string>
#include <vector>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "group.h"
#include "memory.h"
#include "modify.h"
#include "output.h"
#include "update.h"
#include "dem/wall_fix.h"

namespace LAMMPS_NS {

class EngineOfLammps : public asperity::EngineOf<LAMMPS, Fix, std::string> {
public:
  using EngineOf::EngineOf;

  std::string known_units() const override;
  const double *numbers(const std::string &name) const override;
  void diameters(double &least, double &most) const override;
  std::vector<Kind> kinds() const override;

private:
  int group() const;
  double radius_to_come(int type) const;
};

/* A check that the running LAMMPS is the one whose headers this was compiled with: a message about
 * the first difference, or "". */
std::string check_library(LAMMPS *lammps);

} // namespace LAMMPS_NS
