/* Makes normal_table.inc, the tables of normal_law.h, while the library is built. */
#include "spread/normal_law.h"
#include "spread/cells.h"
#include "spread/powers.h"

static real tail(real x) {
  return 0.5L * erfcl(x * 0.70710678118654752440L);
}

/* Newton's method on the logarithm, which is nearly a parabola. */
static real quantile(real p) {
  real x = p < 0.4L ? -sqrtl(-2 * logl(2 * p)) : 0;
  for (int i = 0; i < 60; i++) {
    real density = expl(-x * x / 2) * 0.39894228040143267793995L;
    x -= p < 0.4L ? logl(tail(-x) / p) * tail(-x) / density : (tail(-x) - p) / density;
  }
  return x;
}

/* The quantile at a mantissa in an octave. */
static real quantile_at(real octave, real mantissa) {
  return quantile(ldexpl(mantissa, (int)octave));
}

static real tail_at(real cell, real part) {
  return tail((cell + part) / ASP_TAIL_PER_UNIT);
}

int main(void) {
  printf("static const double tail_table[ASP_TAIL_CELLS * ASP_POWERS] = {\n");
  for (int i = 0; i < ASP_TAIL_CELLS; i++)
    print_powers(tail_at, i, 0, 0.5L, ASP_POWERS);
  printf("};\nstatic const double quantile_table[ASP_NORMAL_CELLS * ASP_NORMAL_TERMS] = {\n");
  for (int i = 0; i < ASP_NORMAL_CELLS; i++) {
    int octave = i / ASP_NORMAL_PER_OCTAVE - ASP_NORMAL_OCTAVES - 1;
    real half = 0.5L / ASP_NORMAL_PER_OCTAVE;
    real middle = 1 + half * (2 * (i % ASP_NORMAL_PER_OCTAVE) + 1);
    print_powers(quantile_at, octave, middle, half, ASP_NORMAL_TERMS);
  }
  printf("};\n");
  return 0;
}
