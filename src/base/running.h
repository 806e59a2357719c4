/* Running mean and variance (Welford 1962).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <math.h>

typedef struct aspi_running {
  double n, mean, square; /* square: sum of squared distances from the mean */
} aspi_running;

static inline void aspi_running_add(aspi_running *r, double x) {
  double step = x - r->mean;
  r->n++;
  r->mean += step / r->n;
  r->square += step * (x - r->mean);
}

/* Standard deviation, with n - 1 in the denominator; 0 for fewer than two values. */
static inline double aspi_running_sd(const aspi_running *r) {
  return r->n > 1 ? sqrt(r->square / (r->n - 1)) : 0;
}
