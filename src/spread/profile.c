/* The exact first-hit law of a profile as a table: quantiles over impact angle and particle size,
 * each the law that asp_track_first_hit gives there. Between the nodes quantiles are interpolated
 * straight, which keeps them monotone in u and above -alpha1, and costs less than a power.
 *
 * Angles stand closer where the law changes fast: at 90 degrees times (k/63)^2. The first and the
 * last cell in u are divided again, for the tails. Later hits are not in the table: particles that
 * fly up meet the law of `visible`. */
#include "error.h"
#include "spread/profile_table.h"

#include <gsl/gsl_sort.h>
#include <stdlib.h>

enum {
  ANGLES = ASP_PROFILE_ANGLES,
  NODES = ASP_PROFILE_NODES,
  CELLS = ASP_PROFILE_CELLS,
  PARTS = ASP_PROFILE_PARTS
};

typedef asp_profile_table table;

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
typedef struct bench {
  asp_track *track;
  size_t n;
  double *slope, *weight;
  size_t *order; /* of the faces, by slope */
} bench;

static void bench_free(bench *b) {
  asp_track_free(b->track);
  free(b->slope);
  free(b->weight);
  free(b->order);
}

static asp_code bench_create(bench *b, const asp_profile *profile, double d_p, asp_error *error) {
  *b = (bench){.track = asp_track_create(profile, d_p, error)};
  if (!b->track)
    return ASP_EARG;
  b->n = asp_track_faces(b->track);
  b->slope = malloc(b->n * sizeof *b->slope);
  b->weight = malloc(b->n * sizeof *b->weight);
  b->order = malloc(b->n * sizeof *b->order);
  if (!b->slope || !b->weight || !b->order) {
    bench_free(b);
    return asp_fail(error, ASP_ENOMEM, "out of memory for the slopes of %zu faces", b->n);
  }
  for (size_t i = 0; i < b->n; i++)
    b->slope[i] = asp_track_face_slope(b->track, i);
  gsl_sort_index(b->order, b->slope, 1, b->n);
  return ASP_OK;
}

/* The quantiles of one angle, ANGLES numbers apart: the slopes at which the sum of the weights
 * passes each node. */
static void fill(bench *b, double alpha1, float *delta) {
  asp_track_first_hit(b->track, alpha1, b->weight);
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
  free(data);
}

static void place_parts(table *t) {
  t->most = t->d_p[t->bins - 1];
  t->first_bits = asp_bits(t->d_p[0]);
  uint64_t range = asp_bits(t->most) - t->first_bits;
  for (t->part_bits = 0; range >> t->part_bits >= ASP_PROFILE_SIZE_PARTS;)
    t->part_bits++;
  int i = 0;
  for (int k = 0; k < ASP_PROFILE_SIZE_PARTS; k++) {
    uint64_t bits = t->first_bits + ((uint64_t)k << t->part_bits);
    while (i < t->bins - 2 && asp_bits(t->d_p[i + 1]) <= bits)
      i++;
    t->below[k] = (uint8_t)i;
  }
}

static void place_nodes(table *t, const asp_sizes *sizes) {
  t->bins = sizes->bins;
  t->next = t->bins > 1 ? ASP_PROFILE_SIZE : 0;
  for (int k = 0; k < ANGLES; k++) {
    t->angle[k] = ASP_PROFILE_WIDTH * k * k;
    t->per_angle[k] = 1 / (ASP_PROFILE_WIDTH * (2 * k + 1));
  }
  for (int i = 0; i < t->bins; i++) {
    t->d_p[i] = asp_sizes_at(sizes, i);
    double step = asp_sizes_at(sizes, i + 1) - t->d_p[i];
    t->per_d_p[i] = step > 0 ? 1 / step : 0; /* all of one size */
  }
  place_parts(t);
}

static void *prepare(const asp_profile *profile, const asp_sizes *sizes, asp_error *error) {
  if (asp_sizes_check(sizes, error))
    return NULL;
  table *t = malloc(sizeof *t + (size_t)sizes->bins * ASP_PROFILE_SIZE * sizeof *t->delta);
  if (!t) {
    asp_fail(error, ASP_ENOMEM, "out of memory for a table of %d sizes", sizes->bins);
    return NULL;
  }
  place_nodes(t, sizes);
  for (int i = 0; i < t->bins; i++) {
    bench b;
    if (bench_create(&b, profile, t->d_p[i], error)) {
      free(t);
      return NULL;
    }
    for (int k = 0; k < ANGLES; k++)
      fill(&b, t->angle[k], t->delta + i * ASP_PROFILE_SIZE + k);
    bench_free(&b);
  }
  return t;
}

/* Between which sizes and angles a view lies: where their numbers begin, and the shares. */
typedef struct cell {
  const table *t;
  int at;
  double size, angle;
} cell;

static inline cell cell_of(const asp_view *view) {
  const table *t = view->data;
  asp_profile_place size = asp_profile_size(t, view->d_p),
                    angle = asp_profile_angle(t, view->alpha1);
  return (cell){t, size.step * ASP_PROFILE_SIZE + angle.step, size.share, angle.share};
}

static inline double delta_at(const cell *c, asp_profile_place u) {
  return asp_profile_delta(c->t->delta, c->at + u.step * ANGLES, c->t->next, c->size, u.share,
                           c->angle);
}

static double node_at(const cell *c, int node) {
  bool last = node == NODES - 1;
  return delta_at(c, (asp_profile_place){last ? node - 1 : node, last ? 1 : 0});
}

static double quantile(const asp_view *view, double u) {
  if (view->alpha1 < 0)
    return asp_spread_visible.quantile(view, u);
  cell c = cell_of(view);
  double delta = delta_at(&c, asp_profile_u(u));
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

static double distribution(const asp_view *view, double delta) {
  if (view->alpha1 < 0)
    return asp_spread_visible.distribution(view, delta);
  cell c = cell_of(view);
  int node = node_below(&c, delta);
  if (node < 0 || node >= NODES - 1)
    return node < 0 ? 0 : 1;
  double low = node_at(&c, node), high = node_at(&c, node + 1);
  return u_at(node + (delta - low) / (high - low));
}

static double density(const asp_view *view, double delta) {
  if (view->alpha1 < 0)
    return asp_spread_visible.density(view, delta);
  cell c = cell_of(view);
  int node = node_below(&c, delta);
  if (node < 0 || node >= NODES - 1)
    return 0;
  return (u_at(node + 1) - u_at(node)) / (node_at(&c, node + 1) - node_at(&c, node));
}

const asp_spread_model asp_spread_profile = {
    .name = "profile",
    .summary = "first-hit law of the profile itself, from a table",
    .source = "geometry, derived for this project",
    .upward = true,
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
    .quantile_n = asp_profile_quantile_n,
    .prepare = prepare,
    .release = release,
};
