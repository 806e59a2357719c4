/* A measured profile or map for all ranks: the first one reads the file, the others get the
 * heights.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_SURFACE_FILE_H
#define ASPERITY_DEM_SURFACE_FILE_H

#include <mpi.h>
#include <memory>
#include <string>

#include "asperity_front.h"

namespace asperity {

typedef std::unique_ptr<asp_profile, void (*)(asp_profile *)> Profile;
typedef std::unique_ptr<asp_map, void (*)(asp_map *)> Map;

/* Findings, repairs and doubts of the reader, or "". */
struct Reading {
  std::string report, doubts;
};

/* Reads path, with `metre` of the result's units to a meter; collective. Throws the reader's
 * message, an Error, on all ranks. */
Profile read_profile(MPI_Comm world, const std::string &path, double metre, Reading &reading);

/* Reads a map like this. */
Map read_map(MPI_Comm world, const std::string &path, double metre, Reading &reading);

} // namespace asperity

#endif
