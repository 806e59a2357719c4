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

static inline double weibull(double sigma, double alpha1, double u, bool cut) {
  asp_weibull_law w = asp_weibull_at(sigma, alpha1);
  if (cut)
    u *= asp_weibull_mass(w);
  double place = w.b + w.lambda * exp(log(asp_minus_log_rest(u)) / w.k);
  return place < ASP_DELTA_MOST ? place : ASP_DELTA_MOST;
}

FOR_EACH_MACHINE
void asp_weibull_quantile_n(const asp_view *view, size_t n, const double *alpha1, const double *u,
                            double *delta) {
  double sigma = view->sigma;
  if (sigma < ASP_SIGMA_ZERO) {
    for (size_t i = 0; i < n; i++)
      delta[i] = 0;
  } else if (sigma < ASP_WEIBULL_UNCUT) {
#pragma omp simd
    for (size_t i = 0; i < n; i++)
      delta[i] = weibull(sigma, alpha1[i], u[i], false);
  } else {
#pragma omp simd
    for (size_t i = 0; i < n; i++)
      delta[i] = weibull(sigma, alpha1[i], u[i], true);
  }
}

/* Up to BLOCK quantiles. The look-up in the grid stays out of the vector loops. */
enum { BLOCK = 128 };

FOR_EACH_MACHINE
static void visible_block(double slope, size_t n, const double *alpha1, const double *u,
                          double *delta) {
  double a[BLOCK], x[BLOCK];
#pragma omp simd
  for (size_t i = 0; i < n; i++) {
    double steep = tan(alpha1[i]) / slope;
    a[i] = steep < ASP_VISIBLE_A_MOST ? steep : ASP_VISIBLE_A_MOST;
    x[i] = sqrt(sqrt(-2 * log(1 - u[i])));
  }
  for (size_t i = 0; i < n; i++)
    x[i] = asp_visible_guess(a[i] > 0 ? a[i] : 0, x[i]);
#pragma omp simd
  for (size_t i = 0; i < n; i++)
    delta[i] = atan(asp_visible_refine(a[i], u[i], x[i]) * slope);
}

void asp_visible_quantile_n(const asp_view *view, size_t n, const double *alpha1, const double *u,
                            double *delta) {
  for (size_t i = 0; i < n; i += BLOCK)
    visible_block(view->slope, n - i < BLOCK ? n - i : BLOCK, alpha1 + i, u + i, delta + i);
  asp_view each = *view;
  for (size_t i = 0; i < n; i++)
    if (!(u[i] >= ASP_VISIBLE_U_LEAST) || alpha1[i] < 0 || view->sigma < ASP_SIGMA_ZERO) {
      each.alpha1 = alpha1[i];
      delta[i] = asp_spread_visible.quantile(&each, u[i]);
    }
}
