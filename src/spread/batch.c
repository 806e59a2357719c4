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

/* The look-up in the grid stays out of the vector loops. */
ASP_EACH_MACHINE
static void visible_n(const asp_views *views, size_t n, const double *u, double *delta) {
  const double *slope = views->slope, *alpha1 = views->alpha1;
  double a[ASP_BATCH], x[ASP_BATCH];
#pragma omp simd
  for (size_t i = 0; i < n; i++) {
    double steep = tan(alpha1[i]) / slope[i];
    a[i] = steep < ASP_VISIBLE_A_MOST ? steep : ASP_VISIBLE_A_MOST;
    x[i] = sqrt(sqrt(-2 * log(1 - u[i])));
  }
  for (size_t i = 0; i < n; i++)
    x[i] = asp_visible_guess(a[i] > 0 ? a[i] : 0, fmax(x[i], ASP_VISIBLE_LEAST));
#pragma omp simd
  for (size_t i = 0; i < n; i++)
    delta[i] = atan(asp_visible_refine(a[i], u[i], x[i]) * slope[i]);
}

void asp_visible_quantile_n(const asp_views *views, size_t n, const double *u, double *delta) {
  visible_n(views, n, u, delta);
  for (size_t i = 0; i < n; i++)
    if (!(u[i] >= ASP_VISIBLE_U_LEAST) || views->alpha1[i] < 0 ||
        views->sigma[i] < ASP_SIGMA_ZERO) {
      asp_view one = asp_views_at(views, i);
      delta[i] = asp_spread_visible.quantile(&one, u[i]);
    }
}
