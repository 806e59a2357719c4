/* Grids of heights: SDF (ISO 25178-71, and the older BCR-1.0 with the same layout) and SUR of
 * Digital Surf. SDF in ASCII: a header of `key = value` lines, a star, the heights of all profiles
 * in turn, a star, a trailer. In binary: 8 bytes of version, 10 of maker, two dates of 12, counts
 * of 2 bytes each (of 4 in version 2.0), four doubles, three single bytes, and the heights row
 * after row. SUR: 512 bytes, of which those that matter are at the places below (as Gwyddion's
 * surffile.c has them), a comment and a private part, and the heights. All in little-endian order.
 * A map is read whole; a profile is one of its rows or columns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/units.h"
#include "readers/read.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- header in ASCII ---- */

/* The keys that matter, and the range of their numbers. */
static const struct {
  const char *key;
  size_t place;
  double least, most;
  bool whole;
} keys[] = {{"NumPoints", offsetof(aspi_sdf, points), 1, 1e12, true},
            {"NumProfiles", offsetof(aspi_sdf, profiles), 1, 1e12, true},
            {"Xscale", offsetof(aspi_sdf, x_scale), 1e-15, 1e9, false},
            {"Yscale", offsetof(aspi_sdf, y_scale), 1e-15, 1e9, false},
            {"Zscale", offsetof(aspi_sdf, z_scale), 1e-300, 1e300, false},
            {"Compression", offsetof(aspi_sdf, compression), 0, 0, true}};
enum { KEYS = sizeof keys / sizeof *keys, YSCALE = 3 };

static double *place_of(const aspi_sdf *h, size_t key) {
  return (double *)((char *)h + keys[key].place);
}

/* One line of the header; *ends at the star. */
static asp_code read_key(aspi_text *text, aspi_sdf *h, bool *ends, asp_error *error) {
  char *rest = text->text, *key = aspi_text_field(&rest, '='),
       *value = aspi_text_field(&rest, '\0');
  *ends = strcmp(key, "*") == 0;
  if (*ends || (!*key && !value))
    return ASP_OK;
  if (!value)
    return aspi_file_fail(text->path, text->line, error,
                          "'%.40s' where the header's `key = value` or its closing * is expected",
                          key);
  for (size_t i = 0; i < KEYS; i++)
    if (strcasecmp(keys[i].key, key) == 0 &&
        aspi_text_number(value, false, place_of(h, i)) != ASP_WORD_NUMBER)
      return aspi_file_fail(text->path, text->line, error, "%.40s is '%.40s'; a number is expected",
                            key, value);
  return ASP_OK;
}

static asp_code read_text_header(aspi_text *text, aspi_sdf *h, asp_error *error) {
  *h = (aspi_sdf){NAN, NAN, NAN, NAN, NAN, 0, -1, NAN};
  for (bool ends = false, version = true, found; !ends;) { /* the version stands first */
    asp_code code = aspi_text_line(text, &found, error);
    if (!code && found && version) {
      version = aspi_text_blank(text->text);
      continue;
    }
    if (!code && !found)
      code = aspi_file_fail(text->path, text->line, error, "the file ends within the SDF header");
    if (!code)
      code = read_key(text, h, &ends, error);
    if (code)
      return code;
  }
  text->rest = NULL; /* the star was read */
  return ASP_OK;
}

/* ---- binary ---- */

static uint64_t whole(const unsigned char *bytes, int size) {
  uint64_t value = 0;
  for (int k = size - 1; k >= 0; k--)
    value = value << 8 | bytes[k];
  return value;
}

static double real64(const unsigned char *bytes) {
  uint64_t bits = whole(bytes, 8);
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static double real32(const unsigned char *bytes) {
  uint32_t bits = (uint32_t)whole(bytes, 4);
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

/* The types of a height by their number, with the mark of a bad one: the least of signed and real
 * types, the most of unsigned ones (those of one byte have none). */
enum { TYPES = 8 };
static const int size_of[TYPES] = {1, 2, 4, 4, 1, 2, 4, 8};

static double height_of(const unsigned char *bytes, int type) {
  uint64_t bits = whole(bytes, size_of[type]);
  uint64_t half = (uint64_t)1 << (8 * size_of[type] - 1), full = half + (half - 1);
  switch (type) {
  case 0:
    return (double)bits;
  case 1:
  case 2:
    return bits == full ? NAN : (double)bits;
  case 3: {
    double value = real32(bytes);
    return fabs(value) < 3e38 ? value : NAN;
  }
  case 7: {
    double value = real64(bytes);
    return fabs(value) < 1e300 ? value : NAN;
  }
  default:
    return bits == half && type != 4 ? NAN
           : bits < half             ? (double)bits
                                     : (double)bits - 2 * (double)half;
  }
}

static asp_code cut_short(const aspi_text *text, const char *what, asp_error *error) {
  return aspi_file_fail(text->path, 0, error, "the file ends within its %s", what);
}

static asp_code read_binary_header(aspi_text *text, aspi_sdf *h, asp_error *error) {
  unsigned char head[96];
  size_t width = 2, at = 8 + 10 + 12 + 12;
  if (fread(head, 1, 8, text->stream) != 8)
    return cut_short(text, "header", error);
  if (memcmp(head + 1, "ISO-2", 5) == 0)
    width = 4;
  size_t length = at + 2 * width + 4 * 8 + 3;
  if (fread(head + 8, 1, length - 8, text->stream) != length - 8)
    return cut_short(text, "header", error);
  const unsigned char *scales = head + at + 2 * width;
  *h = (aspi_sdf){.points = (double)whole(head + at, (int)width),
                  .profiles = (double)whole(head + at + width, (int)width),
                  .x_scale = real64(scales),
                  .y_scale = real64(scales + 8),
                  .z_scale = real64(scales + 16),
                  .compression = scales[32],
                  .type = scales[33],
                  .mark = NAN};
  return ASP_OK;
}

/* The unit of a length in SUR, 16 bytes. */
static double unit_at(const unsigned char *bytes) {
  char name[17];
  snprintf(name, sizeof name, "%.16s", (const char *)bytes);
  char *rest = name;
  const char *unit = aspi_text_field(&rest, '\0');
  return aspi_unit_meters(unit, strlen(unit));
}

static asp_code read_sur_header(aspi_text *text, aspi_sdf *h, asp_error *error) {
  enum { TYPE = 18, MISSING = 86, BITS = 98, LEAST = 100, COUNTS = 108, STEPS = 120, UNITS = 180 };
  enum { COMMENT = 334, HEAD = 512 };
  unsigned char head[HEAD];
  if (fread(head, 1, sizeof head, text->stream) != sizeof head)
    return cut_short(text, "header", error);
  *h = (aspi_sdf){.points = (double)whole(head + COUNTS, 4),
                  .profiles = (double)whole(head + COUNTS + 4, 4),
                  .x_scale = real32(head + STEPS) * unit_at(head + UNITS),
                  .y_scale = real32(head + STEPS + 4) * unit_at(head + UNITS + 16),
                  .z_scale = real32(head + STEPS + 8) * unit_at(head + UNITS + 32),
                  .type = whole(head + BITS, 2) == 32   ? 6
                          : whole(head + BITS, 2) == 16 ? 5
                                                        : -2,
                  .mark = whole(head + MISSING, 2) ? height_of(head + LEAST, 6) - 2 : NAN};
  fseek(text->stream, (long)(whole(head + COMMENT, 2) + whole(head + COMMENT + 2, 2)), SEEK_CUR);
  if (whole(head + TYPE, 2) > 2)
    return aspi_file_fail(text->path, 0, error,
                          "a SUR file of type %d, which is neither a profile nor a surface",
                          (int)whole(head + TYPE, 2));
  return ASP_OK;
}

/* ---- heights ---- */

/* A height, before z_scale; NAN if it is marked as bad. */
static asp_code read_height(aspi_text *text, const aspi_sdf *h, size_t index, double *height,
                            asp_error *error) {
  if (h->type >= 0) {
    unsigned char bytes[8];
    size_t size = (size_t)size_of[h->type];
    if (fread(bytes, 1, size, text->stream) != size)
      return cut_short(text, "heights", error);
    *height = height_of(bytes, h->type);
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
static asp_code read_end(aspi_text *text, const aspi_sdf *h, asp_error *error) {
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
static asp_code read_heights(aspi_text *text, const aspi_sdf *h, size_t row_kept,
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

/* ---- both ---- */

/* Checks the numbers of a header; a single profile needs no distance between profiles. */
static asp_code check(const aspi_text *text, const aspi_sdf *h, asp_error *error) {
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

asp_code aspi_read_grid(aspi_text *text, const aspi_sdf *h, const aspi_profile_options *options,
                        aspi_raw *raw, asp_error *error) {
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

asp_code aspi_read_sdf(aspi_text *text, aspi_format format, const aspi_profile_options *options,
                       aspi_raw *raw, asp_error *error) {
  aspi_sdf h;
  asp_code code = format == ASP_FORMAT_SUR          ? read_sur_header(text, &h, error)
                  : format == ASP_FORMAT_SDF_BINARY ? read_binary_header(text, &h, error)
                                                    : read_text_header(text, &h, error);
  return code ? code : aspi_read_grid(text, &h, options, raw, error);
}
