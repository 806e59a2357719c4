/* Sensitivity of a run's results to the roughness of its wall; see sensitivity.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/sensitivity.h"

#include <math.h>
#include <stdlib.h>

static int order(double a, double b, double then_a, double then_b) {
  return a < b || a > b ? (a > b) - (a < b) : (then_a > then_b) - (then_a < then_b);
}

static int by_row(const void *left, const void *right) {
  const aspi_drawn *a = left, *b = right;
  return order(a->tag, b->tag, a->row, b->row);
}

static int by_place(const void *left, const void *right) {
  const aspi_drawn *a = left, *b = right;
  return order(a->place, b->place, (double)a->grain, (double)b->grain);
}

void aspi_drawn_place(aspi_drawn *drawn, size_t n) {
  qsort(drawn, n, sizeof *drawn, by_place);
}

size_t aspi_drawn_order(aspi_drawn *drawn, size_t n, double *effective) {
  double sum = 0, squares = 0;
  size_t grains = 0;
  qsort(drawn, n, sizeof *drawn, by_row);
  for (size_t i = 0; i < n; i++) {
    aspi_drawn *d = &drawn[i];
    bool again = i > 0 && !(d[-1].tag < d->tag);
    for (int k = ASPI_DERIVATIVE; k < ASPI_OTHER; k++)
      d->prior[k] = again ? d[-1].prior[k] + d[-1].self[k] : 0;
    d->prior[ASPI_OTHER] = again ? d[-1].prior[ASPI_OTHER] * d[-1].self[ASPI_OTHER] : 1;
    d->grain = grains;
    if (i + 1 < n && !(d->tag < d[1].tag))
      continue;
    double weight = d->prior[ASPI_OTHER] * d->self[ASPI_OTHER];
    sum += weight;
    squares += weight * weight;
    grains++;
  }
  *effective = squares > 0 ? sum * sum / squares : 0;
  return grains;
}

/* Means over the impacts at a place that have the result: of the result, of the scores, and of the
 * weighted result. */
typedef struct average {
  double of[ASPI_PARTS], count, weights;
} average;

static double drawn_so_far(const aspi_drawn *d, int part) {
  return part == ASPI_OTHER ? d->prior[part] * d->self[part] : d->prior[part] + d->self[part];
}

static average average_of(const aspi_drawn *drawn, size_t n, int result) {
  average a = {.count = 0};
  for (size_t i = 0; i < n; i++) {
    double x = drawn[i].result[result], weight = drawn_so_far(&drawn[i], ASPI_OTHER);
    if (isnan(x))
      continue;
    a.count++;
    a.weights += weight;
    a.of[ASPI_RUN] += x;
    a.of[ASPI_OTHER] += weight * x;
    for (int k = ASPI_DERIVATIVE; k < ASPI_OTHER; k++)
      a.of[k] += drawn_so_far(&drawn[i], k);
  }
  for (int k = 0; k < ASPI_PARTS; k++)
    a.of[k] /= k == ASPI_OTHER ? a.weights : a.count;
  return a;
}

/* Adds an impact to a sum. Control variate: subtract (leave-one-out mean) x (own score), whose mean
 * is 0. */
static void add_to_sum(const aspi_drawn *d, double x, const average *a, double sum[ASPI_PARTS]) {
  double off = a->count > 1 ? (x - a->of[ASPI_RUN]) * a->count / (a->count - 1) : x;
  sum[ASPI_RUN] += x;
  sum[ASPI_OTHER] += d->prior[ASPI_OTHER] * (x + off * (d->self[ASPI_OTHER] - 1));
  for (int k = ASPI_DERIVATIVE; k < ASPI_OTHER; k++)
    sum[k] += x * d->prior[k] + off * d->self[k];
}

/* Adds an impact's deviation from the means. */
static void add_to_mean(const aspi_drawn *d, double x, const average *a, double sum[ASPI_PARTS]) {
  double off = x - a->of[ASPI_RUN];
  sum[ASPI_RUN] += off;
  sum[ASPI_OTHER] += drawn_so_far(d, ASPI_OTHER) * (x - a->of[ASPI_OTHER]);
  for (int k = ASPI_DERIVATIVE; k < ASPI_OTHER; k++)
    sum[k] += off * (drawn_so_far(d, k) - a->of[k]);
}

void aspi_sensitivity(const aspi_drawn *drawn, size_t n, int result, size_t grains,
                      aspi_derivative found[ASPI_PARTS]) {
  const bool is_mean = result >= ASPI_COR;
  const average a = average_of(drawn, n, result);
  double total[ASPI_PARTS] = {0}, squares[ASPI_PARTS] = {0};
  for (size_t i = 0; i < n;) {
    double own[ASPI_PARTS] = {0};
    for (size_t grain = drawn[i].grain; i < n && drawn[i].grain == grain; i++)
      if (!isnan(drawn[i].result[result]))
        (is_mean ? add_to_mean : add_to_sum)(&drawn[i], drawn[i].result[result], &a, own);
    for (int k = 0; k < ASPI_PARTS; k++) {
      total[k] += own[k];
      squares[k] += own[k] * own[k];
    }
  }
  for (int k = 0; k < ASPI_PARTS; k++) {
    bool is_ratio = is_mean && (k == ASPI_RUN || k == ASPI_OTHER);
    double over = !is_mean ? 1 : k == ASPI_OTHER ? a.weights : a.count;
    double spread = squares[k] - total[k] * total[k] / (is_mean ? a.count : (double)grains);
    found[k].value = is_ratio ? a.of[k] : total[k] / over;
    found[k].se = sqrt(fmax(0, spread)) / over;
  }
}
