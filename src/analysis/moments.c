/* Moments of impacts; see moments.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/moments.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>

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
