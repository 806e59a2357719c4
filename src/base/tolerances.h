/* Relative differences that count as rounding. C and C++.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <math.h>

/* For numbers from a text or a long sum: files have 6 to 9 digits. */
#define ASPI_ROUNDING_TEXT 1e-9

/* For double precision after a few operations, which has 16 digits. */
#define ASPI_ROUNDING_DOUBLE 1e-12

/* For a component of a velocity that went through an engine's steps and frames. */
#define ASPI_ROUNDING_PART 1e-6

/* The share of a velocity that is along the wall at 89.99 degrees: above, an impact is normal. */
#define ASPI_NORMAL_PART 1.7453292e-4

/* a/b; NAN if b is no more than this share of `whole`. */
static inline double aspi_quotient(double a, double b, double share, double whole) {
  return fabs(b) > share * whole ? a / b : NAN;
}
