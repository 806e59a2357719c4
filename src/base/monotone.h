/* Interpolation by cubic pieces that are monotone where their points are, so that nothing
 * overshoots (Steffen 1990, "A simple method for monotonic interpolation in one dimension", Astron.
 * Astrophys. 239, 443).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stddef.h>

/* The tangents at count >= 2 points with rising x (NULL: 0, 1, 2, ...); at both ends the slope of
 * the first and the last chord, so that two points make a straight line. */
void aspi_monotone_tangents(const double *x, const double *y, size_t count, double *tangent);

/* The value at x[0] <= at <= x[count - 1]. */
double aspi_monotone_at(const double *x, const double *y, const double *tangent, size_t count,
                        double at);

/* One piece of width h, `at` from its beginning, by its values and tangents at both ends. */
static inline double aspi_cubic_piece(double h, double at, const double y[2], const double t[2]) {
  double chord = (y[1] - y[0]) / h;
  double c3 = (t[0] + t[1] - 2 * chord) / (h * h), c2 = (3 * chord - 2 * t[0] - t[1]) / h;
  return y[0] + at * (t[0] + at * (c2 + at * c3));
}
