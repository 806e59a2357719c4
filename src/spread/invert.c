/* Quantiles by Newton's method on the logarithm of a tail; see invert.h. */
#include "spread/invert.h"

#include <math.h>

enum { STEPS = 24 };

/* Smaller shares are taken for this one: their squares of a distance would underflow. */
#define LEAST 1e-290

/* After a relative step of this size the next one would be below rounding: the error squares. */
#define SMALL 1e-9

/* Newton's step from x towards a share u below, in the logarithm of the tail that is the smaller
 * one at the root. Not a number where the tail or the density has run out. */
static double step(asp_point p, double u) {
  if (u < 0.5)
    return p.below / p.density * log(u / p.below);
  return -p.above / p.density * log((1 - u) / p.above);
}

double asp_invert(asp_point (*at)(const void *law, double x), const void *law, double lo, double hi,
                  double guess, double u) {
  u = fmax(u, LEAST);
  double x = guess < hi ? guess : 0.5 * (lo + hi);
  if (!(x > lo))
    return lo;
  for (int i = 0; i < STEPS; i++) {
    asp_point p = at(law, x);
    double next = x + step(p, u);
    if (fabs(next - x) <= SMALL * fabs(x))
      return fmin(fmax(next, lo), hi);
    if (u < 0.5 ? p.below < u : p.above > 1 - u)
      lo = x;
    else
      hi = x;
    if (!(next > lo && next < hi))
      next = 0.5 * (lo + hi);
    x = next;
  }
  return x;
}
