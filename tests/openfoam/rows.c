/* Reads a ledger with `fullLedger yes` and makes each impact with the velocity that is given anew
 * by asp_wall_impact, of the words of its heading and of its key: the row must be the same. Ends
 * with status 1, and the row, where it is not. Usage: rows LEDGER KEY VX VY VZ DENSITY
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Columns, from 0. */
enum { TAG, IMPACT, D_P = 8, DELTA = 11, TILT_OUT, HITS, OUTCOME = 18, NX = 20, V1 = 23, V2 = 26 };
enum { COLUMNS = 39 };

static const double degrees = 180 / ASP_PI;

/* As the ledger prints it. */
static bool is_same(double value, double printed) {
  char text[40];
  snprintf(text, sizeof text, "%.10g", value);
  return !(fabs(strtod(text, NULL) - printed) > 0);
}

static bool is_row_of(const asp_wall *wall, uint32_t seed, const double *row, const char *key_name,
                      double density) {
  const asp_particle particle = {.d_p = row[D_P], .density = density};
  const asp_key key = {seed, asp_key_wall(key_name), (uint64_t)row[TAG], (uint32_t)row[IMPACT]};
  asp_impact impact;
  asp_wall_impact(wall, &particle, row + V1, row + NX, &key, &impact);
  bool same = is_same(impact.delta_alpha * degrees, row[DELTA]) &&
              is_same(impact.tilt_out * degrees, row[TILT_OUT]) &&
              is_same(impact.hits, row[HITS]) && is_same(impact.outcome, row[OUTCOME]);
  for (int k = 0; k < 3; k++)
    same = same && is_same(impact.v2[k], row[V2 + k]);
  return same;
}

int main(int argc, char **argv) {
  char line[4000];
  FILE *in = argc == 7 ? fopen(argv[1], "r") : NULL;
  if (!in || !fgets(line, sizeof line, in))
    return 2;
  line[strcspn(line, "\n")] = '\0';
  asp_error error;
  asp_description *words = asp_description_parse(line + 2, NULL, &error);
  asp_wall *wall = words ? asp_wall_create(words, 1e-5, 1e-5, &error) : NULL;
  if (!wall) {
    fprintf(stderr, "%s\n", error.text);
    return 2;
  }
  const uint32_t seed = (uint32_t)asp_description_get(words, "seed");
  int count = 0;
  while (fgets(line, sizeof line, in)) {
    double row[COLUMNS];
    char *at = line;
    for (int i = 0; i < COLUMNS; i++) {
      row[i] = strtod(at, &at);
      at += *at == ',';
    }
    bool is_first = true; /* its velocity is known to all digits */
    for (int k = 0; k < 3; k++)
      is_first = is_first && !(fabs(row[V1 + k] - strtod(argv[3 + k], NULL)) > 0);
    if (!is_first)
      continue;
    count++;
    if (!is_row_of(wall, seed, row, argv[2], strtod(argv[6], NULL))) {
      printf("differs: %s", line);
      return 1;
    }
  }
  printf("%d\n", count);
  asp_wall_free(wall);
  asp_description_free(words);
  fclose(in);
  return count > 0 ? 0 : 1;
}
