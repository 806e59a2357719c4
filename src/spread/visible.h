/* The law of the visible slopes in standard form: x = p/s_eff, a = tan(alpha1)/s_eff, density
 * phi(x) (x + a) / Z for x > -a with Z = phi(a) + a Phi(a), for every finite a; a < 0 is a particle
 * that flies up. Here is the quick quantile for particles that come down, as straight code that a
 * loop over many contacts vectorises; visible.c has the rest. */
#ifndef ASP_SPREAD_VISIBLE_H
#define ASP_SPREAD_VISIBLE_H

#include "spread/gauss.h"

/* The quick quantile holds for a >= 0 and from this u on. */
#define ASP_VISIBLE_U_LEAST 0.00390625

/* From this a on the law is the normal one, to 1e-10 in u. */
#define ASP_VISIBLE_A_MOST 1e10

/* The quantile on a grid: rows a/(2 + a) = 0, 1/16 ... 1, columns the fourth root of -2 log(1 - u)
 * (whose square is the quantile at a = 0, Rayleigh's law) from LEAST in steps of STEP. Four digits:
 * it is a starting point. */
enum { ASP_VISIBLE_ROWS = 17, ASP_VISIBLE_COLUMNS = 25 };
#define ASP_VISIBLE_LEAST 0.297447218027
#define ASP_VISIBLE_STEP 0.110224317347
extern const float asp_visible_grid[ASP_VISIBLE_ROWS][ASP_VISIBLE_COLUMNS];

/* The grid between its nodes, within 0.01. */
static inline double asp_visible_guess(double a, double r) {
  double p = a / (2 + a) * (ASP_VISIBLE_ROWS - 1);
  double q = (r - ASP_VISIBLE_LEAST) * (1 / ASP_VISIBLE_STEP);
  int i = (int)p, j = (int)q;
  i = i < ASP_VISIBLE_ROWS - 2 ? i : ASP_VISIBLE_ROWS - 2;
  j = j < ASP_VISIBLE_COLUMNS - 2 ? j : ASP_VISIBLE_COLUMNS - 2;
  const float *at = &asp_visible_grid[i][j], *up = at + ASP_VISIBLE_COLUMNS;
  p -= i;
  q -= j;
  double first = at[0] + q * (at[1] - at[0]), second = up[0] + q * (up[1] - up[0]);
  return first + p * (second - first);
}

/* One step from a guess x by the inverted Taylor series of the distribution, to fourth order: d is
 * the missing share over the density, c2 to c4 the density's derivatives over itself. From a guess
 * of the grid what is left of the error is below 1.2e-10 in u. */
static inline double asp_visible_refine(double a, double u, double x) {
  double phi_a = asp_gauss_density(a), phi_x = asp_gauss_density(x);
  double z = phi_a + a * (1 - asp_gauss_above(a, phi_a));
  double y = x + a, scale = 1 / (phi_x * y), q = scale * phi_x;
  double d = (phi_x + a * asp_gauss_above(x, phi_x) - (1 - u) * z) * scale;
  double c2 = (q - x) / 2, square = x * x - 1;
  double c3 = (square - 2 * x * q) / 6, c4 = (x * (2 - square) + 3 * square * q) / 24;
  return x + d * (1 - d * (c2 - d * (2 * c2 * c2 - c3 - d * (5 * c2 * (c2 * c2 - c3) + c4))));
}

static inline double asp_visible_quick(double a, double u) {
  a = a < ASP_VISIBLE_A_MOST ? a : ASP_VISIBLE_A_MOST;
  return asp_visible_refine(a, u, asp_visible_guess(a, sqrt(sqrt(-2 * log(1 - u)))));
}

#endif
