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

static inline bool is_quick(double sigma, double alpha1, double u) {
  return (sigma >= ASP_SIGMA_ZERO) & asp_visible_is_quick(alpha1, u);
}

/* False where there are some that are not quick; their deltas mean nothing. */
ASP_EACH_MACHINE
static bool visible_n(const asp_views *views, size_t n, const double *u, double *delta) {
  const double *slope = views->slope, *sigma = views->sigma, *alpha1 = views->alpha1;
  double t[ASP_BATCH], s[ASP_BATCH], p[ASP_BATCH], cell[ASP_BATCH], most = 0, slow = 0;
#pragma omp simd reduction(+ : slow)
  for (size_t i = 0; i < n; i++) {
    bool quick = is_quick(sigma[i], alpha1[i], u[i]);
    asp_visible_place at = asp_visible_find(asp_turn_by(alpha1[i]), slope[i], u[i]);
    cell[i] = quick ? at.cell : 0;
    t[i] = at.t;
    s[i] = at.s;
    slow += quick ? 0 : 1;
  }
#pragma omp simd reduction(max : most)
  for (size_t i = 0; i < n; i++) {
    p[i] = asp_visible_at(cell[i], t[i], s[i]) * slope[i];
    most = most > fabs(p[i]) ? most : fabs(p[i]);
  }
  if (most <= ASP_TAN_PI_8)
#pragma omp simd
    for (size_t i = 0; i < n; i++)
      delta[i] = p[i] + asp_arc_less(p[i]);
  else
#pragma omp simd
    for (size_t i = 0; i < n; i++)
      delta[i] = copysign(asp_arc(fabs(p[i]), 1), p[i]);
  return !(slow > 0);
}

void asp_visible_quantile_n(const asp_views *views, size_t n, const double *u, double *delta) {
  if (visible_n(views, n, u, delta))
    return;
  for (size_t i = 0; i < n; i++)
    if (!is_quick(views->sigma[i], views->alpha1[i], u[i])) {
      asp_view one = asp_views_at(views, i);
      delta[i] = asp_spread_visible.quantile(&one, u[i]);
    }
}
