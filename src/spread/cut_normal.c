/* The normal distribution cut to an interval (eq. 5 to 7); see models.h. */
#include "spread/models.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

/* Phi(x), with full relative precision in the lower tail. */
static double phi_below(double x) {
  return 0.5 * erfc(-x * M_SQRT1_2);
}

/* What the cuts leave of the whole. */
static double mass(double sigma, double lo, double hi) {
  return 1 - phi_below(lo / sigma) - phi_below(-hi / sigma);
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
  return (phi_below(delta / sigma) - phi_below(lo / sigma)) / mass(sigma, lo, hi);
}

double asp_cut_normal_quantile(double sigma, double lo, double hi, double u) {
  double below = phi_below(lo / sigma), above = phi_below(-hi / sigma);
  double left = 1 - below - above;
  double p = below + u * left;
  double x = p < 0.5 ? gsl_cdf_ugaussian_Pinv(p) : gsl_cdf_ugaussian_Qinv(above + (1 - u) * left);
  return fmin(fmax(sigma * x, lo), hi);
}
