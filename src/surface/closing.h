/* Discs on a profile.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SURFACE_CLOSING_H
#define ASP_SURFACE_CLOSING_H

#include "asperity_internal.h"

/* The path of the center of a disc of diameter d_p that rolls over the profile (dilation), and the
 * deepest that its edge reaches (closing: dilation, then erosion); exact for the sampled points, in
 * a time that does not depend on d_p. `out` has asp_profile_points values. 0 < d_p <= length. */
asp_code aspi_profile_dilate(const asp_heights *profile, double d_p, double *out, asp_error *error);
asp_code aspi_profile_close(const asp_heights *profile, double d_p, double *out, asp_error *error);

/* ASP_OK where a disc of that diameter can be laid on the profile; ASP_EARG and a message where
 * not.
 */
asp_code aspi_profile_check_disc(const asp_heights *profile, double d_p, asp_error *error);

/* The path of the center over the smooth curve that goes through the points, `parts` (>= 1) points
 * of it a spacing. 0 <= d_p, of a periodic profile well below the length. */
asp_heights *aspi_profile_rolled(const asp_heights *profile, double d_p, int parts,
                                 asp_error *error);

/* The path over a measured profile. Points are added between the profile's own, up to `most` in
 * all, until the disc's width spans many of them. 0 < d_p <= length; NULL on error. */
asp_heights *aspi_profile_path(const asp_heights *profile, double d_p, size_t most,
                               asp_error *error);

#endif
