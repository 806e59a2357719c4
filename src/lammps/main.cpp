/* lammps-asperity: LAMMPS with the fix style wall/rebound. It runs a script as `lmp` does, all
 * options and MPI included.
 *
 * The script's command `clear` makes a new Modify, so the style is registered where that lists its
 * styles: this program defines a function of the name of Modify::create_factories(), which the
 * dynamic linker gives to the library in place of its own. A library whose version or class layout
 * is not the one compiled for would crash later and elsewhere, so both are checked first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dlfcn.h>
#include <malloc.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string>

#include "lammps.h"
#include "atom.h"
#include "domain.h"
#include "error.h"
#include "input.h"
#include "library.h"
#include "modify.h"
#include "update.h"
#include "fix_wall_rebound.h"

using namespace LAMMPS_NS;

namespace {

bool checked = false;

Fix *create_wall_rebound(LAMMPS *lmp, int narg, char **arg) {
  return new FixWallRebound(lmp, narg, arg);
}

void fail(const std::string &what, const std::string &found, const std::string &expected) {
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0)
    fprintf(stderr,
            "ERROR: lammps-asperity: %s is %s, but it was built for %s; build asperity again "
            "against this LAMMPS\n",
            what.c_str(), found.c_str(), expected.c_str());
  MPI_Finalize();
  exit(1);
}

/* The library allocated the object with its own idea of the class; ours must fit in, and not leave
 * more over than the allocator rounds up to. */
template <class T> void check_layout(const char *name, T *object) {
  const size_t room = malloc_usable_size(object);
  if (sizeof(T) > room || room >= sizeof(T) + 32)
    fail(name, std::to_string(room) + " bytes", std::to_string(sizeof(T)) + " bytes");
}

void check_integers(const char *name, size_t size) {
  const int theirs = lammps_extract_setting(NULL, name);
  if (theirs != static_cast<int>(size))
    fail(std::string("the type ") + name, std::to_string(theirs) + " bytes",
         std::to_string(size) + " bytes");
}

void check_library(LAMMPS *lammps) {
  const int version = lammps_version(lammps);
  if (version != ASPERITY_LAMMPS_VERSION)
    fail("the LAMMPS library", std::to_string(version), std::to_string(ASPERITY_LAMMPS_VERSION));
  check_integers("tagint", sizeof(tagint));
  check_integers("bigint", sizeof(bigint));
  check_integers("imageint", sizeof(imageint));
  check_layout("the class LAMMPS", lammps);
  check_layout("the class Atom", lammps->atom);
  check_layout("the class Domain", lammps->domain);
  check_layout("the class Error", lammps->error);
  check_layout("the class Modify", lammps->modify);
  check_layout("the class Update", lammps->update);
}

void register_style(Modify *modify) {
  (*modify->fix_map)["wall/rebound"] = create_wall_rebound;
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
    fail("the LAMMPS library", "without Modify::create_factories",
         std::to_string(ASPERITY_LAMMPS_VERSION));
  original(modify);
  if (checked)
    register_style(modify);
}
}

int main(int argc, char **argv) {
  MPI_Init(&argc, &argv);
  LAMMPS *lammps = new LAMMPS(argc, argv, MPI_COMM_WORLD);
  check_library(lammps);
  checked = true;
  register_style(lammps->modify);
  lammps->input->file();
  delete lammps;
  MPI_Finalize();
  return 0;
}
