/* The quantile of a log-concave law whose distribution has no inverse in closed form: Newton's
 * method on the logarithm of the nearer tail, which for such a law converges from any start, kept
 * inside a bracket that shrinks with every step. A fixed bound on the steps, and no way to fail.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_INVERT_H
#define ASP_SPREAD_INVERT_H

/* A law at one point: the shares below and above it, and the density. */
typedef struct aspi_point {
  double below, above, density;
} aspi_point;

/* The x in [lo, hi] with a share u below it, 0 < u < 1; `at` is the law, `law` its parameters. A
 * guess that is not above lo says that the root cannot be told from lo. */
double aspi_invert(aspi_point (*at)(const void *law, double x), const void *law, double lo,
                   double hi, double guess, double u);

#endif
