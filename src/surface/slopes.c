/* Contact slopes in numbers: differences of a disc's path or a closed profile, their moments, a
 * kernel density of the angles, and the D_KL of a normal distribution from it (eq. 2, with the sign
 * inside the logarithm).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/slopes.h"
#include "base/error.h"
#include "surface/closing.h"
#include "surface/profile.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { GRID_MOST = 65536, GRID = 1024 };

#define KERNEL_REACH 5.0 /* bandwidths */

/* Interquartile range of a normal distribution of unit sd. */
#define QUARTILES_TO_SD 1.3489795003921634

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

/* Splits each value between the two points next to it. Returns the number of values within. */
static double share(const double *values, size_t count, const aspi_density *d, double *share) {
  double within = 0, last = (double)(d->points - 1);
  memset(share, 0, d->points * sizeof *share);
  for (size_t i = 0; i < count; i++) {
    double at = (values[i] - d->lo) / d->step;
    if (!(at >= 0 && at <= last))
      continue;
    size_t left = at < last ? (size_t)at : d->points - 2;
    share[left] += (double)(left + 1) - at;
    share[left + 1] += at - (double)left;
    within++;
  }
  return within;
}

/* value := share convolved with the kernel, then scaled to an integral of 1. */
static void smooth(const double *share, aspi_density *d) {
  ptrdiff_t n = (ptrdiff_t)d->points;
  double reach = KERNEL_REACH * d->bandwidth / d->step, sum = 0;
  ptrdiff_t far = reach < (double)n ? (ptrdiff_t)reach : n - 1;
  memset(d->value, 0, d->points * sizeof *d->value);
  for (ptrdiff_t k = -far; k <= far; k++) {
    double x = (double)k * d->step / d->bandwidth, weight = exp(-0.5 * x * x);
    for (ptrdiff_t i = k < 0 ? -k : 0; i < (k < 0 ? n : n - k); i++)
      d->value[i + k] += weight * share[i];
  }
  for (ptrdiff_t i = 0; i < n; i++)
    sum += d->value[i];
  for (ptrdiff_t i = 0; i < n; i++)
    d->value[i] /= sum * d->step;
}

/* The value under which `part` of the shares lie, in points of the grid. */
static double quantile(const double *share, size_t points, double part) {
  double sum = 0, below = 0;
  for (size_t i = 0; i < points; i++)
    sum += share[i];
  for (size_t i = 0; i < points; i++) {
    if (below + share[i] >= part * sum)
      return (double)i - 0.5 + (part * sum - below) / share[i];
    below += share[i];
  }
  return (double)points;
}

/* The normal reference rule on the smaller of sd and interquartile range (Silverman 1986), which
 * keeps the peak of a distribution with long tails. */
static double bandwidth_of(const double *share, const aspi_density *d, size_t count, double sd) {
  double width = quantile(share, d->points, 0.75) - quantile(share, d->points, 0.25);
  double robust = width * d->step / QUARTILES_TO_SD;
  return (width > 1 ? fmin(sd, robust) : sd) * pow(4 / (3 * (double)count), 0.2);
}

static aspi_density *density_of(const double *values, size_t count, double sd, double lo, double hi,
                                size_t points, asp_error *error) {
  aspi_density *d = malloc(sizeof *d + points * sizeof *d->value);
  double *buffer = aspi_allocate(points);
  if (!d || !buffer) {
    free(d);
    free(buffer);
    aspi_fail(error, ASP_ENOMEM, "out of memory for a density");
    return NULL;
  }
  *d = (aspi_density){.lo = lo, .step = (hi - lo) / (double)(points - 1), .points = points};
  double within = share(values, count, d, buffer);
  d->bandwidth = bandwidth_of(buffer, d, count, sd);
  smooth(buffer, d);
  free(buffer);
  if (within > 0)
    return d;
  free(d);
  aspi_fail(error, ASP_EARG, "no value lies between %g and %g", lo, hi);
  return NULL;
}

aspi_density *aspi_density_create(const double *values, size_t count, double lo, double hi,
                                  size_t points, asp_error *error) {
  if (points < 2 || points > GRID_MOST || !(lo < hi) || !isfinite(hi - lo)) {
    aspi_fail(error, ASP_EARG,
              "a density of %zu points from %g to %g; it must have 2 to %d points and lo < hi",
              points, lo, hi, GRID_MOST);
    return NULL;
  }
  aspi_moments moments = aspi_moments_of(values, count);
  if (count < 2 || !(moments.sd > 0) || !isfinite(moments.sd)) {
    aspi_fail(error, ASP_EARG, "a density needs at least two finite values that are not equal");
    return NULL;
  }
  return density_of(values, count, moments.sd, lo, hi, points, error);
}

double aspi_density_kl_normal(const aspi_density *density, double mean, double sd) {
  double sum = 0;
  for (size_t i = 0; i < density->points; i++) {
    double p = density->value[i];
    double x = (density->lo + (double)i * density->step - mean) / sd;
    if (p > 0)
      sum += p * (log(p * sd * sqrt(2 * ASP_PI)) + 0.5 * x * x);
  }
  return sum * density->step;
}

/* Points of a path, unless its profile has more. */
#define PATH_MOST ((size_t)1 << 21)

/* The slopes of the path in the middle between the profile's points. */
static asp_code rolled_slopes(const asp_profile *profile, double d_p, double *out,
                              asp_error *error) {
  asp_error wrong;
  asp_profile *path = aspi_profile_path(profile, d_p, PATH_MOST, &wrong);
  if (!path)
    return aspi_fail(error, wrong.code, "%s", wrong.text);
  size_t points = asp_profile_points(profile), fine = asp_profile_points(path);
  size_t parts = (size_t)lround(asp_profile_spacing(profile) / asp_profile_spacing(path));
  const double *z = asp_profile_heights(path);
  for (size_t i = 0; i < points; i++) {
    size_t at = i * parts + parts / 2;
    out[i] = (z[(at + 1) % fine] - z[at % fine]) / asp_profile_spacing(path);
  }
  asp_profile_free(path);
  return ASP_OK;
}

static asp_code point_slopes(const asp_profile *profile, double d_p, aspi_contact contact,
                             double *out, asp_error *error) {
  asp_code code = contact == ASP_CONTACT_DILATION ? aspi_profile_dilate(profile, d_p, out, error)
                                                  : aspi_profile_close(profile, d_p, out, error);
  if (code)
    return code;
  size_t points = asp_profile_points(profile);
  double first = out[0], spacing = asp_profile_spacing(profile);
  for (size_t i = 0; i + 1 < points; i++)
    out[i] = (out[i + 1] - out[i]) / spacing;
  out[points - 1] = (first - out[points - 1]) / spacing;
  return ASP_OK;
}

asp_code aspi_profile_slopes(const asp_profile *profile, double d_p, aspi_contact contact,
                             double *out, size_t *count, asp_error *error) {
  size_t points = asp_profile_points(profile);
  *count = aspi_profile_periodic(profile) ? points : points - 1;
  return contact == ASP_CONTACT_ROLLED ? rolled_slopes(profile, d_p, out, error)
                                       : point_slopes(profile, d_p, contact, out, error);
}

/* The density of the angles, over all of them and the kernel's reach. */
static asp_code fit_normal(const double *angles, size_t count, aspi_slopes *slopes,
                           asp_error *error) {
  double lo, hi;
  gsl_stats_minmax(&lo, &hi, angles, 1, count);
  double reach = KERNEL_REACH * slopes->angle.sd * pow(4 / (3 * (double)count), 0.2);
  asp_error wrong;
  aspi_density *density = aspi_density_create(angles, count, lo - reach, hi + reach, GRID, &wrong);
  if (!density)
    return aspi_fail(error, wrong.code, "%s", wrong.text);
  slopes->bandwidth = density->bandwidth;
  slopes->kl_normal = aspi_density_kl_normal(density, slopes->angle.mean, slopes->angle.sd);
  free(density);
  return ASP_OK;
}

asp_code aspi_profile_describe_slopes(const asp_profile *profile, double d_p, aspi_contact contact,
                                      aspi_slopes *slopes, asp_error *error) {
  size_t count = asp_profile_points(profile);
  double *values = aspi_allocate(count);
  if (!values)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu slopes", count);
  asp_code code = aspi_profile_slopes(profile, d_p, contact, values, &count, error);
  if (code == ASP_OK) {
    *slopes = (aspi_slopes){.slope = aspi_moments_of(values, count)};
    slopes->slope_rms = hypot(slopes->slope.mean, slopes->slope.sd);
    for (size_t i = 0; i < count; i++)
      values[i] = atan(values[i]);
    slopes->angle = aspi_moments_of(values, count);
    code = fit_normal(values, count, slopes, error);
  }
  free(values);
  return code;
}
