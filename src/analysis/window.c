/* Statistics of a window that moves over points; see window.h. Moments come from a tree of the
 * moments of 2, 4, 8 ... points. They are only merged, never subtracted, so no digits are lost.
 * Order statistics come from counts in a Fenwick tree over the values.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/window.h"
#include "base/running.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

struct aspi_window {
  size_t count, leaves; /* leaves: the least power of two that is at least count */
  size_t first, end;    /* of the points within */
  double *angle;        /* of each point */
  size_t *rank;         /* of its value among all, from 1 */
  double *sorted;       /* values by rank, from 0 */
  size_t *inside;       /* Fenwick tree of the points within, by rank */
  aspi_running *tree;   /* node i holds 2i and 2i + 1; the points are the leaves */
};

typedef struct valued {
  double value;
  size_t point;
} valued;

static int by_value(const void *left, const void *right) {
  const valued *a = left, *b = right;
  if (a->value < b->value || a->value > b->value)
    return a->value < b->value ? -1 : 1;
  return (a->point > b->point) - (a->point < b->point);
}

static void rank(aspi_window *w, valued *values) {
  qsort(values, w->count, sizeof *values, by_value);
  for (size_t i = 0; i < w->count; i++) {
    w->sorted[i] = values[i].value;
    w->rank[values[i].point] = i + 1;
  }
}

static double at(const double *first, size_t stride, size_t i) {
  return *(const double *)(const void *)((const char *)first + i * stride);
}

static void grow_tree(aspi_window *w, const valued *values) {
  for (size_t i = 0; i < w->count; i++)
    w->tree[w->leaves + i] = (aspi_running){1, values[i].value, 0};
  for (size_t i = w->leaves - 1; i > 0; i--)
    w->tree[i] = aspi_running_merge(w->tree[2 * i], w->tree[2 * i + 1]);
}

aspi_window *aspi_window_create(const double *angles, const double *values, size_t stride,
                                size_t count) {
  aspi_window *w = calloc(1, sizeof *w);
  valued *all = calloc(count + 1, sizeof *all);
  if (!w || !all || !(w->angle = calloc(count + 1, sizeof *w->angle))) {
    free(all);
    aspi_window_free(w);
    return NULL;
  }
  for (size_t i = 0; i < count; i++)
    if (isfinite(at(values, stride, i))) {
      all[w->count] = (valued){at(values, stride, i), w->count};
      w->angle[w->count++] = at(angles, stride, i);
    }
  for (w->leaves = 1; w->leaves < w->count;)
    w->leaves *= 2;
  w->rank = calloc(w->count + 1, sizeof *w->rank);
  w->sorted = calloc(w->count + 1, sizeof *w->sorted);
  w->inside = calloc(w->leaves + 1, sizeof *w->inside); /* from 1 */
  w->tree = calloc(2 * w->leaves, sizeof *w->tree);
  bool fine = w->rank && w->sorted && w->inside && w->tree;
  if (fine) {
    grow_tree(w, all);
    rank(w, all);
  }
  free(all);
  if (fine)
    return w;
  aspi_window_free(w);
  return NULL;
}

void aspi_window_free(aspi_window *w) {
  if (!w)
    return;
  free(w->angle);
  free(w->rank);
  free(w->sorted);
  free(w->inside);
  free(w->tree);
  free(w);
}

/* Adds a point to the window; with step -1 (as an unsigned number) removes it. */
static void note(aspi_window *w, size_t point, size_t step) {
  for (size_t i = w->rank[point]; i <= w->leaves; i += i & -i)
    w->inside[i] += step;
}

void aspi_window_move(aspi_window *w, double from, double to) {
  for (; w->end < w->count && w->angle[w->end] <= to; w->end++)
    note(w, w->end, 1);
  for (; w->first < w->end && w->angle[w->first] < from; w->first++)
    note(w, w->first, (size_t)-1);
}

size_t aspi_window_count(const aspi_window *w) {
  return w->end - w->first;
}

void aspi_window_moments(const aspi_window *w, double *mean, double *sd) {
  aspi_running left = {0, 0, 0}, right = {0, 0, 0};
  for (size_t i = w->first + w->leaves, end = w->end + w->leaves; i < end; i /= 2, end /= 2) {
    if (i % 2)
      left = aspi_running_merge(left, w->tree[i++]);
    if (end % 2)
      right = aspi_running_merge(w->tree[--end], right);
  }
  aspi_running all = aspi_running_merge(left, right);
  *mean = all.mean;
  *sd = aspi_running_sd(&all);
}

/* The k-th smallest value in the window, from 0. */
static double ordered(const aspi_window *w, size_t k) {
  size_t at = 0;
  for (size_t step = w->leaves; step > 0; step /= 2)
    if (at + step <= w->leaves && w->inside[at + step] <= k) {
      at += step;
      k -= w->inside[at];
    }
  return w->sorted[at < w->count ? at : w->count - 1];
}

double aspi_window_quantile(const aspi_window *w, double share) {
  size_t count = aspi_window_count(w);
  double place = share * (double)(count - 1), below = floor(place), part = place - below;
  double value = ordered(w, (size_t)below);
  return part > 0 ? (1 - part) * value + part * ordered(w, (size_t)below + 1) : value;
}
