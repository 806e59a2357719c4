/* Contact slopes in numbers: differences of a disc's path, their moments, and the D_KL of a normal
 * distribution from the histogram of the angles (eq. 2, with the sign inside the logarithm).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/slopes.h"
#include "base/error.h"
#include "surface/rolling.h"
#include "surface/heights.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>

aspi_moments aspi_moments_of(const double *values, size_t count) {
  double mean = 0, m2 = 0, m3 = 0, m4 = 0;
  for (size_t i = 0; i < count; i++)
    mean += values[i];
  mean /= (double)count;
  for (size_t i = 0; i < count; i++) {
    double d = values[i] - mean, square = d * d;
    m2 += square;
    m3 += square * d;
    m4 += square * square;
  }
  m2 /= (double)count;
  aspi_moments m = {.mean = mean, .sd = sqrt(m2)};
  if (m2 > 0) {
    m.skewness = m3 / (double)count / (m2 * m.sd);
    m.kurtosis = m4 / (double)count / (m2 * m2) - 3;
  }
  return m;
}

void aspi_histogram(const double *values, size_t count, double mean, double sd,
                    double share[ASPI_HISTOGRAM]) {
  size_t found[ASPI_HISTOGRAM] = {0};
  for (size_t i = 0; i < count; i++) {
    double bin = (values[i] - mean) / (ASPI_HISTOGRAM_BIN * sd) + ASPI_HISTOGRAM / 2;
    found[bin < 0 ? 0 : bin < ASPI_HISTOGRAM ? (int)bin : ASPI_HISTOGRAM - 1]++;
  }
  for (int i = 0; i < ASPI_HISTOGRAM; i++)
    share[i] = (double)found[i] / (double)count;
}

double aspi_kl_normal(const double *values, size_t count, double mean, double sd) {
  double share[ASPI_HISTOGRAM], sum = 0, below = 0;
  aspi_histogram(values, count, mean, sd, share);
  for (int i = 0; i < ASPI_HISTOGRAM; i++) {
    double end = (i + 1 - ASPI_HISTOGRAM / 2) * ASPI_HISTOGRAM_BIN;
    double to = i + 1 < ASPI_HISTOGRAM ? gsl_cdf_ugaussian_P(end) : 1;
    if (share[i] > 0)
      sum += share[i] * log(share[i] / (to - below));
    below = to;
  }
  return sum;
}

/* Against the rounding of ratios of steps. */
#define ROUND_UP (1 + 1e-12)

/* Points of a path, unless its profile has more. */
#define PATH_MOST ((size_t)1 << 21)

/* Between points at this step; *count is how many there are. */
static asp_code slopes_at(const asp_heights *profile, double d_p, double step, double *out,
                          size_t *count, asp_error *error) {
  asp_error wrong;
  asp_heights *path = aspi_profile_path(profile, d_p, PATH_MOST, &wrong);
  if (!path)
    return aspi_fail(error, wrong.code, "%s", wrong.text);
  size_t fine = path->columns, cells = profile->columns - !profile->periodic;
  double parts = step / path->step[0], every = profile->step[0] / step;
  *count = (size_t)(ROUND_UP * every * (double)cells);
  for (size_t i = 0; i < *count; i++) {
    size_t at = (size_t)(ROUND_UP * parts * ((double)i + 0.5));
    out[i] = (path->z[at + 1 < fine ? at + 1 : 0] - path->z[at]) / path->step[0];
  }
  asp_heights_free(path);
  return ASP_OK;
}

asp_code aspi_profile_slopes(const asp_heights *profile, double d_p, double *out, size_t *count,
                             asp_error *error) {
  return slopes_at(profile, d_p, profile->step[0], out, count, error);
}

/* Slopes of all profiles at the closest spacing, so that each counts by its length. */
asp_code aspi_profile_describe_slopes(const asp_heights *profile, double d_p, aspi_slopes *slopes,
                                      asp_error *error) {
  double step = profile->step[0];
  size_t count = 0, most = 0, found;
  for (const asp_heights *h = profile; h; h = h->next)
    step = fmin(step, h->step[0]);
  for (const asp_heights *h = profile; h; h = h->next)
    most += (size_t)(aspi_profile_length(h) / step) + 1;
  double *values = aspi_allocate(most);
  if (!values)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu slopes", most);
  asp_code code = ASP_OK;
  for (const asp_heights *h = profile; h && !code; h = h->next) {
    code = slopes_at(h, d_p, step, values + count, &found, error);
    count += code ? 0 : found;
  }
  if (code == ASP_OK) {
    *slopes = (aspi_slopes){.slope = aspi_moments_of(values, count)};
    slopes->slope_rms = hypot(slopes->slope.mean, slopes->slope.sd);
    for (size_t i = 0; i < count; i++)
      values[i] = atan(values[i]);
    slopes->angle = aspi_moments_of(values, count);
    slopes->kl_normal = aspi_kl_normal(values, count, slopes->angle.mean, slopes->angle.sd);
    if (!(slopes->angle.sd > 0))
      code = aspi_fail(error, ASP_EARG, "the slopes are all equal");
  }
  free(values);
  return code;
}
