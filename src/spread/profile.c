/* The first-hit law of the geometry, as a table. On a Gaussian wall that of an ensemble
 * (ensemble.h); on a wall by its profile the exact law of that profile: quantiles over impact angle
 * and particle size, each the law that aspi_track_first_hit gives there. Between the nodes
 * quantiles are interpolated linearly, which keeps them monotone in u and above -alpha1.
 *
 * Angles stand closer where the law changes fast: at 90 degrees times (k/63)^2. The first and the
 * last cell in u are divided again, for the tails. Whether a particle leaves from a face, and which
 * one it hits next, comes from the profile's own law (law.h); on a wall by its map everything does
 * (area.h). On a Gaussian wall particles that fly up meet the law of `visible`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "spread/area.h"
#include "spread/ensemble.h"
#include "spread/models.h"
#include "spread/trace.h"
#include "surface/profile.h"

#include <gsl/gsl_interp.h>
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>

enum {
  ANGLES = 64,
  CELLS = 512, /* of equal width in u */
  PARTS = 32,  /* of the first and of the last of them */
  NODES = CELLS - 2 + 2 * PARTS + 1,
  SIZE = NODES * ANGLES /* numbers a diameter */
};

/* Later hits are tabled from as many faces at most. */
#define LAW_FACES_MOST ((size_t)131072)

/* The angles are this times k^2. */
#define WIDTH (ASP_PI / 2 / ((ANGLES - 1.) * (ANGLES - 1.)))

typedef struct table {
  aspi_area *area; /* the laws of a map; then nothing else is in it */
  int bins;
  double d_p[ASP_BINS_MAX];
  aspi_law *law[ASP_BINS_MAX][2]; /* later hits, of flights both ways */
  float delta[];                  /* by size, u, angle; rad */
} table;

/* u at a node, or between two. */
static double u_at(double place) {
  if (place < PARTS)
    return place / (PARTS * (double)CELLS);
  double last = PARTS + CELLS - 2;
  if (place > last)
    return ((place - last) / PARTS + CELLS - 1) / CELLS;
  return (place - (PARTS - 1)) / CELLS;
}

/* What one size needs while the table is made. */
typedef struct workspace {
  aspi_track *track;
  size_t n, parts; /* faces; those a spacing of the profile */
  double *slope, *weight;
  size_t *order; /* of the faces, by slope */
} workspace;

static void workspace_free(workspace *b) {
  aspi_track_free(b->track);
  free(b->slope);
  free(b->weight);
  free(b->order);
}

static asp_code workspace_create(workspace *b, const asp_profile *profile, double d_p,
                                 asp_error *error) {
  *b = (workspace){.track = aspi_track_create(profile, d_p, error)};
  if (!b->track)
    return ASP_EARG;
  size_t points = asp_profile_points(profile);
  b->n = aspi_track_faces(b->track);
  b->parts = b->n / (aspi_profile_periodic(profile) ? points : 2 * points - 2);
  b->slope = malloc(b->n * sizeof *b->slope);
  b->weight = malloc(b->n * sizeof *b->weight);
  b->order = malloc(b->n * sizeof *b->order);
  if (!b->slope || !b->weight || !b->order) {
    workspace_free(b);
    return aspi_fail(error, ASP_ENOMEM, "out of memory for the slopes of %zu faces", b->n);
  }
  for (size_t i = 0; i < b->n; i++)
    b->slope[i] = aspi_track_face_slope(b->track, i);
  gsl_sort_index(b->order, b->slope, 1, b->n);
  return ASP_OK;
}

/* The quantiles of one angle, ANGLES numbers apart: the slopes at which the sum of the weights
 * passes each node. */
static void fill(workspace *b, double alpha1, float *delta) {
  aspi_track_first_hit(b->track, alpha1, b->weight);
  double sum = 0;
  size_t last = 0;
  int node = 0;
  for (size_t i = 0; i < b->n && node < NODES; i++) {
    size_t face = b->order[i];
    if (!(b->weight[face] > 0))
      continue;
    last = face;
    sum += b->weight[face];
    for (; node < NODES && u_at(node) <= sum; node++)
      delta[node * ANGLES] = (float)atan(b->slope[face]);
  }
  for (; node < NODES; node++)
    delta[node * ANGLES] = (float)atan(b->slope[last]);
}

static void release(void *data) {
  table *t = data;
  aspi_area_free(t->area);
  for (int i = 0; i < t->bins; i++) {
    aspi_law_free(t->law[i][0]);
    aspi_law_free(t->law[i][1]);
  }
  free(t);
}

/* The faces of a track as a line, seen in either way of flight, each as long as a spacing of the
 * profile; of a long one its beginning. */
static asp_code make_law(const workspace *b, bool back, aspi_law **law, asp_error *error) {
  size_t n = b->n / b->parts < LAW_FACES_MOST ? b->n / b->parts : LAW_FACES_MOST;
  aspi_line line;
  asp_code code = aspi_line_create(&line, n, 1, error);
  if (code)
    return code;
  double z = 0;
  for (size_t i = 0; i < n; i++) {
    const double *slope = b->slope + (back ? n - 1 - i : i) * b->parts;
    line.slope[i] = 0;
    for (size_t k = 0; k < b->parts; k++)
      line.slope[i] += (back ? -slope[k] : slope[k]) / (double)b->parts;
    line.end_x[i] = (double)(i + 1);
    line.end_z[i] = z += line.slope[i];
  }
  *law = aspi_law_create(&line, NULL, error);
  aspi_line_free(&line);
  return *law ? ASP_OK : ASP_ENOMEM;
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
    workspace b;
    t->d_p[i] = aspi_sizes_at(sizes, i);
    asp_code code = workspace_create(&b, profile, t->d_p[i], error);
    if (code) {
      release(t);
      return NULL;
    }
    for (int k = 0; k < ANGLES; k++)
      fill(&b, WIDTH * k * k, t->delta + i * SIZE + k);
    code = make_law(&b, false, &t->law[i][0], error);
    if (!code)
      code = make_law(&b, true, &t->law[i][1], error);
    workspace_free(&b);
    if (code) {
      release(t);
      return NULL;
    }
  }
  return t;
}

static void *prepare_map(const asp_map *map, const aspi_sizes *sizes, asp_error *error) {
  table *t = calloc(1, sizeof *t);
  if (t)
    t->area = aspi_area_create(map, sizes, error);
  else
    aspi_fail(error, ASP_ENOMEM, "out of memory for the laws of a map");
  if (t && t->area)
    return t;
  free(t);
  return NULL;
}

/* A place along one of the table's three ways: the node before it, and the share of the step to the
 * next. */
typedef struct place {
  int step;
  double share;
} place;

static place place_of_u(double u) {
  double cell = u * CELLS, last = cell - (CELLS - 1), at = cell + (PARTS - 1);
  if (cell < 1)
    at = cell * PARTS;
  if (last > 0)
    at = last * PARTS + (CELLS + PARTS - 2);
  int node = (int)fmin(at, NODES - 2);
  return (place){node, at - node};
}

static place place_of_angle(double alpha1) {
  int k = (int)fmin(sqrt(alpha1 / WIDTH), ANGLES - 2);
  return (place){k, (alpha1 - WIDTH * k * k) / (WIDTH * (2 * k + 1))};
}

static place place_of_size(const table *t, double d_p) {
  if (t->bins < 2)
    return (place){0, 0};
  size_t last = (size_t)t->bins - 1;
  d_p = fmin(fmax(d_p, t->d_p[0]), t->d_p[last]);
  size_t i = gsl_interp_bsearch(t->d_p, d_p, 0, last);
  double step = t->d_p[i + 1] - t->d_p[i]; /* 0 where all are of one size */
  return (place){(int)i, step > 0 ? (d_p - t->d_p[i]) / step : 0};
}

/* Between which sizes and angles a view lies: where their numbers begin, how far those of the next
 * size are, and the shares. */
typedef struct cell {
  const float *delta;
  int next;
  double size, angle;
} cell;

static cell cell_of(const aspi_view *view) {
  const table *t = view->data;
  place size = place_of_size(t, view->d_p), angle = place_of_angle(view->alpha1);
  return (cell){t->delta + size.step * SIZE + angle.step, t->bins > 1 ? SIZE : 0, size.share,
                angle.share};
}

static double mix(double from, double to, double share) {
  return from + share * (to - from);
}

static double delta_at(const cell *c, place u) {
  double at[2];
  for (int k = 0; k < 2; k++) { /* at the angle below and above */
    const float *first = c->delta + u.step * ANGLES + k, *second = first + c->next;
    at[k] = mix(mix(first[0], first[ANGLES], u.share), mix(second[0], second[ANGLES], u.share),
                c->size);
  }
  return mix(at[0], at[1], c->angle);
}

static double node_at(const cell *c, int node) {
  bool last = node == NODES - 1;
  return delta_at(c, (place){last ? node - 1 : node, last ? 1 : 0});
}

static double quantile(const aspi_view *view, double u) {
  if (view->alpha1 < 0)
    return aspi_spread_visible.quantile(view, u);
  if (!view->data)
    return aspi_ensemble_quantile(view, u);
  cell c = cell_of(view);
  double delta = delta_at(&c, place_of_u(u));
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
  return u_at(node + (delta - low) / (high - low));
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
  return (u_at(node + 1) - u_at(node)) / (node_at(&c, node + 1) - node_at(&c, node));
}

/* Hit after hit over a profile; the first from the table, the others from the law. */
static bool follow(const aspi_view *view, aspi_stream *stream, aspi_path *path, double *delta) {
  const table *t = view->data;
  if (t->area)
    return aspi_area_follow(t->area, view, stream, path, delta);
  if (!path->begun) {
    path->begun = true;
    path->size =
        aspi_sizes_nearest(&(aspi_sizes){t->d_p[0], t->d_p[t->bins - 1], t->bins}, view->d_p);
    path->came = view->alpha1;
    path->kind = aspi_law_kind(view->alpha1, stream);
    *delta = quantile(view, aspi_stream_uniform(stream));
    path->p = tan(*delta);
    return true;
  }
  bool turned = path->back != path->came_back;
  if (view->alpha1 < 0 && aspi_law_leaves(t->law[path->size][path->came_back], &path->kind, path->p,
                                          tan(-view->alpha1), turned, stream))
    return false;
  path->kind = aspi_law_next(t->law[path->size][path->back], path->came, -view->alpha1, stream,
                             &path->p, &path->q);
  path->came_back = path->back;
  path->came = fmax(path->came, view->alpha1);
  *delta = atan(path->p);
  return true;
}

const asp_spread_model aspi_spread_profile = {
    .name = "profile",
    .summary = "first-hit law of the geometry, from a table: of the profile, or of Gaussian walls",
    .source = "geometry, derived for this project",
    .cost = 1,
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
