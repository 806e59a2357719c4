/* The law of a line as tables of quantiles, all of them from its geometry and none from a model of
 * heights: first hits by the running maximum of g = z + x tan(alpha1); whether a particle leaves,
 * by the horizon of the face that it is on, the steepest slope to any point ahead (or behind); the
 * next face, by the next point that is as high as the path. One pass each over the points, with
 * stacks: the upper hull for the horizons, the next greater element for the paths.
 *
 * A face is remembered by its steepness among the faces that are hit: horizons and cross slopes are
 * tabled for each of its parts. Nothing else is known of the place, so that of more than two hits
 * in a row the later ones know less than the geometry does.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/law.h"
#include "base/error.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  ANGLES = 32,
  CELLS = 96, /* of equal width in the share of the first hits */
  PARTS = 16, /* of the first and of the last of them, for the tails */
  NODES = CELLS - 2 + 2 * PARTS + 1,
  BINS = 16,  /* of the faces by steepness */
  SIDES = 24, /* cells of the cross slope in a bin, with tails as above */
  SIDE_PARTS = 4,
  SIDE_NODES = SIDES - 2 + 2 * SIDE_PARTS + 1,
  HORIZON_CELLS = 8, /* of equal width, and the last one halved again and again */
  HORIZON_NODES = 16,
  CLASSES = 3, /* of impact angles, of particles on their way to a later hit */
  ELEVATIONS = 17,
  LATER = CLASSES * ELEVATIONS,
  LATER_CELLS = 24,
  LATER_PARTS = 4,
  LATER_NODES = LATER_CELLS - 2 + 2 * LATER_PARTS + 1
};

/* Impact angles are this times k^2, elevations this times k |k|. */
#define ANGLE_STEP (ASP_PI / 2 / ((ANGLES - 1.) * (ANGLES - 1.)))
#define ELEVATION_MOST (89.5 * ASP_PI / 180)

/* The impact angles that stand for each class, and where one begins. */
static const double class_at[CLASSES] = {0.05, 0.2, 0.7};
static const double class_from[CLASSES] = {0, 0.1, 0.4};

/* Of one set of faces: the first hits at an angle, or the next ones at an elevation. */
typedef struct first_table {
  float p[NODES];
  float q[BINS][SIDE_NODES];
  float horizon[2][BINS][HORIZON_NODES]; /* ahead, behind */
} first_table;

typedef struct later_table {
  float p[LATER_NODES];
  float q[BINS][SIDE_NODES];
  float horizon[2][BINS][HORIZON_NODES];
} later_table;

struct aspi_law {
  bool has_q;
  first_table first[ANGLES];
  later_table later[LATER];
};

/* ---- quantiles ---- */

/* A row of quantiles: shares at its nodes, and how many there are. The first and the last cell of
 * the slopes' are divided into parts, for the tails; the last one of the horizons' is halved again
 * and again, since few faces have a peak right before them, and those decide. */
typedef struct row {
  int cells, parts, nodes; /* parts 0: halved */
} row;

static const row of_first = {CELLS, PARTS, NODES}, of_side = {SIDES, SIDE_PARTS, SIDE_NODES},
                 of_later = {LATER_CELLS, LATER_PARTS, LATER_NODES},
                 of_horizon = {HORIZON_CELLS, 0, HORIZON_NODES};

static double share_at(const row *r, int node) {
  if (r->parts == 0) {
    if (node < r->cells)
      return node / (double)r->cells;
    return node < r->nodes - 1 ? 1 - ldexp(1, r->cells - 1 - node) / r->cells : 1;
  }
  if (node < r->parts)
    return node / ((double)r->parts * r->cells);
  int last = r->parts + r->cells - 2;
  if (node > last)
    return ((double)(node - last) / r->parts + r->cells - 1) / r->cells;
  return (double)(node - (r->parts - 1)) / r->cells;
}

static double place_of(const row *r, double u) {
  double cell = u * r->cells, last = cell - (r->cells - 1);
  if (r->parts == 0)
    return last > 0 ? r->cells - 1 - log2(fmax(1 - last, 1e-9)) : cell;
  if (cell < 1)
    return cell * r->parts;
  return last > 0 ? last * r->parts + (r->cells + r->parts - 2) : cell + (r->parts - 1);
}

static double interpolate(const row *r, const float *nodes, double u) {
  double place = fmin(place_of(r, u), r->nodes - 1);
  int k = (int)fmin(place, r->nodes - 2);
  return nodes[k] + (place - k) * ((double)nodes[k + 1] - nodes[k]);
}

/* What the faces of a line are sorted by. */
typedef struct sorted {
  const double *value;
  size_t *order;
} sorted;

/* Nodes of one bin while a table is filled. */
typedef struct filling {
  double sum, total;
  int node;
} filling;

/* Quantiles of a value over the faces of each bin, by their weights. An empty bin takes those of
 * the bin before it, and empty bins at the beginning those of the first that is not. `table` has
 * `nodes` numbers a bin. */
static void fill(const sorted *by, size_t n, const double *weight, const unsigned char *bin,
                 int bins, const row *r, float *table) {
  int nodes = r->nodes;
  filling f[BINS] = {{0}};
  for (size_t i = 0; i < n; i++)
    f[bin ? bin[i] : 0].total += weight[i];
  double last[BINS] = {0};
  for (size_t i = 0; i < n; i++) {
    size_t at = by->order[i];
    if (!(weight[at] > 0))
      continue;
    int b = bin ? bin[at] : 0;
    f[b].sum += weight[at];
    last[b] = by->value[at];
    for (; f[b].node < nodes && share_at(r, f[b].node) * f[b].total <= f[b].sum; f[b].node++)
      table[b * nodes + f[b].node] = (float)by->value[at];
  }
  for (int b = 0; b < bins; b++)
    for (; f[b].node < nodes; f[b].node++)
      table[b * nodes + f[b].node] = (float)last[b];
  int first = 0;
  while (first < bins - 1 && !(f[first].total > 0))
    first++;
  for (int b = 0; b < bins; b++)
    if (!(f[b].total > 0)) {
      int from = b < first ? first : b - 1;
      memcpy(table + b * nodes, table + from * nodes, (size_t)nodes * sizeof *table);
    }
}

/* ---- geometry ---- */

/* All that is needed while a law is made. */
typedef struct making {
  const aspi_line *line;
  size_t n;
  double *q, *horizon[2], *weight, *start[CLASSES];
  size_t *order[4]; /* by p, q, both horizons */
  size_t *stack, *next;
  unsigned char *bin;
} making;

static void making_free(making *m) {
  double *const numbers[] = {m->q, m->horizon[0], m->horizon[1], m->weight};
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
    free(numbers[i]);
  for (int c = 0; c < CLASSES; c++)
    free(m->start[c]);
  for (int i = 0; i < 4; i++)
    free(m->order[i]);
  free(m->stack);
  free(m->next);
  free(m->bin);
}

static bool making_create(making *m, const aspi_line *line) {
  size_t n = line->n;
  *m = (making){.line = line, .n = n};
  bool made = true;
  double **const numbers[] = {&m->q, &m->horizon[0], &m->horizon[1], &m->weight};
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
    made = (*numbers[i] = calloc(n, sizeof(double))) && made;
  for (int c = 0; c < CLASSES; c++)
    made = (m->start[c] = calloc(n, sizeof(double))) && made;
  for (int i = 0; i < 4; i++)
    made = (m->order[i] = calloc(n, sizeof(size_t))) && made;
  made = (m->stack = calloc(2 * n, sizeof *m->stack)) && made;
  made = (m->next = calloc(n, sizeof *m->next)) && made;
  return (m->bin = calloc(n, 1)) && made;
}

/* Places of points that go on over the periods: point k is the end of face k mod n. */
static double x_of(const aspi_line *line, size_t k) {
  return line->end_x[k % line->n] + line->step * (double)(k - k % line->n);
}

static double z_of(const aspi_line *line, size_t k) {
  return line->end_z[k % line->n];
}

static double slope_between(const aspi_line *line, size_t a, size_t b) {
  double dx = x_of(line, b) - x_of(line, a);
  return dx > 0 ? (z_of(line, b) - z_of(line, a)) / dx : 0;
}

/* The steepest slope from the end of each face to any point ahead, within two periods; the points
 * that matter are those of the upper hull of what lies ahead. */
static void horizons_ahead(making *m) {
  size_t n = m->n, depth = 0;
  for (size_t k = 2 * n; k-- > 0;) {
    while (depth > 1 && slope_between(m->line, k, m->stack[depth - 1]) <=
                            slope_between(m->line, k, m->stack[depth - 2]))
      depth--;
    if (k < n && depth > 0)
      m->horizon[0][k] = fmax(0, slope_between(m->line, k, m->stack[depth - 1]));
    m->stack[depth++] = k;
  }
}

/* As above from the beginning of each face to any point behind. */
static void horizons_behind(making *m) {
  size_t n = m->n, depth = 0;
  for (size_t k = 0; k < 2 * n; k++) {
    while (depth > 1 && slope_between(m->line, m->stack[depth - 1], k) >=
                            slope_between(m->line, m->stack[depth - 2], k))
      depth--;
    if (k >= n && depth > 0)
      m->horizon[1][(k + 1) % n] = fmax(0, -slope_between(m->line, m->stack[depth - 1], k));
    m->stack[depth++] = k;
  }
}

/* For a flight of that slope from the end of each face the face that is met next, n for none. */
static void find_next(making *m, double slope) {
  size_t n = m->n, depth = 0;
  for (size_t k = 2 * n; k-- > 0;) {
    double g = z_of(m->line, k) - slope * x_of(m->line, k);
    while (depth > 0 &&
           z_of(m->line, m->stack[depth - 1]) - slope * x_of(m->line, m->stack[depth - 1]) < g)
      depth--;
    if (k < n)
      m->next[k] = depth > 0 ? m->stack[depth - 1] % n : n;
    m->stack[depth++] = k;
  }
}

/* ---- making ---- */

/* Which part of the faces, by steepness and weight, each is in; false where none has weight. */
static bool make_bins(making *m, const double *weight) {
  double total = 0, sum = 0;
  for (size_t i = 0; i < m->n; i++)
    total += weight[i];
  for (size_t i = 0; i < m->n; i++) {
    size_t at = m->order[0][i];
    double middle = (sum + 0.5 * weight[at]) / total;
    sum += weight[at];
    m->bin[at] = (unsigned char)fmin(fmax(middle * BINS, 0), BINS - 1);
  }
  return total > 0;
}

/* Cross slopes and horizons by bin. */
static void fill_bins(making *m, const double *weight, bool has_q, float *q, float *ahead,
                      float *behind) {
  const sorted by_q = {m->q, m->order[1]}, by_ahead = {m->horizon[0], m->order[2]},
               by_behind = {m->horizon[1], m->order[3]};
  if (has_q)
    fill(&by_q, m->n, weight, m->bin, BINS, &of_side, q);
  fill(&by_ahead, m->n, weight, m->bin, BINS, &of_horizon, ahead);
  fill(&by_behind, m->n, weight, m->bin, BINS, &of_horizon, behind);
}

static void fill_first(making *m, aspi_law *law, int k) {
  first_table *t = &law->first[k];
  double fall = tan(fmin(ANGLE_STEP * k * k, ELEVATION_MOST));
  aspi_line_first_hit(m->line, fmax(fall, aspi_line_fall_least(m->line)), m->weight);
  make_bins(m, m->weight);
  fill(&(sorted){m->line->slope, m->order[0]}, m->n, m->weight, NULL, 1, &of_first, t->p);
  fill_bins(m, m->weight, law->has_q, t->q[0], t->horizon[0][0], t->horizon[1][0]);
}

/* The elevation of a node. */
static double elevation_at(int e) {
  double part = (e - (ELEVATIONS - 1) / 2) / ((ELEVATIONS - 1) / 2.);
  return ELEVATION_MOST * part * fabs(part);
}

/* Paths that begin on faces as they are hit first and are left at that elevation; false where
 * hardly any of them ends on the wall. */
static bool weigh_next(making *m, int c, double slope) {
  double sum = 0, all = 0;
  memset(m->weight, 0, m->n * sizeof *m->weight);
  for (size_t i = 0; i < m->n; i++) {
    if (!(slope > m->line->slope[i]))
      continue;
    all += m->start[c][i];
    if (m->next[i] < m->n) {
      m->weight[m->next[i]] += m->start[c][i];
      sum += m->start[c][i];
    }
  }
  return sum > 1e-6 * all && sum > 0;
}

static void fill_later(making *m, aspi_law *law) {
  for (int e = 0; e < ELEVATIONS; e++) {
    double slope = tan(elevation_at(e));
    find_next(m, slope);
    for (int c = 0; c < CLASSES; c++) {
      later_table *t = &law->later[c * ELEVATIONS + e];
      if (!weigh_next(m, c, slope) || !make_bins(m, m->weight)) {
        if (e > 0)
          *t = t[-1];
        continue;
      }
      fill(&(sorted){m->line->slope, m->order[0]}, m->n, m->weight, NULL, 1, &of_later, t->p);
      fill_bins(m, m->weight, law->has_q, t->q[0], t->horizon[0][0], t->horizon[1][0]);
    }
  }
}

aspi_law *aspi_law_create(const aspi_line *line, const float *q, asp_error *error) {
  aspi_law *law = calloc(1, sizeof *law);
  making m = {0};
  bool made = law && making_create(&m, line);
  if (made) {
    law->has_q = q;
    for (size_t i = 0; q && i < line->n; i++)
      m.q[i] = q[i];
    horizons_ahead(&m);
    horizons_behind(&m);
    gsl_sort_index(m.order[0], line->slope, 1, line->n);
    gsl_sort_index(m.order[1], m.q, 1, line->n);
    gsl_sort_index(m.order[2], m.horizon[0], 1, line->n);
    gsl_sort_index(m.order[3], m.horizon[1], 1, line->n);
    for (int k = 0; k < ANGLES; k++)
      fill_first(&m, law, k);
    for (int c = 0; c < CLASSES; c++)
      aspi_line_first_hit(line, fmax(tan(class_at[c]), aspi_line_fall_least(line)), m.start[c]);
    fill_later(&m, law);
  } else {
    aspi_fail(error, ASP_ENOMEM, "out of memory for the law of a line of %zu points", line->n);
    free(law);
    law = NULL;
  }
  making_free(&m);
  return law;
}

void aspi_law_free(aspi_law *law) {
  free(law);
}

/* ---- drawing ---- */

/* One of the two nodes that an impact angle is between, the nearer one more often. */
static int node_of(double alpha1, aspi_stream *stream) {
  alpha1 = fmax(alpha1, 0); /* of one that hardly approaches */
  int k = (int)fmin(sqrt(alpha1 / ANGLE_STEP), ANGLES - 2);
  double share = (alpha1 - ANGLE_STEP * k * k) / (ANGLE_STEP * (2 * k + 1));
  return aspi_stream_uniform(stream) < share ? k + 1 : k;
}

static int bin_of(double u) {
  return (int)fmin(u * BINS, BINS - 1);
}

/* The share of the faces of a table that are less steep. */
static double share_below(const row *r, const float *nodes, double slope) {
  int low = 0, high = r->nodes - 1;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    *(nodes[middle] <= slope ? &low : &high) = middle;
  }
  double step = (double)nodes[high] - nodes[low];
  double part = step > 0 ? fmin(fmax((slope - nodes[low]) / step, 0), 1) : 0.5;
  return share_at(r, low) + part * (share_at(r, high) - share_at(r, low));
}

aspi_kind aspi_law_kind(double alpha1, aspi_stream *stream) {
  return (aspi_kind){false, node_of(alpha1, stream)};
}

static double side(const float *nodes, bool has_q, aspi_stream *stream) {
  if (!has_q)
    return 0;
  return interpolate(&of_side, nodes, aspi_stream_uniform(stream));
}

aspi_kind aspi_law_first(const aspi_law *law, double alpha1, aspi_stream *stream, double *p,
                         double *q) {
  double u = aspi_stream_uniform(stream);
  alpha1 = fmax(alpha1, 0);
  int k = (int)fmin(sqrt(alpha1 / ANGLE_STEP), ANGLES - 2);
  double share = (alpha1 - ANGLE_STEP * k * k) / (ANGLE_STEP * (2 * k + 1));
  aspi_kind kind = aspi_law_kind(alpha1, stream);
  *p = (1 - share) * interpolate(&of_first, law->first[k].p, u) +
       share * interpolate(&of_first, law->first[k + 1].p, u);
  *p = fmax(*p, -tan(alpha1));
  *q = side(law->first[kind.node].q[bin_of(u)], law->has_q, stream);
  return kind;
}

bool aspi_law_leaves(const aspi_law *law, const aspi_kind *kind, double slope, double rise,
                     bool back, aspi_stream *stream) {
  const first_table *first = &law->first[kind->later ? 0 : kind->node];
  const later_table *later = &law->later[kind->later ? kind->node : 0];
  int bin = bin_of(kind->later ? share_below(&of_later, later->p, slope)
                               : share_below(&of_first, first->p, slope));
  const float *nodes = kind->later ? later->horizon[back][bin] : first->horizon[back][bin];
  return rise > interpolate(&of_horizon, nodes, aspi_stream_uniform(stream));
}

aspi_kind aspi_law_next(const aspi_law *law, double alpha1, double theta, aspi_stream *stream,
                        double *p, double *q) {
  int c = 0, half = (ELEVATIONS - 1) / 2;
  while (c + 1 < CLASSES && alpha1 >= class_from[c + 1])
    c++;
  double part = copysign(sqrt(fmin(fabs(theta) / ELEVATION_MOST, 1)), theta) * half + half;
  int e = (int)fmin(fmax(part, 0), ELEVATIONS - 2);
  e += aspi_stream_uniform(stream) < part - e;
  const later_table *t = &law->later[c * ELEVATIONS + e];
  double u = aspi_stream_uniform(stream), least = tan(fmin(theta, ELEVATION_MOST));
  aspi_kind kind = {true, c * ELEVATIONS + e};
  *p = fmax(least, interpolate(&of_later, t->p, u));
  *q = side(t->q[bin_of(u)], law->has_q, stream);
  return kind;
}
