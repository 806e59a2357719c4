/* A profile in numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SURFACE_DESCRIBE_H
#define ASP_SURFACE_DESCRIBE_H

#include "asperity.h"

/* Levels of the autocorrelation that define the correlation length. */
#define ASP_LEVEL_1_E 0.36787944117144233
#define ASP_LEVEL_S_AL 0.2 /* S_al of ISO 25178-2 */

/* A correlation length of fewer spacings is that of noise: white noise has 0.63 by the 1/e lag. */
#define ASP_SPACINGS_LEAST 1.5

/* Standard error of the mean tilt of first hits at 2 degrees, as a part of sigma: 0.11 for a
 * profile of 100 correlation lengths, proportional to 1/sqrt(length) (from ensembles of generated
 * profiles). */
#define ASP_LENGTH_ERROR(lengths) (1.1 / sqrt(lengths))

typedef struct aspi_description {
  double length, spacing;
  size_t points;
  double r_q, r_a;   /* rms and mean absolute height about the mean */
  double lambda_c;   /* the lag at which the autocorrelation falls to the level */
  double lambda_1_e; /* lambda_c / sqrt(-ln(level)): the 1/e lag of a Gaussian profile with it */
  double phi_r;      /* r_q/lambda_c */
  double slope_rms;  /* of the differences between neighbors */
} aspi_description;

/* Describes a profile; 0 < level < 1. ASP_EDATA when it is constant, or too short for its
 * autocorrelation to fall to the level within half its length. Of a measured profile the
 * autocovariance at lag k is the sum of its n - k products over n. */
asp_code aspi_profile_describe(const asp_profile *profile, double level,
                               aspi_description *description, asp_error *error);

/* ASP_EDATA and a message for heights that are no roughness: phi_r beyond the limit, or
 * uncorrelated neighboring points, as in noise. */
asp_code aspi_description_check(const aspi_description *description, double phi_r_most,
                                asp_error *error);

#endif
