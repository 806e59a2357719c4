/* Samples of a quantity of impacts; see sample.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/sample.h"

#include <math.h>
#include <stdlib.h>

/* Fewer values than this have no 5 to 95 % band. */
enum { BAND_LEAST = 20 };

const aspi_sample aspi_sample_none = {.size = NAN,
                                      .mean = NAN,
                                      .sd = NAN,
                                      .median = NAN,
                                      .low = NAN,
                                      .high = NAN,
                                      .mean_se = NAN,
                                      .sd_se = NAN};

/* Values in order, and last those that are none. */
static int order(double a, double b) {
  return isnan(a) || isnan(b) ? isnan(a) - isnan(b) : (a > b) - (a < b);
}

static int by_cor_n(const void *a, const void *b) {
  return order(((const aspi_impact *)a)->of[COR_N], ((const aspi_impact *)b)->of[COR_N]);
}

static int by_cor_t(const void *a, const void *b) {
  return order(((const aspi_impact *)a)->of[COR_T], ((const aspi_impact *)b)->of[COR_T]);
}

static int by_deposit(const void *a, const void *b) {
  return order(((const aspi_impact *)a)->of[ASPI_DEPOSITS],
               ((const aspi_impact *)b)->of[ASPI_DEPOSITS]);
}

/* Straight between two values, each at the middle of its weight; of equal weights as
 * gsl_stats_quantile_from_sorted_data. */
static double quantile(const aspi_impact *x, size_t count, int k, double total, double share) {
  double ends = 0.5 * (x[0].weight + x[count - 1].weight);
  double place = share * (total - ends), at = 0;
  for (size_t i = 0; i + 1 < count; i++) {
    double step = 0.5 * (x[i].weight + x[i + 1].weight);
    if (place <= at + step) {
      double part = step > 0 ? (place - at) / step : 0;
      return x[i].of[k] + part * (x[i + 1].of[k] - x[i].of[k]);
    }
    at += step;
  }
  return x[count - 1].of[k];
}

void aspi_sample_describe(aspi_side *side, int k) {
  static int (*const orders[])(const void *, const void *) = {by_cor_n, by_cor_t, by_deposit};
  aspi_impact *x = side->impacts;
  qsort(x, side->count, sizeof *x, orders[k]);
  aspi_sample s = aspi_sample_none;
  double total = 0, squares = 0, mean = 0, second = 0, fourth = 0;
  for (; s.count < side->count && !isnan(x[s.count].of[k]); s.count++) {
    double w = x[s.count].weight;
    total += w;
    squares += w * w;
    mean += (x[s.count].of[k] - mean) * w / total;
  }
  for (size_t i = 0; i < s.count; i++) {
    double u = (x[i].of[k] - mean) * (x[i].of[k] - mean);
    second += x[i].weight * u;
    fourth += x[i].weight * u * u;
  }
  if (s.count > 0) {
    s.mean = mean;
    s.size = total * total / squares;
    s.median = quantile(x, s.count, k, total, 0.5);
  }
  if (s.count > 1) {
    s.sd = sqrt(second / (total - squares / total));
    s.mean_se = s.sd / sqrt(s.size);
    second /= total;
    s.sd_se = second > 0 ? sqrt(fmax(0, fourth / total / second - second) / s.size) / 2 : 0;
  }
  if (s.count >= BAND_LEAST) {
    s.low = quantile(x, s.count, k, total, 0.05);
    s.high = quantile(x, s.count, k, total, 0.95);
  }
  side->of[k] = s;
}

static double total_of(const aspi_side *side, int k) {
  double total = 0;
  for (size_t i = 0; i < side->of[k].count; i++)
    total += side->impacts[i].weight;
  return total;
}

/* Equal values are passed together. */
double aspi_sample_distance(const aspi_side *a, const aspi_side *b, int k) {
  double most = 0, at_a = 0, at_b = 0, all_a = total_of(a, k), all_b = total_of(b, k);
  size_t end_a = a->of[k].count, end_b = b->of[k].count;
  for (size_t i = 0, j = 0; i < end_a && j < end_b;) {
    double x = fmin(a->impacts[i].of[k], b->impacts[j].of[k]);
    for (; i < end_a && a->impacts[i].of[k] <= x; i++)
      at_a += a->impacts[i].weight;
    for (; j < end_b && b->impacts[j].of[k] <= x; j++)
      at_b += b->impacts[j].weight;
    if (i < end_a || j < end_b)
      most = fmax(most, fabs(at_a / all_a - at_b / all_b));
  }
  return most;
}
