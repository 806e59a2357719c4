/* Impacts and measured coefficients from the columns of a table; see scatter.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/scatter.h"
#include "base/units.h"
#include "base/tolerances.h"

#include <stdlib.h>

/* A rebound this many times as fast as the impact is an error in the data, not noise. */
#define FASTER_MOST 10

#define FORMS                                                                                      \
  "impacts are columns alpha1,v1,alpha2_plane,v2_plane or alpha1,cor_v_plane and "                 \
  "cor_alpha_plane or alpha2_plane (one camera), both alike of _space, or v1_n,v1_t,v2_n,v2_t or " \
  "v1_n,v2_n (a drop: --columns v1_n=1,v2_n=2) or cor_n,cor_t or alpha1,alpha2_plane alone; "      \
  "means are cor_n_mean,cor_n_sd,cor_t_mean,cor_t_sd or alpha2_plane_mean,alpha2_plane_sd"

/* The columns that give the coefficients, in this order where there are several. */
typedef struct form {
  bool means, points, components, normal; /* normal: components of it alone */
  aspi_rebound_view ratios, velocities;   /* ASPI_VIEWS: none */
  aspi_rebound_view angles;               /* alone; the same */
} form;

static bool has(const cli_scatter *t, int column) {
  return t->at[column] >= 0;
}

static aspi_rebound_view view_of(const cli_scatter *t, int speed, int angle) {
  int view = ASPI_IN_PLANE;
  while (view < ASPI_VIEWS &&
         !(has(t, speed + view) && (has(t, angle + view) || has(t, ALPHA2 + view))))
    view++;
  return (aspi_rebound_view)view;
}

static form find_form(cli_scatter *t) {
  form f = {.means = has(t, MEAN) || has(t, MEAN + COR_T) || has(t, MEAN + REBOUND_ANGLE),
            .points = has(t, POINT) || has(t, POINT + COR_T),
            .components = has(t, V1_N) && has(t, V2_N) && has(t, V1_T) == has(t, V2_T),
            .normal = !has(t, V1_T),
            .ratios = view_of(t, COR_V, COR_ALPHA),
            .velocities = has(t, V1) ? view_of(t, V2, ALPHA2) : ASPI_VIEWS};
  bool impacts = f.points || f.components || f.ratios < ASPI_VIEWS || f.velocities < ASPI_VIEWS;
  bool other = false; /* of the velocity */
  for (int c = V2; c < V1_N; c++)
    other = other || has(t, c);
  int view = impacts || f.means || other ? ASPI_VIEWS : ASPI_IN_PLANE;
  while (view < ASPI_VIEWS && !has(t, ALPHA2 + view))
    view++;
  f.angles = (aspi_rebound_view)view;
  impacts = impacts || view < ASPI_VIEWS;
  if (!f.components)
    cli_scatter_need(t, ALPHA1,
                     "; it is the impact angle from the wall (--from normal turns those from its "
                     "normal), also called impact_angle, alpha_in or theta_i; --columns alpha1=1 "
                     "takes one of another name; " FORMS);
  if (impacts == f.means)
    cli_bad_usage("%s: %s; " FORMS "; --columns cor_n=2 takes one of another name",
                  t->table->text.path,
                  impacts ? "both impacts and means" : "neither impacts nor means");
  return f;
}

/* The coefficients of the components of both velocities. */
static void take_velocities(double n1, double t1, double n2, double t2, aspi_scatter_row *row) {
  bool normal = !(row->degrees < 90 * (1 - ASPI_ROUNDING_TEXT));
  row->cor[COR_N] = aspi_quotient(n2, n1, hypot(n1, t1));
  row->cor[COR_T] = normal ? NAN : aspi_quotient(t2, t1, hypot(n1, t1));
}

static aspi_scatter_row row_of(const form *f, const double v[]) {
  double a1 = aspi_radians(v[ALPHA1]);
  aspi_scatter_row row = {.degrees = fmin(90, v[ALPHA1]),
                          .v1 = v[V1],
                          .d_p = isnan(v[D_P]) ? 2 * v[RADIUS] : v[D_P],
                          .n = v[COUNT]};
  for (int k = 0; k < ASPI_COMPARED; k++) {
    row.cor[k] = f->means ? v[MEAN + k] : k < COR_BOTH ? v[POINT + k] : NAN;
    row.sd[k] = v[SD + k];
    row.se[k] = v[SE + k];
  }
  if (f->angles < ASPI_VIEWS)
    row.cor[REBOUND_ANGLE] = fabs(v[ALPHA2 + f->angles]);
  if (f->means || f->points || f->angles < ASPI_VIEWS)
    return row;
  if (f->components) {
    double t1 = f->normal ? 0 : v[V1_T], t2 = f->normal ? 0 : v[V2_T];
    row.degrees = aspi_degrees(atan2(fabs(v[V1_N]), fabs(t1)));
    row.v1 = hypot(v[V1_N], t1);
    take_velocities(fabs(v[V1_N]), t1, fabs(v[V2_N]), t2, &row);
    return row;
  }
  bool ratios = f->ratios < ASPI_VIEWS;
  double a2 = aspi_radians(v[ALPHA2 + (ratios ? f->ratios : f->velocities)]);
  a2 = ratios && isnan(a2) ? v[COR_ALPHA + f->ratios] * a1 : a2;
  double share = ratios ? v[COR_V + f->ratios] : v[V2 + f->velocities] / v[V1];
  take_velocities(sin(a1), cos(a1), share * sin(a2), share * cos(a2), &row);
  return row;
}

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
  if (s->apart) {
    aspi_scatter_key(s, &row);
    if (s->count > 0 && aspi_scatter_merge(&s->rows[s->count - 1], &row))
      return;
    if (s->count == s->room)
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
static void read_rows(cli_scatter *t, const form *f, bool measured, aspi_scatter *s) {
  const char *path = t->table->text.path;
  double v[SCATTER_COLUMNS];
  size_t below = 0, empty = 0, not_in_space = 0;
  while (cli_scatter_row(t, v)) {
    aspi_scatter_row row = row_of(f, v);
    double n = row.cor[COR_N];
    row.deposit = !f->means && (s->has_outcome ? v[OUTCOME] > 0 : n <= 0 && n >= 0);
    if (row.deposit)
      row.cor[COR_N] = row.cor[COR_T] = row.cor[REBOUND_ANGLE] = NAN;
    if (!measured && s->view == ASPI_IN_SPACE) {
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
static void read(cli_scatter *t, const form *f, bool measured, aspi_scatter *s) {
  s->means = f->means;
  s->has_outcome = has(t, OUTCOME);
  read_rows(t, f, measured, s);
  if (s->apart)
    aspi_scatter_gather(s);
  if (s->count > 0)
    qsort(s->rows, s->count, sizeof *s->rows, by_place);
}

aspi_scatter cli_scatter_read_impacts(const char *path, const aspi_scatter *data,
                                      const aspi_apart *apart) {
  cli_scatter t = cli_scatter_open(path, MESH);
  cli_scatter_need(&t, ALPHA1, "");
  if (t.at[POINT + COR_T] < 0)
    cli_scatter_need(&t, POINT,
                     "; impacts are a ledger or what 'asperity cor' writes, and data stand behind "
                     "them");
  t.needed[POINT] = false; /* deposits have none */
  form f = find_form(&t);
  aspi_scatter s = {.apart = apart,
                    .view = data ? data->view : ASPI_IN_PLANE,
                    .has_angle = data && data->has_angle,
                    .by_interval = apart->width > 0 && !apart->places};
  read(&t, &f, false, &s);
  if (!(s.impacts > s.deposits))
    cli_bad_usage("%s: no rebound in it (%.0f deposits)", path, s.deposits);
  return s;
}

aspi_scatter cli_scatter_read_data(const cli_call *call, const char *path,
                                   const aspi_apart *apart) {
  cli_scatter t = cli_scatter_open(path, MESH);
  const cli_option *choice = cli_get(call, "columns");
  if (choice->value)
    cli_scatter_choose(&t, choice);
  cli_scatter_turn(&t, cli_get(call, "from"));
  form f = find_form(&t);
  bool plane = f.means || f.points || f.components, angle = has(&t, MEAN + REBOUND_ANGLE);
  aspi_scatter s = {.apart = f.means ? NULL : apart,
                    .has_angle = angle || f.angles < ASPI_VIEWS,
                    .view = plane                       ? ASPI_IN_PLANE
                            : f.ratios < ASPI_VIEWS     ? f.ratios
                            : f.velocities < ASPI_VIEWS ? f.velocities
                                                        : f.angles};
  read(&t, &f, true, &s);
  if (s.count == 0)
    cli_bad_usage("%s: no row of data", path);
  return s;
}
