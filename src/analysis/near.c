/* Impacts near a place; see near.h. The tree halves the rows, which are permuted, along the
 * coordinate that reaches farthest. Rows without speed or size are in trees of their own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/near.h"

#include <stdlib.h>

/* Rows of a leaf. Angle, speed, size. A tree for each of: both known, speed, size, none. */
enum { LEAF = 16, PLACES = 3, TREES = 4 };

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
  double rows, at[PLACES], weight; /* 0 where it is not known */
} point;

struct aspi_near {
  double far[PLACES];
  point *points; /* tree after tree */
  size_t first[TREES + 1];
  node *nodes[TREES]; /* the children of node k are 2 k + 1 and 2 k + 2 */
  double **found;     /* weights of what was found last, rows and nodes */
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
      own->least[d] = fmin(own->least[d], p[i].at[d]);
      own->most[d] = fmax(own->most[d], p[i].at[d]);
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

/* Which tree a row is in. */
static int tree_of(const aspi_scatter_row *row) {
  return isnan(row->v1) + 2 * isnan(row->d_p);
}

static bool make(aspi_near *near, const aspi_scatter *impacts) {
  size_t n = 0;
  near->points = malloc((impacts->count + 1) * sizeof *near->points);
  near->found = malloc((impacts->count + 1) * sizeof *near->found);
  for (int t = 0; t < TREES && near->points; t++) {
    for (size_t i = 0; i < impacts->count; i++) {
      const aspi_scatter_row *row = &impacts->rows[i];
      if (tree_of(row) == t)
        near->points[n++] =
            (point){row,
                    row->rows,
                    {row->degrees, isnan(row->v1) ? 0 : row->v1, isnan(row->d_p) ? 0 : row->d_p},
                    0};
    }
    near->first[t + 1] = n;
    size_t count = n - near->first[t], nodes = 1;
    while (nodes * LEAF < count)
      nodes *= 2;
    near->nodes[t] = count ? malloc(2 * nodes * sizeof **near->nodes) : NULL;
    if (count && !near->nodes[t])
      return false;
    if (count)
      build(near, near->nodes[t], 0, near->points + near->first[t], count);
  }
  return near->points && near->found;
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
  for (int t = 0; t < TREES && near; t++)
    free(near->nodes[t]);
  if (near) {
    free(near->points);
    free(near->found);
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
      inside &= !(open >> d & 1) | (fabs(p[i].at[d] - b->center[d]) <= b->reach[d]);
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
  double rows = 0;
  near->n_found = 0;
  for (int t = 0; t < TREES; t++) {
    const int known = 1 | !(t % 2 || isnan(at->v1)) << 1 | !(t / 2 || isnan(at->d_p)) << 2;
    size_t count = near->first[t + 1] - near->first[t];
    if (count)
      rows += find(near, near->nodes[t], 0, near->points + near->first[t], count, &b, known);
  }
  return rows;
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
  size_t n = 0;
  for (int t = 0; t < TREES; t++)
    if (near->nodes[t])
      n += take(near->nodes[t], 0, near->points + near->first[t],
                near->first[t + 1] - near->first[t], 0, taken + n);
  return n;
}
