/* Heights of a wall at equal spacing, along a line or over an area. A Gaussian profile is made
 * (Garcia & Stoll 1984, secondary source) from white noise filtered with exp(-2 x^2/lambda_c^2),
 * whose own autocorrelation is exp(-x^2/lambda_c^2). The filter is applied by GSL's FFT to blocks
 * that fit into the cache and overlap by the filter's reach, so that any number of points costs the
 * same per point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/heights.h"
#include "base/error.h"
#include "base/stream.h"

#include <gsl/gsl_fft_complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The filter is cut where it has fallen to exp(-32). */
#define KERNEL_REACH 4.0

#define SPACING_MOST 0.25 /* correlation lengths */
#define HEIGHT_MOST 1e100 /* spacings; squares of it do not overflow */

asp_heights *aspi_heights_adopt(double *z, size_t columns, size_t rows, const double step[2],
                                bool periodic, asp_error *error) {
  asp_heights *heights = z ? malloc(sizeof *heights) : NULL;
  if (!heights) {
    free(z);
    aspi_fail(error, ASP_ENOMEM, "out of memory for a %s of %zu x %zu points",
              aspi_kind_of_rows(rows), columns, rows);
    return NULL;
  }
  *heights = (asp_heights){columns, rows, {step[0], step[1]}, periodic, z, NULL};
  return heights;
}

asp_heights *aspi_profile_adopt(double *z, size_t points, double spacing, bool periodic,
                                asp_error *error) {
  return aspi_heights_adopt(z, points, 1, (const double[2]){spacing, spacing}, periodic, error);
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

/* Filters periodic noise in blocks of n with `reach` on both sides, two at a time as the real and
 * the imaginary part. */
static void filter_noise(const double *noise, double *heights, size_t points, size_t reach,
                         double *block, size_t n, double width) {
  const size_t kept = n - 2 * reach;
  for (size_t begin = 0; begin < points; begin += 2 * kept) {
    for (size_t k = 0; k < 2; k++)
      for (size_t j = 0, i = (begin + k * kept + points - reach) % points; j < n; j++) {
        block[2 * j + k] = noise[i];
        i = i + 1 < points ? i + 1 : 0;
      }
    aspi_smooth(block, n, 1, width);
    for (size_t k = 0; k < 2; k++)
      for (size_t j = 0, i = begin + k * kept; j < kept && i < points; j++, i++)
        heights[i] = block[2 * (reach + j) + k];
  }
}

asp_heights *aspi_profile_generate(double r_q, double lambda_c, double spacing, size_t points,
                                   uint32_t seed, asp_error *error) {
  double step = spacing / lambda_c;
  if (step > SPACING_MOST || !((double)points * step >= ASPI_LENGTHS_LEAST) ||
      points > ASP_POINTS_MOST / 2)
    return aspi_fail_null(
        error, ASP_EARG,
        "a profile of %zu points, lambda_c/%.3g apart; they must be lambda_c/4 apart or less, "
        "and over %g lambda_c, but no more than %zu",
        points, 1 / step, ASPI_LENGTHS_LEAST, ASP_POINTS_MOST / 2);
  size_t reach = (size_t)ceil(KERNEL_REACH / step), n = aspi_power_of_two(8 * reach);
  double *noise = aspi_allocate(points), *block = aspi_allocate(2 * n),
         *heights = aspi_allocate(points);
  if (noise && block && heights) {
    fill_noise(noise, points, seed);
    filter_noise(noise, heights, points, reach, block, n, sqrt(ASP_PI / 2) / step);
    const double scale = r_q / sqrt(step / sqrt(ASP_PI)); /* the filter leaves step/sqrt(pi) of 1 */
    for (size_t i = 0; i < points; i++)
      heights[i] *= scale;
  } else {
    free(heights);
    heights = NULL;
  }
  free(noise);
  free(block);
  return aspi_profile_adopt(heights, points, spacing, true, error);
}

asp_heights *aspi_profile_generate_scaled(double r_q, double lambda_c, double spacing,
                                          size_t points, uint32_t seed, int sign,
                                          asp_error *error) {
  asp_heights *profile = aspi_profile_generate(r_q, lambda_c, spacing, points, seed, error);
  if (!profile)
    return NULL;
  double step = spacing / lambda_c, mean = -2 * r_q * r_q * expm1(-step * step), found = 0;
  double *z = profile->z;
  for (size_t i = 0; i < points; i++) {
    double rise = z[i + 1 < points ? i + 1 : 0] - z[i];
    found += rise * rise / (double)points;
  }
  double scale = sign * sqrt(mean / found);
  for (size_t i = 0; i < points; i++)
    z[i] *= scale;
  return profile;
}

asp_heights *asp_heights_create(const double *z, size_t columns, size_t rows, double step_x,
                                double step_y, bool periodic, asp_error *error) {
  const double steps[2] = {step_x, rows > 1 ? step_y : step_x};
  if (aspi_check_length(error, "step_x", step_x) ||
      (rows > 1 && aspi_check_length(error, "step_y", step_y)))
    return NULL;
  if (!z || columns < ASP_SIDE_LEAST || !rows || (rows > 1 && rows < ASP_SIDE_LEAST) ||
      columns > ASP_POINTS_MOST / rows)
    return aspi_fail_null(
        error, ASP_EARG,
        "a wall has %zu x %zu points; a row must have at least %d of them, a map as many "
        "rows, and all together at most %zu",
        z ? columns : 0, rows, ASP_SIDE_LEAST, ASP_POINTS_MOST);
  for (size_t i = 0; i < columns * rows; i++)
    if (!(fabs(z[i]) <= HEIGHT_MOST * step_x))
      return aspi_fail_null(error, ASP_EARG,
                            "height %zu is %g; it must be a number up to %g spacings", i, z[i],
                            HEIGHT_MOST);
  double *copy = aspi_allocate(columns * rows);
  if (copy)
    memcpy(copy, z, columns * rows * sizeof *copy);
  return aspi_heights_adopt(copy, columns, rows, steps, periodic, error);
}

void asp_heights_free(asp_heights *heights) {
  for (asp_heights *next; heights; heights = next) {
    next = heights->next;
    free(heights->z);
    free(heights);
  }
}

asp_heights *aspi_profile_mirrored(const asp_heights *profile, asp_error *error) {
  size_t points = profile->columns;
  double *heights = aspi_allocate(points);
  for (size_t i = 0; heights && i < points; i++)
    heights[i] = profile->z[points - 1 - i];
  return aspi_profile_adopt(heights, points, profile->step[0], profile->periodic, error);
}

aspi_extent aspi_heights_extent(const asp_heights *h) {
  if (h->rows > 1) {
    double side = fmin(aspi_profile_length(h), (double)h->rows * h->step[1]);
    return (aspi_extent){fmax(h->step[0], h->step[1]), side, side};
  }
  aspi_extent all = {0, INFINITY, 0};
  for (; h; h = h->next) {
    double length = aspi_profile_length(h);
    all =
        (aspi_extent){fmax(all.spacing, h->step[0]), fmin(all.length, length), all.total + length};
  }
  return all;
}

void aspi_smooth(double *data, size_t n, double spacing, double width) {
  gsl_fft_complex_radix2_forward(data, 1, n);
  for (size_t i = 0; i < n; i++) {
    double f = width * (double)(i <= n / 2 ? i : n - i) / ((double)n * spacing);
    double part = exp(-ASP_PI * f * f);
    data[2 * i] *= part;
    data[2 * i + 1] *= part;
  }
  gsl_fft_complex_radix2_inverse(data, 1, n);
}

/* Columns that are gathered, transformed and put back at a time: a cache line. */
enum { GATHERED = 4 };

size_t aspi_fft2_room(size_t rows) {
  return 2 * GATHERED * rows;
}

static void transform(double *data, size_t n, bool backward) {
  if (backward)
    gsl_fft_complex_radix2_backward(data, 1, n);
  else
    gsl_fft_complex_radix2_forward(data, 1, n);
}

void aspi_fft2(double *data, size_t columns, size_t rows, bool backward, double *room) {
  for (size_t j = 0; j < rows; j++)
    transform(data + 2 * j * columns, columns, backward);
  for (size_t i = 0; i < columns && rows > 1; i += GATHERED) {
    for (size_t j = 0; j < rows; j++)
      for (size_t k = 0; k < GATHERED; k++)
        memcpy(room + 2 * (k * rows + j), data + 2 * (j * columns + i + k), 2 * sizeof *data);
    for (size_t k = 0; k < GATHERED; k++)
      transform(room + 2 * k * rows, rows, backward);
    for (size_t j = 0; j < rows; j++)
      for (size_t k = 0; k < GATHERED; k++)
        memcpy(data + 2 * (j * columns + i + k), room + 2 * (k * rows + j), 2 * sizeof *data);
  }
}
