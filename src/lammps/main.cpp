/* lammps-asperity: LAMMPS with the fix style wall/rebound. It runs a script as `lmp` does, all
 * options and MPI included.
 *
 * The script's command `clear` makes a new Modify, so the style is registered where that lists its
 * styles: this program defines a function of the name of Modify::create_factories(), which the
 * dynamic linker gives to the library in place of its own. A library that was linked to itself, as
 * Ubuntu's, calls its own all the same; so the style is also looked for at each line of the script,
 * which ranks broadcast. The library is checked first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dlfcn.h>
#include <mpi.h>
#include <stdio.h>
#include <string>

#include "lammps.h"
#include "exceptions.h"
#include "input.h"
#include "modify.h"
#include "fix_wall_rebound.h"
#include "dem/launcher.h"

using namespace LAMMPS_NS;

namespace {

const char NAME[] = "lammps-asperity";
bool checked = false;
LAMMPS *program = NULL; /* once it is checked */

void register_style(Modify *modify) {
  (*modify->fix_map)["wall/rebound"] = [](LAMMPS *lmp, int narg, char **arg) -> Fix * {
    return new FixWallRebound(lmp, narg, arg);
  };
}

} // namespace

#define CREATE_FACTORIES "_ZN9LAMMPS_NS6Modify16create_factoriesEv"

/* Modify::create_factories, by the name that GCC and Clang give it. The first Modify is there
 * before the library has been checked; main() sees to that one. */
extern "C" {
void asperity_create_factories(Modify *modify) __asm__(CREATE_FACTORIES);

void asperity_create_factories(Modify *modify) {
  typedef void (*Function)(Modify *);
  Function original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, CREATE_FACTORIES));
  if (!original)
    asperity::check(NAME, asperity::library_mismatch("the LAMMPS library",
                                                     "without Modify::create_factories",
                                                     std::to_string(ASPERITY_LAMMPS_VERSION)));
  original(modify);
  if (checked)
    register_style(modify);
}

int MPI_Bcast(void *buffer, int count, MPI_Datatype type, int root, MPI_Comm comm) {
  if (program && program->modify && !program->modify->fix_map->count("wall/rebound"))
    register_style(program->modify);
  return PMPI_Bcast(buffer, count, type, root, comm);
}
}

static void run(int argc, char **argv) {
  LAMMPS *lammps = new LAMMPS(argc, argv, MPI_COMM_WORLD);
  asperity::check(NAME, check_library(lammps));
  checked = true;
  register_style(lammps->modify);
  program = lammps;
  lammps->input->file();
  program = NULL;
  delete lammps;
}

int main(int argc, char **argv) {
  int status = 0;
  /* Behind a pipe an error message would stay in this process, which ends when another rank has. */
  setvbuf(stdout, NULL, _IOLBF, 0);
  MPI_Init(&argc, &argv);
  try { /* LAMMPS has printed the message when it throws */
    run(argc, argv);
  } catch (LAMMPSAbortException &on_one_rank) {
    MPI_Abort(on_one_rank.get_universe(), 1);
  } catch (LAMMPSException &) {
    status = 1;
  }
  MPI_Finalize();
  return status;
}
