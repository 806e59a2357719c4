/* Makes visible_table.inc, the quantiles of the visible slopes, while the library is built: on
 * every cell of a grid the polynomial of fifth degree in both coordinates that is left of the
 * Chebyshev series. The law is inverted in long double. See visible.h for the coordinates. */
#include "spread/powers.h"
#include "spread/visible.h"

enum { EACH_WAY = 8 }; /* points of the Chebyshev series */

typedef real square[EACH_WAY][EACH_WAY];

static real density(real x) {
  return ASP_INV_SQRT_2PI * expl(-x * x / 2);
}

static real above(real x) {
  return 0.5L * erfcl(x * 0.70710678118654752440L);
}

/* The x that the share w of the law is above: Newton's method between bounds. */
static real solve(real a, real w) {
  real norm = density(a) + a * above(-a), low = fmaxl(-a, -12), high = sqrtl(-2 * logl(w)) + 1;
  real x = (low + high) / 2;
  for (int i = 0; i < 200; i++) {
    real miss = (density(x) + a * above(x)) / norm - w;
    *(miss > 0 ? &low : &high) = x;
    real next = x + miss * norm / (density(x) * (x + a));
    next = next > low && next < high ? next : (low + high) / 2;
    if (fabsl(next - x) < 1e-18L * (1 + fabsl(x)))
      break;
    x = next;
  }
  return x;
}

/* The quantile at row and column of the grid, whole in the middle of a cell. */
static real quantile(real row, real column) {
  real p = (row + 0.5L) / ASP_VISIBLE_ROWS, logit = ASP_VISIBLE_FIRST + column * ASP_VISIBLE_STEP;
  real a = p < 1 ? ASP_VISIBLE_HALF_WAY * p / (1 - p) : 1e8L;
  return solve(fminl(a, 1e8L), 1 / (1 + expl(logit)));
}

/* Coefficients of the Chebyshev series of one cell. */
static void expand(int row, int column, square series) {
  square value;
  for (int i = 0; i < EACH_WAY; i++)
    for (int j = 0; j < EACH_WAY; j++)
      value[i][j] = quantile(row + 0.5L * cosl(chebyshev_angle(i, EACH_WAY)),
                             column + 0.5L * cosl(chebyshev_angle(j, EACH_WAY)));
  for (int m = 0; m < EACH_WAY; m++)
    for (int n = 0; n < EACH_WAY; n++) {
      real sum = 0;
      for (int i = 0; i < EACH_WAY; i++)
        for (int j = 0; j < EACH_WAY; j++)
          sum += value[i][j] * cosl(m * chebyshev_angle(i, EACH_WAY)) *
                 cosl(n * chebyshev_angle(j, EACH_WAY));
      series[m][n] = sum * (m ? 2 : 1) * (n ? 2 : 1) / (EACH_WAY * EACH_WAY);
    }
}

/* The Chebyshev polynomials up to the fifth in powers. */
static const real power_of[6][6] = {
    {1}, {0, 1}, {-1, 0, 2}, {0, -3, 0, 4}, {1, 0, -8, 0, 8}, {0, 5, 0, -20, 0, 16},
};

/* How many powers of the column's coordinate there are with each power of the row's. */
static const int powers[6] = {6, 6, 4, 4, 2, 2};

static void print_cell(int row, int column) {
  square series;
  expand(row, column, series);
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < powers[i]; j++) {
      real sum = 0;
      for (int m = i; m < 6; m++)
        for (int n = j; n < powers[m]; n++)
          sum += series[m][n] * power_of[m][i] * power_of[n][j];
      printf("%.17g,", (double)ldexpl(sum, i + j)); /* at -1/2 to 1/2 */
    }
  printf("\n");
}

int main(void) {
  for (int row = 0; row < ASP_VISIBLE_ROWS; row++)
    for (int column = 0; column < ASP_VISIBLE_COLUMNS; column++)
      print_cell(row, column);
  return 0;
}
