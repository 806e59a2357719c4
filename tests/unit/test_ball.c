/* Maps and spheres on them: the search for the contact against brute force, the contact of a known
 * surface, the covariance of a generated one, and its slopes under a sphere against the closed
 * form.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "gauss_map.h"
#include "surface/ball.h"
#include "surface/heights.h"
#include "surface/size_law.h"

#include <stdlib.h>

static asp_heights *gauss(double lambda_2, double axis, double step_x, double step_y,
                          size_t columns, size_t rows, double r_q) {
  gauss_wall wall = {r_q, 1, lambda_2, axis};
  asp_error error;
  asp_heights *map =
      gauss_map_create(&wall, (const double[2]){step_x, step_y}, columns, rows, 3, &error);
  if (!map)
    fail_msg("%s", error.text);
  return map;
}

/* The height of the center over a point, by asking every point of the map and its images. */
static double brute(const asp_heights *map, double radius, size_t i, size_t j) {
  long columns = (long)map->columns, rows = (long)map->rows, images = map->periodic;
  double best = -INFINITY;
  for (long b = -images * rows; b < (images + 1) * rows; b++)
    for (long a = -images * columns; a < (images + 1) * columns; a++) {
      double x = map->step[0] * (double)(a - (long)i), y = map->step[1] * (double)(b - (long)j);
      double room = radius * radius - x * x - y * y;
      size_t at = (size_t)((b + rows) % rows * columns + (a + columns) % columns);
      if (room >= 0)
        best = fmax(best, map->z[at] + sqrt(room));
    }
  return best;
}

TEST(spheres_rest_where_brute_force_says) {
  asp_heights *map = gauss(2, 0.6, 0.1, 0.13, 128, 256, 0.3);
  for (int periodic = 0; periodic < 2; periodic++)
    for (double d_p = 0.05; d_p < 12; d_p *= 2.3) {
      map->periodic = periodic;
      aspi_ball *ball = aspi_ball_create(map, d_p, NULL);
      for (size_t k = 0; k < 60; k++) {
        size_t i = k < 4 ? 127 * (k % 2) : k * 37 % 128, j = k < 4 ? 255 * (k / 2) : k * 101 % 256;
        assert_near(aspi_ball_touch(ball, i, j, true).height, brute(map, d_p / 2, i, j), 1e-12);
      }
      aspi_ball_free(ball);
    }
  asp_heights_free(map);
}

/* A sphere on waves of small slope whose crests are wider than it: the contact is where the normal
 * through the center meets the wave. */
TEST(contacts_lie_between_the_points) {
  enum { N = 64 };
  double *z = aspi_allocate(N * N);
  double k = 2 * ASP_PI / N, height = 0.9, r = 3.3;
  for (int j = 0; j < N; j++)
    for (int i = 0; i < N; i++)
      z[j * N + i] = height * cos(k * i) * sin(k * j);
  asp_heights *map = aspi_heights_adopt(z, N, N, (const double[2]){1, 1}, true, NULL);
  aspi_ball *ball = aspi_ball_create(map, 2 * r, NULL);
  for (int n = 0; n < 200; n++) {
    double x = n * 29 % N, y = n * 47 % N, u = x, v = y, p = 0, q = 0;
    for (int step = 0; step < 60; step++) {
      p = -height * k * sin(k * u) * sin(k * v);
      q = height * k * cos(k * u) * cos(k * v);
      u = x + r * p / sqrt(1 + p * p + q * q);
      v = y + r * q / sqrt(1 + p * p + q * q);
    }
    aspi_touch touch = aspi_ball_touch(ball, (size_t)x, (size_t)y, false);
    assert_near(touch.p, p, 3e-4);
    assert_near(touch.q, q, 3e-4);
    assert_near(touch.height, height * cos(k * u) * sin(k * v) + r / sqrt(1 + p * p + q * q), 1e-4);
  }
  aspi_ball_free(ball);
  asp_heights_free(map);
}

/* A sphere on a saddle z = c x y, which is its own parabola: its normal through the contact, from
 * wherever that is, leads to the center. */
TEST(saddles_turn_spheres) {
  enum { N = 64, MIDDLE = 32 };
  const double c = 0.02, r = 20;
  double *z = aspi_allocate(N * N);
  for (int j = 0; j < N; j++)
    for (int i = 0; i < N; i++)
      z[j * N + i] = c * (i - MIDDLE) * (j - MIDDLE);
  asp_heights *map = aspi_heights_adopt(z, N, N, (const double[2]){1, 1}, false, NULL);
  aspi_ball *ball = aspi_ball_create(map, 2 * r, NULL);
  aspi_ball_search search = aspi_ball_begin(ball);
  for (double u = -5; u < 5.1; u += 0.7)
    for (double v = -5; v < 5.1; v += 0.9) {
      const double p = c * v, q = c * u, up = r / sqrt(1 + p * p + q * q);
      aspi_touch touch = aspi_ball_at(&search, MIDDLE + u - up * p, MIDDLE + v - up * q);
      assert_near(touch.p, p, 1e-5);
      assert_near(touch.q, q, 1e-5);
      assert_near(touch.height, c * u * v + up, 1e-5);
    }
  aspi_ball_free(ball);
  asp_heights_free(map);
}

TEST(generated_maps_have_their_covariance) {
  enum { N = 1024 };
  double axis = 0.5;
  asp_heights *map = gauss(3, axis, 0.125, 0.125, N, N, 2);
  const int lag[][2] = {{0, 0}, {8, 0}, {0, 8}, {6, 6}, {6, -6}, {15, 9}};
  for (size_t k = 0; k < sizeof lag / sizeof *lag; k++) {
    double sum = 0, x = 0.125 * lag[k][0], y = 0.125 * lag[k][1];
    for (int j = 0; j < N; j++)
      for (int i = 0; i < N; i++)
        sum += map->z[j * N + i] * map->z[(j + lag[k][1] + N) % N * N + (i + lag[k][0]) % N];
    double u = x * cos(axis) + y * sin(axis), v = (y * cos(axis) - x * sin(axis)) / 3;
    assert_near(sum / (N * N), 4 * exp(-u * u - v * v), 0.15); /* 5000 correlated areas */
  }
  asp_heights_free(map);
}

TEST(slopes_follow_the_formula) {
  const double kappa[] = {0.5, 2, 4}, ratio[] = {1, 5};
  for (int k = 0; k < 2; k++) {
    double phi = 0.05;
    asp_heights *map = gauss(ratio[k], 0, 1 / 16., ratio[k] / 16., 512, 512, phi);
    aspi_ball *none = aspi_ball_create(map, 0, NULL);
    size_t n = 256 * 512;
    float *z = malloc(256 * 512 * sizeof(float)), *p[2], *q[2];
    for (int i = 0; i < 2; i++) {
      p[i] = malloc(256 * 512 * sizeof(float));
      q[i] = malloc(256 * 512 * sizeof(float));
    }
    aspi_ball_rows(none, 0, 256, z, p[0], q[0]);
    for (size_t i = 0; i < 3; i++) {
      aspi_ball *ball = aspi_ball_create(map, kappa[i] / (sqrt(3) * phi), NULL);
      if (!ball)
        continue; /* larger than the map */
      aspi_ball_rows(ball, 0, 256, z, p[1], q[1]);
      double sum[4] = {0};
      for (size_t m = 0; m < n; m++)
        for (int of = 0; of < 2; of++) {
          sum[of] += p[of][m] * p[of][m];
          sum[2 + of] += q[of][m] * q[of][m];
        }
      double one = kappa[i], two = kappa[i] / (ratio[k] * ratio[k]);
      assert_near(sqrt(sum[1] / sum[0]), pow(1 + one * one * (0.92 * one + 0.37 * two), -1 / 6.),
                  0.025);
      assert_near(sqrt(sum[3] / sum[2]), pow(1 + two * two * (0.92 * two + 0.37 * one), -1 / 6.),
                  0.025);
      aspi_ball_free(ball);
    }
    for (int i = 0; i < 2; i++) {
      free(p[i]);
      free(q[i]);
    }
    free(z);
    aspi_ball_free(none);
    asp_heights_free(map);
  }
}

/* The rms slope that a sphere meets on half of a map of 512 x 512 points, in any direction. */
static double slope_under(const asp_heights *map, double d_p) {
  size_t n = 256 * 512;
  float *z = malloc(256 * 512 * sizeof(float)), *p = malloc(256 * 512 * sizeof(float)),
        *q = malloc(256 * 512 * sizeof(float));
  aspi_ball *ball = aspi_ball_create(map, d_p, NULL);
  double sum = 0;
  aspi_ball_rows(ball, 0, 256, z, p, q);
  for (size_t i = 0; i < n; i++)
    sum += p[i] * p[i] + q[i] * q[i];
  aspi_ball_free(ball);
  free(z);
  free(p);
  free(q);
  return sqrt(sum / (2 * (double)n));
}

/* How far the law is off where slopes are steep is as the header has it. */
TEST(steep_slopes_are_off_the_law_as_stated) {
  static const double kappa[] = {1, 4}, most[] = {-0.03, 0.02};
  double phi = 0.25, whole;
  asp_heights *map = gauss(1, 0, 1 / 16., 1 / 16., 512, 512, phi);
  asp_surface *surface = asp_surface_create(phi, 1, NULL);
  whole = slope_under(map, 0);
  for (int i = 0; i < 2; i++) {
    double d_p = kappa[i] / (sqrt(3) * phi), law[2], ratio = slope_under(map, d_p) / whole;
    aspi_surface_sphere_slopes(surface, d_p, law);
    double off = law[0] / asp_surface_slope_rms(surface) / ratio - 1;
    print_message("phi_r %g, kappa %g: s_eff/s %.3f, law off by %.3f\n", phi, kappa[i], ratio, off);
    assert_true(off > -0.065 && off < most[i]);
  }
  asp_surface_free(surface);
  asp_heights_free(map);
}

TEST(bad_maps_are_refused) {
  asp_error error;
  asp_heights *map = gauss(1, 0, 0.1, 0.1, 128, 256, 1);
  assert_null(aspi_ball_create(map, 13, &error));
  assert_says(error.text, "d_p is 13; it must be");
  asp_heights_free(map);
}
