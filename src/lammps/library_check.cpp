/* The check of a LAMMPS library; see library_check.h. ASPERITY_LAMMPS_VERSION is the version of the
 * headers, as a number such as 20210929.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "library_check.h"

#include <malloc.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

#include "lammps.h"
#include "atom.h"
#include "domain.h"
#include "error.h"
#include "library.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;

void LAMMPS_NS::fail_library(const std::string &program, const std::string &what,
                             const std::string &found, const std::string &expected) {
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0)
    fprintf(stderr,
            "ERROR: %s: %s is %s, but it was built for %s; build asperity again against this "
            "LAMMPS\n",
            program.c_str(), what.c_str(), found.c_str(), expected.c_str());
  MPI_Finalize();
  exit(1);
}

/* The library allocated the object with its own idea of the class; ours must fit in, and not leave
 * more over than the allocator rounds up to. */
template <class T>
static void check_layout(const std::string &program, const char *name, T *object) {
  const size_t room = malloc_usable_size(object);
  if (sizeof(T) > room || room >= sizeof(T) + 32)
    fail_library(program, name, std::to_string(room) + " bytes",
                 std::to_string(sizeof(T)) + " bytes");
}

static void check_integers(const std::string &program, const char *name, size_t size) {
  const int theirs = lammps_extract_setting(NULL, name);
  if (theirs != static_cast<int>(size))
    fail_library(program, std::string("the type ") + name, std::to_string(theirs) + " bytes",
                 std::to_string(size) + " bytes");
}

void LAMMPS_NS::check_library(LAMMPS *lammps, const std::string &program) {
  const int version = lammps_version(lammps);
  if (version != ASPERITY_LAMMPS_VERSION)
    fail_library(program, "the version of LAMMPS", std::to_string(version),
                 std::to_string(ASPERITY_LAMMPS_VERSION));
  check_integers(program, "tagint", sizeof(tagint));
  check_integers(program, "bigint", sizeof(bigint));
  check_integers(program, "imageint", sizeof(imageint));
  check_layout(program, "the class LAMMPS", lammps);
  check_layout(program, "the class Atom", lammps->atom);
  check_layout(program, "the class Domain", lammps->domain);
  check_layout(program, "the class Error", lammps->error);
  check_layout(program, "the class Modify", lammps->modify);
  check_layout(program, "the class Update", lammps->update);
}
