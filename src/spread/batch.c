/* Quantiles of many contacts at once: the straight code of weibull.h and visible.h in loops that
 * the compiler turns into vector code, for the vector units that it finds at run time. The GNU C
 * library has vector versions of the functions in them; declaring that is all it takes. What the
 * straight code does not cover is done again, one by one. */
#include "spread/models.h"
#include "spread/visible.h"
#include "spread/weibull.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 35)
#define VECTOR __attribute__((simd("notinbranch")))
VECTOR double exp(double);
VECTOR double log(double);
VECTOR double tan(double);
VECTOR double atan(double);
#define FOR_EACH_MACHINE __attribute__((target_clones("avx512f", "avx2", "default")))
#endif
#endif
#ifndef FOR_EACH_MACHINE
#define FOR_EACH_MACHINE
#endif

FOR_EACH_MACHINE
void asp_weibull_quantile_n(const asp_view *view, size_t n, const double *alpha1, const double *u,
                            double *delta) {
  double sigma = view->sigma;
  if (sigma < ASP_SIGMA_ZERO) {
    for (size_t i = 0; i < n; i++)
      delta[i] = 0;
    return;
  }
#pragma omp simd
  for (size_t i = 0; i < n; i++) {
    asp_weibull_law w = asp_weibull_at(sigma, alpha1[i]);
    double reach = w.k * log((ASP_DELTA_MOST - w.b) / w.lambda);
    double mass = reach < 3.62 ? 1 - exp(-exp(reach)) : 1;
    double place = w.b + w.lambda * exp(log(asp_minus_log_rest(u[i] * mass)) / w.k);
    delta[i] = place < ASP_DELTA_MOST ? place : ASP_DELTA_MOST;
  }
}

FOR_EACH_MACHINE
void asp_visible_quantile_n(const asp_view *view, size_t n, const double *alpha1, const double *u,
                            double *delta) {
  double slope = view->slope;
#pragma omp simd
  for (size_t i = 0; i < n; i++)
    delta[i] = atan(asp_visible_quick(tan(alpha1[i]) / slope, u[i]) * slope);
  asp_view each = *view;
  for (size_t i = 0; i < n; i++)
    if (!(u[i] >= ASP_VISIBLE_U_LEAST) || alpha1[i] < 0 || view->sigma < ASP_SIGMA_ZERO) {
      each.alpha1 = alpha1[i];
      delta[i] = asp_spread_visible.quantile(&each, u[i]);
    }
}
