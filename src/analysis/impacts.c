/* Impacts merged as sums; see impacts.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/impacts.h"
#include "base/search.h"

#include <stdlib.h>
#include <string.h>

/* Rows before they are merged, at least. */
enum { ROOM_LEAST = 1 << 14 };

size_t aspi_merge_equal(void *items, size_t count, size_t size,
                        int (*compare)(const void *, const void *),
                        void (*add)(void *to, const void *more)) {
  char *first = items, *last = items;
  if (count == 0)
    return 0;
  qsort(items, count, size, compare);
  for (char *item = first + size; item < first + count * size; item += size)
    if (compare(last, item) == 0)
      add(last, item);
    else if ((last += size) != item)
      memcpy(last, item, size);
  return (size_t)(last - first) / size + 1;
}

static bool is_below(const void *border, size_t i, double value) {
  return ((const double *)border)[i] < value;
}

/* Twice the number of borders below a value, plus 1 if it is on a border; -1: no value. */
static double place_among(const double *border, size_t count, double value) {
  size_t low = aspi_count_below(border, count, value, is_below);
  return isnan(value) ? -1 : 2 * (double)low + (low < count && border[low] <= value);
}

void aspi_scatter_key(const aspi_scatter *s, aspi_scatter_row *row) {
  const double place[] = {row->degrees, row->v1, row->d_p};
  for (int d = 0; d < 3; d++)
    if (s->by_interval)
      row->key[d] = d == 0 ? aspi_scatter_interval(row, s->grouping->width) : 0;
    else if (s->grouping->border[d])
      row->key[d] = place_among(s->grouping->border[d], s->grouping->count[d], place[d]);
    else
      row->key[d] = isnan(place[d]) ? -1 : place[d];
}

/* Bits: coefficients present, and deposit. */
static int kind_of(const aspi_scatter_row *row) {
  return isnan(row->cor[COR_N]) + 2 * isnan(row->cor[COR_T]) + 4 * isnan(row->cor[REBOUND_ANGLE]) +
         8 * row->deposit;
}

static int by_key(const void *left, const void *right) {
  const aspi_scatter_row *a = left, *b = right;
  for (int d = 0; d < 3; d++)
    if (a->key[d] < b->key[d] || a->key[d] > b->key[d])
      return a->key[d] < b->key[d] ? -1 : 1;
  return kind_of(a) - kind_of(b);
}

void aspi_scatter_about(const aspi_scatter_row *row, int k, double center, double sums[4]) {
  static const double none[4];
  const double *s = k < ASPI_COMPARED ? row->power[k] : none, n = row->rows;
  double d = (k < ASPI_COMPARED ? row->cor[k] : row->deposit) - center, d2 = d * d;
  sums[0] = s[0] + n * d;
  sums[1] = s[1] + 2 * d * s[0] + n * d2;
  sums[2] = s[2] + 3 * d * s[1] + 3 * d2 * s[0] + n * d2 * d;
  sums[3] = s[3] + 4 * d * s[2] + 6 * d2 * s[1] + 4 * d2 * d * s[0] + n * (d2 * d2);
}

static void add(void *of, const void *with) {
  aspi_scatter_row *to = of;
  const aspi_scatter_row *more = with;
  double share = more->rows / (to->rows + more->rows), sums[ASPI_COMPARED][4];
  to->degrees += share * (more->degrees - to->degrees);
  to->v1 += share * (more->v1 - to->v1);
  to->d_p += share * (more->d_p - to->d_p);
  to->least = fmin(to->least, more->least);
  to->most = fmax(to->most, more->most);
  for (int k = 0; k < ASPI_COMPARED; k++) {
    aspi_scatter_about(more, k, to->cor[k], sums[k]);
    for (int p = 0; p < 4; p++)
      to->power[k][p] += sums[k][p];
  }
  double n = more->cor[COR_N] - to->cor[COR_N], t = more->cor[COR_T] - to->cor[COR_T];
  to->product += more->product + n * more->power[COR_T][0] + t * sums[COR_N][0];
  to->rows += more->rows;
}

bool aspi_scatter_merge(aspi_scatter_row *to, const aspi_scatter_row *more) {
  bool same = by_key(to, more) == 0;
  if (same)
    add(to, more);
  return same;
}

void aspi_scatter_gather(aspi_scatter *s) {
  s->count = aspi_merge_equal(s->rows, s->count, sizeof *s->rows, by_key, add);
  if (s->grouping->width > 0 && !s->by_interval && s->count > s->grouping->places) {
    s->by_interval = true;
    for (size_t i = 0; i < s->count; i++)
      aspi_scatter_key(s, &s->rows[i]);
    s->count = aspi_merge_equal(s->rows, s->count, sizeof *s->rows, by_key, add);
  }
  s->merge_at = 2 * s->count > ROOM_LEAST ? 2 * s->count : ROOM_LEAST;
}

/* A step between angles that separates two clusters. */
static bool is_gap(const aspi_scatter_row *row, double width) {
  return row->degrees - row[-1].degrees > 0.5 * width;
}

bool aspi_scatter_is_clustered(const aspi_scatter *s, double width) {
  for (size_t i = 0, first = 0; i < s->count; i++) {
    if (i > 0 && is_gap(&s->rows[i], width))
      first = i;
    if (s->rows[i].degrees - s->rows[first].degrees > width)
      return false;
  }
  return !s->by_interval;
}

bool aspi_scatter_joins(const aspi_scatter *s, size_t i, double width, bool clusters) {
  const aspi_scatter_row *row = &s->rows[i];
  return clusters ? !is_gap(row, width)
                  : aspi_scatter_interval(row, width) <= aspi_scatter_interval(row - 1, width);
}
