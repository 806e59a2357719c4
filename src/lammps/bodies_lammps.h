/* The bodies of LAMMPS's fixes rigid/small and rigid/nve/small, for the walls: read and written
 * where the fix keeps them. A body is that of the rank with the particle that owns it; its other
 * particles are there, or among the ghosts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fix.h"
#include "dem/step/bodies.h"

namespace LAMMPS_NS {

class BodiesOfLammps : public asperity::BodySource {
public:
  BodiesOfLammps(LAMMPS *lammps, Fix *fix) : lammps_(lammps), fix_(fix) {}

  /* What walls cannot do with a fix that ties particles to bodies; empty: nothing. */
  static std::string error_of(const Fix *fix);

  /* Before a run: finds the fixes. */
  void init();

  /* True if all of them stand before a fix in the script, and act before it. */
  bool stand_before(const Fix *fix) const;

  bool any() const override {
    return !fixes_.empty();
  }
  bool has(int i) const override {
    return fix_of(i) != NULL;
  }
  void list(const std::vector<asperity::Wall *> &walls, bool begins) override;
  asperity::Bodies *take(const std::vector<asperity::Wall *> &walls) override;

  /* A Row of each particle to its ghosts. */
  int pack(int n, const int *list, double *to) const;
  void unpack(int n, int first, const double *from);

private:
  /* The particle that owns a particle's body, by its tag, 0: none; and the particle's place along
   * the axes of the body. */
  struct Row {
    double owner, arm[3];
  };

public:
  enum { SENT = sizeof(Row) / sizeof(double) };

private:
  Fix *fix_of(int i) const;
  void send_rows();
  void list_spheres(const std::map<double, size_t> &numbers);
  double name_of(size_t b) const override {
    return owners_[b];
  }
  double name_at(int i) const override;
  void write(size_t b, bool is_end) override;
  void set_particles(bool is_end) override;
  void read();
  void set_particle(const Fix *fix, int i, double *x, double v[3], double omega[3]) const;
  bool is_known(Fix *fix) const;

  LAMMPS *lammps_;
  Fix *fix_; /* the wall's */
  std::vector<Fix *> fixes_;
  bool is_checked_ = false;                  /* the layout */
  std::vector<Row> rows_;                    /* of particles and ghosts */
  std::vector<std::pair<Fix *, int>> owned_; /* where each body is */
  std::vector<double> owners_;               /* the tags of their owners */
};

} // namespace LAMMPS_NS
