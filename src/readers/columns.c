/* Measured walls as text in columns: positions and heights of a profile, or heights alone; a map as
 * a matrix of heights, a line a row, or as lines of x, y, z on a grid. Of a matrix the head that
 * Gwyddion writes (`# Width: 100 um`, `# Height:`, `# Value units:`) is understood; else the
 * spacing and the unit must be given.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/points.h"
#include "readers/table.h"

#include <math.h>
#include <stdlib.h>

/* A height in m; notes where it is bad. */
static double height_of(const aspi_table *t, const aspi_field *f, double unit,
                        aspi_missing *missing, aspi_raw *raw) {
  double z = aspi_missing_note(missing, f->value, t->text.line);
  if (isnan(z) && raw->bad++ == 0)
    raw->bad_line = t->text.line;
  return z * unit;
}

static asp_code read_matrix(aspi_table *t, const aspi_profile_options *options,
                            aspi_missing *missing, aspi_raw *raw, asp_error *error) {
  double unit = options->unit_z > 0 ? options->unit_z : t->unit;
  asp_code code = ASP_OK;
  if (!(unit > 0))
    return aspi_text_fail(&t->text, t->text.line, error,
                          "no unit of the heights is stated before the first numbers; say which "
                          "unit of length they are in (reader: unit_z)");
  raw->columns = (size_t)t->due;
  for (bool found = true; found && !code;) {
    for (int i = 0; i < t->count && !code; i++)
      code = aspi_raw_add(raw, height_of(t, &t->fields[i], unit, missing, raw), error);
    raw->rows++;
    if (!code)
      code = aspi_table_next(t, NULL, &found, error);
  }
  for (int k = 0; k < 2; k++)
    raw->step[k] = options->step[k] > 0 ? options->step[k]
                                        : t->side[k] / (double)(k ? raw->rows : raw->columns);
  if (!code && !(raw->step[0] > 0))
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: a matrix of heights does not say how far apart its points are; tell "
                     "it (reader: step_x, step_y)",
                     t->text.path);
  raw->step[1] = raw->step[1] > 0 ? raw->step[1] : raw->step[0];
  return code;
}

/* Lines of positions and heights; of a profile without positions they are the step apart. */
static asp_code read_points(aspi_table *t, const aspi_axes *axes,
                            const aspi_profile_options *options, aspi_missing *missing,
                            aspi_points *points, aspi_raw *raw, asp_error *error) {
  const int *at = axes->column;
  asp_code code = ASP_OK;
  if (at[0] >= 0 && options->step[0] > 0)
    return aspi_text_fail(
        &t->text, t->text.line, error,
        "the spacing is given (step), but the file has the positions of its points");
  for (bool found = true; found && !code;) {
    const aspi_field *f = t->fields;
    double position[2] = {(double)points->count * options->step[0], 0};
    for (int k = 0; k < 2; k++)
      if (at[k] >= 0) {
        position[k] = f[at[k]].value;
        aspi_points_precision(points, f[at[k]].text);
      }
    double z = height_of(t, &f[at[2]], axes->unit[2], missing, raw);
    code = aspi_points_add(points, (aspi_point){position[0], position[1], z, t->text.line}, error);
    if (!code)
      code = aspi_table_next(t, axes, &found, error);
  }
  return code;
}

/* Notes how the file was read. */
static void describe(const aspi_table *t, const aspi_axes *axes, aspi_raw *raw) {
  if (t->due > 2 && !raw->is_map) {
    raw->column[0] = axes->column[0] + 1;
    raw->column[1] = axes->column[2] + 1;
    raw->second_column = axes->column[1] + 1;
  }
  raw->end_line = t->end_line;
  raw->were_depths = axes->unit[2] < 0;
}

asp_code aspi_read_columns(const aspi_text *text, const aspi_profile_options *options,
                           aspi_raw *raw, asp_error *error) {
  aspi_missing missing = {.stated = options->missing};
  aspi_points points = {0};
  aspi_axes axes;
  bool is_matrix, chosen = options->x_column && (options->z_column || options->column);
  aspi_table *t;
  asp_code code = aspi_table_open(text, !raw->is_map && options->step[0] > 0 ? 1 : 2, &t, error);
  if (!code)
    code = aspi_table_find(t, options, raw->is_map, &axes, &is_matrix, error);
  if (!code && is_matrix)
    code = read_matrix(t, options, &missing, raw, error);
  else if (!code)
    code = read_points(t, &axes, options, &missing, &points, raw, error);
  if (!code && !chosen)
    code = aspi_missing_check(&missing, text->path, error);
  if (!code && !is_matrix) {
    describe(t, &axes, raw);
    code = raw->is_map ? aspi_points_grid(&points, text->path, axes.unit, raw, error)
                       : aspi_points_line(&points, text->path, axes.unit, axes.column[1] >= 0,
                                          options->resample, raw, error);
  }
  free(points.list);
  aspi_table_close(t);
  return code;
}
