/* Running mean and variance (Welford 1962), and the merger of two of them (Chan, Golub & LeVeque
 * 1983).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_BASE_RUNNING_H
#define ASP_BASE_RUNNING_H

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

static inline aspi_running aspi_running_merge(aspi_running a, aspi_running b) {
  if (!(a.n > 0) || !(b.n > 0))
    return a.n > 0 ? a : b;
  double n = a.n + b.n, apart = b.mean - a.mean;
  return (aspi_running){n, a.mean + apart * (b.n / n),
                        a.square + b.square + apart * apart * (a.n * b.n / n)};
}

/* Standard deviation, with n - 1 in the denominator; 0 for fewer than two values. */
static inline double aspi_running_sd(const aspi_running *r) {
  return r->n > 1 ? sqrt(r->square / (r->n - 1)) : 0;
}

#endif
