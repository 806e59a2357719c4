/* fix wall/rebound: rough walls for LAMMPS. This is LAMMPS's side only: its hooks and the numbers
 * of each atom. What a wall does is in the library asperity_dem, which knows no engine.
 *
 * Contacts are worked out in post_integrate, when particles are where the step has taken them and
 * before the forces are computed there: so that forces, ghosts and neighbor lists see where
 * particles are after their rebounds. The first fix of the style does it for all of them, for a
 * particle may meet two walls in one step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/rebound,FixWallRebound);
// clang-format on
#else

#ifndef LMP_FIX_WALL_REBOUND_H
#define LMP_FIX_WALL_REBOUND_H

#include "engine_lammps.h"

namespace LAMMPS_NS {

class FixWallRebound : public asperity::WallHooks<Fix, EngineOfLammps> {
public:
  FixWallRebound(class LAMMPS *, int, char **);
  ~FixWallRebound() override;

  int setmask() override;
  void setup(int vflag) override;
  void initial_integrate(int vflag) override;
  void end_of_step() override;
  void post_run() override;
  void write_data_header(FILE *file, int which) override;

  int pack_forward_comm(int n, int *list, double *buffer, int pbc_flag, int *pbc) override;
  void unpack_forward_comm(int n, int first, double *buffer) override;

private:
  struct Parts;

  asperity::WallFix<EngineOfLammps> &wall_fix() override;
  void read_geometry(asperity::Words &words, std::string &geometry);
  double value_of(const std::string &name) const;
  int read_type(asperity::Words &words) const;

  Parts *p_; /* what the wall is made of, with the numbers of each atom */
};

} // namespace LAMMPS_NS

#endif
#endif
