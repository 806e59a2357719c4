/* The paper's choice: a Weibull distribution from b = -alpha1/2 on (eq. 8), fitted to the truncated
 * normal one, with no density at b, where the particle would slide along the wall.
 *
 * Shape k and scale lambda/sigma depend on tau = alpha1/sigma alone, because those of
 * `truncated` do; so ten numbers replace the paper's database of polynomials per roughness and
 * particle size. They were fitted for this project to the pairs of least D_KL(truncated ||
 * Weibull), from which they are off by up to 0.022 in k and 0.004 in lambda/sigma, and 3e-5 in
 * D_KL; see examples/paper_figures. Beyond tau = 6.48, the paper's boundary angle e, the
 * distribution is normal, and the closest Weibull distribution (k = 3.602) is kept, without a step.
 * It is cut at the steepest face, as all are.
 *
 * Eq. 10 of the paper is misprinted: inverting eq. 8 gives delta = b + lambda (-ln(1 - u))^(1/k).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/models.h"

#include <math.h>

/* The paper's boundary angle e over sigma. */
#define TAU_END 6.48

/* Shape and scale as polynomials of fourth degree in tau = alpha1/sigma, written around the end so
 * that they arrive there at the values that hold beyond it: k = 3.602, and the lambda that makes
 * the mean zero, 3.24/Gamma(1 + 1/3.602) (sd 0.9991). */
aspi_weibull aspi_weibull_at(double sigma, double alpha1) {
  double tau = fmin(alpha1 / sigma, TAU_END), ahead = tau - TAU_END, tau2 = tau * tau;
  double k = (0.3607531 + tau * 0.0404840) + tau2 * (0.0037227 - tau * 0.0007002);
  double scale = (0.4221985 + tau * 0.0357573) - tau2 * (0.0019619 + tau * 0.0002228);
  return (aspi_weibull){-0.5 * tau * sigma, 3.602 + ahead * k,
                        (3.595474673403 + ahead * scale) * sigma};
}

/* The share of the uncut distribution beyond the steepest face. */
static double lost_beyond(aspi_weibull w) {
  return exp(-pow((ASP_DELTA_MOST - w.b) / w.lambda, w.k));
}

static double density(const aspi_spread_input *input, double delta) {
  aspi_weibull w = aspi_weibull_at(input->sigma, input->alpha1);
  if (delta <= w.b || delta > ASP_DELTA_MOST)
    return 0;
  double y = (delta - w.b) / w.lambda;
  return w.k / w.lambda * pow(y, w.k - 1) * exp(-pow(y, w.k)) / (1 - lost_beyond(w));
}

static double distribution(const aspi_spread_input *input, double delta) {
  aspi_weibull w = aspi_weibull_at(input->sigma, input->alpha1);
  if (delta <= w.b)
    return 0;
  if (delta >= ASP_DELTA_MOST)
    return 1;
  return -expm1(-pow((delta - w.b) / w.lambda, w.k)) / (1 - lost_beyond(w));
}

/* In the upper half by the share above, which for u near 1 keeps its digits. */
static double quantile(const aspi_spread_input *input, double u) {
  if (input->sigma < ASP_SIGMA_ZERO)
    return 0;
  aspi_weibull w = aspi_weibull_at(input->sigma, input->alpha1);
  double lost = lost_beyond(w);
  double power = u < 0.5 ? -log1p(u * (lost - 1)) : -log((1 - u) + u * lost);
  return fmin(w.b + w.lambda * pow(power, 1 / w.k), ASP_DELTA_MOST);
}

const asp_spread_model aspi_spread_weibull = {
    .name = "weibull",
    .summary = "Weibull distribution fitted to truncated; no rebound slides along the wall",
    .source = "Altmeppen et al. 2020, eq. 8; ten coefficients refitted for this project",
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
};
