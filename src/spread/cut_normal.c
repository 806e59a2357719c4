/* The normal distribution cut to an interval (eq. 5 to 7); see models.h. */
#include "spread/gauss.h"
#include "spread/models.h"

/* The tail beyond this has nothing left, in doubles, next to 1. */
#define FAR 8.3

/* Q(x) for x >= 0. */
static inline double tail(double x) {
  return x > FAR ? 0 : asp_gauss_above(x, asp_gauss_density(x));
}

/* What the cuts leave of the whole. */
static double mass(double sigma, double lo, double hi) {
  return 1 - tail(-lo / sigma) - tail(hi / sigma);
}

double asp_cut_normal_density(double sigma, double lo, double hi, double delta) {
  if (delta < lo || delta > hi)
    return 0;
  double x = delta / sigma;
  return exp(-0.5 * x * x) / (sqrt(2 * ASP_PI) * sigma * mass(sigma, lo, hi));
}

double asp_cut_normal_distribution(double sigma, double lo, double hi, double delta) {
  if (delta <= lo)
    return 0;
  if (delta >= hi)
    return 1;
  return (asp_gauss_below(delta / sigma) - tail(-lo / sigma)) / mass(sigma, lo, hi);
}

double asp_cut_normal_quantile(double sigma, double lo, double hi, double u) {
  double below = tail(-lo / sigma), above = tail(hi / sigma), left = 1 - below - above;
  double x = asp_gauss_quantile(below + u * left, above + (1 - u) * left);
  return asp_within(sigma * x, lo, hi);
}
