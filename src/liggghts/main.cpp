/* liggghts-asperity: LIGGGHTS with the fix style wall/rebound. It runs a script as `liggghts` does,
 * all options and MPI included.
 *
 * The style is registered in Modify::fix_map, which is private; naming the member in an explicit
 * template instantiation is legal C++ and reaches it. The script's command `clear` makes a new
 * Modify, so the style is registered by its constructor: this program defines a function of the
 * constructor's name, which the dynamic linker gives to the library in place of its own. A library
 * whose version or class layout is not the one compiled for would crash later and elsewhere, so
 * both are checked first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dlfcn.h>
#include <malloc.h>
#include <mpi.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <map>
#include <string>

#include "lammps.h"
#include "atom.h"
#include "domain.h"
#include "input.h"
#include "modify.h"
#include "neighbor.h"
#include "signal_handling.h"
#include "universe.h"
#include "update.h"
#include "fix_wall_rebound.h"

using namespace LAMMPS_NS;

namespace {

typedef Fix *(*FixCreator)(LAMMPS *, int, char **);
typedef std::map<std::string, FixCreator> *Modify::*FixMapMember;

FixMapMember fix_map_member;

template <FixMapMember member> struct FixMapAccess {
  struct Setter {
    Setter() {
      fix_map_member = member;
    }
  };
  static Setter setter;
};
template <FixMapMember member> typename FixMapAccess<member>::Setter FixMapAccess<member>::setter;
template struct FixMapAccess<&Modify::fix_map>;

Fix *create_wall_rebound(LAMMPS *lmp, int narg, char **arg) {
  return new FixWallRebound(lmp, narg, arg);
}

void fail(const char *what, const char *found, const char *expected) {
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0)
    fprintf(stderr,
            "ERROR: liggghts-asperity: %s is %s, but it was built for %s; build asperity "
            "again against this LIGGGHTS\n",
            what, found, expected);
  MPI_Finalize();
  exit(1);
}

/* The library allocated the object with its own idea of the class; ours must fit in, and not leave
 * more over than the allocator rounds up to. */
template <class T> void check_layout(const char *name, T *object) {
  size_t room = malloc_usable_size(object);
  if (sizeof(T) <= room && room < sizeof(T) + 32)
    return;
  fail(name, (std::to_string(room) + " bytes").c_str(),
       (std::to_string(sizeof(T)) + " bytes").c_str());
}

/* Adds the style to a Modify that may be under construction, before the rest of LAMMPS exists. */
void register_style(LAMMPS *lammps, Modify *modify) {
  if (!strstr(lammps->universe->version, ASPERITY_LIGGGHTS_VERSION))
    fail("the LIGGGHTS library", lammps->universe->version, ASPERITY_LIGGGHTS_VERSION);
  check_layout("the class Modify", modify);
  (*(modify->*fix_map_member))["wall/rebound"] = create_wall_rebound;
}

void check_classes(LAMMPS *lammps) {
  check_layout("the class Atom", lammps->atom);
  check_layout("the class Domain", lammps->domain);
  check_layout("the class Neighbor", lammps->neighbor);
  check_layout("the class Update", lammps->update);
}

void handle_signals() {
  struct sigaction stop, checkpoint;
  memset(&stop, 0, sizeof stop);
  memset(&checkpoint, 0, sizeof checkpoint);
  stop.sa_handler = SignalHandler::int_handler;
  sigaction(SIGINT, &stop, NULL);
  sigaction(SIGTERM, &stop, NULL);
  checkpoint.sa_handler = SignalHandler::usr1_handler;
  sigaction(SIGUSR1, &checkpoint, NULL);
}

} // namespace

#define MODIFY_CONSTRUCTOR "_ZN9LAMMPS_NS6ModifyC2EPNS_6LAMMPSE"
#define MODIFY_COMPLETE_CONSTRUCTOR "_ZN9LAMMPS_NS6ModifyC1EPNS_6LAMMPSE"

/* Modify::Modify, by the names that GCC and Clang give it (for a base and for a whole object). */
extern "C" {
void asperity_construct_modify(Modify *modify, LAMMPS *lammps) __asm__(MODIFY_CONSTRUCTOR);
void asperity_construct_whole_modify(Modify *, LAMMPS *) __asm__(MODIFY_COMPLETE_CONSTRUCTOR)
    __attribute__((alias(MODIFY_CONSTRUCTOR)));

void asperity_construct_modify(Modify *modify, LAMMPS *lammps) {
  typedef void (*Constructor)(Modify *, LAMMPS *);
  Constructor original = reinterpret_cast<Constructor>(dlsym(RTLD_NEXT, MODIFY_CONSTRUCTOR));
  if (!original)
    fail("the LIGGGHTS library", "without Modify::Modify", ASPERITY_LIGGGHTS_VERSION);
  original(modify, lammps);
  register_style(lammps, modify);
}
}

int main(int argc, char **argv) {
  /* Behind a pipe an error message would stay in this process, which ends when another rank has. */
  setvbuf(stdout, NULL, _IOLBF, 0);
  handle_signals();
  MPI_Init(&argc, &argv);
  LAMMPS *lammps = new LAMMPS(argc, argv, MPI_COMM_WORLD);
  register_style(lammps, lammps->modify); /* where the library was linked to itself */
  check_classes(lammps);
  lammps->input->file();
  delete lammps;
  MPI_Finalize();
  return 0;
}
