/* Moments and their weights; see weights.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/weights.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>

/* Share of each variance that is added to it. If wall and law leave one freedom, moments are nearly
 * functions of each other; the ridge keeps any combination of them from counting for more than a
 * simulation resolves. */
#define RIDGE 1e-2

/* The least variance, so that a moment that does not vary can be weighed. */
#define FLOOR 1e-14

/* The covariance of a group is that of its own impacts in the share n/(n + FEW), halved. */
#define FEW 20.0

/* ---- moments ---- */

aspi_cloud_frame aspi_cloud_frame_at(double x, double y) {
  return (aspi_cloud_frame){{x, y}, {-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
}

void aspi_cloud_frame_cut(aspi_cloud_frame *frame, const aspi_cloud *cloud, double widths,
                          double *room) {
  size_t n = cloud->rebounds;
  for (int k = 0; k < 2; k++) {
    frame->low[k] = -INFINITY;
    frame->high[k] = INFINITY;
    if (n == 0 || !isfinite(widths))
      continue;
    for (size_t i = 0; i < n; i++)
      room[i] = cloud->xy[i][k];
    double median = gsl_stats_median(room, 1, n), width = gsl_stats_mad(room, 1, n, room + n);
    if (!(width > 0))
      continue;
    frame->low[k] = median - widths * width;
    frame->high[k] = median + widths * width;
  }
}

aspi_cloud_moments aspi_cloud_moments_of(const aspi_cloud *cloud, const aspi_cloud_frame *frame) {
  aspi_cloud_moments m = {.rebounds = (double)cloud->rebounds,
                          .all = (double)(cloud->rebounds + cloud->deposits)};
  double product[MOMENT_STUCK][MOMENT_STUCK] = {{0}};
  for (size_t i = 0; i < cloud->rebounds; i++) {
    double u[2];
    for (int k = 0; k < 2; k++)
      u[k] = fmin(fmax(cloud->xy[i][k], frame->low[k]), frame->high[k]) - frame->center[k];
    double term[MOMENT_STUCK] = {u[0], u[1], u[0] * u[0], u[1] * u[1], u[0] * u[1]};
    for (int k = 0; k < MOMENT_STUCK; k++) {
      m.of[k] += term[k];
      for (int l = 0; l <= k; l++)
        product[k][l] += term[k] * term[l];
    }
  }
  double freedom = m.rebounds > 1 ? m.rebounds - 1 : 1;
  for (int k = 0; k < MOMENT_STUCK; k++) {
    m.of[k] /= m.rebounds;
    for (int l = 0; l <= k; l++)
      m.covariance[k][l] = m.covariance[l][k] =
          m.rebounds > 1 ? (product[k][l] - m.rebounds * m.of[k] * m.of[l]) / freedom : 0;
  }
  m.of[MOMENT_STUCK] = (double)cloud->deposits / m.all;
  return m;
}

aspi_cloud_moments aspi_group_moments(const aspi_group *g, const aspi_cloud_frame *frame) {
  if (g->impacts.xy)
    return aspi_cloud_moments_of(&g->impacts, frame);
  aspi_cloud_moments m = {.rebounds = g->n, .all = g->n};
  for (int k = 0; k < 2; k++) {
    double off = g->mean[k] - frame->center[k], square = g->sd[k] * g->sd[k];
    double known = g->n > 1 ? (g->n - 1) / g->n : 1;
    m.of[MOMENT_X + k] = off;
    m.of[MOMENT_XX + k] = known * square + off * off;
    m.covariance[MOMENT_X + k][MOMENT_X + k] = g->se[k] >= 0 ? g->se[k] * g->se[k] * g->n : square;
    m.covariance[MOMENT_XX + k][MOMENT_XX + k] = 2 * square * square + 4 * square * off * off;
  }
  return m;
}

/* ---- weights ---- */

/* The share of deposits is at least that of half a deposit (Wilson 1927), by data and model. */
static double variance_of_share(double data, double model, double n, aspi_weights_kind kind) {
  double both = kind == WEIGHTS_MODEL ? model : kind == WEIGHTS_DATA ? data : (data + model) / 2;
  double share = (n * both + 0.5) / (n + 1);
  return share * (1 - share);
}

/* Lower Cholesky factor of a covariance, in place; a direction without a variance of its own gets
 * the floor. */
static double factor(double (*a)[MOMENTS], int n, const double *floor) {
  double log_determinant = 0;
  for (int k = 0; k < n; k++)
    for (int l = 0; l <= k; l++) {
      double sum = a[k][l];
      for (int i = 0; i < l; i++)
        sum -= a[k][i] * a[l][i];
      if (l < k) {
        a[k][l] = sum / a[l][l];
        continue;
      }
      a[k][k] = sqrt(fmax(sum, floor[k]));
      log_determinant += 2 * log(a[k][k]);
    }
  return log_determinant;
}

/* A corner of n x n of a matrix of moments. */
static gsl_matrix_view corner(double (*a)[MOMENTS], int n) {
  return gsl_matrix_view_array_with_tda(a[0], (size_t)n, (size_t)n, MOMENTS);
}

void aspi_weights_set(aspi_weights *w, const aspi_group *g, const aspi_cloud_moments *model,
                      double (*pooled)[MOMENTS], aspi_weights_kind kind) {
  const aspi_cloud_moments *data = &w->data;
  double own = data->rebounds / (data->rebounds + FEW), floor[MOMENTS];
  double share = kind == WEIGHTS_DATA || g->by_data ? 1 : kind == WEIGHTS_BOTH ? own / 2 : 0;
  double(*exact)[MOMENTS] = w->whitened;
  w->n = 0;
  for (int k = 0; k < MOMENTS; k++)
    if (g->used[k])
      w->of[w->n++] = k;
  for (int i = 0; i < w->n; i++)
    for (int j = 0; j < w->n; j++) {
      int k = w->of[i], l = w->of[j];
      exact[i][j] = 0;
      if (k == MOMENT_STUCK && l == MOMENT_STUCK)
        exact[i][j] = variance_of_share(data->of[k], model->of[k], data->all, kind) *
                      (1 / data->all + 1 / model->all);
      if (k == MOMENT_STUCK || l == MOMENT_STUCK)
        continue;
      double of_data = data->covariance[k][l], of_model = model->covariance[k][l];
      if (kind == WEIGHTS_DATA && g->impacts.xy)
        of_data = own * of_data + (1 - own) * pooled[k][l];
      exact[i][j] = (share > 0 ? share * of_data : 0) + (share < 1 ? (1 - share) * of_model : 0);
      exact[i][j] /= data->rebounds;
      exact[i][j] += kind == WEIGHTS_DATA ? 0 : of_model / model->rebounds;
    }
  for (int i = 0; i < w->n; i++) {
    for (int j = 0; j < w->n; j++)
      w->lower[i][j] = exact[i][j];
    floor[i] = RIDGE * exact[i][i] + FLOOR;
    w->lower[i][i] += floor[i];
  }
  w->log_determinant = factor(w->lower, w->n, floor);
  if (w->n == 0)
    return;
  gsl_matrix_view lower = corner(w->lower, w->n), whitened = corner(exact, w->n);
  gsl_blas_dtrsm(CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, 1, &lower.matrix,
                 &whitened.matrix);
  gsl_blas_dtrsm(CblasRight, CblasLower, CblasTrans, CblasNonUnit, 1, &lower.matrix,
                 &whitened.matrix);
}

void aspi_weights_apply(const aspi_weights *w, const double model[MOMENTS], double *out) {
  for (int i = 0; i < w->n; i++) {
    double off = model[w->of[i]] - w->data.of[w->of[i]];
    for (int j = 0; j < i; j++)
      off -= w->lower[i][j] * out[j];
    out[i] = off / w->lower[i][i];
  }
}
