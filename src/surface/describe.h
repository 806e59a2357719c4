/* A profile or a map in numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SURFACE_DESCRIBE_H
#define ASP_SURFACE_DESCRIBE_H

#include "surface/map.h"

/* Levels of the autocorrelation that define the correlation length. */
#define ASP_LEVEL_1_E 0.36787944117144233
#define ASP_LEVEL_S_AL 0.2 /* S_al of ISO 25178-2 */

/* Standard error of the mean tilt of first hits at 2 degrees, as a part of sigma: 0.11 for a
 * profile of 100 correlation lengths, proportional to 1/sqrt(length) (from ensembles of generated
 * profiles). */
#define ASP_LENGTH_ERROR(lengths) (1.1 / sqrt(lengths))

typedef struct aspi_profile_description {
  double length, spacing;
  size_t points;
  double r_q, r_a;   /* rms and mean absolute height about the mean */
  double lambda_c;   /* the lag at which the autocorrelation falls to the level */
  double lambda_1_e; /* lambda_c / sqrt(-ln(level)): the 1/e lag of a Gaussian profile with it */
  double phi_r;      /* r_q/lambda_c */
  double slope_rms;  /* of the differences between neighbors */
} aspi_profile_description;

/* Describes a profile; 0 < level < 1. ASP_EDATA when it is constant, or too short for its
 * autocorrelation to fall to the level within half its length. Of a measured profile the
 * autocovariance at lag k is the sum of its n - k products over n. */
asp_code aspi_profile_describe(const asp_profile *profile, double level,
                               aspi_profile_description *description, asp_error *error);

/* ASP_EDATA and a message for heights that are no roughness: phi_r beyond the limit, or
 * uncorrelated neighboring points, as in noise. */
asp_code aspi_profile_check(const aspi_profile_description *description, double phi_r_most,
                            asp_error *error);

/* ---- maps ---- */

/* asp_surface_create_map() of a map that was described. */
asp_surface *aspi_surface_create_map(const asp_map *map, const asp_map_numbers *description,
                                     bool lay, asp_error *error);

/* The rms and the skewness of n gradients p, q to the right of the lay and along it; mixed: the
 * mean of the product of the slopes to the left of it and along it. */
void aspi_gradient_describe(const float *p, const float *q, size_t n, double lay, double rms[2],
                            double skewness[2], double *mixed);

/* ASP_EDATA for what cannot be roughness: noise, and phi_r over its most. */
asp_code aspi_map_check(const asp_map *map, const asp_map_numbers *d, double phi_r_most,
                        asp_error *error);

/* Checks a wall of either kind by its `which` correlation length and phi_r, the
 * `ratio`; `remedy` ends the message about noise. */
asp_code aspi_roughness_check(const char *which, double lambda, double step, const char *remedy,
                              const char *ratio, double phi_r, double phi_r_most, asp_error *error);

#endif
