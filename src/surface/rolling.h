/* Discs that roll over a profile.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "surface/heights.h"

/* The path of the center of a disc of diameter d_p that rolls over the smooth curve through the
 * points (dilation), `parts` (>= 1) points of it a spacing. 0 <= d_p; of a periodic profile well
 * below the length. NULL on error. */
asp_heights *aspi_profile_rolled(const asp_heights *profile, double d_p, int parts,
                                 asp_error *error);

/* The same with as many points, up to `most` in all, as the disc's width needs. 0 < d_p <= length.
 */
asp_heights *aspi_profile_path(const asp_heights *profile, double d_p, size_t most,
                               asp_error *error);

/* The deepest that the edge of the disc reaches (closing): the path of a disc that rolls below the
 * path. */
asp_heights *aspi_profile_closed(const asp_heights *profile, double d_p, asp_error *error);
