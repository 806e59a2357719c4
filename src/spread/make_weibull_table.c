/* Makes weibull_table.inc, the tables of weibull_cut.h, while the library is built. */
#include "spread/cells.h"
#include "spread/powers.h"
#include "spread/weibull_cut.h"

static real lost(real cell, real part) {
  return expl(-expl(ASP_CUT_FIRST + (cell + part) / ASP_CUT_PER_UNIT));
}

static real logarithm(real octave, real mantissa) {
  return logl(ldexpl(mantissa, (int)octave));
}

int main(void) {
  printf("static const double lost_table[] = {\n");
  for (int i = 0; i < ASP_CUT_CELLS; i++)
    print_powers(lost, i, 0, 0.5L, ASP_POWERS);
  printf("};\nstatic const double log_table[] = {\n");
  for (int i = 0; i < 8 * ASP_CUT_OCTAVES; i++)
    print_powers(logarithm, i / 8, 1 + (i % 8 + 0.5L) / 8, 1 / 16.L, ASP_POWERS);
  printf("};\n");
  return 0;
}
