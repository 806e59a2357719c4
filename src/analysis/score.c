/* One score of a model against measurements; see score.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/score.h"

#include <math.h>

const aspi_sample aspi_sample_none = {
    .size = NAN, .mean = NAN, .sd = NAN, .mean_se = NAN, .sd_se = NAN};

static aspi_sample describe(const aspi_side *side, int k) {
  aspi_sample s = aspi_sample_none;
  double total = 0, squares = 0, mean = 0, second = 0, fourth = 0, sums[4];
  for (size_t i = 0; i < side->count; i++) {
    const aspi_scatter_row *row = side->impacts[i].row;
    double each = side->impacts[i].weight, weight = each * row->rows;
    if (k < ASPI_COMPARED && isnan(row->cor[k]))
      continue;
    double value = k < ASPI_COMPARED ? row->cor[k] + row->power[k][0] / row->rows : row->deposit;
    s.count += (size_t)row->rows;
    total += weight;
    squares += each * weight;
    mean += (value - mean) * (weight / total); /* exact for equal ones */
  }
  for (size_t i = 0; i < side->count; i++) {
    const aspi_scatter_row *row = side->impacts[i].row;
    if (k < ASPI_COMPARED && isnan(row->cor[k]))
      continue;
    aspi_scatter_about(row, k, mean, sums);
    second += side->impacts[i].weight * sums[1];
    fourth += side->impacts[i].weight * sums[3];
  }
  if (s.count > 0) {
    s.mean = mean;
    s.size = total * total / squares;
  }
  if (s.count > 1) {
    s.sd = sqrt(second / (total - squares / total));
    s.mean_se = s.sd / sqrt(s.size);
    second /= total;
    s.sd_se = second > 0 ? sqrt(fmax(0, fourth / total / second - second) / s.size) / 2 : 0;
  }
  return s;
}

void aspi_side_describe(aspi_side *side) {
  double product = 0, square[COR_BOTH] = {0, 0};
  for (int k = 0; k < ASPI_QUANTITIES; k++)
    side->of[k] = describe(side, k);
  for (size_t i = 0; i < side->count; i++) {
    const aspi_scatter_row *row = side->impacts[i].row;
    double weight = side->impacts[i].weight, sums[COR_BOTH][4];
    for (int k = 0; k < COR_BOTH; k++)
      aspi_scatter_about(row, k, side->of[k].mean, sums[k]);
    double n = row->cor[COR_N] - side->of[COR_N].mean, t = row->cor[COR_T] - side->of[COR_T].mean;
    if (isnan(n + t))
      continue;
    product += weight * (row->product + n * sums[COR_T][0] + t * row->power[COR_N][0]);
    square[COR_N] += weight * sums[COR_N][1];
    square[COR_T] += weight * sums[COR_T][1];
  }
  double both = sqrt(square[COR_N] * square[COR_T]);
  side->correlation = both > 0 ? product / both : 0;
}

/* The standard error of the difference of two sd. The kurtosis is pooled over both samples because
 * small samples estimate it poorly. */
static double sd_error_of(const aspi_sample *m, const aspi_sample *d) {
  const aspi_sample *both[] = {m, d};
  double n = 0, sum = 0;
  for (int i = 0; i < 2; i++)
    if (both[i]->sd > 0) {
      double relative = both[i]->sd_se / both[i]->sd;
      n += both[i]->size;
      sum += both[i]->size * both[i]->size * relative * relative;
    }
  return sqrt(sum / n * (m->sd * m->sd / m->size + d->sd * d->sd / d->size));
}

/* Equal shares of deposits have the error of both together (Pearson's chi-square). */
static double share_error_of(const aspi_sample *m, const aspi_sample *d) {
  double share = (m->mean * m->size + d->mean * d->size) / (m->size + d->size);
  return sqrt(share * (1 - share) * (1 / m->size + 1 / d->size));
}

/* Adds a difference; returns it, or 0 for one that has no known error. */
static double add_difference(aspi_score *score, double difference, double error) {
  double z = difference / error;
  if (!isfinite(z))
    return 0;
  score->terms++;
  score->scatter++;
  score->square += z * z;
  score->shift += z * z;
  return z;
}

/* Adds the covariance of two differences with that correlation. */
static void add_pair(aspi_score *score, const double z[], double correlation) {
  if (fabs(z[COR_N]) > 0 && fabs(z[COR_T]) > 0) {
    score->scatter += 2 * correlation * correlation;
    score->shift += 2 * correlation * z[COR_N] * z[COR_T];
  }
}

void aspi_score_add(aspi_score *score, const aspi_side *model, const aspi_side *data) {
  double means[ASPI_COMPARED] = {0}, sds[ASPI_COMPARED] = {0}, correlation = model->correlation;
  for (int k = 0; k < ASPI_COMPARED; k++) {
    const aspi_sample *m = &model->of[k], *d = &data->of[k];
    if (data->impacts && !(d->size >= ASPI_SCORED_LEAST))
      continue;
    means[k] = add_difference(score, m->mean - d->mean,
                              hypot(d->mean_se, isfinite(m->mean_se) ? m->mean_se : 0));
    if (data->impacts)
      sds[k] = add_difference(score, m->sd - d->sd, sd_error_of(m, d));
  }
  if (data->impacts) {
    const aspi_sample *m = &model->of[ASPI_DEPOSITS], *d = &data->of[ASPI_DEPOSITS];
    add_difference(score, m->mean - d->mean, share_error_of(m, d));
    add_pair(score, means, correlation);
    add_pair(score, sds, correlation * correlation);
  }
}

aspi_mean_error aspi_score_end(const aspi_score *score) {
  double n = score->terms, value = score->square / n;
  double excess = value > 1 ? (value - 1) / value : 0;
  return (aspi_mean_error){value, sqrt(2 * score->scatter + 4 * excess * score->shift) / n};
}
