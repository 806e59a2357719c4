/* Numbers in text against the C library's `%.*g`, to the last character.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"

#include "check.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t next(void) {
  static uint64_t state = 2463534242;
  state = state * 6364136223846793005ULL + 1442695040888963407ULL;
  return state ^ state >> 29;
}

static void check(double value) {
  for (int digits = 6; digits <= 16; digits += 1 + (digits > 6) * 2) {
    char ours[ASPI_NUMBER_MOST + 1], theirs[ASPI_NUMBER_MOST + 1];
    *aspi_number_format(value, digits, ours) = '\0';
    snprintf(theirs, sizeof theirs, "%.*g", digits, value);
    assert_string_equal(ours, theirs);
  }
}

TEST(any_bits) {
  for (int i = 0; i < 60000; i++) {
    uint64_t bits = next();
    double value;
    memcpy(&value, &bits, sizeof value);
    check(value);
  }
}

TEST(usual_magnitudes) {
  for (int i = 0; i < 100000; i++) {
    double value = pow(10, -20 + 60 * (double)(next() >> 11) / 9007199254740992.0);
    check(i % 2 ? value : -value);
  }
}

/* Decimals of ten digits, those half-way between two, and their neighbors. */
TEST(ties) {
  for (int exponent = -30; exponent <= 30; exponent++)
    for (int i = 0; i < 2000; i++) {
      char decimal[40];
      snprintf(decimal, sizeof decimal, "%llu%se%d", (unsigned long long)(next() % 10000000000),
               i % 2 ? "5" : "", exponent);
      double value = strtod(decimal, NULL);
      check(value);
      check(nextafter(value, 0));
      check(nextafter(value, HUGE_VAL));
    }
  for (int k = 1; k < 4096; k++) /* ties that a double holds exactly */
    check(123456789 + k / 4096. * 16);
}

TEST(special) {
  double values[] = {0.,           -0.,          1.,           0.5,   1e-4,   9.9999999999e-5,
                     99999.999995, 9999999999.4, 9999999999.5, 1e10,  1e22,   1e23,
                     1e36,         1e37,         1e-18,        1e-19, 5e-324, 1.7e308,
                     HUGE_VAL,     -HUGE_VAL,    NAN};
  for (size_t i = 0; i < sizeof values / sizeof *values; i++)
    check(values[i]);
  for (int e = -40; e <= 40; e++) {
    double value = strtod((char[]){'1', 'e', e < 0 ? '-' : '+', (char)('0' + abs(e) / 10),
                                   (char)('0' + abs(e) % 10), 0},
                          NULL);
    check(value);
    check(nextafter(value, 0));
    check(nextafter(value, HUGE_VAL));
  }
}
