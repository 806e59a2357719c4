/* SDF (ISO 25178-71, and the older BCR-1.0 with the same layout). In ASCII: a header of `key =
 * value` lines, a star, the heights of all profiles in turn, a star, a trailer. In binary: 8 bytes
 * of version, 10 of maker, two dates of 12, counts of 2 bytes each (of 4 in version 2.0), four
 * doubles, three single bytes, and the heights row after row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/grid.h"

#include <math.h>
#include <string.h>

/* One line of the header; *ends at the star. */
static asp_code read_key(aspi_text *text, aspi_height_grid *h, bool *ends, asp_error *error) {
  char *rest = text->text, *key = aspi_text_field(&rest, '='),
       *value = aspi_text_field(&rest, '\0');
  *ends = strcmp(key, "*") == 0;
  if (*ends || (!*key && !value))
    return ASP_OK;
  if (!value)
    return aspi_file_fail(text->path, text->line, error,
                          "'%.40s' where the header's `key = value` or its closing * is expected",
                          key);
  double *number = aspi_grid_number(h, key);
  return number && aspi_text_number(value, false, number) != ASP_WORD_NUMBER
             ? aspi_file_fail(text->path, text->line, error,
                              "%.40s is '%.40s'; a number is expected", key, value)
             : ASP_OK;
}

static asp_code read_text_header(aspi_text *text, aspi_height_grid *h, asp_error *error) {
  *h = (aspi_height_grid){NAN, NAN, NAN, NAN, NAN, 0, -1, NAN};
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

static asp_code read_binary_header(aspi_text *text, aspi_height_grid *h, asp_error *error) {
  unsigned char head[96];
  size_t width = 2, at = 8 + 10 + 12 + 12;
  if (fread(head, 1, 8, text->stream) != 8)
    return aspi_cut_short(text, "header", error);
  if (memcmp(head + 1, "ISO-2", 5) == 0)
    width = 4;
  size_t length = at + 2 * width + 4 * 8 + 3;
  if (fread(head + 8, 1, length - 8, text->stream) != length - 8)
    return aspi_cut_short(text, "header", error);
  const unsigned char *scales = head + at + 2 * width;
  *h = (aspi_height_grid){.points = (double)aspi_bytes_whole(head + at, (int)width),
                          .profiles = (double)aspi_bytes_whole(head + at + width, (int)width),
                          .x_scale = aspi_bytes_double(scales),
                          .y_scale = aspi_bytes_double(scales + 8),
                          .z_scale = aspi_bytes_double(scales + 16),
                          .compression = scales[32],
                          .type = scales[33],
                          .mark = NAN};
  return ASP_OK;
}

asp_code aspi_read_sdf(aspi_text *text, bool is_binary, const aspi_profile_options *options,
                       aspi_raw *raw, asp_error *error) {
  aspi_height_grid h;
  asp_code code =
      is_binary ? read_binary_header(text, &h, error) : read_text_header(text, &h, error);
  return code ? code : aspi_read_grid(text, &h, options, raw, error);
}
