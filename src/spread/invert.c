/* Quantiles by Newton's method; see invert.h. If the support ends above, Newton's method on the
 * logarithm overshoots, so it works on the tail.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/invert.h"

#include <math.h>

enum { STEPS = 24 };

/* Least u; below it the derivatives of the density would overflow. */
#define LEAST 1e-150

/* Below the first, in lengths over which the density changes, a step is of fifth order: the error
 * is the step to the fifth power. Below the second the error is rounding. */
#define NEAR 0.05
#define SMALL 6e-4

/* Newton's step from x in the logarithm of the lower tail, which is `share` at the root. Infinite
 * if the tail or the density underflows: no quotient overflows. */
static double log_step(const aspi_node *p, double share) {
  if (!(p->share > 1e-300 * share && p->density > LEAST * p->share))
    return INFINITY;
  return p->share / p->density * log(share / p->share);
}

/* The series of the inverse distribution in the missing share over the density, to its fourth term
 * (Lagrange). */
static double series(double h, const double g[3]) {
  double third = 1. / 6 * (2 * g[0] * g[0] - g[1]);
  double fourth = 1. / 24 * (g[0] * (6 * g[0] * g[0] - 7 * g[1]) + g[2]);
  return h * (1 - h * (0.5 * g[0] - h * (third - h * fourth)));
}

double aspi_invert(aspi_node (*at)(const void *parameters, double x, bool upper),
                   const void *parameters, double lo, double hi, double guess, double u) {
  bool upper = u >= 0.5;
  double share = upper ? 1 - u : fmax(u, LEAST), sign = upper ? -1 : 1;
  double x = guess < hi ? guess : 0.5 * (lo + hi);
  if (!(x > lo))
    return lo;
  for (int i = 0; i < STEPS; i++) {
    aspi_node p = at(parameters, x, upper);
    double missing = sign * (share - p.share);
    double h = p.density > LEAST * fabs(missing) ? missing / p.density : INFINITY;
    double length = fabs(h) * (fabs(p.log_rise[0]) + sqrt(-p.log_rise[1]));
    double next = x + (length < NEAR ? series(h, p.log_rise) : sign * log_step(&p, share));
    if (length < SMALL)
      return next < lo ? lo : next < hi ? next : hi;
    *(missing > 0 ? &lo : &hi) = x;
    if (!(next > lo && next < hi) && upper)
      next = x + h;
    x = next > lo && next < hi ? next : 0.5 * (lo + hi);
  }
  return x;
}
