/* Heights of a wall inside the core.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"

/* Row after row, x along a row. A profile is a map with one row; step[1] is not used. Several
 * profiles of one wall are a chain: each has a spacing and a mean of its own, nothing is joined at
 * their ends, and numbers of the wall are means by length. Functions of one path or slope after the
 * other take the first one alone, which their names say by `profile`. */
struct asp_heights {
  size_t columns, rows;
  double step[2]; /* between columns, between rows */
  bool periodic;
  double *z;
  asp_heights *next; /* NULL: the last, or a map */
};

/* A wall shorter than this, in correlation lengths, tells little about its roughness. */
#define ASPI_LENGTHS_LEAST 20.0

/* Least points of a side (a profile has one row), and most points in all: GSL's radix-2 FFT shifts
 * an int. */
enum { ASP_SIDE_LEAST = 3 };
#define ASP_POINTS_MOST ((size_t)1 << 30)

/* "profile" or "map". */
static inline const char *aspi_kind_of_rows(size_t rows) {
  return rows > 1 ? "map" : "profile";
}

/* The length of one profile. */
static inline double aspi_profile_length(const asp_heights *profile) {
  return (double)profile->columns * profile->step[0];
}

/* The widest spacing, the shortest profile or side, and that or the length of all profiles. */
typedef struct aspi_extent {
  double spacing, length, total;
} aspi_extent;
aspi_extent aspi_heights_extent(const asp_heights *heights);

/* Uninitialized room for numbers, or NULL. */
double *aspi_allocate(size_t count);

/* Heights that own `z` (from malloc; NULL: out of memory). On failure `z` is freed. */
asp_heights *aspi_heights_adopt(double *z, size_t columns, size_t rows, const double step[2],
                                bool periodic, asp_error *error);
asp_heights *aspi_profile_adopt(double *z, size_t points, double spacing, bool periodic,
                                asp_error *error);

/* A Gaussian profile (Garcia & Stoll 1984, secondary source): white noise filtered so that the
 * autocovariance is r_q^2 exp(-x^2/lambda_c^2); periodic. At least 20 lambda_c long, points at most
 * lambda_c/4 apart. The ensemble has r_q and lambda_c; one sample has them within its sampling
 * error. The same seed gives the same profile. */
asp_heights *aspi_profile_generate(double r_q, double lambda_c, double spacing, size_t points,
                                   uint32_t seed, asp_error *error);

/* The same, scaled to the ensemble's mean square difference between neighbors, times `sign`, 1 or
 * -1: the negative of a sample is another sample. With flights in both directions, these take most
 * of the sampling error of a short profile out of the law of the first hit. */
asp_heights *aspi_profile_generate_scaled(double r_q, double lambda_c, double spacing,
                                          size_t points, uint32_t seed, int sign, asp_error *error);

/* The wall for particles that fly the other way along x. */
asp_heights *aspi_profile_mirrored(const asp_heights *profile, asp_error *error);

/* The least power of two that is at least that. */
size_t aspi_power_of_two(size_t least);

/* Filters n = 2^k complex numbers on a circle, in place: the spectrum is multiplied by
 * exp(-pi (f width)^2), which is a weight exp(-pi (x/width)^2) on the circle. */
void aspi_smooth(double *data, size_t n, double spacing, double width);

/* GSL's complex FFT over rows and columns of 2^k points each, in place and without a norm; backward
 * with the positive sign. `room` is for aspi_fft2_room(rows) numbers. */
size_t aspi_fft2_room(size_t rows);
void aspi_fft2(double *data, size_t columns, size_t rows, bool backward, double *room);
