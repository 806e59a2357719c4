/* Slopes that particles find on a profile, and their density.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SURFACE_SLOPES_H
#define ASP_SURFACE_SLOPES_H

#include "asperity.h"

/* Mean, standard deviation, skewness, and excess kurtosis (0 for a normal distribution). */
typedef struct aspi_moments {
  double mean, sd, skewness, kurtosis;
} aspi_moments;

aspi_moments aspi_moments_of(const double *values, size_t count);

/* A density on equally spaced points, by a Gaussian kernel: value[i] at lo + i step. */
typedef struct aspi_density {
  double lo, step, bandwidth;
  size_t points;
  double value[];
} aspi_density;

/* Kernel density estimate of at least two values, not all equal, at `points` (2 to 65536) points
 * from lo to hi. Bandwidth min(sd, quartile distance/1.349) (4/(3 count))^(1/5). Normalized over lo
 * to hi; values outside are left out. NULL on error; to be freed. */
aspi_density *aspi_density_create(const double *values, size_t count, double lo, double hi,
                                  size_t points, asp_error *error);

/* D_KL (eq. 2, natural logarithm) of the density against a normal distribution. An estimate from N
 * independent values is about B/(2N) too high, B the number of bins that the kernel is worth over 8
 * sd: 8 sd/(2 sqrt(pi) bandwidth). */
double aspi_density_kl_normal(const aspi_density *density, double mean, double sd);

/* Points of contact that are averaged over: the first two are for a uniformly spread center. */
typedef enum aspi_contact {
  ASP_CONTACT_ROLLED,   /* the smooth curve through the points: of a measured profile */
  ASP_CONTACT_DILATION, /* the points: of a generated profile, which are many */
  ASP_CONTACT_CLOSING   /* those again, by the slopes of the filtered profile; equal in law */
} aspi_contact;

/* Slopes that a disc meets between neighboring points, into `out`; *count is how many there are:
 * the number of points, one less on a profile that is not periodic. */
asp_code aspi_profile_slopes(const asp_profile *profile, double d_p, aspi_contact contact,
                             double *out, size_t *count, asp_error *error);

/* The contact slopes of a profile for one particle size, in numbers. */
typedef struct aspi_slopes {
  double slope_rms;          /* s_eff */
  aspi_moments slope, angle; /* angle in rad */
  double bandwidth;          /* of the density of the angles, rad */
  double kl_normal;          /* D_KL of the normal distribution with the angles' mean and sd */
} aspi_slopes;

asp_code aspi_profile_describe_slopes(const asp_profile *profile, double d_p, aspi_contact contact,
                                      aspi_slopes *slopes, asp_error *error);

#endif
