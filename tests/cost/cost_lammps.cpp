/* Costs of LAMMPS's regions as walls, by a grain and a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <mpi.h>
#include <string>

#include "lammps.h"
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "group.h"
#include "input.h"
#include "modify.h"
#include "output.h"
#include "update.h"
#include "fix_wall_rebound.h"

#include "count.h"

using namespace LAMMPS_NS;

namespace {

const int GRAINS = 100;

/* The fix, whose own instructions count. */
class CountedFix : public FixWallRebound {
public:
  using FixWallRebound::FixWallRebound;
  void post_integrate() override {
    count_on();
    FixWallRebound::post_integrate();
    count_off();
  }
  void end_of_step() override {
    count_on();
    FixWallRebound::end_of_step();
    count_off();
  }
};

Fix *create(LAMMPS *lammps, int count, char **words) {
  return new CountedFix(lammps, count, words);
}

/* 100 grains of 2 mm side by side over z = 0, under gravity. */
const char *const BEGIN[] = {"clear",
                             "units si",
                             "atom_style sphere",
                             "newton off",
                             "boundary f f f",
                             "region box block 0 0.04 0 0.04 -0.01 0.03 units box",
                             "create_box 1 box",
                             "lattice sc 0.004",
                             "region low block INF INF INF INF -0.001 0.001 units box",
                             "create_atoms 1 region low",
                             "set group all diameter 0.002 density 2500",
                             "neighbor 0.001 bin",
                             "neigh_modify exclude group all all",
                             "fix move all nve/sphere",
                             "timestep 1e-5",
                             "thermo_style custom step"};

void count_region(LAMMPS &lammps, const char *what, double height, const char *region,
                  const char *motion) {
  const int steps = 40;
  for (const char *line : BEGIN)
    lammps.input->one(line);
  (*lammps.modify->fix_map)["wall/rebound"] = create;
  for (const std::string &line :
       {"displace_atoms all move 0.002 0.002 " + std::to_string(0.001 + height) + " units box",
        std::string("fix fall all gravity 9.81 vector 0 0 -1"),
        std::string("variable a equal 10*time"), std::string("variable d equal 0.01*time"),
        "region r " + std::string(region) + " " + motion,
        std::string("fix wall all wall/rebound region r rebound walton 0.5 0.3 0 deposit off"),
        std::string("run 20")})
    lammps.input->one(line);
  count_begin();
  lammps.input->one(("run " + std::to_string(steps)).c_str());
  count_end(what, static_cast<double>(steps) * GRAINS);
}

} // namespace

int main(int argc, char **argv) {
  MPI_Init(&argc, &argv);
  const char *words[] = {"cost_lammps", "-log", "none", "-screen", "none"};
  LAMMPS lammps(5, const_cast<char **>(words), MPI_COMM_WORLD);
  const char room[] = "block -1 1 -1 1 0 0.03 units box", moves[] = "move v_d NULL NULL";
  const char turns[] = "rotate v_a 0.02 0.02 0 0 0 1";
  count_region(lammps, "grain at rest on a region", 0, room, "");
  count_region(lammps, "grain at rest on a region that moves", 0, room, moves);
  count_region(lammps, "grain at rest on a region that turns", 0, room, turns);
  count_region(lammps, "grain far from a region that moves", 0.014, room, moves);
  count_region(lammps, "grain far from a region that turns", 0.014, room, turns);
  MPI_Finalize();
  return 0;
}
