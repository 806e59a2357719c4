/* Grids of heights, as SDF, SUR and X3P have them. Numbers in binary are in little-endian order. A
 * map is read whole; a profile is one of its rows or columns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/grid.h"
#include "base/error.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

uint64_t aspi_bytes_whole(const unsigned char *bytes, int size) {
  uint64_t value = 0;
  for (int k = size - 1; k >= 0; k--)
    value = value << 8 | bytes[k];
  return value;
}

double aspi_bytes_double(const unsigned char *bytes) {
  uint64_t bits = aspi_bytes_whole(bytes, 8);
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

double aspi_bytes_real(const unsigned char *bytes) {
  uint32_t bits = (uint32_t)aspi_bytes_whole(bytes, 4);
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

/* The types of a height by their number, with the mark of a bad one: the least of signed and real
 * types, the most of unsigned ones (those of one byte have none). */
enum { TYPES = 8 };
static const int size_of[TYPES] = {1, 2, 4, 4, 1, 2, 4, 8};

double aspi_bytes_height(const unsigned char *bytes, int type) {
  uint64_t bits = aspi_bytes_whole(bytes, size_of[type]);
  uint64_t half = (uint64_t)1 << (8 * size_of[type] - 1), full = half + (half - 1);
  switch (type) {
  case 0:
    return (double)bits;
  case 1:
  case 2:
    return bits == full ? NAN : (double)bits;
  case 3: {
    double value = aspi_bytes_real(bytes);
    return fabs(value) < 3e38 ? value : NAN;
  }
  case 7: {
    double value = aspi_bytes_double(bytes);
    return fabs(value) < 1e300 ? value : NAN;
  }
  default:
    return bits == half && type != 4 ? NAN
           : bits < half             ? (double)bits
                                     : (double)bits - 2 * (double)half;
  }
}

asp_code aspi_cut_short(const aspi_text *text, const char *what, asp_error *error) {
  return aspi_file_fail(text->path, 0, error, "the file ends within its %s", what);
}

/* The numbers of a header by their keys in SDF, and their ranges. */
static const struct {
  const char *key;
  size_t place;
  double least, most;
  bool whole;
} keys[] = {{"NumPoints", offsetof(aspi_height_grid, points), 1, 1e12, true},
            {"NumProfiles", offsetof(aspi_height_grid, profiles), 1, 1e12, true},
            {"Xscale", offsetof(aspi_height_grid, x_scale), 1e-15, 1e9, false},
            {"Yscale", offsetof(aspi_height_grid, y_scale), 1e-15, 1e9, false},
            {"Zscale", offsetof(aspi_height_grid, z_scale), 1e-300, 1e300, false},
            {"Compression", offsetof(aspi_height_grid, compression), 0, 0, true}};
enum { KEYS = sizeof keys / sizeof *keys, YSCALE = 3 };

static double *place_of(const aspi_height_grid *h, size_t key) {
  return (double *)((char *)h + keys[key].place);
}

double *aspi_grid_number(const aspi_height_grid *h, const char *key) {
  for (size_t i = 0; i < KEYS; i++)
    if (strcasecmp(keys[i].key, key) == 0)
      return place_of(h, i);
  return NULL;
}

/* Checks the numbers of a header; a single profile needs no distance between profiles. */
static asp_code check(const aspi_text *text, const aspi_height_grid *h, asp_error *error) {
  for (size_t i = 0; i < KEYS; i++) {
    double value = *place_of(h, i), least = keys[i].least, most = keys[i].most;
    bool fits = value >= least && value <= most && !(keys[i].whole && value > floor(value));
    if (fits || (i == YSCALE && !(h->profiles > 1)))
      continue;
    if (isnan(value))
      return aspi_file_fail(text->path, text->line, error, "the header ends without %s",
                            keys[i].key);
    return aspi_file_fail(text->path, text->line, error, "%s is %g; it must be %g to %g%s",
                          keys[i].key, value, least, most, keys[i].whole ? ", a whole number" : "");
  }
  if (h->type >= -1 && h->type < TYPES)
    return ASP_OK;
  return aspi_file_fail(text->path, text->line, error, "DataType is %d; it must be 0 to %d",
                        h->type, TYPES - 1);
}

/* A height, before z_scale; NAN if it is marked as bad. */
static asp_code read_height(aspi_text *text, const aspi_height_grid *h, size_t index,
                            double *height, asp_error *error) {
  if (h->type >= 0) {
    unsigned char bytes[8];
    size_t size = (size_t)size_of[h->type];
    if (fread(bytes, 1, size, text->stream) != size)
      return aspi_cut_short(text, "heights", error);
    *height = aspi_bytes_height(bytes, h->type);
    *height = fabs(*height - h->mark) <= 0 ? NAN : *height;
    return ASP_OK;
  }
  char *word;
  asp_code code = aspi_text_word(text, &word, error);
  if (code)
    return code;
  if (!word || strcmp(word, "*") == 0)
    return aspi_file_fail(text->path, text->line, error,
                          "the heights end after %zu; NumPoints x NumProfiles is %.0f x %.0f",
                          index, h->points, h->profiles);
  if (aspi_text_number(word, false, height) == ASP_WORD_OTHER)
    return aspi_file_fail(text->path, text->line, error, "'%.40s' where a height is expected",
                          word);
  return ASP_OK;
}

/* The star behind the heights in ASCII. */
static asp_code read_end(aspi_text *text, const aspi_height_grid *h, asp_error *error) {
  char *word = NULL;
  asp_code code = h->type < 0 ? aspi_text_word(text, &word, error) : ASP_OK;
  if (!code && word && *word != '*')
    code = aspi_file_fail(text->path, text->line, error,
                          "'%.40s' after the last of %.0f x %.0f heights, where a * is expected",
                          word, h->points, h->profiles);
  return code;
}

/* Reads all heights. A map keeps all of them, a profile one row or column, from 1; the other
 * one is 0. */
static asp_code read_heights(aspi_text *text, const aspi_height_grid *h, size_t row_kept,
                             size_t column_kept, aspi_raw *raw, asp_error *error) {
  size_t points = (size_t)h->points, profiles = (size_t)h->profiles;
  for (size_t row = 1; row <= profiles; row++)
    for (size_t column = 1; column <= points; column++) {
      double height;
      asp_code code = read_height(text, h, (row - 1) * points + column - 1, &height, error);
      if (!code && (raw->is_map || row == row_kept || column == column_kept)) {
        if (!raw->is_map && isnan(height) && raw->bad++ == 0)
          raw->bad_line = text->line;
        code = aspi_raw_add(raw, height * h->z_scale, error);
      }
      if (code)
        return code;
    }
  return read_end(text, h, error);
}

asp_code aspi_read_grid(aspi_text *text, const aspi_height_grid *h,
                        const aspi_profile_options *options, aspi_raw *raw, asp_error *error) {
  asp_code code = check(text, h, error);
  if (code)
    return code;
  const char *by_column = options->column;
  long chosen = by_column ? strtol(by_column, NULL, 10) : options->row;
  double most = by_column ? h->points : h->profiles;
  if (chosen < 1 || (double)chosen > most)
    return aspi_file_fail(text->path, text->line, error, "%s %ld is asked for; the map has %.0f",
                          by_column ? "column" : "row", chosen, most);
  raw->step[0] = by_column ? h->y_scale : h->x_scale;
  raw->step[1] = h->y_scale;
  if (raw->is_map) {
    raw->columns = (size_t)h->points;
    raw->rows = (size_t)h->profiles;
  }
  code = read_heights(text, h, by_column ? 0 : (size_t)chosen, by_column ? (size_t)chosen : 0, raw,
                      error);
  raw->read = raw->points;
  return code;
}
