/* A measured profile for all ranks: the first one reads the file, the others get the heights.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_REBOUND_PROFILE_H
#define LMP_REBOUND_PROFILE_H

#include <mpi.h>
#include <memory>
#include <string>

#include "asperity.h"

namespace LAMMPS_NS {

typedef std::unique_ptr<asp_profile, void (*)(asp_profile *)> ReboundProfile;

/* Reads path, with `metre` of the result's units to a metre; collective. `report` becomes what the
 * reader found and did. Throws the reader's message, a std::string, on all ranks. */
ReboundProfile read_rebound_profile(MPI_Comm world, const std::string &path, double metre,
                                    std::string &report);

} // namespace LAMMPS_NS

#endif
