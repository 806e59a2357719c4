/* Makes rsm_table.inc: R_Sm/lambda_c of Gaussian profiles over the sampling length, by counting
 * profile elements as ISO 4287 does: portions between crossings of the mean line count where they
 * are higher than 10 % of R_z and longer than 1 % of the sampling length; a peak and the valley
 * behind it are one element. R_z is the mean over five sampling lengths, R_Sm the mean length of
 * the whole elements within them, and the table the mean R_Sm of all such measurements. To be run
 * by `cmake --build build --target rsm_table`, which writes the file in its place; takes a minute.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"
#include "surface/heights.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
  ROWS = 9, /* beyond them the 1 % of a sampling length leaves out whole elements */
  PROFILES = 4,
  PER_LAMBDA = 64, /* points */
  POINTS = 1 << 22,
  LENGTHS = 5 /* sampling lengths of an evaluation */
};

#define FIRST 4.0 /* sampling length over lambda_c; rows are half octaves */
#define HEIGHT_PART 0.1
#define SPACING_PART 0.01

static double extent(const double *z, size_t count) {
  double low = z[0], high = z[0];
  for (size_t i = 1; i < count; i++) {
    low = fmin(low, z[i]);
    high = fmax(high, z[i]);
  }
  return high - low;
}

/* Whole elements within an evaluation length, and where the first and the last of them end. */
typedef struct elements {
  double count, first, last;
} elements;

/* A portion of the profile on one side of the mean line. */
typedef struct portion {
  double begin, height;
  int sign;
} portion;

/* An element begins where the first portion above the line follows one below it. */
static void take(elements *e, const portion *p, double end, double height_least,
                 double length_least, int *side) {
  if (p->height < height_least || end - p->begin < length_least || p->sign == *side)
    return;
  if (p->sign > 0 && *side < 0) {
    if (e->count < 0)
      e->first = p->begin;
    e->count++;
    e->last = p->begin;
  }
  *side = p->sign;
}

/* Adds the R_Sm of one evaluation length, if it has a whole element. */
static void evaluate(const double *z, size_t per_length, double *r_sm, double *count) {
  double mean = 0, r_z = 0;
  size_t n = LENGTHS * per_length;
  for (size_t i = 0; i < n; i++)
    mean += z[i] / (double)n;
  for (int k = 0; k < LENGTHS; k++)
    r_z += extent(z + (size_t)k * per_length, per_length) / LENGTHS;
  elements e = {-1, 0, 0};
  portion p = {0, 0, z[0] > mean ? 1 : -1};
  int side = 0;
  for (size_t i = 1; i < n; i++) {
    double before = z[i - 1] - mean, now = z[i] - mean;
    p.height = fmax(p.height, fabs(before));
    if ((now > 0 ? 1 : -1) == p.sign)
      continue;
    double at = (double)(i - 1) + before / (before - now);
    take(&e, &p, at, HEIGHT_PART * r_z, SPACING_PART * (double)per_length, &side);
    p = (portion){at, 0, -p.sign};
  }
  if (e.count > 0) {
    *r_sm += (e.last - e.first) / e.count;
    *count += 1;
  }
}

int main(void) {
  double sum[ROWS] = {0}, count[ROWS] = {0};
  for (uint32_t k = 0; k < PROFILES; k++) {
    asp_error error;
    asp_heights *profile = aspi_profile_generate(1, 1, 1. / PER_LAMBDA, POINTS, k + 1, &error);
    if (!profile) {
      fprintf(stderr, "make_rsm_table: %s\n", error.text);
      return 1;
    }
    for (int row = 0; row < ROWS; row++) {
      size_t per_length = (size_t)lround(FIRST * pow(2, 0.5 * row) * PER_LAMBDA);
      for (size_t at = 0; at + LENGTHS * per_length <= POINTS; at += LENGTHS * per_length)
        evaluate(profile->z + at, per_length, &sum[row], &count[row]);
    }
    asp_heights_free(profile);
  }
  printf(
      "/* R_Sm/lambda_c of Gaussian profiles, for sampling lengths from %g lambda_c in half\n"
      " * octaves, by %d profiles of %d points, lambda_c/%d apart. Made by: cmake --build build\n"
      " * --target rsm_table */\n#define RSM_FIRST %g\nstatic const double rsm_table[%d] = {",
      FIRST, PROFILES, POINTS, PER_LAMBDA, FIRST, ROWS);
  for (int row = 0; row < ROWS; row++)
    printf("%s%.4f", row ? ", " : "", sum[row] / count[row] / PER_LAMBDA);
  puts("};");
  return 0;
}
