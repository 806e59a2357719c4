/* SUR of Digital Surf: 512 bytes, of which those that matter are at the places below (as Gwyddion's
 * surffile.c has them), a comment and a private part, and the heights.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/units.h"
#include "readers/grid.h"

#include <math.h>
#include <string.h>

/* The unit of a length in SUR, 16 bytes. */
static double unit_at(const unsigned char *bytes) {
  char name[17];
  snprintf(name, sizeof name, "%.16s", (const char *)bytes);
  char *rest = name;
  const char *unit = aspi_text_field(&rest, '\0');
  return aspi_unit_meters(unit, strlen(unit));
}

static asp_code read_header(aspi_text *text, aspi_height_grid *h, aspi_raw *raw, asp_error *error) {
  enum {
    OBJECTS = 14,
    TYPE = 18,
    MISSING = 86,
    BITS = 98,
    LEAST = 100,
    COUNTS = 108,
    STEPS = 120,
    UNITS = 180
  };
  enum { COMMENT = 334, HEAD = 512 };
  unsigned char head[HEAD];
  if (fread(head, 1, sizeof head, text->stream) != sizeof head)
    return aspi_cut_short(text, "header", error);
  *h = (aspi_height_grid){
      .points = (double)aspi_bytes_whole(head + COUNTS, 4),
      .profiles = (double)aspi_bytes_whole(head + COUNTS + 4, 4),
      .x_scale = aspi_bytes_real(head + STEPS) * unit_at(head + UNITS),
      .y_scale = aspi_bytes_real(head + STEPS + 4) * unit_at(head + UNITS + 16),
      .z_scale = aspi_bytes_real(head + STEPS + 8) * unit_at(head + UNITS + 32),
      .type = aspi_bytes_whole(head + BITS, 2) == 32   ? 6
              : aspi_bytes_whole(head + BITS, 2) == 16 ? 5
                                                       : -2,
      .mark = aspi_bytes_whole(head + MISSING, 2) ? aspi_bytes_height(head + LEAST, 6) - 2 : NAN};
  if (aspi_bytes_whole(head + OBJECTS, 2) > 1)
    snprintf(raw->note, sizeof raw->note, "of its %d objects the first is read",
             (int)aspi_bytes_whole(head + OBJECTS, 2));
  fseek(text->stream,
        (long)(aspi_bytes_whole(head + COMMENT, 2) + aspi_bytes_whole(head + COMMENT + 2, 2)),
        SEEK_CUR);
  if (aspi_bytes_whole(head + TYPE, 2) > 2)
    return aspi_file_fail(text->path, 0, error,
                          "a SUR file of type %d, which is neither a profile nor a surface",
                          (int)aspi_bytes_whole(head + TYPE, 2));
  return ASP_OK;
}

asp_code aspi_read_sur(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                       asp_error *error) {
  aspi_height_grid h;
  asp_code code = read_header(text, &h, raw, error);
  return code ? code : aspi_read_grid(text, &h, options, raw, error);
}
