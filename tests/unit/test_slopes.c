/* Moments, histograms and D_KL against closed forms; the size law against generated geometry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "base/stream.h"
#include "surface/rolling.h"
#include "surface/size_law.h"
#include "surface/heights.h"
#include "surface/slopes.h"

#include <gsl/gsl_cdf.h>
#include <stdlib.h>

enum { N = 200000 };
static double values[N];

/* Quantiles of a normal law at equal steps: a sample without sampling error. */
static void fill_normal(double mean, double sd, size_t count) {
  for (size_t i = 0; i < count; i++)
    values[i] = mean + sd * gsl_cdf_ugaussian_Pinv(((double)i + 0.5) / (double)count);
}

TEST(moments_of_known_laws) {
  fill_normal(3, 2, N);
  aspi_moments m = aspi_moments_of(values, N);
  assert_near(m.mean, 3, 1e-9);
  assert_near(m.sd, 2, 1e-3);
  assert_near(m.skewness, 0, 1e-9);
  assert_near(m.kurtosis, 0, 5e-3);
  for (size_t i = 0; i < N; i++)
    values[i] = -log(((double)i + 0.5) / N); /* exponential: 1, 1, 2, 6 */
  m = aspi_moments_of(values, N);
  assert_near(m.mean, 1, 1e-4);
  assert_near(m.sd, 1, 1e-3);
  assert_near(m.skewness, 2, 2e-2);
  assert_near(m.kurtosis, 6, 0.2);
}

/* D_KL between normal laws: log(s2/s1) + (s1^2 + m^2)/(2 s2^2) - 1/2. */
TEST(divergence_of_normal_laws) {
  fill_normal(0, 1, N);
  assert_near(aspi_kl_normal(values, N, 0, 1), 0, 1e-4);
  assert_near(aspi_kl_normal(values, N, 0.5, 2), log(2) + 1.25 / 8 - 0.5, 2e-2);
  double share[ASPI_HISTOGRAM], sum = 0;
  aspi_histogram(values, N, 0, 1, share);
  for (int i = 0; i < ASPI_HISTOGRAM; i++)
    sum += share[i];
  assert_near(sum, 1, 1e-9);
  assert_near(share[ASPI_HISTOGRAM / 2], gsl_cdf_ugaussian_P(0.25) - 0.5, 1e-5);
}

/* The bias of D_KL that the header states, for independent values. */
TEST(divergence_of_a_small_sample_is_as_stated) {
  enum { COUNT = 2000, TRIALS = 200 };
  aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = 4});
  double kl = 0, bins = 0, share[ASPI_HISTOGRAM];
  for (int trial = 0; trial < TRIALS; trial++) {
    for (int i = 0; i < COUNT; i++)
      values[i] = aspi_stream_normal(&stream);
    kl += aspi_kl_normal(values, COUNT, 0, 1) / TRIALS;
    aspi_histogram(values, COUNT, 0, 1, share);
    for (int i = 0; i < ASPI_HISTOGRAM; i++)
      bins += (share[i] > 0) / (double)TRIALS;
  }
  assert_near(kl / (bins / (2. * COUNT)), 1, 0.3);
}

/* A sine has slopes of known law: rms, no skewness, excess kurtosis -3/2. */
TEST(slopes_of_a_wave) {
  enum { POINTS = 5000 };
  for (int i = 0; i < POINTS; i++)
    values[i] = 0.02 * sin(2 * ASP_PI * i / 1000.);
  asp_heights *p = asp_heights_create(values, POINTS, 1, 0.001, 0.001, true, NULL);
  aspi_slopes s;
  assert_int_equal(aspi_profile_describe_slopes(p, 0.01, &s, NULL), ASP_OK);
  assert_near(s.slope_rms, 0.02 * 2 * ASP_PI / sqrt(2), 2e-5);
  assert_near(s.slope.mean, 0, 1e-12);
  assert_near(s.slope.kurtosis, -1.5, 0.01);
  size_t count;
  assert_int_equal(aspi_profile_slopes(p, 0.01, values, &count, NULL), ASP_OK);
  assert_int_equal(count, POINTS);
  asp_heights_free(p);
}

/* Both forms of the size law, and the table between its nodes, against generated profiles. */
TEST(size_law_is_that_of_the_geometry) {
  static const struct {
    double phi_r, size, tolerance;
  } cases[] = {{0.05, 20, 0.03},  {0.25, 1, 0.02},  {0.25, 6, 0.055},
               {0.25, 147, 0.08}, {0.43, 5, 0.015}, {0.97, 1.2, 0.015}};
  enum { POINTS = 128 * 1024 };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    asp_heights *p = aspi_profile_generate(cases[i].phi_r, 1, 1. / 128, POINTS, 11, NULL);
    asp_surface *s = asp_surface_create(cases[i].phi_r, 1, NULL);
    aspi_slopes all, some;
    aspi_profile_describe_slopes(p, 0.004, &all, NULL);
    aspi_profile_describe_slopes(p, cases[i].size, &some, NULL);
    double should = some.slope_rms / all.slope_rms;
    assert_near(asp_surface_slope(s, cases[i].size) / asp_surface_slope_rms(s), should,
                cases[i].tolerance * should);
    asp_surface_free(s);
    asp_heights_free(p);
  }
}

/* A sphere on an isotropic surface, by definition: rms slope along x of its dilation. The law is
 * that of small slopes. */
enum { SIDE = 384, LAMBDA = 12, KERNEL = 36 };

static double *blur(const double *in, size_t along, size_t across) {
  double *out = calloc(SIDE * SIDE, sizeof *out);
  assert_non_null(out);
  for (size_t y = 0; y < SIDE; y++)
    for (int k = -KERNEL; k <= KERNEL; k++) {
      double weight = exp(-2. * k * k / (LAMBDA * LAMBDA));
      for (size_t x = 0; x < SIDE; x++)
        out[y * across + x * along] +=
            weight * in[y * across + (x + (size_t)(SIDE + k)) % SIDE * along];
    }
  return out;
}

static double slope_along_x(const double *z) {
  double sum = 0;
  for (size_t y = 0; y < SIDE; y++)
    for (size_t x = 0; x < SIDE; x++) {
      double rise = z[y * SIDE + (x + 1) % SIDE] - z[y * SIDE + x];
      sum += rise * rise;
    }
  return sqrt(sum / (SIDE * SIDE));
}

static void raise(double *top, const double *z, int dy, int dx, double rise) {
  for (size_t y = 0; y < SIDE; y++) {
    const double *row = &z[(y + (size_t)(SIDE + dy)) % SIDE * SIDE];
    for (size_t x = 0; x < SIDE; x++)
      top[y * SIDE + x] = fmax(top[y * SIDE + x], row[(x + (size_t)(SIDE + dx)) % SIDE] + rise);
  }
}

static double dilated_slope(const double *z, double r) {
  double *top = malloc(SIDE * SIDE * sizeof *top);
  assert_non_null(top);
  memcpy(top, z, SIDE * SIDE * sizeof *top);
  for (size_t i = 0; i < SIDE * SIDE; i++)
    top[i] += r;
  for (int dy = -(int)r; dy <= (int)r; dy++)
    for (int dx = -(int)r; dx <= (int)r; dx++)
      if (dx * dx + dy * dy < r * r)
        raise(top, z, dy, dx, sqrt(r * r - dx * dx - dy * dy));
  double slope = slope_along_x(top);
  free(top);
  return slope;
}

TEST(sphere_law_is_that_of_the_geometry) {
  static double noise[SIDE * SIDE];
  aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = 2});
  for (size_t i = 0; i < SIDE * SIDE; i++)
    noise[i] = aspi_stream_normal(&stream);
  double *half = blur(noise, 1, SIDE), *z = blur(half, SIDE, 1), square = 0;
  for (size_t i = 0; i < SIDE * SIDE; i++)
    square += z[i] * z[i];
  double phi_r = 0.1, scale = phi_r * LAMBDA / sqrt(square / (SIDE * SIDE));
  for (size_t i = 0; i < SIDE * SIDE; i++)
    z[i] *= scale;
  asp_surface *sphere = asp_surface_create(phi_r, 1, NULL);
  const double size = 4;
  double slope[2];
  aspi_surface_sphere_slopes(sphere, size, slope);
  double law = slope[0] / asp_surface_slope_rms(sphere);
  assert_near(dilated_slope(z, size * LAMBDA / 2) / slope_along_x(z), law, 0.04 * law);
  asp_surface_free(sphere);
  free(half);
  free(z);
}
