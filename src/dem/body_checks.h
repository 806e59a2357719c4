/* Doubts about bodies at the beginning of a run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_BODY_CHECKS_H
#define ASPERITY_DEM_BODY_CHECKS_H

#include <mpi.h>
#include <string>

#include "dem/step/bodies.h"

namespace asperity {

/* Bodies that turn so far in a step that Richardson's rule, by which the engine turns them, adds to
 * their energy. remedy: what to use; "": the engine has another rule. Collective; "": no doubt. */
std::string turn_doubt(const Bodies &bodies, const std::string &remedy, MPI_Comm world);

/* Fewer bodies than were `saved` in the restart file. Collective. */
std::string count_doubt(const Bodies &bodies, size_t saved, MPI_Comm world);

} // namespace asperity

#endif
