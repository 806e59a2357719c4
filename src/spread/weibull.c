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
#include "spread/cells.h"
#include "spread/weibull.h"
#include "spread/weibull_cut.h"

#include "weibull_table.inc"

/* The share of the uncut law beyond the steepest face, which is at x. */
static double lost_beyond(double k, double x) {
  return exp(-exp(k * log(x)));
}

static inline double steepest(asp_weibull_law w) {
  return (ASP_DELTA_MOST - w.b) / w.lambda;
}

/* What is below it. */
static double mass(double sigma, double alpha1, asp_weibull_law w) {
  return asp_weibull_uncut(sigma, alpha1) ? 1 : 1 - lost_beyond(w.k, steepest(w));
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

/* The same, from tables where it is small: for a correction some eight digits are enough. */
static inline double quick_lost_beyond(double k, double x) {
  if (x >= 1 && x < 1 << ASP_CUT_OCTAVES) {
    double log_x = asp_powers(log_table + asp_eighth(x, 1) * ASP_POWERS, asp_over_eighth(x));
    double place = k * ASP_CUT_PER_UNIT * log_x - ASP_CUT_FIRST * ASP_CUT_PER_UNIT;
    double cell = asp_nearest(place);
    if (place > ASP_CUT_CELLS - 1)
      return 0;
    if (place >= 0)
      return asp_powers(lost_table + (int)cell * ASP_POWERS, place - cell);
  }
  return lost_beyond(k, x);
}

/* Up to this change of the logarithm, the cut is a correction to second order. */
#define SMALL_CHANGE 1e-6

/* (delta - b)/lambda of the uncut law, corrected for the share that the cut takes. What does not
 * need that share is worked out on the way to it. */
static inline double cut_place(asp_weibull_law w, double u) {
  double uncut = asp_minus_log_rest(u), log_uncut = log(uncut), q = 1 / w.k;
  double lost = quick_lost_beyond(w.k, steepest(w));
  double change = u / ((1 - u) * uncut) * lost, second = 0.5 * (1 - q - uncut);
  double place = exp(q * log_uncut);
  if (!(change < SMALL_CHANGE))
    return exp(q * log(asp_minus_log_cut(u, lost)));
  return place - place * q * change * (1 + second * change);
}

static double quantile(const asp_view *view, double u) {
  if (view->sigma < ASP_SIGMA_ZERO)
    return 0;
  asp_weibull_law w = asp_weibull_at(view->sigma, view->alpha1);
  double place;
  if (asp_weibull_uncut(view->sigma, view->alpha1)) {
    double q = 1 / w.k; /* ready before the logarithms are */
    place = exp(q * log(asp_minus_log_rest(u)));
  } else
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
};
