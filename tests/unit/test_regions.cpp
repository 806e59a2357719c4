/* Barriers between spheres and regions of LAMMPS: a search finds nothing in front of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <string>

#include "lammps.h"
#include "input.h"
#include "update.h"
#include "region_shape.h"

#include "barriers.h"

using namespace LAMMPS_NS;
using namespace asperity;

namespace {

const char *const BEGIN[] = {"clear",
                             "units si",
                             "atom_style sphere",
                             "newton off",
                             "boundary f f f",
                             "region box block -2 2 -2 2 -2 2 units box",
                             "create_box 1 box",
                             "timestep 0.1",
                             "variable a equal 0.1*sin(3.7*step)",
                             "variable d equal 0.03*sin(2.3*step)"};

const char *const REGIONS[] = {
    "block -0.8 0.9 -1 0.7 -0.9 1",
    "block -0.8 0.9 -1 0.7 -0.9 1 side out",
    "cylinder z 0.1 0 0.8 -0.9 0.9",
    "cylinder x 0 0.1 0.4 -0.5 0.6 side out",
    "sphere 0 0.1 0 0.9",
    "sphere 0 0.1 0 0.4 side out",
    "cone z 0 0 0.4 1 -0.9 0.9",
    "cone y 0 0 0.5 0.2 -0.5 0.5 side out",
    "prism -1 0.7 -0.8 0.8 -0.7 0.7 0.3 0.1 0.2",
    "plane 0 0 -0.3 0.2 0.3 1",
    "cylinder z 0 0 0.8 -1 1 open 1 open 2",
    "union 2 ball tube",
    "union 2 ball tube side out",
    "intersect 2 big tube",
};

/* How a region moves, and whether the words are for it. */
const char *const MOTIONS[] = {"", "move v_d NULL v_d", "rotate v_a 0.1 0.2 0 0.6 0 0.8",
                               "move NULL v_d NULL rotate v_a 0 0.2 0 0 0 1"};

/* Counts what is met, and what is in front of barriers; false where both are one. */
bool check_region(LAMMPS &lammps, const std::string &region, const std::string &motion) {
  const double dt = 0.1, radius = 0.2;
  const int rounds = 4000;
  BarrierCounts counts = BarrierCounts();
  for (const char *each : BEGIN)
    lammps.input->one(each);
  const bool has_parts = region[0] == 'u' || region[0] == 'i'; /* which move, then */
  for (const char *part : {"region ball sphere 0.3 0 0 0.7", "region big sphere 0 0 0 0.95",
                           "region tube cylinder x 0 0 0.6 -0.9 0.9"})
    lammps.input->one((part + (" units box " + motion)).c_str());
  lammps.input->one(("region r " + region + " units box " + (has_parts ? "" : motion)).c_str());
  RegionShape shape(&lammps, "r");
  lammps.init();
  shape.init();
  shape.setup();
  for (int round = 0; round < rounds; round++) {
    lammps.update->ntimestep++;
    shape.begin_step();
    count_sphere(shape, radius, dt, counts);
  }
  const bool right =
      counts.both == 0 && (counts.before > rounds / 50 || region.find("open") < region.size());
  printf("%s %4d in front of barriers, %4d met, %d of both: %s %s\n", right ? "ok  " : "FAIL",
         counts.before, counts.met, counts.both, region.c_str(), motion.c_str());
  return right && counts.met > rounds / 50;
}

} // namespace

int main(int argc, char **argv) {
  MPI_Init(&argc, &argv);
  int failed = 0;
  {
    const char *words[] = {"test_regions", "-log", "none", "-screen", "none"};
    LAMMPS lammps(5, const_cast<char **>(words), MPI_COMM_WORLD);
    for (const char *region : REGIONS)
      for (const char *motion : MOTIONS)
        failed += !check_region(lammps, region, motion);
  }
  MPI_Finalize();
  return failed > 0;
}
