/* liggghts-asperity: LIGGGHTS with the fix style wall/rebound. It runs a script as `liggghts` does,
 * all options and MPI included.
 *
 * The style is registered in Modify::fix_map, which is private; naming the member in an explicit
 * template instantiation is legal C++ and reaches it. The script's command `clear` makes a new
 * Modify, so the style is registered by its constructor: this program defines a function of the
 * constructor's name, which the dynamic linker gives to the library in place of its own. A library
 * that was linked to itself, as Ubuntu's, calls its own all the same; so the style is also looked
 * for at each line of the script, which ranks broadcast. The library is checked first.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dlfcn.h>
#include <mpi.h>
#include <signal.h>
#include <stdio.h>
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
#include "dem/launcher.h"

using namespace LAMMPS_NS;
using namespace asperity;

namespace {

const char NAME[] = "liggghts-asperity";
LAMMPS *program = NULL; /* once it is checked */

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

/* Adds the style to a Modify that may be under construction, before the rest of LAMMPS exists. */
void register_style(LAMMPS *lammps, Modify *modify) {
  if (!strstr(lammps->universe->version, ASPERITY_LIGGGHTS_VERSION))
    check(NAME, library_mismatch("the LIGGGHTS library", lammps->universe->version,
                                 ASPERITY_LIGGGHTS_VERSION));
  check(NAME, check_layout("Modify", modify));
  (*(modify->*fix_map_member))["wall/rebound"] = [](LAMMPS *lmp, int narg, char **arg) -> Fix * {
    return new FixWallRebound(lmp, narg, arg);
  };
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
    check(NAME, library_mismatch("the LIGGGHTS library", "without Modify::Modify",
                                 ASPERITY_LIGGGHTS_VERSION));
  original(modify, lammps);
  register_style(lammps, modify);
}

int MPI_Bcast(void *buffer, int count, MPI_Datatype type, int root, MPI_Comm comm) {
  Modify *modify = program ? program->modify : NULL;
  if (modify && !(modify->*fix_map_member)->count("wall/rebound"))
    register_style(program, modify);
  return PMPI_Bcast(buffer, count, type, root, comm);
}
}

int main(int argc, char **argv) {
  /* Behind a pipe an error message would stay in this process, which ends when another rank has. */
  setvbuf(stdout, NULL, _IOLBF, 0);
  handle_signals();
  MPI_Init(&argc, &argv);
  LAMMPS *lammps = new LAMMPS(argc, argv, MPI_COMM_WORLD);
  register_style(lammps, lammps->modify); /* where the library was linked to itself */
  check(NAME, check_layout("Atom", lammps->atom));
  check(NAME, check_layout("Domain", lammps->domain));
  check(NAME, check_layout("Neighbor", lammps->neighbor));
  check(NAME, check_layout("Update", lammps->update));
  program = lammps;
  lammps->input->file();
  program = NULL;
  delete lammps;
  MPI_Finalize();
  return 0;
}
