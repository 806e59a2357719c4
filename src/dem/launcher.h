/* Checks that a launcher makes of the engine's library: a version or a layout of its classes that
 * is not the one compiled for would crash later and elsewhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <malloc.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string>

namespace asperity {

inline std::string library_mismatch(const std::string &what, const std::string &found,
                                    const std::string &expected) {
  return what + " is " + found + ", but it was built for " + expected +
         "; build asperity again against this engine";
}

/* The library allocated the object with its own idea of the class; ours must fit in, and not leave
 * more over than the allocator rounds up to, or than a derived class adds. "": it does. */
template <class T> std::string check_layout(const char *name, T *object, bool is_derived = false) {
  const size_t room = malloc_usable_size(object);
  if (sizeof(T) <= room && (is_derived || room < sizeof(T) + 32))
    return "";
  return library_mismatch(std::string("the class ") + name, std::to_string(room) + " bytes",
                          std::to_string(sizeof(T)) + " bytes");
}

/* Ends the launcher if something is wrong. */
inline void check(const char *launcher, const std::string &wrong) {
  if (wrong.empty())
    return;
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0)
    fprintf(stderr, "ERROR: %s: %s\n", launcher, wrong.c_str());
  MPI_Finalize();
  exit(1);
}

} // namespace asperity
