/* The standard normal distribution by the C library.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <math.h>

#define ASP_INV_SQRT_2PI 0.398942280401432677940

static inline double aspi_gauss_density(double x) {
  return ASP_INV_SQRT_2PI * exp(-0.5 * x * x);
}

/* Phi(x), with full relative precision in the lower tail. */
static inline double aspi_gauss_below(double x) {
  return 0.5 * erfc(-x * M_SQRT1_2);
}
