/* Maps from files: which reader a file needs, and SDF (ISO 25178-71) in both its forms. The text
 * form is that of profiles, with all of its rows kept. The binary one: 8 bytes of version, 10 of
 * maker, two dates of 12, counts of 2 bytes each (of 4 in version 2.0), four doubles, three single
 * bytes, and the heights row after row, all in little-endian order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/map_read.h"
#include "base/error.h"
#include "readers/mend.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Largest side of a map: points are 32-bit numbers to those who read it. */
#define SIDE_MOST ((double)ASP_MAP_SIDE_MOST)

/* ---- SDF in binary ---- */

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

static asp_code cut_short(const char *path, const char *what, asp_error *error) {
  return aspi_fail(error, ASP_EDATA, "%.200s: the file ends within its %s", path, what);
}

static asp_code check_sizes(const char *path, const aspi_raw *raw, double points, double rows,
                            double z_scale, asp_error *error) {
  const struct {
    const char *name;
    double value, least, most;
  } all[] = {{"NumPoints", points, ASP_MAP_SIDE_LEAST, SIDE_MOST},
             {"NumProfiles", rows, ASP_MAP_SIDE_LEAST, SIDE_MOST},
             {"Xscale", raw->step[0], 1e-15, 1e9},
             {"Yscale", raw->step[1], 1e-15, 1e9},
             {"Zscale", z_scale, 1e-300, 1e300}};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    if (!(all[i].value >= all[i].least && all[i].value <= all[i].most))
      return aspi_fail(error, ASP_EDATA, "%.200s: %s is %g; it must be %g to %g", path, all[i].name,
                       all[i].value, all[i].least, all[i].most);
  return ASP_OK;
}

static asp_code read_binary(FILE *stream, const char *path, aspi_raw *raw, asp_error *error) {
  unsigned char head[96];
  size_t width = 2, at = 8 + 10 + 12 + 12;
  if (fread(head, 1, 8, stream) != 8)
    return cut_short(path, "header", error);
  if (memcmp(head + 1, "ISO-2", 5) == 0)
    width = 4;
  size_t length = at + 2 * width + 4 * 8 + 3;
  if (fread(head + 8, 1, length - 8, stream) != length - 8)
    return cut_short(path, "header", error);
  double points = (double)whole(head + at, (int)width);
  double rows = (double)whole(head + at + width, (int)width);
  at += 2 * width;
  raw->step[0] = real64(head + at);
  raw->step[1] = real64(head + at + 8);
  double z_scale = real64(head + at + 16);
  int compression = head[at + 32], type = head[at + 33];
  asp_code code = check_sizes(path, raw, points, rows, z_scale, error);
  if (code)
    return code;
  if (compression)
    return aspi_fail(error, ASP_EDATA, "%.200s: Compression is %d; only 0 can be read", path,
                     compression);
  if (type >= TYPES)
    return aspi_fail(error, ASP_EDATA, "%.200s: DataType is %d; it must be 0 to 7", path, type);
  raw->columns = (size_t)points;
  raw->rows = (size_t)rows;
  unsigned char bytes[8];
  for (size_t i = 0; i < raw->columns * raw->rows && !code; i++) {
    if (fread(bytes, 1, (size_t)size_of[type], stream) != (size_t)size_of[type])
      return cut_short(path, "heights", error);
    code = aspi_raw_add(raw, z_scale * height_of(bytes, type), error);
  }
  return code;
}

/* ---- SDF as text ---- */

static asp_code read_as_text(FILE *stream, const char *path, aspi_raw *raw, asp_error *error) {
  aspi_text text = aspi_text_create(stream, path);
  aspi_sdf h;
  bool found = true;
  asp_code code;
  do /* to the version */
    code = aspi_text_line(&text, &found, error);
  while (!code && found && aspi_text_blank(text.text));
  if (!code)
    code = aspi_sdf_header(&text, &h, error);
  if (code)
    return code;
  raw->step[0] = h.x_scale;
  raw->step[1] = h.y_scale;
  if ((code = check_sizes(path, raw, h.points, h.profiles, h.z_scale, error)))
    return code;
  raw->columns = (size_t)h.points;
  raw->rows = (size_t)h.profiles;
  for (size_t i = 0; i < raw->columns * raw->rows && !code; i++) {
    double height;
    code = aspi_sdf_height(&text, &h, i, &height, error);
    if (!code)
      code = aspi_raw_add(raw, height * h.z_scale, error);
  }
  return code ? code : aspi_sdf_end(&text, &h, error);
}

/* ---- any file ---- */

/* Rejects options that apply to profiles only. */
static asp_code check_options(const char *path, const aspi_profile_options *o, asp_error *error) {
  const struct {
    const char *name;
    bool given;
  } all[] = {{"tip", o->filters.tip > 0},       {"lambda_s", o->filters.lambda_s > 0},
             {"cutoff", o->filters.cutoff > 0}, {"column", o->column > 0},
             {"x_column", o->x_number > 0},     {"row", o->row != 1}};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    if (all[i].given)
      return aspi_fail(error, ASP_EARG, "%.200s: %s is given, which is for profiles, not for maps",
                       path, all[i].name);
  return ASP_OK;
}

asp_map *aspi_map_read_stream(FILE *stream, const char *path, const aspi_map_options *options,
                              aspi_profile_report *report, asp_error *error) {
  aspi_raw raw = {.is_map = true, .zero = NAN};
  aspi_format format = ASP_FORMAT_TEXT;
  asp_code code = check_options(path, options->read, error);
  if (!code)
    code = aspi_format_find(stream, path, &format, error);
  if (!code && format != ASP_FORMAT_TEXT)
    code = aspi_sdf_check_options(path, options->read, options->step[0], error);
  if (!code)
    code = format == ASP_FORMAT_TEXT       ? aspi_read_map_text(stream, path, options, &raw, error)
           : format == ASP_FORMAT_SDF_TEXT ? read_as_text(stream, path, &raw, error)
                                           : read_binary(stream, path, &raw, error);
  raw.read = raw.points;
  raw.bad = aspi_raw_count_bad(&raw);
  raw.step_least = raw.step[0];
  raw.step_most = raw.step[1];
  if (!code)
    code = aspi_mend(&raw, path, options->read, report, error);
  if (code) {
    free(raw.heights);
    return NULL;
  }
  aspi_report(report, &raw, options->read);
  double metre = options->read->metre, step[2] = {raw.step[0] * metre, raw.step[1] * metre};
  double mean = 0;
  for (size_t i = 0; i < raw.points; i++)
    mean += aspi_raw_at(&raw, i) / (double)raw.points;
  for (size_t i = 0; i < raw.points; i++)
    aspi_raw_put(&raw, i, (aspi_raw_at(&raw, i) - mean) * metre);
  return aspi_map_adopt(raw.heights, raw.columns, raw.rows, step, false, error);
}
