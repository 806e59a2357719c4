/* First hits of the geometry, from a table. On a Gaussian wall the table is that of an ensemble
 * (ensemble.h). On a measured profile it has quantiles of the tilt over impact angle and particle
 * size, from the exact first hits of the profile. Linear interpolation keeps them monotone in u and
 * above -alpha1. Escape and later hits come from the tables of the profile's line (line_table.h);
 * on a measured map everything comes from map_table.h. On a Gaussian wall particles that fly up
 * follow `visible`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "spread/ensemble.h"
#include "spread/line_table.h"
#include "spread/map_table.h"
#include "spread/models.h"
#include "spread/quantiles.h"
#include "surface/profile.h"

#include <gsl/gsl_interp.h>
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>

enum { ANGLES = 64, NODES = ASPI_SHARES_NODES(512, 32), SIZE = ANGLES * NODES };

static const aspi_shares shares = {512, 32, NODES};

/* Largest number of faces for the tables of later hits. */
#define LATER_FACES_MOST ((size_t)131072)

typedef struct table {
  aspi_map_table *map; /* of a measured map; then all else is empty */
  int bins;
  double d_p[ASP_BINS_MAX];
  aspi_line_table *later[ASP_BINS_MAX][2]; /* of flights both ways */
  float delta[];                           /* by size, angle, u; rad */
} table;

static void release(void *data) {
  table *t = data;
  aspi_map_table_free(t->map);
  for (int i = 0; i < t->bins; i++) {
    aspi_line_table_free(t->later[i][0]);
    aspi_line_table_free(t->later[i][1]);
  }
  free(t);
}

/* Quantiles of the first hits at all angles. */
static asp_code fill_first(const aspi_line *line, float *delta, asp_error *error) {
  double *weight = malloc(line->n * sizeof *weight), *tilt = malloc(line->n * sizeof *tilt);
  size_t *order = malloc(line->n * sizeof *order);
  bool made = weight && tilt && order;
  if (made) {
    gsl_sort_index(order, line->slope, 1, line->n);
    for (size_t i = 0; i < line->n; i++)
      tilt[i] = atan(line->slope[order[i]]);
  }
  const aspi_sample sample = {tilt, weight, order, NULL, NULL, line->n};
  for (int k = 0; made && k < ANGLES; k++) {
    aspi_line_first_hits(line, aspi_line_fall(line, aspi_angle_at(ANGLES, k)), weight);
    aspi_quantiles_fill(&shares, &sample, 1, delta + k * NODES);
  }
  free(weight);
  free(tilt);
  free(order);
  return made ? ASP_OK
              : aspi_fail(error, ASP_ENOMEM, "out of memory for the slopes of %zu faces", line->n);
}

/* Tables of later hits in one direction, from faces one spacing of the profile long. */
static asp_code fill_later(const aspi_line *line, size_t parts, bool back, aspi_line_table **later,
                           asp_error *error) {
  aspi_line coarse;
  asp_code code = aspi_line_coarsen(&coarse, line, parts, LATER_FACES_MOST, back, error);
  if (code)
    return code;
  *later = aspi_line_table_create(&coarse, NULL, error);
  aspi_line_free(&coarse);
  return *later ? ASP_OK : ASP_ENOMEM;
}

static asp_code fill_size(table *t, int size, const asp_profile *profile, asp_error *error) {
  aspi_line line;
  asp_code code = aspi_line_over_profile(&line, profile, t->d_p[size], error);
  if (code)
    return code;
  size_t points = asp_profile_points(profile);
  size_t parts = line.n / (aspi_profile_periodic(profile) ? points : 2 * points - 2);
  code = fill_first(&line, t->delta + size * SIZE, error);
  for (int way = 0; way < 2 && !code; way++)
    code = fill_later(&line, parts, way, &t->later[size][way], error);
  aspi_line_free(&line);
  return code;
}

static void *prepare(const asp_profile *profile, const aspi_sizes *sizes, asp_error *error) {
  if (aspi_sizes_check(sizes, error))
    return NULL;
  table *t = calloc(1, sizeof *t + (size_t)sizes->bins * SIZE * sizeof *t->delta);
  if (!t) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for a table of %d sizes", sizes->bins);
    return NULL;
  }
  t->bins = sizes->bins;
  for (int i = 0; i < t->bins; i++) {
    t->d_p[i] = aspi_sizes_at(sizes, i);
    if (fill_size(t, i, profile, error)) {
      release(t);
      return NULL;
    }
  }
  return t;
}

static void *prepare_map(const asp_map *map, const aspi_sizes *sizes, asp_error *error) {
  table *t = calloc(1, sizeof *t);
  if (t)
    t->map = aspi_map_table_create(map, sizes, error);
  else
    aspi_fail(error, ASP_ENOMEM, "out of memory for the tables of a map");
  if (t && t->map)
    return t;
  free(t);
  return NULL;
}

static aspi_place place_of_size(const table *t, double d_p) {
  if (t->bins < 2)
    return (aspi_place){0, 0};
  size_t last = (size_t)t->bins - 1;
  d_p = fmin(fmax(d_p, t->d_p[0]), t->d_p[last]);
  size_t i = gsl_interp_bsearch(t->d_p, d_p, 0, last);
  double step = t->d_p[i + 1] - t->d_p[i]; /* 0 where all are of one size */
  return (aspi_place){(int)i, step > 0 ? (d_p - t->d_p[i]) / step : 0};
}

/* The four rows of quantiles around a view: those of two angles, at two sizes. */
typedef struct cell {
  const float *row[2][2];
  double size, angle; /* parts of the step */
} cell;

static cell cell_of(const aspi_view *view) {
  const table *t = view->data;
  aspi_place size = place_of_size(t, view->d_p), angle = aspi_angle_place(ANGLES, view->alpha1);
  const float *first = t->delta + size.node * SIZE + angle.node * NODES;
  int next = t->bins > 1 ? SIZE : 0;
  return (cell){
      {{first, first + next}, {first + NODES, first + NODES + next}}, size.part, angle.part};
}

static double mix(double from, double to, double part) {
  return from + part * (to - from);
}

static double delta_at(const cell *c, aspi_place u) {
  double at[2];
  for (int k = 0; k < 2; k++) /* at the angle below and above */
    at[k] = mix(aspi_quantiles_between(c->row[k][0], u), aspi_quantiles_between(c->row[k][1], u),
                c->size);
  return mix(at[0], at[1], c->angle);
}

static double node_at(const cell *c, int node) {
  bool last = node == NODES - 1;
  return delta_at(c, (aspi_place){last ? node - 1 : node, last ? 1 : 0});
}

static double quantile(const aspi_view *view, double u) {
  if (view->alpha1 < 0)
    return aspi_spread_visible.quantile(view, u);
  if (!view->data)
    return aspi_ensemble_quantile(view, u);
  cell c = cell_of(view);
  double delta = delta_at(&c, aspi_shares_place(&shares, u));
  return delta > -view->alpha1 ? delta : -view->alpha1;
}

/* The last node that is not above delta; -1 when there is none. */
static int node_below(const cell *c, double delta) {
  int low = -1, high = NODES;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    *(node_at(c, middle) <= delta ? &low : &high) = middle;
  }
  return low;
}

static double distribution(const aspi_view *view, double delta) {
  if (view->alpha1 < 0)
    return aspi_spread_visible.distribution(view, delta);
  if (!view->data)
    return aspi_ensemble_distribution(view, delta);
  cell c = cell_of(view);
  int node = node_below(&c, delta);
  if (node < 0 || node >= NODES - 1)
    return node < 0 ? 0 : 1;
  double low = node_at(&c, node), high = node_at(&c, node + 1);
  return aspi_shares_at(&shares, node + (delta - low) / (high - low));
}

static double density(const aspi_view *view, double delta) {
  if (view->alpha1 < 0)
    return aspi_spread_visible.density(view, delta);
  if (!view->data)
    return aspi_ensemble_density(view, delta);
  cell c = cell_of(view);
  int node = node_below(&c, delta);
  if (node < 0 || node >= NODES - 1)
    return 0;
  return (aspi_shares_at(&shares, node + 1) - aspi_shares_at(&shares, node)) /
         (node_at(&c, node + 1) - node_at(&c, node));
}

/* Follows a particle over a profile: the first hit from the quantiles, the others from the line
 * tables. */
static bool follow(const aspi_view *view, aspi_stream *stream, aspi_path *path, double *delta) {
  const table *t = view->data;
  if (t->map)
    return aspi_map_table_follow(t->map, view, stream, path, delta);
  if (!path->begun) {
    path->begun = true;
    path->size =
        aspi_sizes_nearest(&(aspi_sizes){t->d_p[0], t->d_p[t->bins - 1], t->bins}, view->d_p);
    path->alpha_in = view->alpha1;
    path->face_class = aspi_line_table_class(view->alpha1, stream);
    *delta = quantile(view, aspi_stream_uniform(stream));
    path->p = tan(*delta);
    return true;
  }
  aspi_line_table *const *later = t->later[path->size];
  if (view->alpha1 < 0 &&
      aspi_line_table_escapes(later[path->back_in], path->face_class, path->p, tan(-view->alpha1),
                              path->back != path->back_in, stream))
    return false;
  path->face_class = aspi_line_table_next(later[path->back], path->alpha_in, -view->alpha1, stream,
                                          &path->p, &path->q);
  path->back_in = path->back;
  path->alpha_in = fmax(path->alpha_in, view->alpha1);
  *delta = atan(path->p);
  return true;
}

const asp_spread_model aspi_spread_profile = {
    .name = "profile",
    .summary = "first hits from a table: of the measured wall, or of generated Gaussian walls",
    .source = "geometry, derived for this project",
    .geometry = true,
    .upward = true,
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
    .prepare = prepare,
    .prepare_map = prepare_map,
    .release = release,
    .follow = follow,
};
