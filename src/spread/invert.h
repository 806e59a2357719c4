/* The quantile of a log-concave distribution without a closed inverse: Newton's method on the
 * logarithm of the nearer tail, which converges from any start, inside a bracket that shrinks with
 * every step; near the root a step of fifth order, of which a good guess needs one. The number of
 * steps is bounded, and it cannot fail.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdbool.h>

/* A distribution at one point: the share below (or above) it, the density, and the first three
 * derivatives of the density's logarithm. */
typedef struct aspi_node {
  double share, density, log_rise[3];
} aspi_node;

/* The x in [lo, hi] with a share u below it, 0 < u < 1; `at` is the distribution, with the share
 * above x if `upper`, and `parameters` its first argument. Returns lo if the guess is not above lo.
 */
double aspi_invert(aspi_node (*at)(const void *parameters, double x, bool upper),
                   const void *parameters, double lo, double hi, double guess, double u);
