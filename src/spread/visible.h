/* The law of the visible slopes in standard form: x = p/s_eff, a = tan(alpha1)/s_eff, density
 * phi(x) (x + a) / Z for x > -a with Z = phi(a) + a Phi(a), for every finite a; a < 0 is a particle
 * that flies up. Here is the quick quantile for particles that come down, from a table, as straight
 * code that a loop over many contacts vectorises; visible.c has the rest. */
#ifndef ASP_SPREAD_VISIBLE_H
#define ASP_SPREAD_VISIBLE_H

#include "spread/cells.h"
#include "spread/gauss.h"
#include "spread/models.h"

/* The quantile over a grid of cells: rows evenly over a/(HALF_WAY + a) from 0 to 1, columns over
 * the logit, with the middle of the first at FIRST. Each holds a polynomial of fifth degree in
 * both, from -1/2 to 1/2 over the cell: the coefficients of 1, s, ... s^5, t, t s, ... t s^5, then
 * four each with t^2 and t^3 and two with t^4 and t^5 (t: row, s: column). It is off by less
 * than 1.1e-10 in u. */
enum { ASP_VISIBLE_ROWS = 41, ASP_VISIBLE_COLUMNS = 68, ASP_VISIBLE_TERMS = 24 };
#define ASP_VISIBLE_HALF_WAY 2.5
#define ASP_VISIBLE_FIRST (-9.575)
#define ASP_VISIBLE_STEP 0.349
extern const double asp_visible_table[ASP_VISIBLE_ROWS * ASP_VISIBLE_COLUMNS * ASP_VISIBLE_TERMS];

/* Whether the table has this quantile: a >= 0, and the logit within the columns. */
static inline bool asp_visible_is_quick(double alpha1, double u) {
  return (alpha1 >= 0) & (u > 6.2e-5) & (u < 1 - 1e-6);
}

/* A place in the grid: the cell, row by row, and -1/2 to 1/2 over it. */
typedef struct asp_visible_place {
  double cell; /* a whole number, where the table has the place */
  double t, s;
} asp_visible_place;

/* With an odd number of rows the last holds a = infinity, too, for halves go to the even one; and
 * y, in the order in which it is worked out, is never above ROWS - 1/2. */
static inline asp_visible_place asp_visible_find(double alpha1, double slope, double u) {
  double sine = sin(alpha1), along = sine + ASP_VISIBLE_HALF_WAY * slope * cos(alpha1);
  double y = sine / along * ASP_VISIBLE_ROWS - 0.5;
  double x = log(u / (1 - u)) * (1 / ASP_VISIBLE_STEP) - ASP_VISIBLE_FIRST / ASP_VISIBLE_STEP;
  double row = asp_nearest(y), column = asp_nearest(x);
  return (asp_visible_place){row * ASP_VISIBLE_COLUMNS + column, y - row, x - column};
}

/* x of the law. Even and odd powers of s side by side, for which there are instructions. */
static inline double asp_visible_at(double cell, double t, double s) {
  const double *c = asp_visible_table;
  int at = (int)cell * ASP_VISIBLE_TERMS;
  double s2 = s * s, s4 = s2 * s2, t2 = t * t, t4 = t2 * t2, part[2];
  for (int k = 0; k < 2; k++, at++)
    part[k] = ((c[at] + c[at + 2] * s2 + c[at + 4] * s4) +
               (c[at + 6] + c[at + 8] * s2 + c[at + 10] * s4) * t) +
              ((c[at + 12] + c[at + 14] * s2) + (c[at + 16] + c[at + 18] * s2) * t) * t2 +
              (c[at + 20] + c[at + 22] * t) * t4;
  return part[0] + s * part[1];
}

#endif
