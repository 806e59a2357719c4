/* Measured walls as text: positions and heights of a profile in columns, or heights alone; a map as
 * a matrix of heights, a line a row, or as lines of x, y, z on a grid. Units and spacing stand in
 * names, in a line of units, or in the header (`Spacing: 0.5 um`, as instruments, SPIP and Gwyddion
 * write it). If the file lacks unit or spacing, the error asks for it; a warning counts numbers
 * left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/columns.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "readers/head.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A line of another kind ends the rows only after at least this many. */
enum { ROWS_LEAST = 3 };

/* Axes of a matrix are even but for this part of their step. */
#define UNEVEN 1e-3

/* Kind of a field that must be there, of a height one that may be missing. */
static bool fits(aspi_columns *r) {
  const aspi_table *t = r->table;
  double value;
  bool good = t->count > 0, matrix = r->column[Z] < 0;
  for (int i = 0; matrix && i < t->count && good; i++)
    good = aspi_table_field(t, i, &value) != ASP_WORD_OTHER;
  for (int k = X; k <= Z && !matrix && good; k++) {
    int at = r->column[k];
    aspi_word word =
        at >= 0 && at < t->all ? aspi_table_field(t, at, &r->value[k]) : ASP_WORD_OTHER;
    good = at < 0 || word == ASP_WORD_NUMBER || (k == Z && word == ASP_WORD_MISSING);
  }
  return good;
}

/* The beginning of the current line, and if there are digits in it. */
static bool show(const aspi_table *t, char *shown, size_t size) {
  bool digits = false;
  *shown = '\0';
  for (int i = 0; i < t->count; i++) {
    digits = digits || strpbrk(t->fields[i], "0123456789");
    aspi_append(shown, size, "%s%s", i > 0 ? (const char[]){t->separator, '\0'} : "", t->fields[i]);
    if (strlen(shown) + 1 >= size)
      break;
  }
  return digits;
}

/* Checks the number of fields of the current row. */
static asp_code check_count(const aspi_columns *r, asp_error *error) {
  const aspi_table *t = r->table;
  bool matrix = r->column[Z] < 0, comma = t->separator == ',';
  int count = t->all >= r->due && t->count < r->due ? r->due : t->count;
  if (count > r->due || (matrix && count < r->due))
    return aspi_table_fail(t, error, "%d fields, the first line of numbers has %d%s", count, r->due,
                           comma ? ": " DECIMAL_COMMAS : "");
  for (int i = 0; i < t->count && matrix && comma; i++)
    if (*t->fields[i] == '0' && isdigit((unsigned char)t->fields[i][1]))
      return aspi_table_fail(t, error, "numbers that begin with a zero: " DECIMAL_COMMAS);
  return ASP_OK;
}

/* True if the positions of a profile begin anew: the row turns back, and is nearer to the first of
 * the trace than to the last. */
static bool begins_anew(const aspi_columns *r) {
  double x = r->value[X], back = (x - r->last) * (r->last - r->first);
  return r->column[X] >= 0 && r->column[Z] >= 0 && r->column[Y] < 0 && r->traces > 0 && back < 0 &&
         fabs(x - r->first) < fabs(x - r->last);
}

/* Reads the next row. A line of another kind ends the rows, unless more rows follow and the header
 * does not state that all were read, or another trace. */
static asp_code next_row(aspi_columns *r, bool *found, asp_error *error) {
  aspi_table *t = r->table;
  char first_shown[48], shown[48];
  size_t other = 0, left = 0, left_line = 0;
  double value;
  asp_code code;
  bool is_first = t->has_row; /* which is counted */
  while (!(code = aspi_table_line(t, found, error)) && *found) {
    bool full = r->stated > 0 && t->rows >= r->stated;
    bool good = fits(r),
         first = (other || !good) && aspi_table_field(t, 0, &value) == ASP_WORD_NUMBER;
    if (good && (!other || begins_anew(r))) {
      t->rows += !is_first && r->traces < 2;
      return check_count(r, error);
    }
    bool digits = show(t, other ? shown : first_shown, sizeof shown);
    if (!full && (other ? good && first : first || t->rows < ROWS_LEAST))
      return aspi_file_fail(
          t->text.path, other ? other : t->text.line, error,
          "'%s' is not a number; a missing height is written nan, bad, ---, or left empty",
          first_shown);
    other = other ? other : t->text.line;
    left_line = left == 0 ? t->text.line : left_line;
    left += digits;
  }
  r->left = left;
  r->left_line = left_line;
  r->end_line = other;
  return code;
}

static double number_at(const aspi_columns *r, int column) {
  double value;
  aspi_table_field(r->table, column, &value);
  return value;
}

/* The height in a column in m; notes where it is bad. */
static double height_at(aspi_columns *r, int column, aspi_raw *raw) {
  size_t line = r->table->text.line;
  double z =
      aspi_missing_note(&r->missing, r->column[Z] < 0 ? number_at(r, column) : r->value[Z], line);
  if (r->column[VALID] >= 0 && fabs(number_at(r, r->column[VALID])) <= 0)
    z = NAN;
  if (isnan(z) && raw->bad++ == 0)
    raw->bad_line = line;
  return z * r->unit[Z];
}

/* True if `count` heights, `stride` apart, rise evenly; *step is that of one. */
static bool is_even(const double *z, size_t count, size_t stride, double *step) {
  *step = (z[(count - 1) * stride] - z[0]) / (double)(count - 1);
  bool even = count >= ROWS_LEAST && *step > 0;
  for (size_t i = 1; i < count && even; i++)
    even = fabs(z[i * stride] - z[(i - 1) * stride] - *step) <= UNEVEN * *step;
  return even;
}

/* Takes the first row or column of a matrix, or both, for axes where they rise evenly, in units of
 * x; one of 0, 1, 2, ... or 1, 2, 3, ... is an index and gives no step. */
static void take_axes(aspi_columns *r, double unit_x, aspi_raw *raw) {
  size_t n = raw->columns, rows = raw->rows;
  double step[2], first[2] = {raw->z[n > 1], raw->z[rows > 1 ? n : 0]};
  if (n < 2 || rows < 2)
    return;
  size_t row = is_even(raw->z + 1, n - 1, 1, &step[0]);
  size_t column = is_even(raw->z + n, rows - 1, n, &step[1]);
  if (row + column == 1) { /* alone it is the whole one */
    first[0] = first[1] = raw->z[0];
    row = row && is_even(raw->z, n, 1, &step[0]);
    column = column && is_even(raw->z, rows, n, &step[1]);
  }
  if (row + column == 0)
    return;
  for (size_t i = row; i < rows; i++)
    memmove(raw->z + (i - row) * (n - column), raw->z + i * n + column,
            (n - column) * sizeof *raw->z);
  raw->columns -= column;
  raw->rows -= row;
  raw->points = raw->columns * raw->rows;
  if (row + column == 1)
    snprintf(raw->note, sizeof raw->note, "the first %s, of even steps, is left out",
             row ? "row" : "column");
  for (size_t k = 0; k < 2; k++) {
    double by = step[k] / r->unit[Z], from = first[k] / r->unit[Z];
    bool index = fabs(by - 1) < UNEVEN && (fabs(from) < UNEVEN || fabs(from - 1) < UNEVEN);
    if ((k ? column : row) && !(r->step[k] > 0) && (!index || row + column == 2))
      r->step[k] = by * unit_x;
  }
}

static asp_code read_matrix(aspi_columns *r, aspi_raw *raw, asp_error *error) {
  const aspi_profile_options *o = r->options;
  asp_code code = ASP_OK;
  raw->columns = (size_t)r->due;
  for (bool found; !code && !(code = next_row(r, &found, error)) && found; raw->rows++)
    for (int i = 0; i < r->due && !code; i++)
      code = aspi_raw_add(raw, height_at(r, i, raw), error);
  if (code)
    return code;
  take_axes(r, o->unit_x > 0 ? o->unit_x : aspi_head_length(r->table, ASPI_HEAD_UNIT, 1), raw);
  double side[2] = {aspi_head_length(r->table, ASPI_HEAD_WIDTH, 1e-9),
                    aspi_head_length(r->table, ASPI_HEAD_HEIGHT, 1e-9)}; /* SPIP: nm */
  for (int k = 0; k < 2; k++)
    raw->step[k] = r->step[k] > 0 ? r->step[k] : side[k] / (double)(k ? raw->rows : raw->columns);
  if (!(raw->step[0] > 0))
    return aspi_file_fail(r->table->text.path, 0, error,
                          "a matrix of heights does not say how far apart its points are; tell "
                          "it (asperity surface --step 0.5um)");
  raw->step[1] = raw->step[1] > 0 ? raw->step[1] : raw->step[0];
  return code;
}

/* Counts above a single column are not heights. */
static void drop_count(aspi_points *p, const aspi_columns *r, aspi_raw *raw) {
  size_t skip = 0;
  for (size_t i = 0; i < 2 && i + ROWS_LEAST < p->count && skip == 0; i++)
    if (fabs(p->list[i].z / r->unit[Z] - (double)(p->count - i - 1)) < ASPI_ROUNDING_TEXT)
      skip = i + 1;
  if (skip > 1)
    snprintf(raw->note, sizeof raw->note, "line %zu, above a count of the points, is left out",
             p->list[0].line);
  p->count -= skip;
  memmove(p->list, p->list + skip, p->count * sizeof *p->list);
  for (size_t i = 0; i < p->count && skip > 0; i++)
    p->list[i].x = (double)i * r->step[0];
}

/* Reads rows of positions and heights. A profile without positions has equal steps. */
static asp_code read_points(aspi_columns *r, aspi_points *points, aspi_raw *raw, asp_error *error) {
  const int *at = r->column, row = raw->is_map ? 1 : r->options->row;
  asp_code code = ASP_OK;
  if (at[X] >= 0 && r->options->step[0] > 0)
    return aspi_table_fail(
        r->table, error,
        "the spacing is given (step), but the file has the positions of its points");
  for (bool found; !code && !(code = next_row(r, &found, error)) && found;) {
    double position[2] = {(double)points->count * r->step[0], 0};
    for (int k = X; k <= Y; k++)
      if (at[k] >= 0) {
        position[k] = r->value[k];
        aspi_points_precision(points, r->table->fields[at[k]]);
      }
    if (r->traces == 0 || begins_anew(r)) {
      r->traces++;
      r->first = position[0];
    }
    r->last = position[0];
    if (r->traces != (size_t)row)
      continue;
    double z = height_at(r, at[Z], raw);
    code = aspi_points_add(points, (aspi_xyz){position[0], position[1], z, r->table->text.line},
                           error);
  }
  if (!code && (size_t)row > r->traces)
    return aspi_file_fail(r->table->text.path, 0, error,
                          "row %d is asked for; the text has %zu trace%s", row, r->traces,
                          r->traces == 1 ? "" : "s");
  if (r->traces > 1)
    aspi_append(raw->note, sizeof raw->note, "of its %zu traces number %d is read", r->traces, row);
  if (!code && r->due == 1)
    drop_count(points, r, raw);
  size_t flags = 0;
  for (size_t i = 0; i < points->count && !code; i++)
    flags += fabs(points->list[i].z * (points->list[i].z - r->unit[Z])) <= 0;
  if (!code && points->count > ROWS_LEAST && flags == points->count)
    return aspi_file_fail(r->table->text.path, 0, error,
                          "column %d has only 0 and 1, as marks of valid points; " ASK_COLUMNS,
                          at[Z] + 1);
  return code;
}

/* Notes how the file was read, and what was left out. */
static void describe(const aspi_columns *r, aspi_raw *raw) {
  const int x = r->column[X] + 1, y = r->column[Y] + 1, z = r->column[Z] + 1;
  bool chosen = r->due > 2 && !raw->is_map;
  if (chosen && y > 0)
    aspi_append(raw->text, sizeof raw->text,
                ", distances in columns %d and %d, heights of column %d", x, y, z);
  else if (chosen && x > 0)
    aspi_append(raw->text, sizeof raw->text, ", of columns %d and %d", x, z);
  else if (chosen)
    aspi_append(raw->text, sizeof raw->text, ", of column %d", z);
  if (r->unit[Z] < 0)
    aspi_append(raw->text, sizeof raw->text, ", depths turned into heights");
  if (r->end_line > 0)
    aspi_append(raw->text, sizeof raw->text, ", data end before line %zu", r->end_line);
  if (r->stated > 0 && r->stated != r->table->rows)
    aspi_append(raw->note, sizeof raw->note, "%sthe header states %zu rows, there are %zu",
                *raw->note ? "; " : "", r->stated, r->table->rows);
  if (r->left > 0)
    aspi_append(raw->note, sizeof raw->note,
                "%s%zu lines with numbers from line %zu on are left out", *raw->note ? "; " : "",
                r->left, r->left_line);
}

static asp_code read(aspi_columns *r, aspi_raw *raw, asp_error *error) {
  const aspi_profile_options *o = r->options;
  const aspi_table *t = r->table;
  aspi_points points = {0};
  bool chosen = o->x_column && o->column;
  if (t->start == 0)
    return aspi_table_fail(t, error,
                           "the file ends without a line of two numbers or more (heights alone of "
                           "a profile need the step between them: asperity surface --step 0.5um)");
  r->due = t->columns > t->count ? t->columns : t->count;
  double unit = o->unit_x > 0 ? o->unit_x : aspi_head_length(r->table, ASPI_HEAD_UNIT, 1);
  for (int k = 0; k < 2; k++)
    r->step[k] = o->step[k] > 0 || (!raw->is_map && t->count > 1)
                     ? o->step[k]
                     : aspi_head_length(r->table, ASPI_HEAD_SPACING, unit);
  if (raw->is_map && !(o->step[0] > 0) && aspi_head_length(r->table, ASPI_HEAD_Y_SPACING, unit) > 0)
    r->step[1] = aspi_head_length(r->table, ASPI_HEAD_Y_SPACING, unit);
  if (raw->is_map && !(o->step[0] > 0))
    aspi_head_known(t, o->unit_x > 0 ? o->unit_x : o->unit_z, r->step, &r->known_unit);
  r->stated = aspi_head_count(r->table, raw->is_map ? ASPI_HEAD_ROWS : ASPI_HEAD_COUNT);
  asp_code code = aspi_columns_choose(r, raw->is_map, error);
  r->due = r->column[Z] < 0 ? t->count : r->due;
  bool matrix = r->column[Z] < 0;
  if (!code)
    code = matrix ? read_matrix(r, raw, error) : read_points(r, &points, raw, error);
  if (!code && !chosen)
    code = aspi_missing_check(&r->missing, t->text.path, error);
  describe(r, raw);
  if (!code && !matrix)
    code = raw->is_map ? aspi_points_grid(&points, r->unit, raw, error)
                       : aspi_points_line(&points, r->unit, r->column[Y] >= 0, raw, error);
  free(points.list);
  return code;
}

asp_code aspi_read_columns(const aspi_text *text, const aspi_profile_options *options,
                           aspi_raw *raw, asp_error *error) {
  aspi_columns r = {
      .options = options, .column = {-1, -1, -1, -1}, .missing = {.stated = options->missing}};
  r.table = aspi_table_open(text->stream, text->path,
                            raw->is_map || !(options->step[0] > 0) ? 2 : 1, error);
  asp_code code = r.table ? read(&r, raw, error) : ASP_EDATA;
  aspi_table_close(r.table);
  return code;
}
