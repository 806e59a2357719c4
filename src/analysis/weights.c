/* Moments and their weights; see weights.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/weights.h"

#include <gsl/gsl_blas.h>
#include <math.h>

/* Share of each variance that is added to it. If wall and law leave one freedom, moments are nearly
 * functions of each other; the ridge keeps any combination of them from counting for more than a
 * simulation resolves. */
#define RIDGE 1e-2

/* The least variance, so that a moment that does not vary can be weighed. */
#define FLOOR 1e-14

/* The data's covariance of a group is that of its own impacts in the share n/(n + FEW), and the
 * pooled one in the rest. */
#define FEW 20.0

/* ---- moments ---- */

aspi_cloud_moments aspi_cloud_moments_of(const aspi_cloud *cloud, const double center[2]) {
  aspi_cloud_moments m = {.rebounds = (double)cloud->rebounds,
                          .all = (double)(cloud->rebounds + cloud->deposits)};
  double product[MOMENT_STUCK][MOMENT_STUCK] = {{0}};
  for (size_t i = 0; i < cloud->rebounds; i++) {
    double u[2] = {cloud->xy[i][0] - center[0], cloud->xy[i][1] - center[1]};
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

aspi_cloud_moments aspi_group_moments(const aspi_group *g, const double center[2]) {
  if (g->impacts.xy)
    return aspi_cloud_moments_of(&g->impacts, center);
  aspi_cloud_moments m = {.rebounds = g->n, .all = g->n};
  for (int k = 0; k < 2; k++) {
    double off = g->mean[k] - center[k], square = g->sd[k] * g->sd[k];
    double known = g->n > 1 ? (g->n - 1) / g->n : 1;
    m.of[MOMENT_X + k] = off;
    m.of[MOMENT_XX + k] = known * square + off * off;
    m.covariance[MOMENT_X + k][MOMENT_X + k] = g->se[k] >= 0 ? g->se[k] * g->se[k] * g->n : square;
    m.covariance[MOMENT_XX + k][MOMENT_XX + k] = 2 * square * square + 4 * square * off * off;
  }
  return m;
}

/* ---- weights ---- */

/* Variance of one impact's outcome. The share of deposits is at least that of half a deposit
 * (Wilson 1927). */
static double variance_of_share(double share, double n) {
  double least = (n * share + 0.5) / (n + 1);
  return least * (1 - least);
}

/* Lower Cholesky factor of a covariance, in place; a direction without a variance of its own gets
 * the floor. Returns the logarithm of the determinant. */
static double factor(double (*a)[MOMENTS], int n, const double *floor) {
  double log_determinant = 0;
  for (int k = 0; k < n; k++) {
    for (int l = 0; l <= k; l++) {
      double sum = a[k][l];
      for (int i = 0; i < l; i++)
        sum -= a[k][i] * a[l][i];
      a[k][l] = l < k ? sum / a[l][l] : sqrt(fmax(sum, floor[k]));
    }
    log_determinant += 2 * log(a[k][k]);
  }
  return log_determinant;
}

/* The covariance of two moments, measured minus simulated. */
static double covariance(const aspi_weights *w, const aspi_group *g,
                         const aspi_cloud_moments *model, double (*pooled)[MOMENTS], int k, int l) {
  const aspi_cloud_moments *data = &w->data;
  if (k == MOMENT_STUCK && l == MOMENT_STUCK)
    return variance_of_share((model ? model : data)->of[k], data->all) *
           (1 / data->all + (model ? 1 / model->all : 0));
  if (k == MOMENT_STUCK || l == MOMENT_STUCK)
    return 0;
  double own = g->impacts.xy ? data->rebounds / (data->rebounds + FEW) : 1;
  double of_data = own * data->covariance[k][l] + (own < 1 ? (1 - own) * pooled[k][l] : 0);
  if (!model)
    return of_data / data->rebounds;
  return (g->by_data ? data : model)->covariance[k][l] / data->rebounds +
         model->covariance[k][l] / model->rebounds;
}

/* A corner of n x n of a matrix of moments. */
static gsl_matrix_view corner(double (*a)[MOMENTS], int n) {
  return gsl_matrix_view_array_with_tda(a[0], (size_t)n, (size_t)n, MOMENTS);
}

void aspi_weights_set(aspi_weights *w, const aspi_group *g, const aspi_cloud_moments *model,
                      double (*pooled)[MOMENTS]) {
  double floor[MOMENTS];
  w->n = 0;
  for (int k = 0; k < MOMENTS; k++)
    if (g->used[k])
      w->of[w->n++] = k;
  for (int i = 0; i < w->n; i++) {
    for (int j = 0; j < w->n; j++) {
      w->whitened[i][j] = covariance(w, g, model, pooled, w->of[i], w->of[j]);
      w->lower[i][j] = w->whitened[i][j];
    }
    floor[i] = RIDGE * w->lower[i][i] + FLOOR;
    w->lower[i][i] += floor[i];
  }
  w->log_determinant = factor(w->lower, w->n, floor);
  if (w->n == 0)
    return;
  gsl_matrix_view lower = corner(w->lower, w->n), whitened = corner(w->whitened, w->n);
  gsl_blas_dtrsm(CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, 1, &lower.matrix,
                 &whitened.matrix);
  gsl_blas_dtrsm(CblasRight, CblasLower, CblasTrans, CblasNonUnit, 1, &lower.matrix,
                 &whitened.matrix);
}

void aspi_weights_apply(const aspi_weights *w, const double model[MOMENTS], double *out) {
  for (int i = 0; i < w->n; i++) {
    out[i] = model[w->of[i]] - w->data.of[w->of[i]];
    for (int j = 0; j < i; j++)
      out[i] -= w->lower[i][j] * out[j];
    out[i] /= w->lower[i][i];
  }
}
