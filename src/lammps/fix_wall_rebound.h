/* fix wall/rebound: rough walls for LAMMPS. This is LAMMPS's side only: its hooks and the numbers
 * of each atom. What both engines do is in
 * dem/wall_fix.h; what a wall does, in the rest of dem, which knows no engine.
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
