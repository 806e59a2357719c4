/* A program that has LIGGGHTS as a library, as CFDEMcoupling's solvers have it: it reads a script,
 * and then calls `run` once for each exchange with a flow, which sets the force of each particle
 * before. Usage: coupled SCRIPT EXCHANGES STEPS FX FZ SWING. The force is (FX, 0, FZ) times 1 +
 * SWING in even exchanges and 1 - SWING in odd ones.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <mpi.h>
#include <stdlib.h>
#include <string>

#include "library.h"
#include "library_cfd_coupling.h"

int main(int argc, char **argv) {
  MPI_Init(&argc, &argv);
  if (argc != 7)
    MPI_Abort(MPI_COMM_WORLD, 2);
  char *options[] = {argv[0], const_cast<char *>("-log"), const_cast<char *>("none")};
  void *engine;
  lammps_open(3, options, MPI_COMM_WORLD, &engine);
  lammps_file(engine, argv[1]);
  const std::string run = std::string("run ") + argv[3];
  const double swing = atof(argv[6]);
  double **force = NULL;
  for (int exchange = 0; exchange < atoi(argv[2]); exchange++) {
    const double factor = exchange % 2 == 0 ? 1 + swing : 1 - swing;
    allocate_external_double(force, 3, "nparticles", 0, engine);
    for (int i = 0; i < liggghts_get_maxtag(engine); i++) {
      force[i][0] = factor * atof(argv[4]);
      force[i][2] = factor * atof(argv[5]);
    }
    data_of_to_liggghts("dragforce", "vector-atom", engine, force, "double");
    lammps_command(engine, run.c_str());
  }
  lammps_close(engine);
  MPI_Finalize();
  return 0;
}
