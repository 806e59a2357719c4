/* Quantiles by Newton's method on the logarithm of a tail; see invert.h. Where the support ends
 * above, the logarithm overshoots, and the step is in the tail itself.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/invert.h"

#include <math.h>

enum { STEPS = 24 };

/* Smaller shares are taken for this one: their squares of a distance would underflow. */
#define LEAST 1e-290

/* After a step of this size, relative to the distance from the nearer end, the next one would be
 * below rounding: the error squares. */
#define SMALL 1e-8

/* Newton's step from x toward a share u below, in the logarithm of the tail that is the smaller
 * one at the root. Infinite where the tail or the density has run out: no quotient overflows. */
static double step(aspi_point p, double u) {
  double tail = u < 0.5 ? p.below : p.above, share = u < 0.5 ? u : 1 - u;
  if (!(tail > 1e-300 * share && p.density > LEAST * tail))
    return INFINITY;
  double toward = tail / p.density * log(share / tail);
  return u < 0.5 ? toward : -toward;
}

static double straight_step(aspi_point p, double u) {
  double missing = p.above - (1 - u);
  return p.density > LEAST * fabs(missing) ? missing / p.density : INFINITY;
}

double aspi_invert(aspi_point (*at)(const void *parameters, double x), const void *parameters,
                   double lo, double hi, double guess, double u) {
  const double begin = lo, end = hi;
  u = fmax(u, LEAST);
  double x = guess < hi ? guess : 0.5 * (lo + hi);
  if (!(x > lo))
    return lo;
  for (int i = 0; i < STEPS; i++) {
    aspi_point p = at(parameters, x);
    double next = x + step(p, u);
    if (fabs(next - x) <= SMALL * fmin(x - begin, end - x))
      return fmin(fmax(next, lo), hi);
    if (u < 0.5 ? p.below < u : p.above > 1 - u)
      lo = x;
    else
      hi = x;
    if (!(next > lo && next < hi) && u >= 0.5)
      next = x + straight_step(p, u);
    if (!(next > lo && next < hi))
      next = 0.5 * (lo + hi);
    x = next;
  }
  return x;
}
