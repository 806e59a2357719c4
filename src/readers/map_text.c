/* Maps as text: a matrix of heights, a line a row, or lines of x, y, z on a grid. What Gwyddion
 * writes at the head of its matrices (`# Width: 100 um`, `# Height:`, `# Value units:`) is
 * understood; else the spacing and the unit must be given.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/table.h"

#include <math.h>
#include <stdlib.h>

static asp_code fail_at(const aspi_table *t, asp_error *error, const char *what) {
  return aspi_text_fail(&t->text, t->text.line, error, "%s", what);
}

static asp_code read_matrix(aspi_table *t, const aspi_profile_options *options,
                            aspi_missing *missing, aspi_raw *raw, asp_error *error) {
  double unit = options->unit_z > 0 ? options->unit_z : t->unit;
  asp_code code = ASP_OK;
  if (!(unit > 0))
    return fail_at(t, error,
                   "no unit of the heights is stated before the first numbers; say which "
                   "unit of length they are in (reader: unit_z)");
  raw->columns = (size_t)t->due;
  for (bool found = true; found && !code;) {
    for (int i = 0; i < t->count && !code; i++)
      code = aspi_raw_add(raw, unit * aspi_missing_note(missing, t->fields[i].value, t->text.line),
                          error);
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

static asp_code read_triples(aspi_table *t, const aspi_profile_options *options,
                             const aspi_axes *axes, aspi_missing *missing, aspi_raw *raw,
                             asp_error *error) {
  if (options->step[0] > 0)
    return fail_at(t, error,
                   "the spacing is given (step), but the file has the positions of its points");
  aspi_map_points points = {0};
  asp_code code = ASP_OK;
  raw->were_depths = axes->unit[2] < 0;
  for (bool found = true; found && !code;) {
    double point[ASP_MAP_AXES];
    for (int k = 0; k < ASP_MAP_AXES; k++)
      point[k] = t->fields[axes->column[k]].value;
    point[2] = aspi_missing_note(missing, point[2], t->text.line);
    code = aspi_map_points_add(&points, point, error);
    if (!code)
      code = aspi_table_next(t, axes, &found, error);
  }
  if (!code)
    code = aspi_map_points_place(&points, t->text.path, axes->unit, raw, error);
  free(points.at);
  return code;
}

asp_code aspi_read_map_text(const aspi_text *text, const aspi_profile_options *options,
                            aspi_raw *raw, asp_error *error) {
  aspi_missing missing = {.stated = options->has_missing ? options->missing : NAN};
  aspi_axes axes;
  bool is_matrix;
  aspi_table *t;
  asp_code code = aspi_table_open(text, 2, &t, error);
  if (!code)
    code = aspi_table_find(t, options, true, &axes, &is_matrix, error);
  if (!code)
    code = is_matrix ? read_matrix(t, options, &missing, raw, error)
                     : read_triples(t, options, &axes, &missing, raw, error);
  aspi_table_close(t);
  return code ? code : aspi_missing_check(&missing, text->path, error);
}
