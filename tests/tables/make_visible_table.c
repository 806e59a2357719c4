/* Makes visible_table.inc: quantiles of `visible` from which its root search starts. To be run by
 * `cmake --build build --target visible_table`, which writes the file in its place; the search
 * finds them from any start.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/models.h"

#include <math.h>
#include <stdio.h>

enum { AS = 16, US = 20 };

#define LOGIT_MOST 7.0
#define A_MIDDLE 3.0
#define SLOPE 1e-3

int main(void) {
  printf(
      "/* Quantiles x of `visible`; row: a/(a + %g) from 0 to 1, column: ln(u/(1 - u)) from %g to "
      "%g.\n * Made by: cmake --build build --target visible_table */\n",
      A_MIDDLE, -LOGIT_MOST, LOGIT_MOST);
  printf("enum { VISIBLE_AS = %d, VISIBLE_US = %d };\n", AS, US);
  printf("#define VISIBLE_LOGIT_MOST %g\n#define VISIBLE_A_MIDDLE %g\n", LOGIT_MOST, A_MIDDLE);
  puts("/* clang-format off */\n"
       "static const double visible_table[VISIBLE_AS][VISIBLE_US] = {");
  for (int row = 0; row < AS; row++) {
    double a = row < AS - 1 ? A_MIDDLE * row / (AS - 1 - row) : 1e10;
    aspi_spread_input input = aspi_spread_input_of(atan(SLOPE), atan(SLOPE * a));
    printf("    {");
    for (int i = 0; i < US; i++) {
      double u = 1 / (1 + exp(LOGIT_MOST * (1 - 2. * i / (US - 1))));
      printf("%.4f%s", tan(aspi_spread_visible.quantile(&input, u)) / SLOPE,
             i + 1 < US ? i % 10 == 9 ? ",\n     " : ", " : "},\n");
    }
  }
  puts("};\n/* clang-format on */");
  return 0;
}
