/* Numbers in text; see number.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"

#include <locale.h>
#include <math.h>
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
  double error = shift < 0 ? fma(-p, power[-shift], size) : fma(size, power[shift], -p);
  double whole = floor(p), over = p - whole - 0.5;
  unsigned long long number = (unsigned long long)whole;
  bool up = over > 0 || (!(over < 0) && (error > 0 || (!(error < 0) && number % 2)));
  return number + up;
}

/* The digits of a finite number that is not 0, and the exponent of the first one. False if they are
 * not found in this way. */
static bool find_digits(double size, int digits, char text[DIGITS_MOST], int *exponent) {
  int binary;
  frexp(size, &binary);
  int ten = (int)floor((binary - 1) * 0.30102999566398120); /* log10(2); perhaps one too low */
  if (digits > DIGITS_MOST || abs(digits - 1 - ten) >= POWERS - 1)
    return false;
  unsigned long long number = scale(size, digits - 1 - ten);
  if (number >= (unsigned long long)power[digits])
    number = scale(size, digits - 1 - ++ten);
  for (int i = digits - 1; i >= 0; i--, number /= 10)
    text[i] = (char)('0' + number % 10);
  *exponent = ten;
  return true;
}

char *aspi_number_format(double value, int digits, char to[ASPI_NUMBER_MOST]) {
  char text[DIGITS_MOST], *at = to;
  int exponent, last = digits;
  if (!isfinite(value) || !(fabs(value) > 0) ||
      !find_digits(fabs(value), digits, text, &exponent)) {
    locales l = use_c_locale();
    at += snprintf(to, ASPI_NUMBER_MOST, "%.*g", digits, value);
    restore_locale(l);
    return at;
  }
  bool scientific = exponent < -4 || exponent >= digits;
  int point = scientific ? 0 : exponent; /* the point is behind this digit */
  while (last > 1 && last > point + 1 && text[last - 1] == '0')
    last--;
  if (value < 0)
    *at++ = '-';
  for (int i = point < 0 ? point : 0; i < last; i++) {
    *at++ = i < 0 ? '0' : text[i];
    if (i == point && i + 1 < last)
      *at++ = '.';
  }
  if (scientific)
    at += snprintf(at, 8, "e%+03d", exponent);
  return at;
}
