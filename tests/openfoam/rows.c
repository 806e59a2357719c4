/* Reads a ledger of OpenFOAM's wall (.npy, with `fullLedger yes`) and makes each impact anew by
 * asp_wall_impact, of the words of its heading and of its key: the row must be the same to the last
 * bit. Prints the number of rows; ends with status 1, and the row's number, where one is not.
 * Usage: rows LEDGER KEY D_P DENSITY
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asperity.h"
#include "base/ledger_columns.h"

/* Bytes of the columns. */
#define TYPE(ID, name, type, text) type,
static const char *const types[] = {LEDGER_COLUMNS(TYPE) LEDGER_MORE_COLUMNS(TYPE)};

static double number_at(const char *at, const char *type) {
  int8_t i1;
  int16_t i2;
  int32_t i4;
  int64_t i8;
  float f4;
  double f8;
#define TAKE(name) return memcpy(&name, at, sizeof name), (double)name
  if (strcmp(type, "i1") == 0)
    TAKE(i1);
  if (strcmp(type, "i2") == 0)
    TAKE(i2);
  if (strcmp(type, "i4") == 0)
    TAKE(i4);
  if (strcmp(type, "i8") == 0)
    TAKE(i8);
  if (strcmp(type, "f4") == 0)
    TAKE(f4);
  TAKE(f8);
}

static bool read_row(FILE *in, double row[LEDGER_N_FULL]) {
  for (int i = 0; i < LEDGER_N_FULL; i++) {
    char bytes[8];
    const size_t size = (size_t)(types[i][1] - '0');
    if (fread(bytes, 1, size, in) != size)
      return false;
    row[i] = number_at(bytes, types[i]);
  }
  return true;
}

static bool is_same(double a, double b) {
  return !(a < b) && !(a > b);
}

static bool is_row_of(const asp_wall *wall, const asp_particle *particle, uint32_t seed,
                      const char *name, const double *row) {
  const double degrees = 180 / ASP_PI;
  const asp_key key = {seed, asp_key_wall(name), (uint64_t)row[LEDGER_TAG],
                       (uint32_t)row[LEDGER_IMPACT]};
  asp_impact impact;
  asp_wall_impact(wall, particle, row + LEDGER_V1X, row + LEDGER_NX, &key, &impact);
  bool same = is_same((float)(impact.delta_alpha * degrees), row[LEDGER_DELTA_ALPHA]) &&
              is_same((float)(impact.tilt_out * degrees), row[LEDGER_TILT_OUT]) &&
              is_same(impact.hits, row[LEDGER_HITS]) &&
              is_same(impact.outcome != ASP_REBOUND, row[LEDGER_OUTCOME] > 0) &&
              is_same(impact.eroded * row[LEDGER_MASS], row[LEDGER_ERODED_MASS]);
  for (int k = 0; k < 3; k++)
    same = same && is_same(impact.v2[k], row[LEDGER_V2X + k]) &&
           is_same(impact.omega[k], row[LEDGER_OMEGA2X + k]);
  return same;
}

/* The words of the array's header, up to a quotation mark, and what follows the header. */
static bool read_heading(FILE *in, char words[4096]) {
  unsigned char start[10];
  if (fread(start, 1, sizeof start, in) != sizeof start)
    return false;
  const size_t length = start[8] + 256u * start[9];
  if (length >= 4096 || fread(words, 1, length, in) != length)
    return false;
  words[length] = '\0';
  char *begin = strstr(words, "((");
  if (!begin)
    return false;
  memmove(words, begin + 3, strlen(begin + 3) + 1);
  words[strcspn(words, "'")] = '\0';
  return true;
}

int main(int argc, char **argv) {
  char words[4096];
  FILE *in = argc == 5 ? fopen(argv[1], "rb") : NULL;
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
