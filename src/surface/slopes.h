/* Slopes that particles find on a profile, and how far they are from a normal distribution.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"

/* Mean, standard deviation, skewness, and excess kurtosis (0 for a normal distribution). */
typedef struct aspi_moments {
  double mean, sd, skewness, kurtosis;
} aspi_moments;

aspi_moments aspi_moments_of(const double *values, size_t count);

/* Shares of values in bins of a quarter of sd about the mean; the outer two have all beyond. sd >
 * 0.
 */
enum { ASPI_HISTOGRAM = 40 };
#define ASPI_HISTOGRAM_BIN 0.25
void aspi_histogram(const double *values, size_t count, double mean, double sd,
                    double share[ASPI_HISTOGRAM]);

/* D_KL (eq. 2, natural logarithm) of a normal distribution from that histogram. An estimate from N
 * independent values is about B/(2N) too high, where B is the number of bins that have values. */
double aspi_kl_normal(const double *values, size_t count, double mean, double sd);

/* Slopes that a disc, rolling over the first profile, meets in the middle between neighboring
 * points, into `out`; *count is how many there are: the number of points, one less on a profile
 * that is not periodic. */
asp_code aspi_profile_slopes(const asp_heights *profile, double d_p, double *out, size_t *count,
                             asp_error *error);

/* The contact slopes of all profiles for one particle size, in numbers. */
typedef struct aspi_slopes {
  double slope_rms;          /* s_eff */
  aspi_moments slope, angle; /* angle in rad */
  double kl_normal;          /* D_KL of the normal distribution with the angles' mean and sd */
} aspi_slopes;

asp_code aspi_profile_describe_slopes(const asp_heights *profile, double d_p, aspi_slopes *slopes,
                                      asp_error *error);
