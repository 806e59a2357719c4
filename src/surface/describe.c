/* Numbers of a profile: heights, correlation length, slope. The autocorrelation is GSL's FFT of the
 * heights about their mean: circular if the profile is periodic, else padded with zeros (the sum of
 * n - k products over n, which damps lags with few products).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/describe.h"
#include "base/error.h"
#include "surface/profile.h"
#include "base/tolerances.h"

#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A correlation length of fewer spacings is that of noise: white noise has 0.63 by the 1/e lag. */
#define SPACINGS_LEAST 1.5

static void describe_heights(const asp_profile *profile, aspi_profile_description *d) {
  const double *z = asp_profile_heights(profile);
  double mean = gsl_stats_mean(z, 1, d->points), step = 0;
  size_t steps = aspi_profile_periodic(profile) ? d->points : d->points - 1;
  for (size_t i = 0; i < steps; i++) {
    double rise = (z[(i + 1) % d->points] - z[i]) / d->spacing;
    step += rise * rise;
  }
  d->r_q = sqrt(gsl_stats_variance_with_fixed_mean(z, 1, d->points, mean));
  d->r_a = gsl_stats_absdev_m(z, 1, d->points, mean);
  d->slope_rms = sqrt(step / (double)steps);
}

/* The power spectrum in place, in half-complex order, then its transform: the autocovariance. */
static void correlate(double *data, size_t n) {
  gsl_fft_real_radix2_transform(data, 1, n);
  data[0] *= data[0];
  data[n / 2] *= data[n / 2];
  for (size_t i = 1; i < n / 2; i++) {
    data[i] = data[i] * data[i] + data[n - i] * data[n - i];
    data[n - i] = 0;
  }
  gsl_fft_halfcomplex_radix2_inverse(data, 1, n);
}

/* Autocovariances at lags 0 to n/2, in a buffer that the caller frees. The circular one of a
 * periodic profile at lag k is the linear one at k and at n - k together. */
static double *autocovariance(const asp_profile *profile, double scale) {
  size_t points = asp_profile_points(profile), n = aspi_power_of_two(2 * points);
  const double *z = asp_profile_heights(profile);
  double *data = aspi_allocate(n), mean = gsl_stats_mean(z, 1, points);
  if (!data)
    return NULL;
  for (size_t i = 0; i < points; i++)
    data[i] = (z[i] - mean) / scale;
  memset(data + points, 0, (n - points) * sizeof *data);
  correlate(data, n);
  if (aspi_profile_periodic(profile))
    for (size_t lag = 1; lag <= points / 2; lag++)
      data[lag] += data[points - lag];
  return data;
}

/* The lag, in points, at which the autocorrelation first falls to the level; 0 when it does not
 * within half the profile. */
static double crossing(const double *covariance, size_t lags, double level) {
  for (size_t lag = 1; lag <= lags; lag++) {
    double before = covariance[lag - 1] / covariance[0], here = covariance[lag] / covariance[0];
    if (here <= level)
      return (double)lag - (level - here) / (before - here);
  }
  return 0;
}

asp_code aspi_profile_describe(const asp_profile *profile, double level,
                               aspi_profile_description *description, asp_error *error) {
  if (!(level > 0 && level < 1))
    return aspi_fail(error, ASP_EARG, "level of the autocorrelation is %g; it must be 0 to 1",
                     level);
  aspi_profile_description d = {.points = asp_profile_points(profile),
                                .spacing = asp_profile_spacing(profile)};
  d.length = (double)d.points * d.spacing;
  if (d.points > ASP_FFT_MOST / 2)
    return aspi_fail(error, ASP_EARG, "a profile of %zu points; they must be at most %zu", d.points,
                     ASP_FFT_MOST / 2);
  describe_heights(profile, &d);
  if (!isfinite(d.r_q) || !isfinite(d.slope_rms))
    return aspi_fail(error, ASP_EDATA, "the profile's heights are too large to work with");
  if (!(d.r_q > ASPI_ROUNDING_DOUBLE * fabs(asp_profile_heights(profile)[0])))
    return aspi_fail(error, ASP_EDATA, "the profile is constant");
  double *covariance = autocovariance(profile, d.r_q);
  if (!covariance)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a profile of %zu points", d.points);
  d.lambda_c = crossing(covariance, d.points / 2, level) * d.spacing;
  free(covariance);
  if (!(d.lambda_c > 0))
    return aspi_fail(
        error, ASP_EDATA,
        "the autocorrelation does not fall to %.3g within half the profile's length of "
        "%g: the profile is too short, or form is left in it",
        level, d.length);
  d.lambda_1_e = d.lambda_c / sqrt(-log(level));
  d.phi_r = d.r_q / d.lambda_c;
  *description = d;
  return ASP_OK;
}

asp_code aspi_roughness_check(const char *which, double lambda, double step, const char *remedy,
                              const char *ratio, double phi_r, double phi_r_most,
                              asp_error *error) {
  if (lambda < SPACINGS_LEAST * step)
    return aspi_fail(
        error, ASP_EDATA,
        "the %scorrelation length, %g, is less than %g spacings of the points: this is "
        "noise, or sampled too coarsely%s",
        which, lambda, SPACINGS_LEAST, remedy);
  if (phi_r > phi_r_most)
    return aspi_fail(error, ASP_EDATA,
                     "phi_r = %s is %g; over %g is no roughness: are the units of positions and "
                     "heights right (reader: unit_x, unit_z)?",
                     ratio, phi_r, phi_r_most);
  return ASP_OK;
}

asp_code aspi_profile_check(const aspi_profile_description *d, double phi_r_most,
                            asp_error *error) {
  return aspi_roughness_check("", d->lambda_c, d->spacing,
                              "; take short waves out (reader: lambda_s)", "R_q/lambda_c", d->phi_r,
                              phi_r_most, error);
}
