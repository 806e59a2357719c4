/* The closing against the definition, point by point, and the law of slopes that comes of it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "base/stream.h"
#include "surface/closing.h"
#include "surface/heights.h"
#include "surface/slopes.h"

enum { MOST = 400 };

static double noise(aspi_stream *stream) {
  return 2 * aspi_stream_uniform(stream) - 1;
}

static ptrdiff_t continued(ptrdiff_t i, ptrdiff_t n, bool periodic) {
  if (periodic)
    return (i % n + n) % n;
  i = i < 0 ? -i : i;
  return i < n ? i : 2 * n - 2 - i;
}

/* max over j of sign z(j) + rise(i - j): dilation for sign 1, and erosion is its negative for -1.
 */
static void by_definition(const double *z, ptrdiff_t n, double spacing, bool periodic, double d_p,
                          double sign, double *out) {
  double r = d_p / 2;
  ptrdiff_t reach = (ptrdiff_t)floor(r / spacing);
  for (ptrdiff_t i = 0; i < n; i++) {
    out[i] = -INFINITY;
    for (ptrdiff_t k = -reach; k <= reach; k++) {
      double x = (double)k * spacing;
      out[i] = fmax(out[i], sign * z[continued(i + k, n, periodic)] + sqrt(r * r - x * x));
    }
    out[i] *= sign;
  }
}

static void compare(const double *z, size_t n, double spacing, bool periodic, double d_p) {
  double got[MOST], dilated[MOST], closed[MOST];
  asp_heights *p = asp_heights_create(z, n, 1, spacing, spacing, periodic, NULL);
  by_definition(z, (ptrdiff_t)n, spacing, periodic, d_p, 1, dilated);
  by_definition(dilated, (ptrdiff_t)n, spacing, periodic, d_p, -1, closed);
  assert_int_equal(aspi_profile_dilate(p, d_p, got, NULL), ASP_OK);
  for (size_t i = 0; i < n; i++)
    assert_near(got[i], dilated[i], 1e-10 * (1 + d_p));
  assert_int_equal(aspi_profile_close(p, d_p, got, NULL), ASP_OK);
  for (size_t i = 0; i < n; i++)
    assert_near(got[i], closed[i], 1e-10 * (1 + d_p));
  asp_heights_free(p);
}

/* Random walks, white noise, steps and spikes from flat to far higher than the disc. */
static void envelopes_are_those_of_the_definition(void **state) {
  (void)state;
  aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = 1});
  for (int round = 0; round < 3000; round++) {
    double z[MOST], height = pow(10, 3 * noise(&stream)), walk = 0;
    size_t n = 3 + (size_t)(60 * aspi_stream_uniform(&stream));
    double spacing = pow(10, noise(&stream));
    for (size_t i = 0; i < n; i++) {
      walk += noise(&stream);
      double shape[] = {walk, noise(&stream), floor(3 * noise(&stream)),
                        noise(&stream) > 0.8 ? 1 : 0};
      z[i] = height * shape[round % 4];
    }
    double d_p = (double)n * spacing * pow(aspi_stream_uniform(&stream), 2);
    compare(z, n, spacing, round % 8 < 4, d_p);
  }
}

/* A disc that rolls over the curve through points of any shape stays near their polygon's dilation:
 * the curve bulges less than a tenth of a spacing over its chord. */
static void rolls_over_anything(void **state) {
  (void)state;
  enum { FINE = 32 };
  static double fine[MOST * FINE], path[MOST * FINE];
  aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = 2});
  for (int round = 0; round < 2000; round++) {
    double z[MOST], height = pow(10, 2 * noise(&stream) - 1), walk = 0, steepest = 0;
    size_t n = 3 + (size_t)(60 * aspi_stream_uniform(&stream)), parts = 1 + 3 * (size_t)(round % 2);
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
    asp_heights *polygon = asp_heights_create(fine, all, 1, 1. / FINE, 1. / FINE, periodic, NULL);
    asp_heights *rolled = aspi_profile_rolled(p, d_p, (int)parts, NULL);
    assert_int_equal(aspi_profile_dilate(polygon, d_p, path, NULL), ASP_OK);
    assert_int_equal(rolled->columns, (all - 1) / FINE * parts + (periodic ? parts : 1));
    for (size_t i = 0; i < rolled->columns; i++)
      assert_near(rolled->z[i], path[i * FINE / parts], 0.11 + steepest / FINE);
    asp_heights_free(rolled);
    asp_heights_free(polygon);
    asp_heights_free(p);
  }
}

static void ends_wrap_or_mirror(void **state) {
  (void)state;
  double z[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 5}, out[10];
  asp_heights *p = asp_heights_create(z, 10, 1, 1, 1, true, NULL);
  aspi_profile_dilate(p, 4, out, NULL);
  assert_near(out[0], 5 + sqrt(3), 1e-12);
  asp_heights_free(p);
  p = asp_heights_create(z, 10, 1, 1, 1, false, NULL);
  aspi_profile_dilate(p, 4, out, NULL);
  assert_near(out[0], 2, 1e-12);
  asp_heights_free(p);
}

/* A closing fills valleys only, and a second one changes nothing. */
static void closing_is_a_closing(void **state) {
  (void)state;
  enum { N = 20000 };
  static double once[N], twice[N];
  asp_heights *p = aspi_profile_generate(0.2, 1, 0.02, N, 3, NULL);
  aspi_profile_close(p, 2, once, NULL);
  asp_heights *closed = asp_heights_create(once, N, 1, 0.02, 0.02, true, NULL);
  aspi_profile_close(closed, 2, twice, NULL);
  for (int i = 0; i < N; i++) {
    assert_true(once[i] >= p->z[i] - 1e-12);
    assert_near(once[i], twice[i], 1e-12);
  }
  asp_heights_free(p);
  asp_heights_free(closed);
}

/* The slopes of the dilation under a uniform center and those of the closing are one law. */
static void dilation_and_closing_have_the_same_slopes(void **state) {
  (void)state;
  static const double cases[][2] = {{0.1, 1}, {0.2, 1}, {0.2, 4}};
  for (int i = 0; i < 3; i++) {
    enum { POINTS = 131072 };
    static double heights[POINTS];
    asp_heights *p = aspi_profile_generate(cases[i][0], 1, 1. / 128, POINTS, 5, NULL);
    aspi_slopes a, b;
    aspi_profile_describe_slopes(p, cases[i][1], ASP_CONTACT_DILATION, &a, NULL);
    aspi_profile_close(p, cases[i][1], heights, NULL);
    asp_heights *closed = asp_heights_create(heights, POINTS, 1, 1. / 128, 1. / 128, true, NULL);
    aspi_profile_describe_slopes(closed, 1e-6, ASP_CONTACT_DILATION, &b, NULL);
    asp_heights_free(closed);
    assert_near(a.slope.sd, b.slope.sd, 0.003 * a.slope.sd);
    assert_near(a.angle.sd, b.angle.sd, 0.003 * a.angle.sd);
    assert_near(a.slope.skewness, b.slope.skewness, 0.01);
    assert_near(a.slope.kurtosis, b.slope.kurtosis, 0.02);
    asp_heights_free(p);
  }
}

static void bad_diameters_are_named(void **state) {
  (void)state;
  double z[5] = {0, 1, 0, 2, 0}, out[5];
  asp_heights *p = asp_heights_create(z, 5, 1, 1, 1, true, NULL);
  static const double bad[] = {-1, 0, NAN, INFINITY, 5.5};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    asp_error error;
    assert_int_equal(aspi_profile_dilate(p, bad[i], out, &error), ASP_EARG);
    assert_non_null(strstr(error.text, "d_p is"));
    assert_int_equal(aspi_profile_close(p, bad[i], out, &error), ASP_EARG);
  }
  asp_heights_free(p);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(envelopes_are_those_of_the_definition),
      cmocka_unit_test(rolls_over_anything),
      cmocka_unit_test(ends_wrap_or_mirror),
      cmocka_unit_test(closing_is_a_closing),
      cmocka_unit_test(dilation_and_closing_have_the_same_slopes),
      cmocka_unit_test(bad_diameters_are_named),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
