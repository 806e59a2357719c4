/* Quantiles of many contacts at once: the straight code of weibull.h and visible.h in vector loops.
 * What the straight code does not cover is done again, one by one. */
#include "simd.h"
#include "spread/models.h"
#include "spread/visible.h"
#include "spread/weibull.h"

/* Smaller sigmas would overflow alpha1/sigma; there the tilt is 0. */
static inline double weibull(double sigma, double alpha1, double u, bool cut) {
  asp_weibull_law w = asp_weibull_at(sigma, alpha1);
  double rest = cut ? asp_minus_log_cut(u, asp_weibull_lost(w)) : asp_minus_log_rest(u);
  double place = w.b + w.lambda * exp(log(rest) / w.k);
  place = place < ASP_DELTA_MOST ? place : ASP_DELTA_MOST;
  return sigma < ASP_SIGMA_ZERO ? 0 : place;
}

ASP_EACH_MACHINE
void asp_weibull_quantile_n(const asp_views *views, size_t n, const double *u, double *delta) {
  const double *sigma = views->sigma, *alpha1 = views->alpha1;
  bool cut = false;
  for (size_t i = 0; i < n; i++)
    cut |= !asp_weibull_uncut(sigma[i], alpha1[i]);
  if (cut) {
#pragma omp simd
    for (size_t i = 0; i < n; i++)
      delta[i] = weibull(sigma[i], alpha1[i], u[i], true);
  } else {
#pragma omp simd
    for (size_t i = 0; i < n; i++)
      delta[i] = weibull(sigma[i], alpha1[i], u[i], false);
  }
}

ASP_EACH_MACHINE
static void visible_n(const asp_views *views, size_t n, const double *u, double *delta) {
  const double *slope = views->slope, *alpha1 = views->alpha1;
  const double *table = asp_visible_table[0][0];
  double t[ASP_BATCH], s[ASP_BATCH];
  int cell[ASP_BATCH];
#pragma omp simd
  for (size_t i = 0; i < n; i++) {
    asp_visible_place at = asp_visible_find(asp_turn_by(alpha1[i]), slope[i], u[i]);
    int column = at.column < ASP_VISIBLE_COLUMNS ? at.column : 0;
    cell[i] = (at.row * ASP_VISIBLE_COLUMNS + (column > 0 ? column : 0)) * ASP_VISIBLE_TERMS;
    t[i] = at.t;
    s[i] = at.s;
  }
#pragma omp simd
  for (size_t i = 0; i < n; i++) {
    double p = asp_visible_at(table + cell[i], t[i], s[i]) * slope[i];
    delta[i] = copysign(asp_arc(fabs(p), 1), p);
  }
}

void asp_visible_quantile_n(const asp_views *views, size_t n, const double *u, double *delta) {
  visible_n(views, n, u, delta);
  for (size_t i = 0; i < n; i++)
    if (views->sigma[i] < ASP_SIGMA_ZERO || !asp_visible_is_quick(views->alpha1[i], u[i])) {
      asp_view one = asp_views_at(views, i);
      delta[i] = asp_spread_visible.quantile(&one, u[i]);
    }
}
