/* Makes size_table.inc: s_eff/s over (phi_r, d_p/lambda_c) for phi_r beyond the closed form, from
 * generated profiles, each ratio against the same profiles' own unfiltered slope. To be run by
 * `cmake --build build --target size_table`, which writes the file in its place. Takes some
 * minutes; the result does not depend on the number of threads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"
#include "surface/size_law.h"
#include "surface/slopes.h"
#include "surface/heights.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
  ROWS = 15,
  COLUMNS = 21,
  PROFILES = 16,
  PER_LAMBDA = 128,   /* points */
  POINTS = 128 * 4096 /* a profile */
};

#define PHI_FIRST 0.30
#define PHI_STEP 0.05
#define SIZE_FIRST 0.03125 /* d_p/lambda_c; columns are half octaves */

static void fail(const char *text) {
  fprintf(stderr, "make_size_table: %s\n", text);
  exit(1);
}

/* Adds the squares of the filtered slopes, and of the unfiltered one, of one profile. */
static void add_profile(double phi_r, uint32_t seed, double sums[COLUMNS + 1]) {
  asp_error error;
  asp_heights *profile = aspi_profile_generate(phi_r, 1, 1. / PER_LAMBDA, POINTS, seed, &error);
  double *slopes = malloc(POINTS * sizeof *slopes);
  if (!profile || !slopes)
    fail(profile ? "out of memory" : error.text);
  for (int i = 0; i <= COLUMNS; i++) {
    /* A disc smaller than the spacing filters nothing. */
    double d_p = i < COLUMNS ? SIZE_FIRST * pow(2, 0.5 * i) : 0.5 / PER_LAMBDA;
    size_t count;
    if (aspi_profile_slopes(profile, d_p, slopes, &count, &error))
      fail(error.text);
    aspi_moments m = aspi_moments_of(slopes, count);
    sums[i] += m.mean * m.mean + m.sd * m.sd;
  }
  free(slopes);
  asp_heights_free(profile);
}

static void print_table(double table[ROWS][COLUMNS]) {
  printf("/* s_eff/s of a Gaussian profile filtered by a disc; row: phi_r from %.2f in steps of "
         "%.2f;\n"
         " * column: d_p/lambda_c from %g in half octaves. %d profiles of %d points, lambda_c/%d\n"
         " * apart. Made by: cmake --build build --target size_table */\n",
         PHI_FIRST, PHI_STEP, SIZE_FIRST, PROFILES, POINTS, PER_LAMBDA);
  printf("#define SIZE_TABLE_PHI_STEP %.2f\n#define SIZE_TABLE_PHI_MOST %.2f\n", PHI_STEP,
         PHI_FIRST + (ROWS - 1) * PHI_STEP);
  printf("#define SIZE_TABLE_SIZE_FIRST %g\n", SIZE_FIRST);
  printf("enum { SIZE_TABLE_ROWS = %d, SIZE_TABLE_COLUMNS = %d };\n", ROWS, COLUMNS);
  puts("/* clang-format off */\n"
       "static const double size_table[SIZE_TABLE_ROWS][SIZE_TABLE_COLUMNS] = {");
  for (int row = 0; row < ROWS; row++) {
    printf("    {");
    for (int i = 0; i < COLUMNS; i++)
      printf("%.4f%s", table[row][i], i + 1 < COLUMNS ? i % 10 == 9 ? ",\n     " : ", " : "},\n");
  }
  puts("};\n/* clang-format on */");
}

int main(void) {
  static double table[ROWS][COLUMNS];
#pragma omp parallel for schedule(dynamic)
  for (int row = 0; row < ROWS; row++) {
    double sums[COLUMNS + 1] = {0};
    for (uint32_t seed = 0; seed < PROFILES; seed++)
      add_profile(PHI_FIRST + row * PHI_STEP, seed, sums);
    for (int i = 0; i < COLUMNS; i++)
      table[row][i] = sqrt(sums[i] / sums[COLUMNS]);
    fprintf(stderr, "phi_r %.2f done\n", PHI_FIRST + row * PHI_STEP);
  }
  print_table(table);
  return 0;
}
