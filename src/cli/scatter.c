/* Impacts and measured coefficients from the columns of a table; see scatter.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/scatter.h"
#include "base/units.h"

#include <stdlib.h>

/* A rebound this many times as fast as the impact is an error in the data, not noise. */
#define FASTER_MOST 10

/* Rows farther apart than this, in degrees, or by this logarithm of speeds or sizes, cannot be the
 * scatter of one impact. */
#define APART 4
#define NEARLY 0.1

#define RIGHT_ANGLE_RADIANS 1.571

/* CoR_T of the whole speed along the wall. */
static double cor_t_space(const double v[], const aspi_scatter_row *row) {
  double alpha = aspi_radians(row->degrees), normal = row->cor[COR_N] * sin(alpha);
  double ratio = v[COR_V + ASPI_IN_SPACE];
  double share = isnan(ratio) ? v[V2 + ASPI_IN_SPACE] / v[V1] : ratio;
  double square = share * share - normal * normal;
  return isnan(row->cor[COR_T]) ? NAN : sqrt(square < 0 ? 0 : square) / cos(alpha);
}

/* From both coefficients, in degrees. */
static double rebound_angle(const aspi_scatter_row *row) {
  double alpha = aspi_radians(row->degrees);
  return aspi_degrees(atan2(row->cor[COR_N] * sin(alpha), row->cor[COR_T] * cos(alpha)));
}

static void add_row(aspi_scatter *s, aspi_scatter_row row) {
  s->impacts++;
  s->deposits += row.deposit;
  row.rows = 1;
  row.least = row.most = row.degrees;
  if (s->grouping) {
    aspi_scatter_key(s, &row);
    if (s->count > 0 && aspi_scatter_merge(&s->rows[s->count - 1], &row))
      return;
    if (s->count == s->merge_at)
      aspi_scatter_gather(s);
    aspi_scatter_key(s, &row); /* which may be of an interval now */
  }
  s->rows = cli_grow(s->rows, s->count, sizeof *s->rows);
  s->rows[s->count++] = row;
}

/* Mirrors a measured rebound that is below the wall at it, and exits if it is too fast. */
static void mend(const aspi_table *table, aspi_scatter_row *row) {
  double alpha = aspi_radians(row->degrees), n = row->cor[COR_N] * sin(alpha),
         t = row->cor[COR_T] * cos(alpha);
  double ratio = hypot(isnan(n) ? 0 : n, isnan(t) ? 0 : t);
  if (ratio > FASTER_MOST)
    cli_bad_usage("%s:%zu: at %g degrees the rebound is %g times as fast as the impact; correct or "
                  "remove it",
                  table->text.path, table->text.line, row->degrees, ratio);
  row->cor[COR_N] = fabs(row->cor[COR_N]);
}

static int by_place(const void *left, const void *right) {
  const aspi_scatter_row *a = left, *b = right;
  if (a->degrees < b->degrees || a->degrees > b->degrees)
    return a->degrees < b->degrees ? -1 : 1;
  if (a->v1 < b->v1 || a->v1 > b->v1)
    return a->v1 < b->v1 ? -1 : 1;
  return (a->d_p > b->d_p) - (a->d_p < b->d_p);
}

/* Reads the rows; warns of those that noise put below the wall, and of those that are left out. */
static void read_rows(cli_scatter *t, const cli_scatter_form *f, bool measured, aspi_scatter *s) {
  const char *path = t->table->text.path;
  double v[SCATTER_COLUMNS];
  size_t below = 0, empty = 0, not_in_space = 0;
  while (cli_scatter_row(t, v)) {
    aspi_scatter_row row = cli_scatter_row_of(f, v);
    double n = row.cor[COR_N];
    row.deposit = !f->means && (s->has_outcome ? v[OUTCOME] > 0 : n <= 0 && n >= 0);
    if (row.deposit)
      row.cor[COR_N] = row.cor[COR_T] = row.cor[REBOUND_ANGLE] = NAN;
    if (!measured && s->projection == ASPI_IN_SPACE) {
      double in_space = cor_t_space(v, &row);
      not_in_space += isfinite(row.cor[COR_N] + row.cor[COR_T]) && isnan(in_space);
      row.cor[COR_T] = in_space;
    }
    s->has_speed = s->has_speed || isfinite(row.v1);
    s->has_size = s->has_size || isfinite(row.d_p);
    below += row.cor[COR_N] < 0;
    if (measured)
      mend(t->table, &row);
    else if (s->has_angle)
      row.cor[REBOUND_ANGLE] = rebound_angle(&row);
    if (s->has_outcome || isfinite(row.cor[COR_N]) || isfinite(row.cor[COR_T]) ||
        isfinite(row.cor[REBOUND_ANGLE]))
      add_row(s, row);
    else
      empty++;
  }
  if (not_in_space > 0)
    cli_bad_usage("%s: the data are of rebounds in space, and these impacts have no speed v2 or "
                  "cor_v_space to compare with",
                  path);
  if (measured && below > 0)
    cli_warn("%s: %zu rebounds are below the wall, as by noise; they are mirrored at it", path,
             below);
  if (empty > 0)
    cli_warn("%s: %zu of %.0f rows have neither coefficient nor outcome and are left out", path,
             empty, (double)empty + s->impacts);
}

/* Reads all rows, in order. */
static void read(cli_scatter *t, const cli_scatter_form *f, bool measured, aspi_scatter *s) {
  s->means = f->means;
  s->has_outcome = cli_scatter_has(t, OUTCOME);
  read_rows(t, f, measured, s);
  if (s->grouping)
    aspi_scatter_gather(s);
  if (s->count > 0)
    qsort(s->rows, s->count, sizeof *s->rows, by_place);
}

/* True if no two rows are of the same place: a table or curve of a law, not impacts that scatter.
 */
static bool is_apart(const aspi_scatter *s) {
  for (size_t i = 0; i < s->count; i++)
    for (size_t k = 0; k < i; k++) {
      const aspi_scatter_row *a = &s->rows[k], *b = &s->rows[i];
      if (b->rows > 1 || (b->degrees - a->degrees < APART && !(fabs(log(b->v1 / a->v1)) > NEARLY) &&
                          !(fabs(log(b->d_p / a->d_p)) > NEARLY)))
        return false;
    }
  return s->count > 1 && !s->has_outcome;
}

/* Angles without a unit that may be radians. */
static void check_angles(const char *path, const cli_scatter *t, const aspi_scatter *s) {
  double most = s->count > 0 ? s->rows[s->count - 1].degrees : 0;
  if (t->bare_angle && most > 0 && most <= RIGHT_ANGLE_RADIANS)
    cli_bad_usage("%s: the angles are at most %.4g, and their unit is not stated; name the column "
                  "alpha1_rad or alpha1_deg",
                  path, most);
}

aspi_scatter cli_scatter_read_impacts(const char *path, const aspi_scatter *data,
                                      const aspi_grouping *grouping) {
  cli_scatter t = cli_scatter_open(path, MESH);
  cli_scatter_need(&t, ALPHA1, "");
  if (t.column_of[POINT + COR_T] < 0)
    cli_scatter_need(&t, POINT,
                     "; impacts are a ledger or what 'asperity cor' writes, and data stand behind "
                     "them");
  t.needed[POINT] = false; /* deposits have none */
  cli_scatter_form f = cli_scatter_find_form(&t);
  aspi_scatter s = {.grouping = grouping,
                    .projection = data ? data->projection : ASPI_IN_PLANE,
                    .has_angle = data && data->has_angle,
                    .by_interval = grouping->width > 0 && !grouping->places};
  read(&t, &f, false, &s);
  if (!(s.impacts > s.deposits))
    cli_bad_usage("%s: no rebound in it (%.0f deposits)", path, s.deposits);
  return s;
}

aspi_scatter cli_scatter_read_data(const cli_call *call, const char *path,
                                   const aspi_grouping *grouping) {
  cli_scatter t = cli_scatter_open(path, MESH);
  const cli_option *choice = cli_get(call, "columns");
  if (choice->value)
    cli_scatter_choose(&t, choice);
  cli_scatter_turn(&t, cli_get(call, "from"));
  cli_scatter_take_means(&t);
  cli_scatter_form f = cli_scatter_find_form(&t);
  bool plane = f.means || f.points || f.components,
       angle = cli_scatter_has(&t, MEAN + REBOUND_ANGLE);
  aspi_scatter s = {.grouping = f.means ? NULL : grouping,
                    .has_angle = angle || f.angles < ASPI_PROJECTIONS,
                    .projection = plane                             ? ASPI_IN_PLANE
                                  : f.ratios < ASPI_PROJECTIONS     ? f.ratios
                                  : f.velocities < ASPI_PROJECTIONS ? f.velocities
                                                                    : f.angles};
  read(&t, &f, true, &s);
  if (s.count == 0)
    cli_bad_usage("%s: no row of data", path);
  check_angles(path, &t, &s);
  if (!s.means && is_apart(&s)) {
    s.means = true;
    s.grouping = NULL;
    cli_warn("%s: no two rows are at one angle and speed; they are taken as means without errors",
             path);
  }
  return s;
}
