/* Measured coefficients of restitution; see measured.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/measured.h"
#include "base/csv.h"
#include "base/error.h"
#include "cli/measured_columns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Two forms of a velocity that differ by more, as a share of v1, are of different impacts. */
#define CONTRADICTION 0.05

/* A rebound may seem a little faster than the impact, by noise. */
#define FASTER_WARNED 1.2
#define FASTER_MOST 10

static bool has(const cli_columns *l, int column) {
  return l->at[column] >= 0;
}

static bool has_components(const cli_columns *l) {
  return has(l, V1_N) && has(l, V1_T) && has(l, V2_N) && has(l, V2_T);
}

/* Finds out if the columns are those of impacts or of means. */
static asp_code find_form(const aspi_csv *csv, const cli_columns *l, bool *means,
                          asp_error *error) {
  bool points = has(l, POINT) || has(l, POINT + COR_T) || has_components(l) ||
                (has(l, COR_V) && has(l, COR_ALPHA)) ||
                (has(l, ALPHA2) && has(l, V2) && has(l, V1));
  *means = has(l, MEAN) || has(l, MEAN + COR_T);
  if (!has(l, ALPHA1) && !has_components(l))
    return aspi_csv_need(csv, "alpha1_deg", error) < 0 ? ASP_EDATA : ASP_OK;
  if (points != *means)
    return ASP_OK;
  return aspi_text_fail(&csv->text, csv->text.line, error,
                        "%s; impacts are columns alpha1,v1,alpha2,v2 or v1_n,v1_t,v2_n,v2_t or "
                        "cor_v,cor_alpha or cor_n,cor_t, means are cor_n_mean,cor_n_sd,cor_t_mean,"
                        "cor_t_sd",
                        points ? "both points and means" : "neither points nor means");
}

/* The coefficients of the components of both velocities. */
static void of_components(double n1, double t1, double n2, double t2, aspi_measured_row *row) {
  double n = fabs(n1), t = fabs(t1);
  row->degrees = cli_degrees(atan2(n, t));
  row->v1 = hypot(n, t);
  row->cor[COR_N] = n > 0 ? n2 / n : NAN;
  row->cor[COR_T] = t > 1e-12 * n ? t2 / t1 : NAN;
}

/* False where there are no columns of the velocities. */
static bool of_velocities(const cli_columns *l, const double *v, aspi_measured_row *row) {
  double a1 = cli_radians(v[ALPHA1]), a2 = cli_radians(v[ALPHA2]);
  if (has_components(l))
    of_components(v[V1_N], v[V1_T], fabs(v[V2_N]), v[V2_T], row);
  else if (has(l, COR_V) && has(l, COR_ALPHA))
    of_components(sin(a1), cos(a1), v[COR_V] * sin(v[COR_ALPHA] * a1),
                  v[COR_V] * cos(v[COR_ALPHA] * a1), row);
  else if (has(l, ALPHA2) && has(l, V2) && has(l, V1))
    of_components(v[V1] * sin(a1), v[V1] * cos(a1), v[V2] * sin(a2), v[V2] * cos(a2), row);
  else
    return false;
  return true;
}

static aspi_measured_row row_of(const cli_columns *l, const double *v, bool means) {
  aspi_measured_row row = {.degrees = fmin(90, v[ALPHA1]), .v1 = v[V1], .n = v[COUNT]};
  row.d_p = has(l, D_P) ? v[D_P] : 2 * v[RADIUS];
  for (int k = 0; k < COR_BOTH; k++) {
    row.cor[k] = means ? v[MEAN + k] : v[POINT + k];
    row.sd[k] = v[SD + k];
    row.se[k] = v[SE + k];
  }
  if (means || has(l, POINT) || has(l, POINT + COR_T))
    return row;
  of_velocities(l, v, &row);
  if (!has_components(l))
    row.v1 = v[V1];
  if (row.degrees >= 90 - 1e-9)
    row.cor[COR_T] = NAN;
  return row;
}

static int by_place(const void *left, const void *right) {
  const aspi_measured_row *a = left, *b = right;
  if (a->degrees < b->degrees || a->degrees > b->degrees)
    return a->degrees < b->degrees ? -1 : 1;
  if (a->v1 < b->v1 || a->v1 > b->v1)
    return a->v1 < b->v1 ? -1 : 1;
  return (a->d_p > b->d_p) - (a->d_p < b->d_p);
}

static void add_row(aspi_measured *data, aspi_measured_row row) {
  if ((data->count & (data->count - 1)) == 0) {
    size_t room = data->count ? 2 * data->count : 1;
    data->rows = realloc(data->rows, room * sizeof *data->rows);
    if (!data->rows)
      cli_fail("out of memory for %zu rows", data->count);
  }
  data->rows[data->count++] = row;
}

/* Sets the view: the velocity in the plane, if coefficients or components are given. */
static asp_code find_view(const aspi_csv *csv, const cli_columns *l, aspi_measured *data,
                          asp_error *error) {
  bool ratios = has(l, COR_V) && has(l, COR_ALPHA);
  int speed = ratios ? COR_V : V2, angle = ratios ? COR_ALPHA : ALPHA2;
  data->view = ASPI_MEASURED_PLANE;
  if (data->means || has(l, POINT) || has(l, POINT + COR_T) || has_components(l))
    return ASP_OK;
  if (l->view[speed] != l->view[angle])
    return aspi_text_fail(
        &csv->text, csv->text.line, error,
        "columns '%s' and '%s' are not of the same velocity; both must be of that "
        "in the plane of incidence, or of that in space",
        csv->names[l->at[speed]], csv->names[l->at[angle]]);
  data->view = l->view[speed];
  return ASP_OK;
}

/* Rows that need a warning: rebounds below the wall, rows without coefficient and outcome, and rows
 * whose coefficients are not those of their velocities: the first of them has the degrees, and a
 * coefficient as it is given and by velocities. */
typedef struct odd_rows {
  size_t below, empty, contradict;
  double degrees, given, other;
  int which;
} odd_rows;

/* Notes a row whose two forms contradict each other. */
static void compare_forms(const cli_columns *l, const double *v, const aspi_measured_row *row,
                          odd_rows *odd) {
  aspi_measured_row other = *row;
  if (!of_velocities(l, v, &other))
    return;
  const double by[COR_BOTH] = {
      [COR_N] = sin(cli_radians(row->degrees)), [COR_T] = cos(cli_radians(row->degrees))};
  for (int k = 0; k < COR_BOTH; k++) {
    double off = fabs(fabs(row->cor[k]) - fabs(other.cor[k])) * by[k];
    if (!(off > CONTRADICTION) || (k == COR_T && l->view[V2] == ASPI_MEASURED_SPACE))
      continue;
    if (odd->contradict++ == 0) {
      odd->degrees = row->degrees;
      odd->which = k;
      odd->given = row->cor[k];
      odd->other = other.cor[k];
    }
    return;
  }
}

static asp_code read_rows(aspi_csv *csv, const cli_columns *l, aspi_measured *data, odd_rows *odd,
                          asp_error *error) {
  uint32_t needed = COLUMN_BIT(ALPHA1);
  for (bool found;;) {
    double value[MEASURED_COLUMNS];
    asp_code code;
    if ((code = aspi_csv_row(csv, &found, error)) || !found ||
        (code = cli_columns_row(csv, l, needed, value, error)))
      return code;
    aspi_measured_row row = row_of(l, value, data->means);
    row.deposit = !data->means && !(fabs(row.cor[COR_N]) > 0) && !isnan(row.cor[COR_N]);
    if (has(l, OUTCOME) && !data->means)
      row.deposit = value[OUTCOME] > 0;
    if (row.deposit)
      row.cor[COR_N] = row.cor[COR_T] = NAN;
    if (isnan(row.degrees))
      return aspi_text_fail(&csv->text, csv->text.line, error,
                            "the impact angle is missing; v1_n and v1_t, or alpha1, must be there");
    bool empty = isnan(row.cor[COR_N]) && isnan(row.cor[COR_T]) && !has(l, OUTCOME);
    if (!data->means && !l->is_ledger && (has(l, POINT) || has(l, POINT + COR_T)))
      compare_forms(l, value, &row, odd);
    odd->empty += empty;
    odd->below += !data->means && row.cor[COR_N] < 0;
    row.cor[COR_N] = data->means ? row.cor[COR_N] : fabs(row.cor[COR_N]);
    if (!empty)
      add_row(data, row);
  }
}

/* v2/v1; a coefficient that is missing counts as 0. */
static double speed_ratio(const aspi_measured_row *row) {
  double alpha = cli_radians(row->degrees), n = row->cor[COR_N] * sin(alpha),
         t = row->cor[COR_T] * cos(alpha);
  return hypot(isnan(n) ? 0 : n, isnan(t) ? 0 : t);
}

/* Warns of rebounds that are faster than their impacts; exits where one is much faster. */
static void check_speeds(const aspi_measured *data, const char *path) {
  size_t faster = 0;
  double most = 0;
  for (size_t i = 0; i < data->count; i++) {
    const aspi_measured_row *row = &data->rows[i];
    double ratio = speed_ratio(row);
    if (ratio > FASTER_MOST)
      cli_bad_usage("%s: in the row at %g degrees the rebound is %g times as fast as the impact; "
                    "correct or remove it",
                    path, row->degrees, ratio);
    faster += ratio > FASTER_WARNED;
    most = fmax(most, ratio);
  }
  if (faster > 0)
    cli_warn(
        "%s: in %zu of %zu rows the rebound is over %g times as fast as the impact, in one %.3g "
        "times",
        path, faster, data->count, FASTER_WARNED, most);
}

static void warn_of_odd(const char *path, const aspi_measured *data, const odd_rows *odd) {
  if (odd->below > 0)
    cli_warn("%s: %zu rebounds are below the wall, as by noise; they are mirrored at it", path,
             odd->below);
  if (odd->contradict > 0)
    cli_warn("%s: in %zu of %zu rows the coefficients, which are taken, contradict the velocities, "
             "as cor_%c at %g degrees: %.3g, by velocities %.3g",
             path, odd->contradict, data->count, odd->which == COR_N ? 'n' : 't', odd->degrees,
             odd->given, odd->other);
  if (odd->empty > 0)
    cli_warn("%s: %zu of %zu rows have neither coefficient nor outcome and are left out", path,
             odd->empty, odd->empty + data->count);
}

aspi_measured cli_measured_read(const char *path, const cli_option *view) {
  aspi_measured data = {.count = 0};
  cli_columns l;
  odd_rows odd = {.below = 0};
  asp_error error;
  aspi_csv *csv = aspi_csv_open(path, &error);
  cli_must(csv, &error);
  cli_columns_find(csv, path, COLUMN_BIT(DELTA_ALPHA) - 1, &l);
  cli_must(!find_form(csv, &l, &data.means, &error) && !find_view(csv, &l, &data, &error) &&
               !read_rows(csv, &l, &data, &odd, &error),
           &error);
  if (view->value) {
    int in_space = cli_choice(view);
    if (data.view != ASPI_MEASURED_EITHER)
      cli_bad_usage("--view is '%s'; the columns of %s say it themselves", view->value, path);
    data.view = in_space ? ASPI_MEASURED_SPACE : ASPI_MEASURED_PLANE;
  }
  warn_of_odd(path, &data, &odd);
  data.has_speed = has(&l, V1) || has_components(&l);
  data.has_size = has(&l, D_P) || has(&l, RADIUS);
  data.has_outcome = has(&l, OUTCOME);
  aspi_csv_close(csv);
  if (data.count == 0)
    cli_bad_usage("%s: no row of data", path);
  check_speeds(&data, path);
  double most = 0;
  for (size_t i = 0; i < data.count; i++)
    most = fmax(most, data.rows[i].degrees);
  if (has(&l, ALPHA1))
    cli_warn_radians(path, most);
  cli_measured_sort(&data);
  return data;
}

void cli_measured_sort(aspi_measured *data) {
  qsort(data->rows, data->count, sizeof *data->rows, by_place);
}

void cli_measured_need_view(const char *path, aspi_measured *data, bool matters) {
  if (data->view == ASPI_MEASURED_EITHER && matters)
    cli_bad_usage(
        "%s: are speed and angle of rebounds those in the plane of incidence, as one camera "
        "sees them, or those in space? Name the columns v2_plane, alpha2_plane or "
        "v2_space, alpha2_space (cor_v, cor_alpha alike), or give --view plane or --view "
        "space",
        path);
  if (data->view == ASPI_MEASURED_EITHER)
    data->view = ASPI_MEASURED_PLANE;
}
