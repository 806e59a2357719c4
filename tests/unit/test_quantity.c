/* Numbers with units, and their text.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"
#include "base/units.h"
#include "check.h"

#include <stdlib.h>

static const asp_units si = {"SI", 1, 1, 1, {0}}, cgs = {"'units cgs'", 1e2, 1e3, 1, {0}};

static double read(const char *text, const char *kind, const asp_units *units) {
  double value;
  asp_error error = {.code = ASP_OK};
  if (aspi_quantity_read("it", text, kind, units, &value, &error))
    print_error("%s\n", error.text);
  assert_int_equal(error.code, ASP_OK);
  return value;
}

TEST(units_are_powers_of_ten) {
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

TEST(unknown_units_are_listed) {
  asp_error error;
  double value;
  assert_int_equal(aspi_quantity_read("--dp", "5parsec", "length", &si, &value, &error), ASP_EARG);
  assert_string_equal(error.text, "--dp is '5parsec'; its unit must be one of: m cm mm um nm");
  assert_int_equal(aspi_quantity_read("--speed", "5um", "speed", &si, &value, &error), ASP_EARG);
  assert_says(error.text, "m/s cm/s mm/s km/s");
  assert_int_equal(aspi_quantity_read("friction", "40%", "", &si, &value, &error), ASP_EARG);
  assert_int_equal(aspi_quantity_read("friction", "5um", "", &si, &value, &error), ASP_EARG);
  assert_string_equal(error.text, "friction is '5um'; it must be a number");
  assert_int_equal(aspi_quantity_read("--dp", "um", "length", &si, &value, &error), ASP_EARG);
}

/* What is printed reads as the same number, and is as short as 15 digits allow. */
TEST(numbers_go_round) {
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
