/* Relative differences that count as rounding. C and C++.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_BASE_TOLERANCES_H
#define ASP_BASE_TOLERANCES_H

#include <math.h>

/* Of numbers that went through a text or a sum of many: files have 6 to 9 digits. */
#define ASPI_ROUNDING_TEXT 1e-9

/* Of numbers in double precision after a few operations: they have 16 digits. */
#define ASPI_ROUNDING_DOUBLE 1e-12

/* Of a component of a velocity that went through an engine's steps and frames. */
#define ASPI_ROUNDING_PART 1e-6

/* a/b; NAN if b is only rounding of a part of `whole`. */
static inline double aspi_quotient(double a, double b, double whole) {
  return fabs(b) > ASPI_ROUNDING_PART * whole ? a / b : NAN;
}

#endif
