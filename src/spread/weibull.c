/* The paper's choice: a Weibull distribution from b = -alpha1/2 on (eq. 8), fitted to the truncated
 * normal one, with no density at b, where the particle would slide along the wall.
 *
 * Shape k and scale lambda/sigma depend on tau = alpha1/sigma alone, because the truncated law
 * does; so ten numbers replace the paper's database of polynomials per roughness and particle size.
 * They were fitted for this project to the pairs of least D_KL(truncated || Weibull), from which
 * they are off by up to 0.022 in k and 0.004 in lambda/sigma, and 3e-5 in D_KL; see `asperity fit`.
 * Beyond tau = 6.48, the paper's boundary angle e, the law is the normal one, and its Weibull twin
 * (k = 3.602) is kept; there is no step there.
 *
 * Eq. 10 of the paper is misprinted: inverting eq. 8 gives delta = b + lambda (-ln(1 - u))^(1/k).
 */
#include "spread/weibull.h"

/* The share of the uncut law below the steepest face. */
static inline double mass(double sigma, double alpha1, asp_weibull_law w) {
  return asp_weibull_uncut(sigma, alpha1) ? 1 : 1 - asp_weibull_lost(w);
}

static double density(const asp_view *view, double delta) {
  asp_weibull_law w = asp_weibull_at(view->sigma, view->alpha1);
  if (delta <= w.b || delta > ASP_DELTA_MOST)
    return 0;
  double y = (delta - w.b) / w.lambda;
  return w.k / w.lambda * pow(y, w.k - 1) * exp(-pow(y, w.k)) / mass(view->sigma, view->alpha1, w);
}

static double distribution(const asp_view *view, double delta) {
  asp_weibull_law w = asp_weibull_at(view->sigma, view->alpha1);
  if (delta <= w.b)
    return 0;
  if (delta >= ASP_DELTA_MOST)
    return 1;
  return -expm1(-pow((delta - w.b) / w.lambda, w.k)) / mass(view->sigma, view->alpha1, w);
}

/* Up to this change of the logarithm, the cut is a correction in three terms. */
#define SMALL_CHANGE 1e-5

/* (delta - b)/lambda of the uncut law, corrected for the share that the cut takes. The steps to
 * that share stand between those to the quantile, so that none waits for the other: it comes in
 * time for the correction, which is nearly always enough. */
static inline double cut_place(asp_weibull_law w, double u) {
  double reach = log((ASP_DELTA_MOST - w.b) / w.lambda), uncut = asp_minus_log_rest(u);
  double exponent = exp(w.k * reach), log_uncut = log(uncut), q = 1 / w.k;
  double lost = exp(-exponent), place = exp(q * log_uncut);
  double change = u * lost / ((1 - u) * uncut), more = change * uncut;
  if (!(change < SMALL_CHANGE))
    return exp(q * log(asp_minus_log_cut(u, lost)));
  change *= 1 - more * (0.5 - 1 / 3. * more);
  return place * (1 - q * change * (1 + 0.5 * (1 - q) * change));
}

static double quantile(const asp_view *view, double u) {
  if (view->sigma < ASP_SIGMA_ZERO)
    return 0;
  asp_weibull_law w = asp_weibull_at(view->sigma, view->alpha1);
  double place;
  if (asp_weibull_uncut(view->sigma, view->alpha1))
    place = exp(log(asp_minus_log_rest(u)) / w.k);
  else
    place = cut_place(w, u);
  double delta = w.b + w.lambda * place;
  return delta < ASP_DELTA_MOST ? delta : ASP_DELTA_MOST;
}

const asp_spread_model asp_spread_weibull = {
    .name = "weibull",
    .summary = "Weibull distribution fitted to the truncated one: no sliding rebounds",
    .source = "Altmeppen et al. 2020, eq. 8; ten coefficients refitted for this project",
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
    .quantile_n = asp_weibull_quantile_n,
};
