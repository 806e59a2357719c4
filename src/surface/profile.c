/* A profile: equally spaced heights. A Gaussian one is made (Garcia & Stoll 1984, secondary source)
 * from white noise filtered with exp(-2 x^2/lambda_c^2), whose own autocorrelation is
 * exp(-x^2/lambda_c^2). The filter is applied by GSL's FFT on a power of two that holds the noise
 * and its periodic continuation, so that any number of points costs the same per point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/profile.h"
#include "base/error.h"
#include "base/stream.h"

#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The filter is cut where it has fallen to exp(-32). */
#define KERNEL_REACH 4.0

#define LENGTH_LEAST 20.0 /* correlation lengths */
#define SPACING_MOST 0.25 /* correlation lengths */
#define PHI_R_MOST 100.0
#define HEIGHT_MOST 1e100 /* spacings; squares of it do not overflow */

struct asp_profile {
  size_t points;
  double spacing;
  bool periodic;
  double *heights;
};

asp_profile *aspi_profile_adopt(double *heights, size_t points, double spacing, bool periodic,
                                asp_error *error) {
  asp_profile *profile = heights ? malloc(sizeof *profile) : NULL;
  if (!profile) {
    free(heights);
    aspi_fail(error, ASP_ENOMEM, "out of memory for a profile of %zu points", points);
    return NULL;
  }
  *profile = (asp_profile){points, spacing, periodic, heights};
  return profile;
}

size_t aspi_power_of_two(size_t least) {
  size_t n = 1;
  while (n < least)
    n *= 2;
  return n;
}

double *aspi_allocate(size_t count) {
  return count <= SIZE_MAX / sizeof(double) ? malloc(count * sizeof(double)) : NULL;
}

static void fill_noise(double *noise, size_t points, uint32_t seed) {
  aspi_stream stream =
      aspi_stream_begin(&(asp_key){.seed = seed, .wall = asp_key_wall("profile"), .impact = 0});
  for (size_t i = 0; i < points; i++)
    noise[i] = aspi_stream_normal(&stream);
}

/* The filter around index 0 of a circle of n points, of unit sum of squares, times r_q. */
static void fill_kernel(double *kernel, size_t n, size_t reach, double step, double r_q) {
  double sum = 1;
  memset(kernel, 0, n * sizeof *kernel);
  kernel[0] = 1;
  for (size_t i = 1; i <= reach; i++) {
    double x = (double)i * step, value = exp(-2 * x * x);
    kernel[i] = kernel[n - i] = value;
    sum += 2 * value * value;
  }
  double scale = r_q / sqrt(sum);
  for (size_t i = 0; i <= reach; i++)
    kernel[i] *= scale;
  for (size_t i = 1; i <= reach; i++)
    kernel[n - i] *= scale;
}

/* data := data convolved with an even kernel, both on a circle of n = 2^k points. The spectrum of
 * an even kernel is real: entries 0 to n/2 of GSL's half-complex order. */
static void convolve(double *data, double *kernel, size_t n) {
  gsl_fft_real_radix2_transform(data, 1, n);
  gsl_fft_real_radix2_transform(kernel, 1, n);
  for (size_t i = 0; i <= n / 2; i++) {
    data[i] *= kernel[i];
    if (i > 0 && i < n / 2)
      data[n - i] *= kernel[i];
  }
  gsl_fft_halfcomplex_radix2_inverse(data, 1, n);
}

static asp_code check_generated(double r_q, double lambda_c, double spacing, size_t points,
                                asp_error *error) {
  if (aspi_check_length(error, "r_q", r_q) || aspi_check_length(error, "lambda_c", lambda_c) ||
      aspi_check_length(error, "spacing", spacing))
    return ASP_EARG;
  if (r_q > PHI_R_MOST * lambda_c)
    return aspi_fail(error, ASP_EARG, "r_q is %g; it must be at most %g lambda_c", r_q, PHI_R_MOST);
  if (spacing > SPACING_MOST * lambda_c)
    return aspi_fail(error, ASP_EARG, "spacing is %g; it must be at most lambda_c/4 = %g", spacing,
                     SPACING_MOST * lambda_c);
  if (!((double)points * spacing >= LENGTH_LEAST * lambda_c))
    return aspi_fail(error, ASP_EARG,
                     "a profile of %zu points is %g long; it must be at least 20 lambda_c = %g",
                     points, (double)points * spacing, LENGTH_LEAST * lambda_c);
  if (points > ASP_FFT_MOST)
    return aspi_fail(error, ASP_EARG, "a profile of %zu points; they must be at most %zu", points,
                     ASP_FFT_MOST);
  return ASP_OK;
}

asp_profile *asp_profile_create(double r_q, double lambda_c, double spacing, size_t points,
                                uint32_t seed, asp_error *error) {
  if (check_generated(r_q, lambda_c, spacing, points, error))
    return NULL;
  double step = spacing / lambda_c;
  size_t reach = (size_t)ceil(KERNEL_REACH / step), n = aspi_power_of_two(points + 2 * reach);
  if (n > ASP_FFT_MOST) {
    aspi_fail(error, ASP_EARG, "a profile of %zu points; they must be at most %zu", points,
              ASP_FFT_MOST - 2 * reach);
    return NULL;
  }
  double *data = aspi_allocate(n), *kernel = aspi_allocate(n), *heights = aspi_allocate(points);
  if (data && kernel && heights) {
    fill_noise(data + reach, points, seed);
    memcpy(data, data + points, reach * sizeof *data);
    memcpy(data + reach + points, data + reach, reach * sizeof *data);
    memset(data + points + 2 * reach, 0, (n - points - 2 * reach) * sizeof *data);
    fill_kernel(kernel, n, reach, step, r_q);
    convolve(data, kernel, n);
    memcpy(heights, data + reach, points * sizeof *heights);
  } else {
    free(heights);
    heights = NULL;
  }
  free(data);
  free(kernel);
  return aspi_profile_adopt(heights, points, spacing, true, error);
}

asp_profile *aspi_profile_create_scaled(double r_q, double lambda_c, double spacing, size_t points,
                                        uint32_t seed, int sign, asp_error *error) {
  asp_profile *profile = asp_profile_create(r_q, lambda_c, spacing, points, seed, error);
  if (!profile)
    return NULL;
  double step = spacing / lambda_c, mean = -2 * r_q * r_q * expm1(-step * step), found = 0;
  double *z = profile->heights;
  for (size_t i = 0; i < points; i++) {
    double rise = z[i + 1 < points ? i + 1 : 0] - z[i];
    found += rise * rise / (double)points;
  }
  double scale = sign * sqrt(mean / found);
  for (size_t i = 0; i < points; i++)
    z[i] *= scale;
  return profile;
}

asp_profile *asp_profile_from_heights(const double *heights, size_t points, double spacing,
                                      bool periodic, asp_error *error) {
  if (aspi_check_length(error, "spacing", spacing))
    return NULL;
  if (!heights || points < ASP_POINTS_LEAST) {
    aspi_fail(error, ASP_EARG, "a profile has %zu points; it must have at least %d",
              heights ? points : 0, ASP_POINTS_LEAST);
    return NULL;
  }
  for (size_t i = 0; i < points; i++)
    if (!(fabs(heights[i]) <= HEIGHT_MOST * spacing)) {
      aspi_fail(error, ASP_EARG, "height %zu is %g; it must be a number up to %g spacings", i,
                heights[i], HEIGHT_MOST);
      return NULL;
    }
  double *copy = aspi_allocate(points);
  if (copy)
    memcpy(copy, heights, points * sizeof *copy);
  return aspi_profile_adopt(copy, points, spacing, periodic, error);
}

asp_profile *aspi_profile_mirrored(const asp_profile *profile, asp_error *error) {
  size_t points = profile->points;
  double *heights = aspi_allocate(points);
  for (size_t i = 0; heights && i < points; i++)
    heights[i] = profile->heights[points - 1 - i];
  return aspi_profile_adopt(heights, points, profile->spacing, profile->periodic, error);
}

void asp_profile_free(asp_profile *profile) {
  if (profile)
    free(profile->heights);
  free(profile);
}

size_t asp_profile_points(const asp_profile *profile) {
  return profile->points;
}

double asp_profile_spacing(const asp_profile *profile) {
  return profile->spacing;
}

bool aspi_profile_periodic(const asp_profile *profile) {
  return profile->periodic;
}

const double *asp_profile_heights(const asp_profile *profile) {
  return profile->heights;
}
