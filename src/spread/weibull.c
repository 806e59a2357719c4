/* The paper's choice: a Weibull distribution from b = -alpha1/2 on (eq. 8), fitted to the truncated
 * normal one, with no density at b, where the particle would slide along the wall.
 *
 * Shape k and scale lambda/sigma depend on tau = alpha1/sigma alone, because the truncated law
 * does; so ten numbers replace the paper's database of polynomials per roughness and particle size.
 * They were fitted (least D_KL) for this project. Beyond tau = 6.48, the paper's boundary angle e,
 * the law is the normal one, and its Weibull twin (k = 3.602) is kept.
 *
 * Eq. 10 of the paper is misprinted: inverting eq. 8 gives delta = b + lambda (-ln(1 - u))^(1/k).
 */
#include "spread/models.h"

#include <math.h>

#define TAU_BOUNDARY 6.48

typedef struct law {
  double b, k, lambda;
} law;

static law law_at(const asp_view *view) {
  double sigma = view->sigma, tau = view->alpha1 / sigma;
  if (tau >= TAU_BOUNDARY)
    return (law){-3.2428 * sigma, 3.602, 3.5986 * sigma};
  double k = 1.259734 + tau * (0.115531 + tau * (0.002511 + tau * (0.012057 - tau * 0.001030)));
  double scale = 0.859665 + tau * (0.192191 + tau * (0.046609 + tau * (0.000058 - tau * 0.000276)));
  return (law){-view->alpha1 / 2, k, scale * sigma};
}

/* The share of the uncut law below the steepest face. 1 to the last bit when the exponent passes
 * 37; the cheap tests spare the power in nearly every contact (k is never below 1.25). */
static double mass(law w) {
  double reach = (ASP_DELTA_MOST - w.b) / w.lambda;
  if (reach > 18 || (w.k > 2 && reach > 6.1) || (w.k > 3 && reach > 3.35))
    return 1;
  return -expm1(-pow(reach, w.k));
}

static double density(const asp_view *view, double delta) {
  law w = law_at(view);
  if (delta <= w.b || delta > ASP_DELTA_MOST)
    return 0;
  double y = (delta - w.b) / w.lambda;
  return w.k / w.lambda * pow(y, w.k - 1) * exp(-pow(y, w.k)) / mass(w);
}

static double distribution(const asp_view *view, double delta) {
  law w = law_at(view);
  if (delta <= w.b)
    return 0;
  if (delta >= ASP_DELTA_MOST)
    return 1;
  return -expm1(-pow((delta - w.b) / w.lambda, w.k)) / mass(w);
}

static double quantile(const asp_view *view, double u) {
  if (view->sigma < ASP_SIGMA_ZERO)
    return 0;
  law w = law_at(view);
  double delta = w.b + w.lambda * pow(-log1p(-u * mass(w)), 1 / w.k);
  return fmin(delta, ASP_DELTA_MOST);
}

const asp_spread_model asp_spread_weibull = {
    .name = "weibull",
    .summary = "Weibull distribution fitted to the truncated one: no sliding rebounds",
    .source = "Altmeppen et al. 2020, eq. 8; ten coefficients refitted for this project",
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
};
