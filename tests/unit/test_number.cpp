/* The ledger's numbers against the C library's `%.10g`, to the last character.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/number.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <random>
extern "C" {
#include <cmocka.h>
}

using namespace asperity;

static void check(double value) {
  char ours[NUMBER_MOST + 1] = "", theirs[NUMBER_MOST + 1];
  *print_number(value, ours) = '\0';
  snprintf(theirs, sizeof theirs, "%.10g", value);
  assert_string_equal(ours, theirs);
}

static void any_bits(void **) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 500000; i++) {
    const uint64_t bits = random();
    double value;
    memcpy(&value, &bits, sizeof value);
    check(value);
  }
}

static void usual_magnitudes(void **) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(-20, 40);
  for (int i = 0; i < 500000; i++) {
    const double value = pow(10, exponent(random));
    check(i % 2 ? value : -value);
  }
}

/* Decimals of ten digits, those half-way between two, and their neighbors. */
static void ties(void **) {
  std::mt19937_64 random(3);
  for (int exponent = -30; exponent <= 30; exponent++)
    for (int i = 0; i < 4000; i++) {
      char decimal[40];
      snprintf(decimal, sizeof decimal, "%llu%se%d",
               static_cast<unsigned long long>(random() % 10000000000), i % 2 ? "5" : "", exponent);
      const double value = strtod(decimal, NULL);
      check(value);
      check(nextafter(value, 0));
      check(nextafter(value, HUGE_VAL));
    }
  for (int k = 1; k < 4096; k++) /* ties that a double holds exactly */
    check(123456789 + k / 4096. * 16);
}

static void special(void **) {
  for (double value :
       {0., -0., 1., 0.5, 1e-4, 9.9999999999e-5, 99999.999995, 9999999999.4, 9999999999.5, 1e10,
        1e36, 1e37, 1e-18, 1e-19, 5e-324, 1.7e308, HUGE_VAL, -HUGE_VAL, static_cast<double>(NAN)})
    check(value);
}

static void counts(void **) {
  for (long long value :
       {0LL, 9LL, 10LL, 2147483647LL, -1LL, 9223372036854775807LL, -9223372036854775807LL - 1}) {
    char ours[NUMBER_MOST + 1] = "", theirs[NUMBER_MOST + 1];
    *print_count(value, ours) = '\0';
    snprintf(theirs, sizeof theirs, "%lld", value);
    assert_string_equal(ours, theirs);
  }
}

static void reading(void **) {
  for (const char *number :
       {"0", "-0.1", "+2.5e-3", "1E5", "5e-324", "0.30000000000000004", "nan"}) {
    double value = 7;
    assert_true(read_number(number, number + strlen(number), value));
    const double theirs = strtod(number, NULL);
    assert_true(value == theirs || (isnan(value) && isnan(theirs)));
  }
  for (const char *other : {"", "1,5", "here", "1.0x", "--1"}) {
    double value;
    assert_false(read_number(other, other + strlen(other), value));
  }
}

int main() {
  const struct CMUnitTest tests[] = {cmocka_unit_test(any_bits), cmocka_unit_test(usual_magnitudes),
                                     cmocka_unit_test(ties),     cmocka_unit_test(special),
                                     cmocka_unit_test(counts),   cmocka_unit_test(reading)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
