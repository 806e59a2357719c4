/* For the programs that make tables while the library is built: a function as a polynomial, by its
 * Chebyshev series in long double. */
#ifndef ASP_SPREAD_POWERS_H
#define ASP_SPREAD_POWERS_H

#include <math.h>
#include <stdio.h>

enum { POINTS = 16, TERMS_MAX = 10 };

typedef long double real;

static inline real chebyshev_angle(int k, int points) {
  return 3.14159265358979323846264338327950288L * (k + 0.5L) / points;
}

/* Prints the coefficients of `terms` powers of z, -half to half, for of(place, middle + z). */
static inline void print_powers(real (*of)(real, real), real place, real middle, real half,
                                int terms) {
  real value[POINTS], series[TERMS_MAX] = {0}, power[TERMS_MAX] = {0};
  for (int i = 0; i < POINTS; i++)
    value[i] = of(place, middle + half * cosl(chebyshev_angle(i, POINTS)));
  for (int m = 0; m < terms; m++)
    for (int i = 0; i < POINTS; i++)
      series[m] += value[i] * cosl(m * chebyshev_angle(i, POINTS)) * (m ? 2 : 1) / POINTS;
  real last[TERMS_MAX] = {1}, chebyshev[TERMS_MAX] = {0, 1}; /* in powers */
  for (int m = 0; m < terms; m++) {
    for (int k = 0; k < terms; k++)
      power[k] += series[m] * last[k];
    real next[TERMS_MAX];
    for (int k = 0; k < terms; k++)
      next[k] = (k > 0 ? 2 * chebyshev[k - 1] : 0) - last[k];
    for (int k = 0; k < terms; k++) {
      last[k] = chebyshev[k];
      chebyshev[k] = next[k];
    }
  }
  for (int k = 0; k < terms; k++)
    printf("%.17g,", (double)(power[k] / powl(half, k)));
  printf("\n");
}

#endif
