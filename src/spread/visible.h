/* The law of the visible slopes in standard form: x = p/s_eff, a = tan(alpha1)/s_eff, density
 * phi(x) (x + a) / Z for x > -a with Z = phi(a) + a Phi(a), for every finite a; a < 0 is a particle
 * that flies up. Here is the quick quantile for particles that come down, from a table, as straight
 * code that a loop over many contacts vectorises; visible.c has the rest. */
#ifndef ASP_SPREAD_VISIBLE_H
#define ASP_SPREAD_VISIBLE_H

#include "angle.h"
#include "spread/gauss.h"

/* The quantile of the others (see asp_visible_is_quick), by safeguarded inversion. */
double asp_visible_careful(const asp_view *view, double u);

/* The quantile over a grid of cells: rows evenly over a/(HALF_WAY + a) from 0 to 1, columns over the
 * logit, with the middle of the first at FIRST. Each holds a polynomial of fifth degree in both, from -1/2 to
 * 1/2 over the cell: the coefficients of 1, s, ... s^5, t, t s, ... t s^4, t^2, ... t^5 (t: row, s:
 * column). It is off by less than 1.1e-10 in u. */
enum { ASP_VISIBLE_ROWS = 41, ASP_VISIBLE_COLUMNS = 56, ASP_VISIBLE_TERMS = 21 };
#define ASP_VISIBLE_HALF_WAY 2.5
#define ASP_VISIBLE_FIRST (-5.371)
#define ASP_VISIBLE_STEP 0.349
extern const double asp_visible_table[ASP_VISIBLE_ROWS][ASP_VISIBLE_COLUMNS][ASP_VISIBLE_TERMS];

/* Whether the table has this quantile: a >= 0, and the logit within the columns. */
static inline bool asp_visible_is_quick(double alpha1, double u) {
  return alpha1 >= 0 && u > 0.00390625 && u < 1 - 1e-6;
}

/* A place in the grid: the cell, and -1/2 to 1/2 over it. */
typedef struct asp_visible_place {
  int row, column;
  double t, s;
} asp_visible_place;

/* x to the nearest whole number, for |x| < 2^51; halves to the even one, so that an odd number of
 * rows needs no more. */
static inline double asp_nearest(double x) {
  const double shift = 6755399441055744.0; /* 1.5 * 2^52, beyond which there are no others */
  return (x + shift) - shift;
}

static inline asp_visible_place asp_visible_find(asp_turn alpha1, double slope, double u) {
  double along = ASP_VISIBLE_HALF_WAY * slope * alpha1.cosine;
  double y = alpha1.sine / (alpha1.sine + along) * ASP_VISIBLE_ROWS - 0.5;
  double x = (log(u / (1 - u)) - ASP_VISIBLE_FIRST) * (1 / ASP_VISIBLE_STEP);
  double row = asp_nearest(y), column = asp_nearest(x);
  return (asp_visible_place){(int)row, (int)column, y - row, x - column};
}

/* x of the law. */
static inline double asp_visible_at(const double *c, double t, double s) {
  double s2 = s * s, s4 = s2 * s2, t2 = t * t, t4 = t2 * t2;
  double c0 = (c[0] + c[1] * s) + s2 * (c[2] + c[3] * s) + s4 * (c[4] + c[5] * s);
  double c1 = (c[6] + c[7] * s) + s2 * (c[8] + c[9] * s) + s4 * c[10];
  double c2 = (c[11] + c[12] * s) + s2 * (c[13] + c[14] * s);
  double c3 = (c[15] + c[16] * s) + s2 * c[17];
  return (c0 + c1 * t) + t2 * (c2 + c3 * t) + t4 * ((c[18] + c[19] * s) + c[20] * t);
}

#endif
