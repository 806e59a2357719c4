/* The size law against the numbers it was derived with, and its limits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* feenableexcept */
#include <fenv.h>

#include "check.h"
#include "surface/describe.h"
#include "surface/instrument.h"
#include "surface/size_law.h"
#include "surface/slopes.h"

TEST(numbers_of_the_wall) {
  asp_surface *s = asp_surface_create(5e-6, 40e-6, NULL);
  assert_non_null(s);
  assert_near(asp_surface_phi_r(s), 0.125, 1e-15);
  assert_near(asp_surface_slope_rms(s), 0.125 * sqrt(2), 1e-15);
  assert_near(asp_surface_kappa(s, 55e-6), sqrt(3) * 55 * 5 / 1600., 1e-12);
  asp_surface_free(s);
}

/* The profile column of the table that the closed form was fitted to (same run as the sphere's). */
TEST(size_law_agrees_with_traced_profiles) {
  static const double table[][2] = {{0.25, 0.999}, {0.5, 0.986}, {0.75, 0.940}, {1, 0.883},
                                    {1.5, 0.777},  {2, 0.696},   {3, 0.584},    {4, 0.511},
                                    {6, 0.418},    {8, 0.362},   {12, 0.292},   {16, 0.250}};
  asp_surface *s = asp_surface_create(0.04, 1, NULL);
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    double d_p = table[i][0] / asp_surface_kappa(s, 1);
    assert_near(asp_surface_slope(s, d_p) / asp_surface_slope_rms(s), table[i][1],
                0.03 * table[i][1]);
  }
  asp_surface_free(s);
}

/* Leaving the filter out under a small kappa must not show as a step. */
TEST(no_step_where_the_filter_begins) {
  asp_surface *s = asp_surface_create(1, 10, NULL);
  double previous = asp_surface_slope(s, 0);
  for (double d_p = 0; d_p < 100; d_p += 0.01) {
    double slope = asp_surface_slope(s, d_p);
    assert_true(slope <= previous && previous - slope < 1e-4 * previous);
    previous = slope;
  }
  asp_surface_free(s);
}

/* A generated profile gives back R_q and lambda_c by what an instrument finds on it. */
TEST(instruments_numbers_come_back) {
  enum { POINTS = 1 << 20, PER_LAMBDA = 32 };
  const double r_q = 5, lambda_c = 40, spacing = lambda_c / PER_LAMBDA;
  asp_heights *profile = aspi_profile_generate(r_q, lambda_c, spacing, POINTS, 3, NULL);
  const double *z = profile->z;
  double r_a = 0, slope = 0, product = 0, square = 0;
  const int lag = (int)lround(sqrt(log(5)) * PER_LAMBDA);
  for (int i = 0; i + lag < POINTS; i++) {
    r_a += fabs(z[i]) / (POINTS - lag);
    slope += pow((z[i + 1] - z[i]) / spacing, 2) / (POINTS - lag);
    product += z[i] * z[i + lag];
    square += z[i] * z[i];
  }
  assert_near(aspi_r_q_of_r_a(r_a), r_q, 0.01 * r_q);
  assert_near(aspi_lambda_of_r_dq(r_q, sqrt(slope)), lambda_c, 0.01 * lambda_c);
  assert_near(aspi_lambda_of_s_dq(r_q, sqrt(2 * slope)), lambda_c, 0.01 * lambda_c);
  assert_near(product / square, 0.2, 0.01);
  assert_near(aspi_lambda_of_s_al(lag * spacing), lambda_c, 0.02 * lambda_c);
  asp_heights_free(profile);
}

/* R_Sm as another program counted it at cut-offs of 0.25, 0.8 and 2.5 mm, and back. */
TEST(mean_spacings_come_back) {
  static const double counted[][2] = {{0.25e-3, 5.6}, {0.8e-3, 6.6}, {2.5e-3, 7.3}};
  for (int i = 0; i < 3; i++) {
    double lambda_c = 40e-6, factor = aspi_r_sm_factor(counted[i][0] / lambda_c);
    assert_near(factor, counted[i][1], 0.015 * counted[i][1]);
    assert_near(aspi_lambda_of_r_sm(factor * lambda_c, counted[i][0]), lambda_c, 1e-9 * lambda_c);
  }
  for (double ratio = ASPI_RSM_LEAST; ratio <= ASPI_RSM_MOST; ratio *= 1.1)
    assert_near(aspi_lambda_of_r_sm(aspi_r_sm_factor(ratio), ratio), 1, 1e-9);
  assert_true(isnan(aspi_lambda_of_r_sm(1.3, 1)) && isnan(aspi_lambda_of_r_sm(0.11, 1)));
}

TEST(bad_numbers_are_named) {
  asp_error error;
  static const double bad[] = {0, -1, NAN, INFINITY, -INFINITY};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    assert_null(asp_surface_create(bad[i], 1, &error));
    assert_int_equal(error.code, ASP_EARG);
    assert_says(error.text, "r_q");
    assert_null(asp_surface_create(1, bad[i], &error));
    assert_says(error.text, "lambda_c");
    assert_says(error.text, "> 0");
  }
}

/* Where the table takes over from the closed form, and between its rows and columns. */
TEST(no_step_where_the_table_begins) {
  for (double d_p = 0.05; d_p < 40; d_p *= 1.3) {
    asp_surface *below = asp_surface_create(0.25, 1, NULL);
    asp_surface *above = asp_surface_create(0.25 * (1 + 1e-6), 1, NULL);
    assert_near(asp_surface_slope(below, d_p), asp_surface_slope(above, d_p), 1e-5);
    asp_surface_free(below);
    asp_surface_free(above);
  }
  for (double phi_r = 0.26; phi_r < 1; phi_r += 0.07) {
    asp_surface *s = asp_surface_create(phi_r, 1, NULL);
    double previous = asp_surface_slope(s, 0);
    assert_near(previous, sqrt(2) * phi_r, 1e-12);
    for (double d_p = 0.03; d_p < 40; d_p *= 1.003) {
      double slope = asp_surface_slope(s, d_p);
      assert_true(slope <= previous * (1 + 2e-4) && previous - slope < 0.01 * previous);
      previous = slope;
    }
    asp_surface_free(s);
  }
}

/* Contact gradients of dilated isotropic surfaces, made outside this project's code (+-0.4 %). */
TEST(sphere_finds_less_slope) {
  static const double known[][2] = {{0.5, 0.988}, {0.75, 0.937}, {1, 0.873}, {1.5, 0.756},
                                    {2, 0.669},   {3, 0.551},    {4, 0.476}, {8, 0.325}};
  asp_surface *s = asp_surface_create(0.04, 1, NULL);
  double slope[2];
  for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
    double d_p = known[i][0] / asp_surface_kappa(s, 1);
    aspi_surface_sphere_slopes(s, d_p, slope);
    assert_near(slope[0] / asp_surface_slope_rms(s), known[i][1],
                (known[i][0] > 4 ? 0.045 : 0.015) * known[i][1]);
    assert_near(slope[1], slope[0], 0);
    assert_true(slope[0] < asp_surface_slope(s, d_p));
  }
  aspi_surface_sphere_slopes(s, 0, slope);
  assert_near(slope[0], asp_surface_slope_rms(s), 1e-12);
  asp_surface_free(s);
}

/* A lay: each axis has its own slope and curvature; with a long way along the lay the sphere is the
 * disc across it; and which length is named first does not matter. */
TEST(lays_have_two_slopes) {
  asp_surface *s = asp_surface_create_lay(5, 40, 200, NULL),
              *turned = asp_surface_create_lay(5, 200, 40, NULL),
              *grooves = asp_surface_create_lay(5, 40, 4e6, NULL);
  double d_p = 185, slope[2], other[2];
  double k1 = sqrt(3) * d_p * 5 / 1600, k2 = sqrt(3) * d_p * 5 / 40000;
  aspi_surface_sphere_slopes(s, d_p, slope);
  assert_near(slope[0], sqrt(2) / 8 * pow(1 + k1 * k1 * (0.92 * k1 + 0.37 * k2), -1. / 6), 1e-12);
  assert_near(slope[1], sqrt(2) / 40 * pow(1 + k2 * k2 * (0.92 * k2 + 0.37 * k1), -1. / 6), 1e-12);
  aspi_surface_sphere_slopes(turned, d_p, other);
  assert_near(other[0], slope[1], 1e-12);
  assert_near(other[1], slope[0], 1e-12);
  aspi_surface_sphere_slopes(grooves, d_p, other);
  assert_near(other[0], asp_surface_slope(grooves, d_p), 1e-9);
  assert_near(asp_surface_slope(s, d_p), asp_surface_slope(grooves, d_p), 0);
  assert_near(asp_surface_lambda_along(s), 200, 0);
  asp_surface_free(s);
  asp_surface_free(turned);
  asp_surface_free(grooves);
  asp_error error;
  assert_null(asp_surface_create_lay(5, 40, 0, &error));
  assert_says(error.text, "along the lay");
  assert_null(asp_surface_create_lay(5, 40, 10, &error));
  assert_int_equal(error.code, ASP_ERANGE);
}

/* Outside the tables there is an error, never a silent number. */
TEST(ends_of_the_tables_are_errors) {
  asp_error error;
  assert_null(asp_surface_create(1.01, 1, &error));
  assert_int_equal(error.code, ASP_ERANGE);
  assert_says(error.text, "ratio");
  assert_null(asp_surface_create_lay(0.26, 1, 3, &error));
  assert_int_equal(error.code, ASP_ERANGE);
  asp_surface *walls[] = {asp_surface_create(0.1, 1, NULL), asp_surface_create(0.5, 1, NULL),
                          asp_surface_create_lay(0.1, 2, 1, NULL)};
  static const double kappa_most[] = {64, 32 * 0.5 * 1.7320508075688772, 16};
  for (int i = 0; i < 3; i++) {
    double most = kappa_most[i] / asp_surface_kappa(walls[i], 1);
    assert_int_equal(asp_surface_check(walls[i], most, &error), ASP_OK);
    assert_int_equal(asp_surface_check(walls[i], 1.001 * most, &error), ASP_ERANGE);
    assert_says(error.text, "d_p is");
    assert_int_equal(asp_surface_check(walls[i], NAN, &error), ASP_ERANGE);
    asp_surface_free(walls[i]);
  }
}

/* A wall by its profile has the profile's own slopes at its bins, and goes from one to the next
 * without a turn. */
TEST(profile_wall_has_the_profiles_slopes) {
  enum { BINS = 12 };
  asp_heights *p = aspi_profile_generate(0.3, 1, 0.01, 20000, 3, NULL);
  asp_surface *s = asp_surface_create_profile(p, 0.02, 20, BINS, NULL);
  assert_non_null(s);
  assert_int_equal(asp_surface_bins(s), BINS);
  assert_near(asp_surface_bin_d_p(s, 0), 0.02, 1e-12);
  assert_near(asp_surface_bin_d_p(s, BINS - 1), 20, 1e-9);
  for (int i = 0; i < BINS; i++) {
    aspi_slopes slopes;
    double d_p = asp_surface_bin_d_p(s, i);
    aspi_profile_describe_slopes(p, fmin(d_p, 20), &slopes, NULL);
    assert_near(asp_surface_slope(s, d_p), slopes.slope_rms, 1e-9);
    assert_near(asp_surface_slope(s, asp_surface_bin_d_p(s, i)), slopes.slope_rms, 1e-9);
  }
  double previous = asp_surface_slope(s, 0);
  for (double d_p = 0.01; d_p < 30; d_p *= 1.01) {
    double slope = asp_surface_slope(s, d_p);
    assert_true(slope <= previous + 1e-5); /* what sampled slopes differ by */
    previous = slope;
  }
  assert_near(asp_surface_slope(s, 1e-3), asp_surface_slope(s, asp_surface_bin_d_p(s, 0)), 1e-12);
  assert_near(asp_surface_slope(s, 1e3), asp_surface_slope(s, asp_surface_bin_d_p(s, BINS - 1)),
              1e-12);
  asp_heights_numbers d;
  asp_heights_describe(p, &d, NULL);
  assert_near(asp_surface_r_q(s), d.s_q, 0);
  assert_near(asp_surface_phi_r(s), d.s_q / d.lambda_1, 1e-15);
  asp_surface_free(s);
  s = asp_surface_create_profile(p, 1, 4, 1, NULL);
  assert_near(asp_surface_bin_d_p(s, 0), 2, 1e-12);
  assert_near(asp_surface_slope(s, 9), asp_surface_slope(s, 0.1), 0);
  asp_surface_free(s);
  asp_heights_free(p);
}

TEST(bad_bins_are_named) {
  asp_error error;
  asp_heights *p = aspi_profile_generate(0.3, 1, 0.1, 2000, 3, NULL);
  assert_null(asp_surface_create_profile(p, 0.05, 1, 10, &error));
  assert_says(error.text, "allow 0.1 to 200");
  assert_null(asp_surface_create_profile(p, 0.5, 300, 10, &error));
  assert_says(error.text, "is 0.5 to 300");
  assert_null(asp_surface_create_profile(p, -1, 1, 10, &error));
  assert_null(asp_surface_create_profile(p, 1, 0.5, 10, &error));
  assert_null(asp_surface_create_profile(p, 0.5, 1, 0, &error));
  assert_says(error.text, "bins are 0");
  assert_int_equal(error.code, ASP_EARG);
  asp_heights_free(p);
}

/* Lengths over 200 decades, and denormal ones: a wall whose numbers are numbers, or none. */
TEST(lengths_are_numbers_or_refused) {
  static const double lengths[] = {5e-324, 1e-320, 2.2e-308, 1e-200, 1e-101, 1e-100, 1e-50,
                                   1,      1e50,   1e100,    1e101,  1e300,  1.7e308};
  enum { N = sizeof lengths / sizeof *lengths };
  int walls = 0;
  for (int lay = 0; lay < 2; lay++)
    for (int i = 0; i < N; i++)
      for (int k = 0; k < N; k++) {
        asp_error error = {.code = ASP_OK};
        asp_surface *s =
            lay ? asp_surface_create_lay(lengths[i], lengths[k], 3 * lengths[k], &error)
                : asp_surface_create(lengths[i], lengths[k], &error);
        if (!s) {
          assert_true(error.code == ASP_EARG || error.code == ASP_ERANGE);
          continue;
        }
        walls++;
        double most = 64 / asp_surface_kappa(s, 1),
               sizes[] = {0, 5e-324, 1e-310, 1e-100, 1e-3 * most, most};
        assert_true(isfinite(most) && most > 0);
        for (size_t n = 0; n < sizeof sizes / sizeof *sizes; n++) {
          double slope = asp_surface_slope(s, sizes[n]);
          assert_true(slope >= 0 && slope <= asp_surface_slope_rms(s) * (1 + 1e-12));
          assert_true(asp_surface_kappa(s, sizes[n]) >= 0);
        }
        asp_surface_free(s);
      }
  assert_true(walls > 20);
}

/* No division by zero or invalid operation on the way to a slope, for a program that traps them. */
TEST(slopes_raise_no_trap) {
  asp_heights *p = aspi_profile_generate(0.3, 1, 0.1, 2000, 3, NULL);
  asp_surface *walls[] = {asp_surface_create(0.1, 1, NULL),
                          asp_surface_create(0.25, 1, NULL),
                          asp_surface_create(0.6, 1, NULL),
                          asp_surface_create(1, 1, NULL),
                          asp_surface_create_lay(0.1, 1, 5, NULL),
                          asp_surface_create_profile(p, 1, 4, 5, NULL),
                          asp_surface_create_profile(p, 1, 4, 1, NULL)};
  static const double sizes[] = {0, 5e-324, 1e-300, 1e-9, 0.02, 1, 3, 1e3, 1e300};
  double sum = 0, both[2];
  feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(FE_DIVBYZERO | FE_INVALID);
  for (size_t w = 0; w < sizeof walls / sizeof *walls; w++)
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
      aspi_surface_sphere_slopes(walls[w], sizes[i], both);
      sum += asp_surface_slope(walls[w], sizes[i]) + both[0] + both[1];
    }
  fedisableexcept(FE_ALL_EXCEPT);
  assert_true(sum > 0);
  for (size_t w = 0; w < sizeof walls / sizeof *walls; w++)
    asp_surface_free(walls[w]);
  asp_heights_free(p);
}

/* A wall by its slope alone has no height, and a length only if that is given. */
TEST(slope_alone) {
  for (int i = 0; i < 2; i++) {
    asp_wall *wall = asp_wall_from_text(i ? "surface sigma 45 lambda_c 40um rebound constant 1 1"
                                          : "surface sigma 45 rebound constant 1 1",
                                        0, 0, NULL);
    const asp_surface *s = asp_wall_surface(wall);
    assert_true(isnan(asp_surface_r_q(s)));
    assert_near(asp_surface_phi_r(s), sqrt(0.5), 1e-15);
    assert_near(asp_surface_kappa(s, 1), 0, 0);
    for (double d = 1e-9; d < 10; d *= 10)
      assert_near(asp_wall_slope(wall, d), 1, 1e-15);
    assert_true(i ? fabs(asp_surface_lambda_c(s) - 40e-6) < 1e-18 : isnan(asp_surface_lambda_c(s)));
    assert_near(asp_surface_face_length(s, 1e-3), i ? 40e-6 * M_PI / sqrt(2) : 1e-3, 1e-15);
    asp_wall_free(wall);
  }
}

/* Between two rows of the table, at its sizes, the ratio to the closed form is the mean of theirs.
 */
TEST(rows_of_the_table_are_joined_by_lines) {
  double over[3];
  for (int i = 0; i < 3; i++) {
    asp_surface *s = asp_surface_create(0.45 + 0.025 * i, 1, NULL);
    over[i] = asp_surface_slope(s, 4) / asp_surface_slope_rms(s) /
              aspi_closed_form(asp_surface_kappa(s, 4));
    asp_surface_free(s);
  }
  assert_near(over[1], 0.5 * (over[0] + over[2]), 1e-12);
  assert_true(fabs(over[2] - over[0]) > 1e-3);
}

/* A sphere meets the slope of a wall by its words; the words come back from that slope. */
TEST(words_of_a_slope_come_back) {
  const char *text = "surface rq 5um rdq 0.3 rebound walton 0.5 0.3 0 deposit off";
  asp_wall *wall = asp_wall_from_text(text, 1e-6, 1e-4, NULL);
  for (double d_p = 1e-6; d_p < 2e-4; d_p *= 10)
    assert_near(aspi_r_dq_met(5e-6, d_p, asp_wall_slope(wall, d_p)), 0.3, 1e-6);
  assert_true(isnan(aspi_r_dq_met(5e-6, 1e-3, 1))); /* too large for a slope of 1 */
  asp_wall_free(wall);
}
