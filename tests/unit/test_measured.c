/* The readers on instruments' files as they lie outside the source tree (ASPERITY_MEASURED_DATA);
 * registered only where those are. */
#include "check.h"

#include <stdlib.h>

static char path[4096];
static asp_error error;

static const char *file(const char *name) {
  const char *folder = getenv("ASPERITY_MEASURED_DATA");
  assert_non_null(folder);
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

/* Positions rounded to 0.1 um at a spacing of 0.156 um, Latin-1, a header of parameters, a tilt. */
static void stylus_file(void **state) {
  (void)state;
  asp_profile_report report;
  asp_profile *p = asp_profile_read(file("dektak-1.csv"), NULL, &report, &error);
  assert_non_null(p);
  assert_int_equal(asp_profile_points(p), 9600);
  assert_near(asp_profile_spacing(p), 0.15625e-6, 1e-12);
  assert_false(report.resampled);
  asp_description d;
  assert_int_equal(asp_profile_describe(p, ASP_LEVEL_1_E, &d, &error), ASP_OK);
  assert_near(d.r_q, 0.094e-6, 0.0005e-6);
  assert_near(d.lambda_c, 195e-6, 0.5e-6);
  asp_profile_free(p);
}

static void columns_without_a_unit(void **state) {
  (void)state;
  assert_null(asp_profile_read(file("xy-4.txt"), NULL, NULL, &error));
  assert_int_equal(error.code, ASP_EDATA);
  assert_non_null(strstr(error.text, "xy-4.txt:1: no unit of length is stated"));
  asp_profile_options o = asp_profile_options_default();
  o.unit_x = o.unit_z = 1e-3;
  asp_profile *p = asp_profile_read(path, &o, NULL, &error);
  assert_non_null(p);
  assert_int_equal(asp_profile_points(p), 10001);
  assert_near(asp_profile_spacing(p), 0.995613e-3 / 10000, 1e-13);
  asp_profile_free(p);
}

static void example_of_the_standard(void **state) {
  (void)state;
  asp_profile_options o = asp_profile_options_default();
  o.form = -1;
  o.row = 4;
  asp_profile *p = asp_profile_read(file("sdf-1.sdf"), &o, NULL, &error);
  assert_non_null(p);
  assert_int_equal(asp_profile_points(p), 7);
  assert_near(asp_profile_spacing(p), 1e-6, 1e-18);
  assert_near(asp_profile_heights(p)[5], 0.94907e-6, 1e-15);
  asp_profile_free(p);
  o.column = 2;
  p = asp_profile_read(path, &o, NULL, &error);
  assert_non_null(p);
  assert_int_equal(asp_profile_points(p), 4);
  assert_near(asp_profile_heights(p)[3], 0.97862e-6, 1e-15);
  asp_profile_free(p);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(stylus_file),
      cmocka_unit_test(columns_without_a_unit),
      cmocka_unit_test(example_of_the_standard),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
