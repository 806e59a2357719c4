/* The Weibull distribution at an impact angle; see weibull.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_WEIBULL_H
#define ASP_SPREAD_WEIBULL_H

/* delta = b + lambda y, where y >= 0 has the distribution 1 - exp(-y^k). */
typedef struct aspi_weibull {
  double b, k, lambda;
} aspi_weibull;

/* For sigma > 0, both in rad. */
aspi_weibull aspi_weibull_at(double sigma, double alpha1);

#endif
