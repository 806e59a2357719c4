/* Impacts near a place; see near.h. The tree halves the rows, which are permuted, along the
 * coordinate that reaches farthest. An unknown speed or size is NAN: no comparison with it is true,
 * so that it is near any.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/near.h"

#include <stdlib.h>

/* Rows of a leaf. Angle, speed, size. */
enum { LEAF = 16, PLACES = 3 };

/* A reach of 0 counts as this. */
#define FAR_LEAST 1e-4

/* `added`: weight of all its rows. touched: it or
 * something below it may have one. */
typedef struct node {
  double least[PLACES], most[PLACES], rows, added;
  bool touched;
} node;

typedef struct point {
  const aspi_scatter_row *row;
  double rows, at[PLACES], weight; /* at: NAN where it is not known */
} point;

struct aspi_near {
  double far[PLACES];
  point *points;
  size_t count;
  node *nodes;    /* the children of node k are 2 k + 1 and 2 k + 2 */
  double **found; /* weights of what was found last, rows and nodes */
  size_t n_found;
};

typedef struct box {
  double center[PLACES], reach[PLACES];
} box;

static void swap(point *a, point *b) {
  point copy = *a;
  *a = *b;
  *b = copy;
}

/* Permutes points so that those before the middle are not above those behind it (Hoare). */
static void select_middle(point *p, size_t count, int d) {
  size_t middle = count / 2, low = 0, high = count - 1;
  while (low < high) {
    double pivot = p[low + (high - low) / 2].at[d];
    size_t i = low, j = high;
    for (;; i++, j--) {
      while (p[i].at[d] < pivot)
        i++;
      while (p[j].at[d] > pivot)
        j--;
      if (i >= j)
        break;
      swap(&p[i], &p[j]);
    }
    *(middle <= j ? &high : &low) = middle <= j ? j : j + 1;
  }
}

static void build(const aspi_near *near, node *nodes, size_t k, point *p, size_t count) {
  node *own = &nodes[k];
  *own = (node){.least = {INFINITY, INFINITY, INFINITY}, .most = {-INFINITY, -INFINITY, -INFINITY}};
  int longest = 0;
  double most = 0;
  for (size_t i = 0; i < count; i++)
    own->rows += p[i].rows;
  for (int d = 0; d < PLACES; d++) {
    for (size_t i = 0; i < count; i++) {
      own->least[d] = fmin(own->least[d], isnan(p[i].at[d]) ? -INFINITY : p[i].at[d]);
      own->most[d] = fmax(own->most[d], isnan(p[i].at[d]) ? INFINITY : p[i].at[d]);
    }
    double length = (own->most[d] - own->least[d]) / (near->far[d] * (d ? own->most[d] : 1));
    longest = length > most ? d : longest;
    most = fmax(most, length);
  }
  if (count <= LEAF)
    return;
  select_middle(p, count, longest);
  build(near, nodes, 2 * k + 1, p, count / 2);
  build(near, nodes, 2 * k + 2, p + count / 2, count - count / 2);
}

static bool make(aspi_near *near, const aspi_scatter *impacts) {
  size_t nodes = 1;
  while (nodes * LEAF < impacts->count)
    nodes *= 2;
  near->count = impacts->count;
  near->points = malloc((near->count + 1) * sizeof *near->points);
  near->found = malloc((near->count + 1) * sizeof *near->found);
  near->nodes = malloc(2 * nodes * sizeof *near->nodes);
  if (!near->points || !near->found || !near->nodes)
    return false;
  for (size_t i = 0; i < near->count; i++) {
    const aspi_scatter_row *row = &impacts->rows[i];
    near->points[i] = (point){row, row->rows, {row->degrees, row->v1, row->d_p}, 0};
  }
  build(near, near->nodes, 0, near->points, near->count);
  return true;
}

aspi_near *aspi_near_create(const aspi_scatter *impacts, const aspi_compare_reach *far) {
  aspi_near *near = calloc(1, sizeof *near);
  if (!near)
    return NULL;
  const double reach[PLACES] = {far->degrees, far->speed, far->size};
  for (int d = 0; d < PLACES; d++)
    near->far[d] = fmax(reach[d], FAR_LEAST);
  if (make(near, impacts))
    return near;
  aspi_near_free(near);
  return NULL;
}

void aspi_near_free(aspi_near *near) {
  if (near) {
    free(near->points);
    free(near->found);
    free(near->nodes);
  }
  free(near);
}

/* Narrows `open`, bits of the coordinates in which a span may reach out of the box, to those in
 * which it does; -1: it is outside. */
static int cuts(const box *b, const double least[PLACES], const double most[PLACES], int open) {
  int cut = 0;
  for (int d = 0; d < PLACES; d++) {
    if (!(open >> d & 1))
      continue;
    double low = least[d] - b->center[d], high = most[d] - b->center[d], reach = b->reach[d];
    if (low > reach || -high > reach)
      return -1;
    cut |= (-low > reach || high > reach) << d;
  }
  return cut;
}

static double find(aspi_near *near, node *nodes, size_t k, point *p, size_t count, const box *b,
                   int open) {
  node *own = &nodes[k];
  open = cuts(b, own->least, own->most, open);
  if (open < 0)
    return 0;
  own->touched = true;
  if (open == 0) {
    near->found[near->n_found++] = &own->added;
    return own->rows;
  }
  if (count > LEAF)
    return find(near, nodes, 2 * k + 1, p, count / 2, b, open) +
           find(near, nodes, 2 * k + 2, p + count / 2, count - count / 2, b, open);
  double rows = 0;
  for (size_t i = 0; i < count; i++) { /* without branches, as half of these are outside */
    bool inside = true;
    for (int d = 0; d < PLACES; d++)
      inside &= !(fabs(p[i].at[d] - b->center[d]) > b->reach[d]);
    near->found[near->n_found] = &p[i].weight;
    near->n_found += inside;
    rows += inside * p[i].rows;
  }
  return rows;
}

double aspi_near_find(aspi_near *near, const aspi_scatter_row *at,
                      const aspi_compare_reach *reach) {
  const box b = {{at->degrees, at->v1, at->d_p},
                 {reach->degrees, reach->speed * at->v1, reach->size * at->d_p}};
  near->n_found = 0;
  return find(near, near->nodes, 0, near->points, near->count, &b, (1 << PLACES) - 1);
}

void aspi_near_weigh(aspi_near *near, double each) {
  for (size_t i = 0; i < near->n_found; i++)
    *near->found[i] += each;
}

static size_t take(node *nodes, size_t k, point *p, size_t count, double weight,
                   aspi_weighted *taken) {
  node *own = &nodes[k];
  if (!own->touched && !(weight > 0))
    return 0;
  weight += own->added;
  own->added = 0;
  own->touched = false;
  if (count > LEAF) {
    size_t n = take(nodes, 2 * k + 1, p, count / 2, weight, taken);
    return n + take(nodes, 2 * k + 2, p + count / 2, count - count / 2, weight, taken + n);
  }
  size_t n = 0;
  for (size_t i = 0; i < count; i++) {
    if (p[i].weight + weight > 0)
      taken[n++] = (aspi_weighted){p[i].row, p[i].weight + weight};
    p[i].weight = 0;
  }
  return n;
}

size_t aspi_near_take(aspi_near *near, aspi_weighted *taken) {
  return take(near->nodes, 0, near->points, near->count, 0, taken);
}
