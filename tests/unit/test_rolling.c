/* Discs on profiles: their path and their closing against the definition.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "base/stream.h"
#include "surface/rolling.h"
#include "surface/heights.h"
#include "surface/slopes.h"

#include <stdlib.h>

enum { MOST = 400 };

static double noise(aspi_stream *stream) {
  return 2 * aspi_stream_uniform(stream) - 1;
}

static ptrdiff_t continued(ptrdiff_t i, ptrdiff_t n, bool periodic) {
  ptrdiff_t period = periodic ? n : 2 * n - 2;
  i = (i % period + period) % period;
  return i < n ? i : period - i;
}

/* The dilation at point i: the maximum over j of z(j) + rise(i - j). */
static double by_definition(const double *z, ptrdiff_t n, double spacing, bool periodic, double r,
                            ptrdiff_t i) {
  ptrdiff_t reach = (ptrdiff_t)floor(r / spacing);
  double most = -INFINITY;
  for (ptrdiff_t k = -reach; k <= reach; k++) {
    double x = (double)k * spacing;
    most = fmax(most, z[continued(i + k, n, periodic)] + sqrt(r * r - x * x));
  }
  return most;
}

/* A disc that rolls over the curve through points of any shape stays near their polygon's dilation:
 * the curve bulges less than a tenth of a spacing over its chord. */
TEST(rolls_over_anything) {
  enum { FINE = 32 };
  static double fine[MOST * FINE];
  aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = 2});
  for (int round = 0; round < 400; round++) {
    double z[MOST], height = pow(10, 2 * noise(&stream) - 1), walk = 0, steepest = 0;
    size_t longest = round % 9 ? 60 : MOST - 3;
    size_t n = 3 + (size_t)((double)longest * aspi_stream_uniform(&stream)),
           parts = 1 + 3 * (size_t)(round % 2);
    bool periodic = round % 8 < 4;
    for (size_t i = 0; i < n; i++) {
      walk += noise(&stream);
      double shape[] = {walk, noise(&stream), floor(3 * noise(&stream)),
                        noise(&stream) > 0.8 ? 1 : 0};
      z[i] = height * shape[round / 2 % 4];
    }
    size_t all = periodic ? n * FINE : (n - 1) * FINE + 1;
    for (size_t i = 0; i < all; i++) {
      double t = (double)(i % FINE) / FINE, rise = z[(i / FINE + 1) % n] - z[i / FINE];
      fine[i] = z[i / FINE] + t * rise;
      steepest = fmax(steepest, t > 0 ? fabs(rise) : 0);
    }
    double d_p = fmax(1, (double)(n - 1) * pow(aspi_stream_uniform(&stream), 2));
    asp_heights *p = asp_heights_create(z, n, 1, 1, 1, periodic, NULL);
    asp_heights *rolled = aspi_profile_rolled(p, d_p, (int)parts, NULL);
    assert_int_equal(rolled->columns, (all - 1) / FINE * parts + (periodic ? parts : 1));
    for (size_t i = 0; i < rolled->columns; i++)
      assert_near(rolled->z[i],
                  by_definition(fine, (ptrdiff_t)all, 1. / FINE, periodic, d_p / 2,
                                (ptrdiff_t)(i * FINE / parts)),
                  0.11 + steepest / FINE);
    asp_heights_free(rolled);
    asp_heights_free(p);
  }
}

/* A disc much wider than the spacing touches a profile of sharp bends at points only: there its
 * path is the dilation of the points, to rounding, however wide it is. */
TEST(wide_discs_rest_on_points) {
  enum { N = 600, SHAPES = 4 };
  static const double diameters[] = {20, 300, 1000, 9000, 40000};
  aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = 4});
  for (int round = 0; round < 2 * SHAPES; round++) {
    double z[N];
    for (int i = 0; i < N; i++) {
      double upright = i % 2 ? 1 : -1,
             shape[SHAPES] = {upright * (1 + noise(&stream)), 10 * sin(0.03 * i) + 3 * upright,
                              floor(3 * noise(&stream)), i == 77 ? 5 : 0};
      z[i] = shape[round / 2];
    }
    asp_heights *p = asp_heights_create(z, N, 1, 1, 1, round % 2, NULL);
    for (size_t k = 0; k < sizeof diameters / sizeof *diameters; k++) {
      double r = diameters[k] / 2;
      asp_heights *path = aspi_profile_rolled(p, diameters[k], 1, NULL);
      for (ptrdiff_t i = 0; i < N; i += 7)
        assert_near(path->z[i], by_definition(z, N, 1, round % 2, r, i), 1e-12 * r);
      asp_heights_free(path);
    }
    asp_heights_free(p);
  }
}

/* The path of a disc's center over a smooth profile, from few points, against the dilation of the
 * same profile by many: no slopes that crowd at multiples of the spacing. */
TEST(discs_roll_over_curves) {
  enum { N = 512, FINE = 64 };
  double *z = malloc(N * FINE * sizeof *z), off = 0;
  for (int i = 0; i < N * FINE; i++) {
    double x = 2 * ASP_PI * i / (N * FINE);
    z[i] = 0.0016 * sin(17 * x) + 0.0008 * cos(31 * x + 1) + 0.0004 * sin(43 * x);
  }
  double few[N];
  for (int i = 0; i < N; i++)
    few[i] = z[i * FINE];
  asp_heights *coarse = asp_heights_create(few, N, 1, 1. / N, 1. / N, true, NULL);
  for (double d_p = 0.002; d_p < 1; d_p *= 3) {
    asp_heights *rolled = aspi_profile_rolled(coarse, d_p, 1, NULL);
    for (int i = 0; i < N; i += 3)
      off = fmax(off, fabs(rolled->z[i] -
                           by_definition(z, N * FINE, 1. / (N * FINE), true, d_p / 2, i * FINE)));
    asp_heights_free(rolled);
  }
  print_message("rolled, off by %.2g of a height of 0.0016\n", off);
  assert_true(off < 2e-5);
  asp_heights_free(coarse);
  free(z);
}

TEST(ends_wrap_or_mirror) {
  double z[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 5};
  for (int periodic = 0; periodic < 2; periodic++) {
    asp_heights *p = asp_heights_create(z, 10, 1, 1, 1, periodic, NULL);
    asp_heights *path = aspi_profile_rolled(p, 4, 1, NULL);
    assert_near(path->z[0], periodic ? 5 + sqrt(3) : 2, 1e-12);
    asp_heights_free(path);
    asp_heights_free(p);
  }
}

/* A closing fills valleys only, a second one changes hardly anything, and its slopes are those of
 * the path under a uniform center. */
TEST(closing_is_a_closing) {
  enum { N = 40000 };
  double below = 0, off = 0;
  asp_heights *p = aspi_profile_generate(0.2, 1, 0.01, N, 3, NULL);
  asp_heights *closed = aspi_profile_closed(p, 2, NULL);
  asp_heights *twice = aspi_profile_closed(closed, 2, NULL);
  for (int i = 0; i < N; i++) {
    below = fmax(below, p->z[i] - closed->z[i]);
    off = fmax(off, fabs(closed->z[i] - twice->z[i]));
  }
  print_message("closed, below the profile by %.2g, a second time off by %.2g\n", below, off);
  assert_true(below < 1e-3 && off < 1e-3); /* a tenth of a spacing */
  aspi_slopes a, b;
  aspi_profile_describe_slopes(p, 2, &a, NULL);
  aspi_profile_describe_slopes(closed, 0.01, &b, NULL);
  assert_near(a.slope.sd, b.slope.sd, 0.003 * a.slope.sd);
  assert_near(a.slope.skewness, b.slope.skewness, 0.01);
  assert_near(a.slope.kurtosis, b.slope.kurtosis, 0.02);
  asp_heights_free(p);
  asp_heights_free(closed);
  asp_heights_free(twice);
}

TEST(bad_diameters_are_named) {
  double z[5] = {0, 1, 0, 2, 0};
  asp_heights *p = asp_heights_create(z, 5, 1, 1, 1, true, NULL);
  static const double bad[] = {-1, 0, NAN, INFINITY, 5.5};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    asp_error error;
    assert_null(aspi_profile_path(p, bad[i], 1000, &error));
    assert_int_equal(error.code, ASP_EARG);
    assert_says(error.text, "d_p is");
  }
  asp_heights_free(p);
}
