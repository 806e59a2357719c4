/* Statistics of a window that moves over points; see window.h. Moments come from a tree of the
 * moments of 2, 4, 8 ... points, which are merged, so that nothing is taken away from a sum again;
 * order statistics from counts in a Fenwick tree over the values.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/window.h"
#include "base/running.h"
#include "cli/cli.h"

#include <math.h>
#include <stdlib.h>

struct cli_window {
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

static void rank(cli_window *w, valued *values) {
  qsort(values, w->count, sizeof *values, by_value);
  for (size_t i = 0; i < w->count; i++) {
    w->sorted[i] = values[i].value;
    w->rank[values[i].point] = i + 1;
  }
}

cli_window *cli_window_create(const scatter_point *points, size_t count, int which) {
  cli_window *w = cli_allocate(1, sizeof *w);
  valued *values = cli_allocate(count, sizeof *values);
  w->angle = cli_allocate(count, sizeof *w->angle);
  for (size_t i = 0; i < count; i++)
    if (isfinite(points[i].cor[which])) {
      values[w->count] = (valued){points[i].cor[which], w->count};
      w->angle[w->count++] = points[i].degrees;
    }
  for (w->leaves = 1; w->leaves < w->count;)
    w->leaves *= 2;
  w->rank = cli_allocate(w->count, sizeof *w->rank);
  w->sorted = cli_allocate(w->count, sizeof *w->sorted);
  w->inside = cli_allocate(w->leaves + 1, sizeof *w->inside); /* from 1 */
  w->tree = cli_allocate(2 * w->leaves, sizeof *w->tree);
  for (size_t i = 0; i < w->count; i++)
    w->tree[w->leaves + i] = (aspi_running){1, values[i].value, 0};
  for (size_t i = w->leaves - 1; i > 0; i--)
    w->tree[i] = aspi_running_merge(w->tree[2 * i], w->tree[2 * i + 1]);
  rank(w, values);
  free(values);
  return w;
}

void cli_window_free(cli_window *w) {
  free(w->angle);
  free(w->rank);
  free(w->sorted);
  free(w->inside);
  free(w->tree);
  free(w);
}

/* Counts a point in or, with step -1 as an unsigned number, out. */
static void note(cli_window *w, size_t point, size_t step) {
  for (size_t i = w->rank[point]; i <= w->leaves; i += i & -i)
    w->inside[i] += step;
}

void cli_window_move(cli_window *w, double from, double to) {
  for (; w->end < w->count && w->angle[w->end] <= to; w->end++)
    note(w, w->end, 1);
  for (; w->first < w->end && w->angle[w->first] < from; w->first++)
    note(w, w->first, (size_t)-1);
}

size_t cli_window_count(const cli_window *w) {
  return w->end - w->first;
}

void cli_window_moments(const cli_window *w, double *mean, double *sd) {
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

/* The value of the point number k within, from 0, in order of values. */
static double ordered(const cli_window *w, size_t k) {
  size_t at = 0;
  for (size_t step = w->leaves; step > 0; step /= 2)
    if (at + step <= w->leaves && w->inside[at + step] <= k) {
      at += step;
      k -= w->inside[at];
    }
  return w->sorted[at < w->count ? at : w->count - 1];
}

double cli_window_quantile(const cli_window *w, double share) {
  size_t count = cli_window_count(w);
  double place = share * (double)(count - 1), below = floor(place), part = place - below;
  double value = ordered(w, (size_t)below);
  return part > 0 ? (1 - part) * value + part * ordered(w, (size_t)below + 1) : value;
}
