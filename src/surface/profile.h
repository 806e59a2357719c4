/* Profiles inside the core.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SURFACE_PROFILE_H
#define ASP_SURFACE_PROFILE_H

#include "asperity_internal.h"

enum { ASP_POINTS_LEAST = 3 };

/* True if it repeats; false if it continues beyond its ends as its mirror image. */
bool aspi_profile_periodic(const asp_profile *profile);

/* The most numbers that GSL's FFT by powers of two takes: it shifts an int. */
#define ASP_FFT_MOST ((size_t)1 << 30)

/* A profile that takes over `heights` (from malloc; NULL counts as out of memory), and frees them
 * when it fails. */
asp_profile *aspi_profile_adopt(double *heights, size_t points, double spacing, bool periodic,
                                asp_error *error);

/* asp_profile_create with its heights scaled so that the mean square of the differences between
 * neighbors is that of the ensemble, times `sign`, 1 or -1: the negative of a realization is
 * another one. With flights in both directions, these take most of the sampling error of a short
 * profile out of the law of the first hit. */
asp_profile *aspi_profile_create_scaled(double r_q, double lambda_c, double spacing, size_t points,
                                        uint32_t seed, int sign, asp_error *error);

/* The wall as particles see it that fly the other way. */
asp_profile *aspi_profile_mirrored(const asp_profile *profile, asp_error *error);

/* The least power of two that is at least that. */
size_t aspi_power_of_two(size_t least);

/* Uninitialized room for numbers, or NULL. */
double *aspi_allocate(size_t count);

#endif
