/* The tables of a line come from its geometry alone: first hits by the running maximum of g = z +
 * x tan(alpha1); escape by the horizon of a face, the steepest slope to any point ahead (or
 * behind); the next face by the next point as high as the path. Each takes one pass over the points
 * with a stack: the upper hull for the horizons, the next greater element for the paths.
 *
 * A face is remembered by its class and its steepness only: horizons and cross slopes are tabled
 * for 16 bins of the faces by steepness. So the third and later hits in a row lose some of the
 * correlation between neighboring faces.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/line_table.h"
#include "base/error.h"
#include "spread/quantiles.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  ANGLES = 32,             /* impact angles of first hits */
  BINS = ASPI_SAMPLE_BINS, /* of the faces by steepness */
  INCOMING = 3,            /* ranges of impact angles, of particles on their way to a later hit */
  ELEVATIONS = 17,
  LATER = INCOMING * ELEVATIONS,
  CLASSES = ANGLES + LATER,
  FIRST_NODES = ASPI_SHARES_NODES(96, 16),
  LATER_NODES = ASPI_SHARES_NODES(24, 4),
  SIDE_NODES = ASPI_SHARES_NODES(24, 4),
  HORIZON_NODES = 16
};

/* Slopes along the flight at first and later hits, across the flight, and of the horizons. The last
 * cell of the horizons is halved again and again: the few faces with a peak right before them
 * decide. */
static const aspi_shares of_first = {96, 16, FIRST_NODES}, of_later = {24, 4, LATER_NODES},
                         of_side = {24, 4, SIDE_NODES}, of_horizon = {8, 0, HORIZON_NODES};

/* Elevations are this times k |k|. */
#define ELEVATION_MOST (89.5 * ASP_PI / 180)

/* Representative impact angle of each range, and the start of the range. */
static const double incoming_at[INCOMING] = {0.05, 0.2, 0.7};
static const double incoming_from[INCOMING] = {0, 0.1, 0.4};

/* The faces of one class by steepness. */
typedef struct face_bins {
  float q[BINS][SIDE_NODES];
  float horizon[2][BINS][HORIZON_NODES]; /* ahead, behind */
} face_bins;

struct aspi_line_table {
  bool has_q;
  float first[ANGLES][FIRST_NODES];
  float later[LATER][LATER_NODES];
  face_bins bins[CLASSES]; /* of first hits, then of later ones */
};

/* ---- geometry ---- */

enum { BY_P, BY_Q, BY_AHEAD, BY_BEHIND, ORDERS };

/* Arrays over the faces while a table is made. */
typedef struct builder {
  const aspi_line *line;
  aspi_line_table *table;
  size_t n;
  double *q, *horizon[2], *weight, *start[INCOMING];
  double *sorted[ORDERS]; /* slopes, cross slopes, horizons; `order` has their indices */
  double total[BINS];     /* weight */
  size_t *order[ORDERS], *stack, *next;
  unsigned char *bin;
  double *numbers; /* memory of the arrays above */
  size_t *indices;
} builder;

static void builder_free(builder *m) {
  free(m->numbers);
  free(m->indices);
  free(m->bin);
}

static bool builder_create(builder *m, const aspi_line *line, aspi_line_table *table) {
  size_t n = line->n;
  *m = (builder){.line = line, .table = table, .n = n};
  double **const arrays[] = {&m->q,         &m->horizon[0], &m->horizon[1], &m->weight,
                             &m->start[0],  &m->start[1],   &m->start[2],   &m->sorted[0],
                             &m->sorted[1], &m->sorted[2],  &m->sorted[3]};
  enum { ARRAYS = sizeof arrays / sizeof *arrays };
  m->numbers = calloc(n, ARRAYS * sizeof *m->numbers);
  m->indices = calloc(n, (ORDERS + 3) * sizeof *m->indices);
  m->bin = calloc(n, 1);
  if (!m->numbers || !m->indices || !m->bin)
    return false;
  for (size_t i = 0; i < ARRAYS; i++)
    *arrays[i] = m->numbers + i * n;
  for (size_t i = 0; i < ORDERS; i++)
    m->order[i] = m->indices + i * n;
  m->next = m->indices + ORDERS * n;
  m->stack = m->next + n; /* two periods */
  return true;
}

/* Positions over two periods: point k is the end of face k mod n. */
static double x_of(const aspi_line *line, size_t k) {
  return k < line->n ? line->end_x[k] : line->end_x[k - line->n] + line->step * (double)line->n;
}

static double z_of(const aspi_line *line, size_t k) {
  return line->end_z[k < line->n ? k : k - line->n];
}

static double slope_between(const aspi_line *line, size_t a, size_t b) {
  double dx = x_of(line, b) - x_of(line, a);
  return dx > 0 ? (z_of(line, b) - z_of(line, a)) / dx : 0;
}

/* The steepest slope from the end of each face to any point ahead, within two periods: to a point
 * of the upper hull of the line ahead. */
static void horizons_ahead(builder *m) {
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

/* The steepest slope from the beginning of each face to any point behind. */
static void horizons_behind(builder *m) {
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

/* The next face on a flight of this slope from the end of each face; n for none. */
static void find_next(builder *m, double slope) {
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

/* Sorts the faces into bins of equal weight by steepness; false where none has weight. */
static bool make_bins(builder *m) {
  double total = 0, sum = 0;
  for (size_t i = 0; i < m->n; i++)
    total += m->weight[i];
  for (size_t i = 0; i < m->n; i++) {
    size_t at = m->order[BY_P][i];
    double middle = (sum + 0.5 * m->weight[at]) / total;
    sum += m->weight[at];
    m->bin[at] = (unsigned char)fmin(fmax(middle * BINS, 0), BINS - 1);
  }
  memset(m->total, 0, sizeof m->total);
  for (size_t i = 0; i < m->n; i++)
    m->total[m->bin[i]] += m->weight[i];
  return total > 0;
}

static void fill(const builder *m, const aspi_shares *shares, int order, const unsigned char *bin,
                 float *table) {
  const aspi_sample sample = {m->sorted[order], m->weight, m->order[order], bin, m->total, m->n};
  aspi_quantiles_fill(shares, &sample, bin ? BINS : 1, table);
}

/* Slopes along the flight, and by bin cross slopes and horizons. */
static void fill_class(builder *m, const aspi_shares *shares, float *slopes, face_bins *bins) {
  fill(m, shares, BY_P, NULL, slopes);
  if (m->table->has_q)
    fill(m, &of_side, BY_Q, m->bin, bins->q[0]);
  fill(m, &of_horizon, BY_AHEAD, m->bin, bins->horizon[0][0]);
  fill(m, &of_horizon, BY_BEHIND, m->bin, bins->horizon[1][0]);
}

static void fill_first(builder *m, int k) {
  double alpha1 = fmin(aspi_angle_at(ANGLES, k), ELEVATION_MOST);
  aspi_line_first_hits(m->line, aspi_line_fall(m->line, alpha1), m->weight);
  make_bins(m);
  fill_class(m, &of_first, m->table->first[k], &m->table->bins[k]);
}

static double elevation_at(int node) {
  double part = (node - (ELEVATIONS - 1) / 2) / ((ELEVATIONS - 1) / 2.);
  return ELEVATION_MOST * part * fabs(part);
}

/* Weighs each face by the paths that end there, which begin at first hits and fly off at this
 * slope; false where hardly any path ends on the wall. */
static bool weigh_next(builder *m, int incoming, double slope) {
  const double *start = m->start[incoming];
  double sum = 0, all = 0;
  memset(m->weight, 0, m->n * sizeof *m->weight);
  for (size_t i = 0; i < m->n; i++) {
    if (!(slope > m->line->slope[i]))
      continue;
    all += start[i];
    if (m->next[i] < m->n) {
      m->weight[m->next[i]] += start[i];
      sum += start[i];
    }
  }
  for (size_t i = 0; sum > 0 && i < m->n; i++)
    m->weight[i] /= sum;
  return sum > 1e-6 * all && sum > 0;
}

static void fill_later(builder *m) {
  aspi_line_table *t = m->table;
  for (int e = 0; e < ELEVATIONS; e++) {
    double slope = tan(elevation_at(e));
    find_next(m, slope);
    for (int c = 0; c < INCOMING; c++) {
      int k = c * ELEVATIONS + e;
      if (weigh_next(m, c, slope) && make_bins(m)) {
        fill_class(m, &of_later, t->later[k], &t->bins[ANGLES + k]);
      } else if (e > 0) {
        memcpy(t->later[k], t->later[k - 1], sizeof t->later[k]);
        t->bins[ANGLES + k] = t->bins[ANGLES + k - 1];
      }
    }
  }
}

static void fill_all(builder *m) {
  const double *const by[ORDERS] = {m->line->slope, m->q, m->horizon[0], m->horizon[1]};
  horizons_ahead(m);
  horizons_behind(m);
  for (int i = 0; i < ORDERS; i++) {
    gsl_sort_index(m->order[i], by[i], 1, m->n);
    for (size_t k = 0; k < m->n; k++)
      m->sorted[i][k] = by[i][m->order[i][k]];
  }
  for (int k = 0; k < ANGLES; k++)
    fill_first(m, k);
  for (int c = 0; c < INCOMING; c++)
    aspi_line_first_hits(m->line, aspi_line_fall(m->line, incoming_at[c]), m->start[c]);
  fill_later(m);
}

aspi_line_table *aspi_line_table_create(const aspi_line *line, const float *q, asp_error *error) {
  builder m = {0};
  aspi_line_table *table = calloc(1, sizeof *table);
  if (table && builder_create(&m, line, table)) {
    table->has_q = q;
    for (size_t i = 0; q && i < line->n; i++)
      m.q[i] = q[i];
    fill_all(&m);
  } else {
    aspi_fail(error, ASP_ENOMEM, "out of memory for the tables of a line of %zu points", line->n);
    free(table);
    table = NULL;
  }
  builder_free(&m);
  return table;
}

void aspi_line_table_free(aspi_line_table *table) {
  free(table);
}

/* ---- drawing ---- */

/* One of the two nodes around a place, the nearer one more often. */
static int node_near(aspi_place place, aspi_stream *stream) {
  return place.node + (aspi_stream_uniform(stream) < place.part);
}

static int bin_of(double share) {
  return (int)fmin(share * BINS, BINS - 1);
}

static double draw_side(const aspi_line_table *table, int face_class, double share,
                        aspi_stream *stream) {
  if (!table->has_q)
    return 0;
  const float *nodes = table->bins[face_class].q[bin_of(share)];
  return aspi_quantile(&of_side, nodes, aspi_stream_uniform(stream));
}

int aspi_line_table_class(double alpha1, aspi_stream *stream) {
  return node_near(aspi_angle_place(ANGLES, alpha1), stream);
}

int aspi_line_table_first(const aspi_line_table *table, double alpha1, aspi_stream *stream,
                          double *p, double *q) {
  double u = aspi_stream_uniform(stream);
  aspi_place angle = aspi_angle_place(ANGLES, alpha1);
  int face_class = node_near(angle, stream);
  *p = (1 - angle.part) * aspi_quantile(&of_first, table->first[angle.node], u) +
       angle.part * aspi_quantile(&of_first, table->first[angle.node + 1], u);
  *p = fmax(*p, -tan(fmax(alpha1, 0)));
  *q = draw_side(table, face_class, u, stream);
  return face_class;
}

bool aspi_line_table_escapes(const aspi_line_table *table, int face_class, double slope,
                             double rise, bool back, aspi_stream *stream) {
  bool first = face_class < ANGLES;
  double share = first ? aspi_quantiles_below(&of_first, table->first[face_class], slope)
                       : aspi_quantiles_below(&of_later, table->later[face_class - ANGLES], slope);
  const float *nodes = table->bins[face_class].horizon[back][bin_of(share)];
  return rise > aspi_quantile(&of_horizon, nodes, aspi_stream_uniform(stream));
}

int aspi_line_table_next(const aspi_line_table *table, double alpha1, double theta,
                         aspi_stream *stream, double *p, double *q) {
  int incoming = 0, half = (ELEVATIONS - 1) / 2;
  while (incoming + 1 < INCOMING && alpha1 >= incoming_from[incoming + 1])
    incoming++;
  double at = copysign(sqrt(fmin(fabs(theta) / ELEVATION_MOST, 1)), theta) * half + half;
  int e = (int)fmin(fmax(at, 0), ELEVATIONS - 2);
  int k = incoming * ELEVATIONS + node_near((aspi_place){e, at - e}, stream);
  double u = aspi_stream_uniform(stream), flight = tan(fmin(theta, ELEVATION_MOST));
  double unseen = aspi_quantiles_below(&of_later, table->later[k], flight);
  if (u < unseen) /* no such face is hit: one is drawn of those that are */
    u = unseen + (1 - unseen) * (u / unseen);
  *p = fmax(flight, aspi_quantile(&of_later, table->later[k], u));
  *q = draw_side(table, ANGLES + k, u, stream);
  return ANGLES + k;
}
