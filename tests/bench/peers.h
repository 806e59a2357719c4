/* Samplers of other libraries as works of bench.h, for bench_spread.c. Each draws with a generator
 * of its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"
#include "spread/models.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A Weibull shape for the i-th draw: it depends on the impact angle, so that no sampler can rely on
 * it being the same again. */
static inline double bench_shape(size_t i) {
  return 1.4 + 2.2 / 64 * (double)(i & 63);
}

/* The C++ standard library: std::weibull_distribution, std::normal_distribution (each of scale
 * sigma, the context), and a uniform number, all with std::mt19937_64, whose one word has all of a
 * double's digits. */
void bench_std_weibull(void *sigma, size_t n);
void bench_std_normal(void *sigma, size_t n);
void bench_std_uniform(void *nothing, size_t n);

/* UNU.RAN's PINV (Derflinger, Hoermann & Leydold 2010): numerical inversion of a density, here that
 * of a model for one wall and one impact angle; error in u at most 1e-10. NULL when the set-up
 * fails. */
typedef struct unur_gen bench_pinv;
bench_pinv *bench_pinv_create(const asp_spread_model *model, const aspi_spread_input *view);
void bench_pinv_free(bench_pinv *pinv);
double bench_pinv_quantile(const bench_pinv *pinv, double u);

#ifdef __cplusplus
}
#endif
