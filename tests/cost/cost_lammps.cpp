/* Costs of walls in LAMMPS, by a grain and a step: of regions, and of a plane beside a body.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <mpi.h>
#include <string>
#include <vector>

#include "lammps.h"
#include "input.h"
#include "fix_wall_rebound.h"

#include "count.h"
#include "jet.h"

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
                             "atom_modify map array",
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

std::string number(double value) {
  char text[32];
  snprintf(text, sizeof text, "%.12g", value);
  return text;
}

/* What the wall costs a grain in a step after the first ones. */
void count_scene(LAMMPS &lammps, const char *what, int grains,
                 const std::vector<std::string> &lines, int first = 20, int steps = 40) {
  for (const char *line : BEGIN)
    lammps.input->one(line);
  (*lammps.modify->fix_map)["wall/rebound"] = create;
  for (const std::string &line : lines)
    lammps.input->one(line);
  lammps.input->one(("run " + std::to_string(first)).c_str());
  count_begin();
  lammps.input->one(("run " + std::to_string(steps)).c_str());
  count_end(what, static_cast<double>(steps) * grains);
}

const char SMOOTH[] = "rebound walton 0.5 0.3 0 deposit off";
const char STICKY[] = "rebound bons materials quartz surface_energy 1e9";

void count_region(LAMMPS &lammps, const char *what, double height, const char *region,
                  const char *motion, const std::string &law = SMOOTH) {
  count_scene(
      lammps, what, GRAINS,
      {"displace_atoms all move 0.002 0.002 " + std::to_string(0.001 + height) + " units box",
       "fix fall all gravity 9.81 vector 0 0 -1", "variable a equal 10*time",
       "variable d equal 0.01*time", "region r " + std::string(region) + " " + motion,
       "velocity all set NULL NULL " + std::string(law == STICKY ? "-0.1" : "0"),
       "fix wall all wall/rebound region r " + law});
}

/* A grain's whole life. */
void count_jet(LAMMPS &lammps, const char *what, const char *region) {
  const std::vector<JetGrain> jet = jet_grains();
  std::vector<std::string> lines = {"delete_atoms group all", "timestep " + number(JET_DT),
                                    "region r " + std::string(region),
                                    "fix wall all wall/rebound region r " + std::string(JET_LAW)};
  for (const JetGrain &one : jet) {
    const std::string set = "set atom " + std::to_string(lines.size() / 2 - 1);
    lines.push_back("create_atoms 1 single " + number(0.002 + one.x[0]) + " " +
                    number(0.002 + one.x[1]) + " " + number(one.x[2]) + " units box");
    lines.push_back(set + " diameter " + number(2 * one.radius) + " density 2650 vx " +
                    number(one.v[0]) + " vz " + number(one.v[2]));
  }
  count_scene(lammps, what, static_cast<int>(jet.size()), lines, 0, JET_STEPS);
}

/* Many small grains that fall far from a plane, two of which are a body. */
void count_beside_body(LAMMPS &lammps, const char *what) {
  const int along = 100;
  count_scene(lammps, what, along * along,
              {"delete_atoms group all", "lattice sc 0.0004",
               "region layer block INF INF INF INF -0.0001 0.0001 units box",
               "create_atoms 1 region layer", "set group all diameter 0.0003 density 2500",
               "unfix move", "group two id 1 2", "fix number all property/atom mol",
               "set group two mol 1", "group others subtract all two", "fix move others nve/sphere",
               "comm_modify cutoff 0.001", "fix body two rigid/small molecule",
               "fix fall all gravity 9.81 vector 0 0 -1",
               "fix wall all wall/rebound zplane -0.009 rebound walton 0.5 0.3 0 deposit off"});
}

} // namespace

int main(int argc, char **argv) {
  MPI_Init(&argc, &argv);
  const char *words[] = {"cost_lammps", "-log", "none", "-screen", "none"};
  LAMMPS lammps(5, const_cast<char **>(words), MPI_COMM_WORLD);
  const char room[] = "block -1 1 -1 1 0 0.03 units box", moves[] = "move v_d NULL NULL";
  const char turns[] = "rotate v_a 0.02 0.02 0 0 0 1";
  count_region(lammps, "grain at rest on a region", 0, room, "");
  count_region(lammps, "grain stuck to a region", 0, room, "", STICKY);
  count_region(lammps, "grain at rest on a region that moves", 0, room, moves);
  count_region(lammps, "grain at rest on a region that turns", 0, room, turns);
  count_region(lammps, "grain far from a region that moves", 0.014, room, moves);
  count_region(lammps, "grain far from a region that turns", 0.014, room, turns);
  count_jet(lammps, "grain of a jet at a region", room);
  count_beside_body(lammps, "grain far from a plane beside a body");
  MPI_Finalize();
  return 0;
}
