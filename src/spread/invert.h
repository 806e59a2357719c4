/* The quantile of a log-concave distribution without a closed inverse: Newton's method on the
 * logarithm of the nearer tail, which converges from any start, inside a bracket that shrinks with
 * every step. The number of steps is bounded, and it cannot fail.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_INVERT_H
#define ASP_SPREAD_INVERT_H

/* A distribution at one point: the shares below and above it, and the density. */
typedef struct aspi_point {
  double below, above, density;
} aspi_point;

/* The x in [lo, hi] with a share u below it, 0 < u < 1; `at` is the distribution, `parameters` its
 * first argument. Returns lo if the guess is not above lo. */
double aspi_invert(aspi_point (*at)(const void *parameters, double x), const void *parameters,
                   double lo, double hi, double guess, double u);

#endif
