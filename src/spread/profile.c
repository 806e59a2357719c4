/* The exact first-hit law of a profile as a table: quantiles over impact angle and particle size,
 * each the law that asp_track_first_hit gives there. Between the nodes quantiles are interpolated
 * straight, which keeps them monotone in u and above -alpha1, and costs less than a power.
 *
 * Angles stand closer where the law changes fast: at 90 degrees times (k/63)^2. The first and the
 * last cell in u are divided again, for the tails. Later hits are not in the table: particles that
 * fly up meet the law of `visible`. */
#include "error.h"
#include "spread/cells.h"
#include "spread/models.h"
#include "spread/trace.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  ANGLES = 64,
  CELLS = 512, /* of equal width in u */
  PARTS = 32,  /* of the first and of the last of them */
  NODES = CELLS - 2 + 2 * PARTS + 1,
  PARTS_OF_SIZE = 512 /* at most, to find a bin by */
};

typedef struct table {
  int bins;
  double d_p[ASP_BINS_MAX], per_d_p[ASP_BINS_MAX]; /* 1 over the step to the next */
  double most;                                     /* the last d_p */
  /* Parts of the sizes' range, each so many bits of a double long, and the bin that each begins in:
   * the bits of the diameter are its logarithm, as straight lines between powers of two. */
  uint64_t first_bits;
  int part_bits;
  uint8_t below[PARTS_OF_SIZE];
  double angle[ANGLES], per_angle[ANGLES];
  float delta[][NODES][ANGLES]; /* by size, u, angle; rad */
} table;

/* Where u lies among the nodes: whole part and rest. */
static inline double place_of(double u) {
  double cell = u * CELLS;
  if (cell < 1)
    return cell * PARTS;
  if (cell > CELLS - 1)
    return PARTS + CELLS - 2 + (cell - (CELLS - 1)) * PARTS;
  return PARTS - 1 + cell;
}

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

/* The quantiles of one angle: the slopes at which the sum of the weights passes each node. */
static void fill(bench *b, double alpha1, float (*delta)[ANGLES], int angle) {
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
      delta[node][angle] = (float)atan(b->slope[face]);
  }
  for (; node < NODES; node++)
    delta[node][angle] = (float)atan(b->slope[last]);
}

static void release(void *data) {
  free(data);
}

static void place_parts(table *t) {
  t->most = t->d_p[t->bins - 1];
  t->first_bits = asp_bits(t->d_p[0]);
  uint64_t range = asp_bits(t->most) - t->first_bits;
  for (t->part_bits = 0; range >> t->part_bits >= PARTS_OF_SIZE;)
    t->part_bits++;
  int i = 0;
  for (int k = 0; k < PARTS_OF_SIZE; k++) {
    uint64_t bits = t->first_bits + ((uint64_t)k << t->part_bits);
    while (i < t->bins - 2 && asp_bits(t->d_p[i + 1]) <= bits)
      i++;
    t->below[k] = (uint8_t)i;
  }
}

static void place_nodes(table *t, const asp_sizes *sizes) {
  t->bins = sizes->bins;
  for (int k = 0; k < ANGLES; k++) {
    double width = ASP_PI / 2 / ((ANGLES - 1.) * (ANGLES - 1.));
    t->angle[k] = width * k * k;
    t->per_angle[k] = 1 / (width * (2 * k + 1));
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
  table *t = malloc(sizeof *t + (size_t)sizes->bins * sizeof *t->delta);
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
      fill(&b, t->angle[k], t->delta[i], k);
    bench_free(&b);
  }
  return t;
}

/* Between which sizes and angles a view lies. */
typedef struct cell {
  const float *row;               /* of the lesser size, at the first u and the lesser angle */
  size_t next;                    /* from there to the greater size; 0: there is but one */
  double size_share, angle_share; /* of the greater */
} cell;

/* The last bin but one whose size is not above d_p, which is within the table. */
static inline int bin_below(const table *t, double d_p) {
  int i = t->below[(asp_bits(d_p) - t->first_bits) >> t->part_bits];
  while (i < t->bins - 2 && d_p > t->d_p[i + 1])
    i++;
  return i;
}

static inline cell cell_of(const table *t, const asp_view *view) {
  int k = (int)sqrt(view->alpha1 * (2 / ASP_PI * (ANGLES - 1) * (ANGLES - 1)));
  k = k < ANGLES - 2 ? k : ANGLES - 2;
  double angle = (view->alpha1 - t->angle[k]) * t->per_angle[k];
  if (t->bins == 1)
    return (cell){*t->delta[0] + k, 0, 0, angle};
  double d_p = asp_within(view->d_p, t->d_p[0], t->most);
  int i = bin_below(t, d_p);
  return (cell){*t->delta[i] + k, NODES * ANGLES, (d_p - t->d_p[i]) * t->per_d_p[i], angle};
}

/* The quantile at so large a share of the way from a node to the next. */
static inline double between(const cell *c, int node, double share) {
  const float *first = c->row + node * ANGLES, *second = first + c->next;
  double at[2];
  for (int k = 0; k < 2; k++) {
    double low = first[k] + share * ((double)first[ANGLES + k] - first[k]);
    double high = second[k] + share * ((double)second[ANGLES + k] - second[k]);
    at[k] = low + c->size_share * (high - low);
  }
  return at[0] + c->angle_share * (at[1] - at[0]);
}

static inline double node_at(const cell *c, int node) {
  return node < NODES - 1 ? between(c, node, 0) : between(c, NODES - 2, 1);
}

static double quantile(const asp_view *view, double u) {
  if (view->alpha1 < 0)
    return asp_spread_visible.quantile(view, u);
  cell c = cell_of(view->data, view);
  double place = place_of(u);
  int node = (int)place < NODES - 2 ? (int)place : NODES - 2;
  double delta = between(&c, node, place - node);
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
  cell c = cell_of(view->data, view);
  int node = node_below(&c, delta);
  if (node < 0 || node >= NODES - 1)
    return node < 0 ? 0 : 1;
  double low = node_at(&c, node), high = node_at(&c, node + 1);
  return u_at(node + (delta - low) / (high - low));
}

static double density(const asp_view *view, double delta) {
  if (view->alpha1 < 0)
    return asp_spread_visible.density(view, delta);
  cell c = cell_of(view->data, view);
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
    .prepare = prepare,
    .release = release,
};
