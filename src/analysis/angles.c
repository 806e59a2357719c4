/* Histograms of rebound angles; see angles.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/angles.h"
#include "base/units.h"

#include <math.h>

static int bin_of(double degrees) {
  int bin = (int)floor(degrees);
  return bin < 0 ? 0 : bin < ASPI_ANGLE_BINS ? bin : ASPI_ANGLE_BINS - 1;
}

void aspi_angles_add(aspi_angles *a, const double v2[3], double tilt, int hits) {
  double speed = sqrt(v2[0] * v2[0] + v2[1] * v2[1] + v2[2] * v2[2]);
  double rebound = aspi_degrees(atan2(v2[2], v2[0])), lateral = aspi_degrees(asin(v2[1] / speed));
  a->n++;
  a->rebound[bin_of(rebound)]++;
  a->lateral[bin_of(lateral + 90)]++;
  a->tilt[bin_of(aspi_degrees(tilt) + 90)]++;
  a->rebound_sum += rebound;
  a->lateral_sum += lateral;
  a->lateral_square += lateral * lateral;
  a->later += hits > 1;
}

/* All members are sums. */
void aspi_angles_merge(aspi_angles *to, const aspi_angles *from) {
  double *sum = &to->n;
  const double *more = &from->n;
  for (size_t i = 0; i < sizeof *to / sizeof *sum; i++)
    sum[i] += more[i];
}

static const double *member(const aspi_angles *angles, size_t offset) {
  return (const double *)(const void *)((const char *)angles + offset);
}

/* A histogram of all groups but one; returns the number of rebounds in it. */
static double sum_groups(aspi_angle_groups groups, size_t without, size_t histogram,
                         double sum[ASPI_ANGLE_BINS]) {
  double n = 0;
  for (int i = 0; i < ASPI_ANGLE_BINS; i++)
    sum[i] = 0;
  for (size_t g = 0; g < groups.n; g++) {
    const double *count = member(&groups.at[g * groups.stride], histogram);
    for (int i = 0; i < ASPI_ANGLE_BINS && g != without; i++)
      sum[i] += count[i];
    n += g == without ? 0 : groups.at[g * groups.stride].n;
  }
  return n;
}

/* Without one of the groups; their number: of all. */
static double divergence_without(aspi_angle_groups reference, aspi_angle_groups model,
                                 size_t histogram, size_t without) {
  double p[ASPI_ANGLE_BINS], q[ASPI_ANGLE_BINS], sum = 0;
  double n = sum_groups(reference, without, histogram, p);
  double m = sum_groups(model, model.n == 1 ? 1 : without, histogram, q);
  for (int i = 0; i < ASPI_ANGLE_BINS; i++)
    if (p[i] > 0)
      sum += p[i] / n * log(p[i] / n * m / fmax(q[i], 0.5));
  return sum;
}

aspi_mean_error aspi_angles_divergence(aspi_angle_groups reference, aspi_angle_groups model,
                                       size_t histogram) {
  double n = (double)reference.n, mean = 0, square = 0, bias = 0;
  double whole = divergence_without(reference, model, histogram, reference.n);
  for (size_t g = 0; g < reference.n; g++) {
    double less = divergence_without(reference, model, histogram, g) - whole;
    mean += less / n;
    square += less * less / n;
  }
  for (int i = 0; i < ASPI_ANGLE_BINS && model.n == 1; i++)
    bias += (member(model.at, histogram)[i] > 0) / (2 * model.at->n);
  bias -= model.n == 1 ? 1 / (2 * model.at->n) : 0;
  return (aspi_mean_error){whole - (n - 1) * mean - bias,
                           sqrt((n - 1) * fmax(0, square - mean * mean))};
}

aspi_mean_error aspi_angles_mean(aspi_angle_groups groups, size_t sum) {
  double n = (double)groups.n, mean = 0, square = 0;
  for (size_t g = 0; g < groups.n; g++) {
    const aspi_angles *a = &groups.at[g * groups.stride];
    double value = *member(a, sum) / a->n;
    mean += value / n;
    square += value * value / n;
  }
  return (aspi_mean_error){mean, sqrt(fmax(0, square - mean * mean) / (n - 1))};
}
