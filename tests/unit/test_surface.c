/* The size law against the numbers it was derived with, and its limits. */
#include "check.h"

static void numbers_of_the_wall(void **state) {
  (void)state;
  asp_surface *s = asp_surface_create(5e-6, 40e-6, NULL);
  assert_non_null(s);
  assert_near(asp_surface_phi_r(s), 0.125, 1e-15);
  assert_near(asp_surface_slope_rms(s), 0.125 * sqrt(2), 1e-15);
  assert_near(asp_surface_kappa(s, 55e-6), sqrt(3) * 55 * 5 / 1600., 1e-12);
  asp_surface_free(s);
}

/* The profile column of the table that the closed form was fitted to (same run as the sphere's). */
static void size_law_agrees_with_traced_profiles(void **state) {
  (void)state;
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
static void no_step_where_the_filter_begins(void **state) {
  (void)state;
  asp_surface *s = asp_surface_create(1, 10, NULL);
  double previous = asp_surface_slope(s, 0);
  for (double d_p = 0; d_p < 100; d_p += 0.01) {
    double slope = asp_surface_slope(s, d_p);
    assert_true(slope <= previous && previous - slope < 1e-4 * previous);
    previous = slope;
  }
  asp_surface_free(s);
}

static void bad_numbers_are_named(void **state) {
  (void)state;
  asp_error error;
  static const double bad[] = {0, -1, NAN, INFINITY, -INFINITY};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    assert_null(asp_surface_create(bad[i], 1, &error));
    assert_int_equal(error.code, ASP_EARG);
    assert_non_null(strstr(error.text, "r_q"));
    assert_null(asp_surface_create(1, bad[i], &error));
    assert_non_null(strstr(error.text, "lambda_c"));
    assert_non_null(strstr(error.text, "> 0"));
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(numbers_of_the_wall),
      cmocka_unit_test(size_law_agrees_with_traced_profiles),
      cmocka_unit_test(no_step_where_the_filter_begins),
      cmocka_unit_test(bad_numbers_are_named),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
