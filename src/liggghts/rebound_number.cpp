/* Numbers in ten digits; see rebound_number.h. A double times a power of ten that a long double
 * holds exactly is right to half a unit of the long double's last place, so its ten digits are
 * right unless the rest lies that close to one half: those few, and extreme values, go to the C
 * library.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound_number.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

using namespace LAMMPS_NS;

static const int DIGITS = 10;
static const uint64_t DIGITS_END = 10000000000; /* 10^DIGITS */

/* 10^27 = 5^27 2^27, and 5^27 has 63 bits. */
static const int POWER_MOST = 27;
static const long double POWERS[POWER_MOST + 1] = {1e0L,  1e1L,  1e2L,  1e3L,  1e4L,  1e5L,  1e6L,
                                                   1e7L,  1e8L,  1e9L,  1e10L, 1e11L, 1e12L, 1e13L,
                                                   1e14L, 1e15L, 1e16L, 1e17L, 1e18L, 1e19L, 1e20L,
                                                   1e21L, 1e22L, 1e23L, 1e24L, 1e25L, 1e26L, 1e27L};

/* The error of a number below 2^34 in 64 bits is 2^-31; and some room. */
static const long double TIE = 1e-8L;

static char *print_digits(uint64_t digits, int count, char *to) {
  for (int i = count - 1; i >= 0; i--) {
    to[i] = static_cast<char>('0' + digits % 10);
    digits /= 10;
  }
  return to + count;
}

char *LAMMPS_NS::print_count(long long value, char *to) {
  uint64_t rest = value < 0 ? 0 - static_cast<uint64_t>(value) : static_cast<uint64_t>(value);
  int count = 1;
  for (uint64_t r = rest; r >= 10; r /= 10)
    count++;
  if (value < 0)
    *to++ = '-';
  return print_digits(rest, count, to);
}

/* The ten digits of a positive number and the power of ten of the first; false where they are not
 * certain. */
static bool find_digits(double value, uint64_t &digits, int &exponent) {
  int binary;
  frexp(value, &binary);
  exponent = static_cast<int>(floor((binary - 1) * 0.30102999566398120)); /* or one less */
  long double scaled;
  for (;; exponent++) {
    const int power = DIGITS - 1 - exponent;
    if (power > POWER_MOST || power < -POWER_MOST)
      return false;
    scaled = power >= 0 ? value * POWERS[power] : value / POWERS[-power];
    if (scaled < DIGITS_END)
      break;
  }
  digits = static_cast<uint64_t>(scaled);
  const long double rest = scaled - static_cast<long double>(digits);
  if (fabsl(rest - 0.5L) < TIE)
    return false;
  digits += rest > 0.5L;
  if (digits == DIGITS_END) {
    digits /= 10;
    exponent++;
  }
  return true;
}

/* d.ddde-05 */
static char *print_scientific(const char *digits, int count, int exponent, char *to) {
  *to++ = digits[0];
  if (count > 1) {
    *to++ = '.';
    memcpy(to, digits + 1, count - 1);
    to += count - 1;
  }
  *to++ = 'e';
  *to++ = exponent < 0 ? '-' : '+';
  return print_digits(exponent < 0 ? -exponent : exponent, 2, to); /* below 100: find_digits() */
}

/* dd.ddd, dd000 or 0.000ddd */
static char *print_fixed(const char *digits, int count, int exponent, char *to) {
  const int before = exponent < 0 ? 0 : exponent + 1;
  if (before == 0)
    *to++ = '0';
  for (int i = 0; i < before; i++)
    *to++ = i < count ? digits[i] : '0';
  if (count <= before)
    return to;
  *to++ = '.';
  for (int i = exponent + 1; i < 0; i++)
    *to++ = '0';
  memcpy(to, digits + before, count - before);
  return to + count - before;
}

char *LAMMPS_NS::print_number(double value, char *to) {
  uint64_t digits;
  int exponent, count = DIGITS;
  if (LDBL_MANT_DIG < 64 || !(fabs(value) > 0) || !find_digits(fabs(value), digits, exponent))
    return to + snprintf(to, NUMBER_MOST, "%.10g", value);
  char text[DIGITS];
  print_digits(digits, DIGITS, text);
  while (text[count - 1] == '0')
    count--;
  if (value < 0)
    *to++ = '-';
  return exponent < -4 || exponent >= DIGITS ? print_scientific(text, count, exponent, to)
                                             : print_fixed(text, count, exponent, to);
}
