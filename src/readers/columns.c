/* Profiles as text in columns: positions and heights, or heights alone. Where there are X, Y and a
 * height, the position is the distance from the first point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/positions.h"
#include "readers/table.h"

#include <math.h>
#include <stdlib.h>

static asp_code read_lines(aspi_table *t, const aspi_axes *axes,
                           const aspi_profile_options *options, aspi_positions *positions,
                           aspi_raw *raw, asp_error *error) {
  const int *at = axes->column;
  bool chosen =
      (options->x_column || options->x_number > 0) && (options->z_column || options->column > 0);
  aspi_missing missing = {.stated = options->has_missing ? options->missing : NAN};
  asp_code code = ASP_OK;
  for (bool found = true; found && !code;) {
    const aspi_field *f = t->fields;
    for (int k = 0; k < 2; k++)
      if (at[k] >= 0)
        aspi_positions_precision(positions, f[at[k]].text);
    double z = aspi_missing_note(&missing, f[at[2]].value, t->text.line);
    if (isnan(z) && raw->bad++ == 0)
      raw->bad_line = t->text.line;
    code = aspi_positions_add(positions, &t->text,
                              at[0] < 0 ? (double)positions->points * options->step[0]
                                        : f[at[0]].value,
                              at[1] < 0 ? 0 : f[at[1]].value, z * axes->unit[2], error);
    if (!code)
      code = aspi_table_next(t, axes, &found, error);
  }
  return code || chosen ? code : aspi_missing_check(&missing, t->text.path, error);
}

/* Notes how the file was read, lengths in m. */
static void describe(const aspi_table *t, const aspi_axes *axes, const aspi_positions *positions,
                     aspi_raw *raw) {
  const double *last = positions->plane.last;
  if (t->due > 2) {
    raw->column[0] = axes->column[0] + 1;
    raw->column[1] = axes->column[2] + 1;
  }
  raw->second_column = last[1] * last[1] > 0 ? axes->column[1] + 1 : 0;
  raw->end_line = t->end_line;
  raw->were_depths = axes->unit[2] < 0;
  raw->step_least *= axes->unit[0];
  raw->step_most *= axes->unit[0];
  raw->step[0] *= axes->unit[0];
}

asp_code aspi_read_columns(const aspi_text *text, const aspi_profile_options *options,
                           aspi_raw *raw, asp_error *error) {
  aspi_positions positions;
  aspi_axes axes;
  bool is_matrix;
  aspi_table *t;
  asp_code code = aspi_table_open(text, options->step[0] > 0 ? 1 : 2, &t, error);
  aspi_positions_begin(&positions);
  if (!code)
    code = aspi_table_find(t, options, false, &axes, &is_matrix, error);
  if (!code) {
    positions.ratio = axes.column[1] < 0 ? 0 : axes.unit[1] / axes.unit[0];
    code = read_lines(t, &axes, options, &positions, raw, error);
  }
  if (!code)
    code = aspi_positions_space(&positions, &t->text, options->resample, raw, error);
  if (!code)
    describe(t, &axes, &positions, raw);
  free(positions.list);
  aspi_table_close(t);
  return code;
}
