/* The Weibull law of an impact angle; see weibull.c. */
#ifndef ASP_SPREAD_WEIBULL_H
#define ASP_SPREAD_WEIBULL_H

/* delta = b + lambda y, where y >= 0 has the distribution 1 - exp(-y^k). */
typedef struct asp_weibull_law {
  double b, k, lambda;
} asp_weibull_law;

/* For sigma > 0, both in rad. */
asp_weibull_law asp_weibull_at(double sigma, double alpha1);

#endif
