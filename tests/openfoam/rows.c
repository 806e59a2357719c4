/* Reads a ledger of OpenFOAM's wall (with `fullLedger yes`) and makes each impact anew by
 * asp_wall_impact, of the words of its heading and of its key: the row must be the same, to what
 * its ten digits leave of a velocity. Prints the number of rows; ends with status 1, and the row's
 * number, where one is not. Usage: rows LEDGER KEY D_P DENSITY
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asperity.h"
#include "base/ledger_columns.h"

/* An empty field is NAN. */
static bool read_row(FILE *in, double row[LEDGER_N_FULL]) {
  char line[4096], *at = line;
  if (!fgets(line, sizeof line, in))
    return false;
  for (int i = 0; i < LEDGER_N_FULL; i++) {
    char *end;
    row[i] = strtod(at, &end);
    row[i] = end == at ? NAN : row[i];
    at = end + (*end == ',');
  }
  return *at == '\n';
}

/* As numbers of that size. */
static bool is_near(double a, double b, double size) {
  return fabs(a - b) <= 1e-7 * size;
}

static bool is_row_of(const asp_wall *wall, const asp_particle *particle, uint32_t seed,
                      const char *name, const double *row) {
  const double degrees = 180 / ASP_PI;
  const asp_key key = {seed, asp_key_wall(name), (uint64_t)row[LEDGER_TAG],
                       (uint32_t)row[LEDGER_IMPACT], 0};
  asp_impact impact;
  asp_wall_impact(wall, particle, row + LEDGER_V1X, row + LEDGER_NX, &key, &impact);
  const double *omega = row + LEDGER_OMEGA2X, v1 = row[LEDGER_V1];
  double spin = fabs(omega[0]) + fabs(omega[1]) + fabs(omega[2]);
  bool same =
      is_near(impact.delta_alpha * degrees, row[LEDGER_DELTA_ALPHA], 90) &&
      is_near(impact.tilt_out * degrees, row[LEDGER_TILT_OUT], 90) &&
      is_near(impact.hits, row[LEDGER_HITS], 1) &&
      (impact.outcome != ASP_REBOUND) == (row[LEDGER_OUTCOME] > 0) &&
      is_near(impact.eroded * row[LEDGER_MASS], row[LEDGER_ERODED_MASS], row[LEDGER_ERODED_MASS]);
  for (int k = 0; k < 3; k++)
    same = same && is_near(impact.v2[k], row[LEDGER_V2X + k], v1) &&
           is_near(impact.omega[k], omega[k], spin);
  return same;
}

/* The words of the heading; the line of the names is passed over. */
static bool read_heading(FILE *in, char words[4096]) {
  char names[4096];
  if (!fgets(words, 4096, in) || *words != '#' || !fgets(names, sizeof names, in))
    return false;
  words[strcspn(words, "\n")] = '\0';
  memmove(words, words + 2, strlen(words + 2) + 1);
  return true;
}

int main(int argc, char **argv) {
  char words[4096];
  FILE *in = argc == 5 ? fopen(argv[1], "r") : NULL;
  if (!in || !read_heading(in, words))
    return 2;
  asp_error error;
  asp_description *description = asp_description_parse(words, NULL, &error);
  asp_wall *wall = description ? asp_wall_create(description, 1e-6, 1e-4, &error) : NULL;
  if (!wall) {
    fprintf(stderr, "%s: %s\n", words, error.text);
    return 2;
  }
  const uint32_t seed = (uint32_t)asp_description_get(description, "seed");
  const asp_lay lay = asp_description_lay(description);
  const asp_particle particle = {.d_p = strtod(argv[3], NULL),
                                 .density = strtod(argv[4], NULL),
                                 .lay = lay.kind == ASP_LAY_NONE ? NULL : lay.vector};
  int count = 0;
  for (double row[LEDGER_N_FULL]; read_row(in, row);) {
    count++;
    if (!is_row_of(wall, &particle, seed, argv[2], row)) {
      printf("row %d differs\n", count);
      return 1;
    }
  }
  printf("%d\n", count);
  asp_wall_free(wall);
  asp_description_free(description);
  fclose(in);
  return count > 0 ? 0 : 1;
}
