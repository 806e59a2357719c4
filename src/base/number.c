/* Numbers in text; see number.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct locales {
  locale_t c, before;
} locales;

/* Sets the "C" locale for this thread, for the length of one call. glibc's "C" allocates no
 * memory. */
static locales use_c_locale(void) {
  locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  return (locales){c, c ? uselocale(c) : (locale_t)0};
}

static void restore_locale(locales l) {
  if (!l.c)
    return;
  uselocale(l.before);
  freelocale(l.c);
}

int aspi_print_list(char *text, size_t size, const char *format, va_list list) {
  locales l = use_c_locale();
  int length = vsnprintf(text, size, format, list);
  restore_locale(l);
  return length;
}

double aspi_number(const char *text, char **end) {
  locales l = use_c_locale();
  double value = strtod(text, end);
  restore_locale(l);
  return value;
}

void aspi_number_print(double value, char text[32]) {
  locales l = use_c_locale();
  char printed[32];
  for (int digits = 15; digits <= 17; digits++) {
    snprintf(printed, sizeof printed, "%.*g", digits, value);
    double read = strtod(printed, NULL);
    if (read >= value && read <= value)
      break;
  }
  memcpy(text, printed, sizeof printed);
  restore_locale(l);
}

/* Powers of ten that a double holds exactly. */
static const double power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                               1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                               1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
enum { POWERS = sizeof power / sizeof *power, DIGITS_MOST = 15 };

bool aspi_number_read(const char *c, char other_point, double *value) {
  bool minus = *c == '-', point = false;
  unsigned long long digits = 0;
  int scale = 0, exponent = 0;
  const char *first = c += minus;
  for (; c - first < 18; c++) {
    unsigned digit = (unsigned)(*c - '0');
    if (digit < 10) {
      digits = 10 * digits + digit;
      scale -= point;
    } else if (!point && (*c == '.' || *c == other_point)) {
      point = true;
    } else {
      break;
    }
  }
  if (c - first <= point)
    return false;
  if (*c == 'e' || *c == 'E') {
    bool below = *++c == '-';
    const char *power_of = c += below || *c == '+';
    for (; *c >= '0' && *c <= '9' && c - power_of < 4; c++)
      exponent = 10 * exponent + (*c - '0');
    if (c == power_of)
      return false;
    scale += below ? -exponent : exponent;
  }
  if (*c || digits > 1ull << 53 || abs(scale) >= POWERS)
    return false;
  double size = scale < 0 ? (double)digits / power[-scale] : (double)digits * power[scale];
  *value = minus ? -size : size;
  return true;
}

/* Rounds size * 10^shift to a whole number below 2^53, ties to even: the product or quotient and
 * its own rounding error are exact. */
static unsigned long long scale(double size, int shift) {
  double p = shift < 0 ? size / power[-shift] : size * power[shift];
  unsigned long long number = (unsigned long long)(long long)p;
  double over = p - (double)(long long)number - 0.5;
  if (over > 0 || over < 0)
    return number + (over > 0);
  double error = shift < 0 ? fma(-p, power[-shift], size) : fma(size, power[shift], -p);
  return number + (error > 0 || (!(error < 0) && number % 2));
}

/* A positive number as a whole one of so many digits, and the exponent of the first. False if it
 * is not found in this way. */
static bool round_to(double size, int digits, unsigned long long *number, int *exponent) {
  unsigned long long bits;
  memcpy(&bits, &size, sizeof bits);
  int binary = (int)(bits >> 52) - DBL_MAX_EXP + 1;
  int ten = binary * 315653 / 1048576 - (binary < 0); /* log10(2); perhaps one too low */
  if (digits > DIGITS_MOST || abs(digits - 1 - ten) >= POWERS - 1)
    return false;
  *number = scale(size, digits - 1 - ten);
  if ((double)*number >= power[digits])
    *number = scale(size, digits - 1 - ++ten);
  *exponent = ten;
  return true;
}

/* So many digits of a number: of one below 2^32, of any one. */
static inline void write_part(uint32_t number, int digits, char *to) {
  static const char pairs[] = "00010203040506070809101112131415161718192021222324"
                              "25262728293031323334353637383940414243444546474849"
                              "50515253545556575859606162636465666768697071727374"
                              "75767778798081828384858687888990919293949596979899";
  for (; digits > 1; number /= 100) {
    digits -= 2;
    memcpy(to + digits, pairs + 2 * (number % 100), 2);
  }
  if (digits > 0)
    *to = (char)('0' + number);
}

static void write_digits(uint64_t number, int digits, char *to) {
  for (; digits > 8; number /= 100000000) {
    digits -= 8;
    write_part((uint32_t)(number % 100000000), 8, to + digits);
  }
  write_part((uint32_t)number, digits, to);
}

char *aspi_count_format(double value, char to[ASPI_NUMBER_MOST]) {
  int digits = 1;
  while (value >= power[digits])
    digits++;
  write_digits((uint64_t)value, digits, to);
  return to + digits;
}

char *aspi_number_format(double value, int digits, char to[ASPI_NUMBER_MOST]) {
  unsigned long long number = 0;
  int exponent = 0;
  if (value >= 0 && value <= 0)
    digits = 1;
  else if (!isfinite(value) || !round_to(fabs(value), digits, &number, &exponent)) {
    locales l = use_c_locale();
    int length = snprintf(to, ASPI_NUMBER_MOST, "%.*g", digits, value);
    restore_locale(l);
    return to + length;
  }
  bool scientific = exponent < -4 || exponent >= digits;
  int whole = scientific ? 1 : exponent + 1; /* digits before the point */
  if (signbit(value))
    *to++ = '-';
  char *first = to + (whole > 0 ? 1 : 2 - whole), *end = first + digits;
  memcpy(to, "0.000", 5); /* of a number below 1 */
  write_digits(number, digits, first);
  while (end > first + 1 && end > first + whole && end[-1] == '0')
    end--;
  for (int i = 0; i < whole; i++)
    to[i] = first[i];
  if (whole > 0 && end > first + whole)
    to[whole] = '.';
  else if (whole > 0)
    end--;
  if (!scientific)
    return end;
  int size = abs(exponent);
  end[0] = 'e';
  end[1] = exponent < 0 ? '-' : '+';
  write_digits((unsigned)size, 2, end + 2);
  return end + 4;
}
