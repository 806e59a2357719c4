/* Samples whose values have weights; see sample.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/sample.h"
#include "asperity.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>

/* Fewer values than this have no 5 to 95 % band. */
enum { BAND_LEAST = 20 };

/* The p-value is exact up to EXACT_MOST pairs of values, Fisher's test up to SHARES_MOST values. */
#define EXACT_MOST 4e6
#define SHARES_MOST 100000

static int by_value(const void *left, const void *right) {
  const aspi_weighted *a = left, *b = right;
  return (a->value > b->value) - (a->value < b->value);
}

/* Straight between two values, each at the middle of its weight; of equal weights as
 * gsl_stats_quantile_from_sorted_data. */
static double quantile(const aspi_sample *s, double total, double share) {
  double ends = 0.5 * (s->values[0].weight + s->values[s->count - 1].weight);
  double place = share * (total - ends), at = 0;
  for (size_t i = 0; i + 1 < s->count; i++) {
    double step = 0.5 * (s->values[i].weight + s->values[i + 1].weight);
    if (place <= at + step) {
      double part = step > 0 ? (place - at) / step : 0;
      return s->values[i].value + part * (s->values[i + 1].value - s->values[i].value);
    }
    at += step;
  }
  return s->values[s->count - 1].value;
}

void aspi_sample_describe(aspi_sample *s) {
  s->mean = s->sd = s->median = s->low = s->high = NAN;
  s->size = 0;
  s->equal = true;
  if (s->count == 0)
    return;
  qsort(s->values, s->count, sizeof *s->values, by_value);
  double total = 0, squares = 0, spread = 0;
  s->mean = 0;
  for (size_t i = 0; i < s->count; i++) {
    double w = s->values[i].weight;
    total += w;
    squares += w * w;
    s->mean += (s->values[i].value - s->mean) * w / total;
    s->equal = s->equal && fabs(w - s->values[0].weight) <= 1e-12 * w;
  }
  for (size_t i = 0; i < s->count; i++)
    spread += s->values[i].weight * (s->values[i].value - s->mean) * (s->values[i].value - s->mean);
  s->size = s->equal ? (double)s->count : total * total / squares;
  if (s->count > 1)
    s->sd = sqrt(spread / (total - squares / total));
  s->median = quantile(s, total, 0.5);
  if (s->count < BAND_LEAST)
    return;
  s->low = quantile(s, total, 0.05);
  s->high = quantile(s, total, 0.95);
}

double aspi_sample_within(const aspi_sample *s, double low, double high) {
  double within = 0, total = 0;
  for (size_t i = 0; i < s->count; i++) {
    total += s->values[i].weight;
    within += s->values[i].value >= low && s->values[i].value <= high ? s->values[i].weight : 0;
  }
  return within / total;
}

static double total_of(const aspi_sample *s) {
  double total = 0;
  for (size_t i = 0; i < s->count; i++)
    total += s->values[i].weight;
  return total;
}

/* Equal values are passed together. */
double aspi_sample_distance(const aspi_sample *a, const aspi_sample *b) {
  double most = 0, at_a = 0, at_b = 0, all_a = total_of(a), all_b = total_of(b);
  for (size_t i = 0, k = 0; i < a->count && k < b->count;) {
    double x = fmin(a->values[i].value, b->values[k].value);
    for (; i < a->count && a->values[i].value <= x; i++)
      at_a += a->values[i].weight;
    for (; k < b->count && b->values[k].value <= x; k++)
      at_b += b->values[k].weight;
    if (i < a->count || k < b->count)
      most = fmax(most, fabs(at_a / all_a - at_b / all_b));
  }
  return most;
}

/* Kolmogorov's limit with Stephens' 1970 term for finite samples. */
static double p_of_limit(double distance, double n, double m) {
  double root = sqrt(n * m / (n + m)), x = (root + 0.12 + 0.11 / root) * distance, p = 0;
  if (x < 0.2)
    return 1; /* to ten digits; the sum would need many terms */
  for (int k = 1; k <= 100; k++) {
    double term = exp(-2.0 * k * k * x * x);
    p += k % 2 ? term : -term;
    if (term < 1e-17)
      break;
  }
  return fmin(1, fmax(0, 2 * p));
}

/* Under one law every order of the n + m values is as likely as any other: the share of the paths
 * from (0, 0) to (n, m) that stay closer than the distance to the diagonal, taken as the
 * probability u(i, j) to have come to (i, j) inside, which ends with a step along either axis in
 * proportion i to j. */
static double p_exact(double distance, size_t n, size_t m) {
  double *u = calloc(m + 1, sizeof *u), most = distance - 1e-9;
  if (!u)
    return NAN;
  for (size_t i = 0; i <= n; i++)
    for (size_t j = 0; j <= m; j++) {
      double off = fabs((double)i / (double)n - (double)j / (double)m), all = (double)(i + j);
      double from = i + j == 0 ? 1 : 0;
      if (i > 0)
        from += u[j] * (double)i / all;
      if (j > 0)
        from += u[j - 1] * (double)j / all;
      u[j] = off < most ? from : 0;
    }
  double p = 1 - u[m];
  free(u);
  return fmin(1, fmax(0, p));
}

double aspi_sample_p_value(const aspi_sample *a, const aspi_sample *b, double distance) {
  bool exact = a->equal && b->equal && (double)a->count * (double)b->count <= EXACT_MOST;
  if (!(distance > 0))
    return 1;
  return exact ? p_exact(distance, a->count, b->count) : p_of_limit(distance, a->size, b->size);
}

double aspi_shares_p_value(size_t k1, size_t n1, size_t k2, size_t n2) {
  if (n1 > SHARES_MOST || n2 > SHARES_MOST) {
    double share = (double)(k1 + k2) / (double)(n1 + n2);
    double sd = sqrt(share * (1 - share) * (1 / (double)n1 + 1 / (double)n2));
    double off = fabs((double)k1 / (double)n1 - (double)k2 / (double)n2);
    return sd > 0 ? 2 * gsl_cdf_ugaussian_Q(off / sd) : 1;
  }
  unsigned all = (unsigned)(k1 + k2), others = (unsigned)(n1 + n2) - all, draws = (unsigned)n1;
  unsigned first = draws > others ? draws - others : 0, last = draws < all ? draws : all;
  double as_seen = gsl_ran_hypergeometric_pdf((unsigned)k1, all, others, draws), p = 0;
  for (unsigned k = first; k <= last; k++) {
    double each = gsl_ran_hypergeometric_pdf(k, all, others, draws);
    p += each <= as_seen * (1 - 1e-7) ? each : each <= as_seen * (1 + 1e-7) ? 0.5 * each : 0;
  }
  return p;
}

double aspi_combine_independent(const double *p, size_t count) {
  double sum = 0;
  for (size_t i = 0; i < count; i++)
    sum -= 2 * log(fmax(p[i], 1e-300));
  return count ? gsl_cdf_chisq_Q(sum, 2 * (double)count) : NAN;
}

double aspi_combine_dependent(const double *p, size_t count) {
  double sum = 0;
  for (size_t i = 0; i < count; i++)
    sum += tan((0.5 - fmin(fmax(p[i], 1e-15), 1 - 1e-3)) * ASP_PI) / (double)count;
  return count ? 0.5 - atan(sum) / ASP_PI : NAN;
}
