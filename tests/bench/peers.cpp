/* The C++ standard library's side of bench_spread.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "peers.h"

#include <random>

static std::mt19937_64 generator(1);
static volatile double sink; /* so that no draw is left out */

void bench_std_weibull(void *sigma, size_t n) {
  double scale = *static_cast<const double *>(sigma), sum = 0;
  for (size_t i = 0; i < n; i++)
    sum += std::weibull_distribution<double>(bench_shape(i), scale)(generator);
  sink = sum;
}

void bench_std_normal(void *sigma, size_t n) {
  std::normal_distribution<double> normal(0, *static_cast<const double *>(sigma));
  double sum = 0;
  for (size_t i = 0; i < n; i++)
    sum += normal(generator);
  sink = sum;
}

void bench_std_uniform(void *, size_t n) {
  std::uniform_real_distribution<double> uniform;
  double sum = 0;
  for (size_t i = 0; i < n; i++)
    sum += uniform(generator);
  sink = sum;
}
