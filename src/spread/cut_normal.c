/* The normal distribution cut to an interval (eq. 5 to 7); see models.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/gauss.h"
#include "spread/models.h"

#include <gsl/gsl_cdf.h>

/* The share beyond x. */
static double tail(double x) {
  return aspi_gauss_below(-x);
}

/* The x with Phi(x) = p = 1 - q. Takes both p and q, so that neither tail loses digits. */
static double normal_quantile(double p, double q) {
  return p < q ? gsl_cdf_ugaussian_Pinv(p) : gsl_cdf_ugaussian_Qinv(q);
}

/* Probability left after both cuts. */
static double mass(double sigma, double lo, double hi) {
  return 1 - tail(-lo / sigma) - tail(hi / sigma);
}

double aspi_cut_normal_density(double sigma, double lo, double hi, double delta) {
  if (delta < lo || delta > hi)
    return 0;
  double x = delta / sigma;
  return exp(-0.5 * x * x) / (sqrt(2 * ASP_PI) * sigma * mass(sigma, lo, hi));
}

double aspi_cut_normal_distribution(double sigma, double lo, double hi, double delta) {
  if (delta <= lo)
    return 0;
  if (delta >= hi)
    return 1;
  return (aspi_gauss_below(delta / sigma) - tail(-lo / sigma)) / mass(sigma, lo, hi);
}

double aspi_cut_normal_quantile(double sigma, double lo, double hi, double u) {
  double below = tail(-lo / sigma), above = tail(hi / sigma), rest = 1 - u;
  double moved = rest * below - u * above; /* maps u to the share of the uncut distribution */
  return fmin(fmax(sigma * normal_quantile(u + moved, rest - moved), lo), hi);
}
