/* Numbers with units, their text, and lists of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/list.h"
#include "base/number.h"
#include "base/quantity.h"
#include "check.h"

#include <stdlib.h>

static const asp_units si = {"SI", 1, 1, 1}, cgs = {"'units cgs'", 1e2, 1e3, 1};

static double read(const char *text, const char *kind, const asp_units *units) {
  double value;
  asp_error error = {ASP_OK, ""};
  if (aspi_quantity_read("it", text, kind, units, &value, &error))
    print_error("%s\n", error.text);
  assert_int_equal(error.code, ASP_OK);
  return value;
}

static void units_are_powers_of_ten(void **state) {
  (void)state;
  assert_near(read("15.6um", "length", &si), 15.6e-6, 0);
  assert_near(read("1.56e1um", "length", &si), 15.6e-6, 0);
  assert_near(read("-3\xC2\xB5m", "length", &si), -3e-6, 0);
  assert_near(read("0.3mm", "length", &si), 0.3e-3, 0);
  assert_near(read("0.3", "length", &cgs), 0.3, 0);
  assert_near(read("0.3m", "length", &cgs), 30, 0);
  assert_near(read("120cm/s", "speed", &si), 1.2, 0);
  assert_near(read("2GPa", "stress", &cgs), 2e10, 0);
  assert_near(read("3MPa/(m/s)", "stress/speed", &si), 3e6, 0);
  assert_near(read("100mJ/m2", "energy/area", &si), 0.1, 0);
  assert_near(read("1.2g/cm3", "density", &cgs), 1.2, 1e-15);
  assert_near(read("30deg", "degrees", &si), 30, 0);
  assert_near(read("0.5rad", "degrees", &si), 90 / ASP_PI, 1e-13);
  assert_near(read("5mil", "length", &si), 127e-6, 1e-18); /* as a file's header may state it */
  assert_near(read("500C", "K", &si), 773.15, 0);
  assert_near(read("0.001/K", "1/K", &si), 1e-3, 0);
}

static void unknown_units_are_listed(void **state) {
  (void)state;
  asp_error error;
  double value;
  assert_int_equal(aspi_quantity_read("--dp", "5parsec", "length", &si, &value, &error), ASP_EARG);
  assert_string_equal(error.text, "--dp is '5parsec'; its unit must be one of: m cm mm um nm");
  assert_int_equal(aspi_quantity_read("--speed", "5um", "speed", &si, &value, &error), ASP_EARG);
  assert_non_null(strstr(error.text, "m/s cm/s mm/s km/s"));
  assert_int_equal(aspi_quantity_read("friction", "40%", "", &si, &value, &error), ASP_EARG);
  assert_int_equal(aspi_quantity_read("friction", "5um", "", &si, &value, &error), ASP_EARG);
  assert_string_equal(error.text, "friction is '5um'; it must be a number");
  assert_int_equal(aspi_quantity_read("--dp", "um", "length", &si, &value, &error), ASP_EARG);
}

/* What is printed reads as the same number, and is as short as 15 digits allow. */
static void numbers_go_round(void **state) {
  (void)state;
  char text[32], *end;
  srand(3);
  for (int i = 0; i < 10000; i++) {
    double value = ldexp(rand() / (RAND_MAX + 1.0) - 0.5, rand() % 200 - 100);
    aspi_number_print(value, text);
    assert_near(aspi_number(text, &end), value, 0);
  }
  aspi_number_print(0.1, text);
  assert_string_equal(text, "0.1");
  aspi_number_print(4294967295.0, text);
  assert_string_equal(text, "4294967295");
}

static void check_list(const char *text, const char *kind, size_t count, const double *values) {
  aspi_list list;
  asp_error error = {ASP_OK, ""};
  assert_int_equal(aspi_list_read("it", text, kind, &si, 0, 1e3, &list, &error), ASP_OK);
  assert_int_equal(list.count, count);
  for (size_t i = 0; i < count; i++)
    assert_near(list.values[i], values[i], 1e-12 * values[i]);
  aspi_list_free(&list);
}

static void lists_are_read(void **state) {
  (void)state;
  check_list("5um", "length", 1, (const double[]){5e-6});
  check_list("1um,0.01mm,3e-6", "length", 3, (const double[]){1e-6, 1e-5, 3e-6});
  check_list("5:20:5", "degrees", 4, (const double[]){5, 10, 15, 20});
  check_list("0.1:0.4:0.1", "", 4, (const double[]){0.1, 0.2, 0.3, 0.4});
  check_list("1um:3um:1um,10um", "length", 4, (const double[]){1e-6, 2e-6, 3e-6, 1e-5});
  check_list("7:7:1", "", 1, (const double[]){7});
  aspi_list list;
  assert_int_equal(
      aspi_list_read("--dp", "lognormal:1um:100um:10um", "length", &si, 0, 1, &list, NULL), ASP_OK);
  assert_int_equal(list.count, 0);
  assert_near(list.least, 1e-6, 0);
  assert_near(list.most, 100e-6, 0);
  assert_near(list.median, 10e-6, 0);
  aspi_list_free(&list);
}

static void other_forms_are_refused(void **state) {
  (void)state;
  static const char *const bad[] = {"",
                                    ",",
                                    "1,",
                                    "1,,2",
                                    "1:2",
                                    "1:2:3:4",
                                    "2:1:1",
                                    "1:2:0",
                                    "1:2:-1",
                                    "0:1:1e-9",
                                    "1;2",
                                    "1:2:",
                                    "1001",
                                    "0:1001:1",
                                    "nan",
                                    "lognormal:1:2",
                                    "lognormal:1:2:3",
                                    "lognormal:1:3:2:1",
                                    "lognormal:0:3:2",
                                    "lognormal:",
                                    "normal:1:3:2"};
  aspi_list list;
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    asp_error error = {ASP_OK, ""};
    assert_int_equal(aspi_list_read("--dp", bad[i], "", &si, 0, 1e3, &list, &error), ASP_EARG);
    assert_non_null(strstr(error.text, "--dp is "));
    assert_null(list.values);
  }
  asp_error error;
  aspi_list_read("--dp", "1:2", "", &si, 0, 1e3, &list, &error);
  assert_non_null(strstr(error.text, "a list is a,b,c or from:to:step, a log-normal law "
                                     "lognormal:min:max:median"));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(units_are_powers_of_ten), cmocka_unit_test(unknown_units_are_listed),
      cmocka_unit_test(numbers_go_round),        cmocka_unit_test(lists_are_read),
      cmocka_unit_test(other_forms_are_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
