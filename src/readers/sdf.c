/* Profiles and maps in SDF, ASCII (ISO 25178-71, and the older aBCR-1.0 with the same layout): a
 * header of `key = value` lines, a star, the heights of all profiles in turn, a star, a trailer. Of
 * a map one row or one column is kept. The binary form is for maps only (map_read.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The variable of a key; NULL for keys that do not matter here. */
static double *place_of(aspi_sdf *h, const char *key) {
  const struct {
    const char *key;
    double *place;
  } keys[] = {{"NumPoints", &h->points}, {"NumProfiles", &h->profiles},
              {"Xscale", &h->x_scale},   {"Yscale", &h->y_scale},
              {"Zscale", &h->z_scale},   {"Compression", &h->compression}};
  for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
    if (strcasecmp(keys[i].key, key) == 0)
      return keys[i].place;
  return NULL;
}

/* One line of the header; *ends at the star. */
static asp_code read_key(aspi_text *text, aspi_sdf *h, bool *ends, asp_error *error) {
  char *line = aspi_text_trim(text->text);
  *ends = strcmp(line, "*") == 0;
  if (*ends || !*line)
    return ASP_OK;
  char *equals = strchr(line, '=');
  if (!equals)
    return aspi_text_fail(text, text->line, error,
                          "'%.40s' where the header's `key = value` or its closing * is expected",
                          line);
  *equals = '\0';
  char *key = aspi_text_trim(line), *value = aspi_text_trim(equals + 1);
  double *place = place_of(h, key);
  if (place && aspi_text_number(value, false, place) != ASP_WORD_NUMBER)
    return aspi_text_fail(text, text->line, error, "%.40s is '%.40s'; a number is expected", key,
                          value);
  return ASP_OK;
}

static asp_code check_counts(const aspi_text *text, const aspi_sdf *h, asp_error *error) {
  const struct {
    const char *key;
    double value;
  } counts[] = {{"NumPoints", h->points}, {"NumProfiles", h->profiles}};
  for (size_t i = 0; i < 2; i++) {
    double value = counts[i].value;
    if (isnan(value))
      return aspi_text_fail(text, text->line, error, "the header ends without %s", counts[i].key);
    if (!(value >= 1 && value <= 1e12) || value > floor(value))
      return aspi_text_fail(text, text->line, error, "%s is %g; a whole number from 1 is expected",
                            counts[i].key, value);
  }
  return ASP_OK;
}

static asp_code check_scales(const aspi_text *text, const aspi_sdf *h, asp_error *error) {
  const struct {
    const char *key;
    double value;
    bool needed;
  } scales[] = {{"Xscale", h->x_scale, true},
                {"Yscale", h->y_scale, h->profiles > 1},
                {"Zscale", h->z_scale, true}};
  for (size_t i = 0; i < 3; i++) {
    if (scales[i].needed && isnan(scales[i].value))
      return aspi_text_fail(text, text->line, error, "the header ends without %s", scales[i].key);
    if (scales[i].needed && !(scales[i].value > 0))
      return aspi_text_fail(text, text->line, error, "%s is %g; a number > 0 is expected",
                            scales[i].key, scales[i].value);
  }
  if (h->compression > 0)
    return aspi_text_fail(text, text->line, error, "Compression is %g; only 0 can be read",
                          h->compression);
  return ASP_OK;
}

asp_code aspi_sdf_check_options(const char *path, const aspi_profile_options *options, double step,
                                asp_error *error) {
  const struct {
    const char *name;
    bool given;
  } all[] = {{"unit", options->unit_x > 0 || options->unit_z > 0},
             {"step", step > 0},
             {"missing", options->has_missing},
             {"x-column", options->x_column || options->x_number > 0},
             {"z-column", options->z_column != NULL}};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    if (all[i].given)
      return aspi_fail(
          error, ASP_EARG,
          "%.200s: %s is given; a file in SDF states its units, spacing and bad points "
          "itself",
          path, all[i].name);
  return ASP_OK;
}

asp_code aspi_sdf_header(aspi_text *text, aspi_sdf *h, asp_error *error) {
  *h = (aspi_sdf){NAN, NAN, NAN, NAN, NAN, 0};
  for (bool ends = false, found; !ends;) {
    asp_code code = aspi_text_line(text, &found, error);
    if (!code && !found)
      code = aspi_text_fail(text, text->line, error, "the file ends within the SDF header");
    if (!code)
      code = read_key(text, h, &ends, error);
    if (code)
      return code;
  }
  asp_code code = check_counts(text, h, error);
  return code ? code : check_scales(text, h, error);
}

/* One height of the map; *height is NAN where it is marked as bad. */
asp_code aspi_sdf_height(aspi_text *text, const aspi_sdf *h, size_t index, double *height,
                         asp_error *error) {
  bool found;
  asp_code code = aspi_text_word(text, &found, error);
  if (code)
    return code;
  if (!found || strcmp(text->text, "*") == 0)
    return aspi_text_fail(text, text->line, error,
                          "the heights end after %zu; NumPoints x NumProfiles is %.0f x %.0f",
                          index, h->points, h->profiles);
  if (aspi_text_number(text->text, false, height) == ASP_WORD_OTHER)
    return aspi_text_fail(text, text->line, error, "'%.40s' where a height is expected",
                          text->text);
  return ASP_OK;
}

asp_code aspi_sdf_end(aspi_text *text, const aspi_sdf *h, asp_error *error) {
  bool found;
  asp_code code = aspi_text_word(text, &found, error);
  if (!code && found && text->text[0] != '*')
    code = aspi_text_fail(text, text->line, error,
                          "'%.40s' after the last of %.0f x %.0f heights, where a * is expected",
                          text->text, h->points, h->profiles);
  return code;
}

/* Row or column of a map to keep, from 1; the other is 0. */
typedef struct section {
  size_t row, column;
} section;

static asp_code read_map(aspi_text *text, const aspi_sdf *h, section kept, aspi_raw *raw,
                         asp_error *error) {
  size_t points = (size_t)h->points, profiles = (size_t)h->profiles;
  for (size_t row = 1; row <= profiles; row++)
    for (size_t column = 1; column <= points; column++) {
      double height;
      asp_code code = aspi_sdf_height(text, h, (row - 1) * points + column - 1, &height, error);
      if (!code && (row == kept.row || column == kept.column)) {
        if (isnan(height) && raw->bad++ == 0)
          raw->bad_line = text->line;
        code = aspi_raw_add(raw, height * h->z_scale, error);
      }
      if (code)
        return code;
    }
  return aspi_sdf_end(text, h, error);
}

asp_code aspi_read_sdf(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                       asp_error *error) {
  aspi_sdf h;
  asp_code code = aspi_sdf_header(text, &h, error);
  if (code)
    return code;
  bool by_column = options->column > 0;
  int chosen = by_column ? options->column : options->row;
  double most = by_column ? h.points : h.profiles;
  if (chosen > most)
    return aspi_text_fail(text, text->line, error, "%s %d is asked for; the map has %.0f",
                          by_column ? "column" : "row", chosen, most);
  raw->step[0] = by_column ? h.y_scale : h.x_scale;
  section kept = {by_column ? 0 : (size_t)chosen, by_column ? (size_t)chosen : 0};
  code = read_map(text, &h, kept, raw, error);
  raw->read = raw->points;
  raw->step_least = raw->step_most = raw->step[0];
  return code;
}
