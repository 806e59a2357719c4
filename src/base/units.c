/* Units by the names that people and instruments give them, and where the header of a text file
 * states those of length.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "base/text.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>
#include <strings.h>

static const aspi_unit units[] = {
    {"length", "m", 0, 1, 0, true},
    {"length", "cm", -2, 1, 0, true},
    {"length", "mm", -3, 1, 0, true},
    {"length", "um", -6, 1, 0, true},
    {"length", "nm", -9, 1, 0, true},
    {"length", "meter", 0, 1, 0, false},
    {"length", "meters", 0, 1, 0, false},
    {"length", "metre", 0, 1, 0, false},
    {"length", "metres", 0, 1, 0, false},
    {"length", "millimeter", -3, 1, 0, false},
    {"length", "millimeters", -3, 1, 0, false},
    {"length", "millimetre", -3, 1, 0, false},
    {"length", "millimetres", -3, 1, 0, false},
    {"length", "millimetro", -3, 1, 0, false},
    {"length", "\xE3\x8E\x9C", -3, 1, 0, false}, /* one character, as in Japan and China */
    {"length", "micrometer", -6, 1, 0, false},
    {"length", "micrometers", -6, 1, 0, false},
    {"length", "micrometre", -6, 1, 0, false},
    {"length", "micrometres", -6, 1, 0, false},
    {"length", "micron", -6, 1, 0, false},
    {"length", "microns", -6, 1, 0, false},
    {"length", "\xB5m", -6, 1, 0, false},        /* micro sign, Latin-1 */
    {"length", "\xC2\xB5m", -6, 1, 0, false},    /* micro sign, UTF-8 */
    {"length", "\xCE\xBCm", -6, 1, 0, false},    /* Greek mu, UTF-8 */
    {"length", "\x83\xCAm", -6, 1, 0, false},    /* Greek mu, Shift JIS */
    {"length", "\xE3\x8E\x9B", -6, 1, 0, false}, /* one character */
    {"length", "mikrometer", -6, 1, 0, false},
    {"length", "micrometro", -6, 1, 0, false},
    {"length", "nanometer", -9, 1, 0, false},
    {"length", "nanometers", -9, 1, 0, false},
    {"length", "nanometre", -9, 1, 0, false},
    {"length", "nanometres", -9, 1, 0, false},
    {"length", "\xE3\x8E\x9A", -9, 1, 0, false}, /* one character */
    {"length", "in", -3, 25.4, 0, false},
    {"length", "inch", -3, 25.4, 0, false},
    {"length", "inches", -3, 25.4, 0, false},
    {"length", "mil", -6, 25.4, 0, false},
    {"length", "mils", -6, 25.4, 0, false},
    {"length", "thou", -6, 25.4, 0, false},
    {"length", "uin", -9, 25.4, 0, false},
    {"length", "\xB5in", -9, 25.4, 0, false},
    {"length", "\xC2\xB5in", -9, 25.4, 0, false},
    {"length", "\xCE\xBCin", -9, 25.4, 0, false},
    {"length", "uinch", -9, 25.4, 0, false},
    {"length", "microinch", -9, 25.4, 0, false},
    {"length", "microinches", -9, 25.4, 0, false},
    {"length", "A", -10, 1, 0, false},
    {"length", "Angstrom", -10, 1, 0, false},
    {"length", "Angstroms", -10, 1, 0, false},
    {"length", "\xC5", -10, 1, 0, false},         /* Latin-1 */
    {"length", "\xC3\x85", -10, 1, 0, false},     /* UTF-8 */
    {"length", "\xE2\x84\xAB", -10, 1, 0, false}, /* the sign of its own, UTF-8 */
    {"speed", "m/s", 0, 1, 0, true},
    {"speed", "cm/s", -2, 1, 0, true},
    {"speed", "mm/s", -3, 1, 0, true},
    {"speed", "km/s", 3, 1, 0, true},
    {"stress", "Pa", 0, 1, 0, true},
    {"stress", "kPa", 3, 1, 0, true},
    {"stress", "MPa", 6, 1, 0, true},
    {"stress", "GPa", 9, 1, 0, true},
    {"density", "kg/m3", 0, 1, 0, true},
    {"density", "g/cm3", 3, 1, 0, true},
    {"density", "kg/m^3", 0, 1, 0, false},
    {"density", "g/cm^3", 3, 1, 0, false},
    {"energy/area", "J/m2", 0, 1, 0, true},
    {"energy/area", "mJ/m2", -3, 1, 0, true},
    {"energy/area", "J/m^2", 0, 1, 0, false},
    {"energy/area", "mJ/m^2", -3, 1, 0, false},
    {"energy/area", "N/m", 0, 1, 0, false},
    {"stress/speed", "Pa/(m/s)", 0, 1, 0, true},
    {"stress/speed", "kPa/(m/s)", 3, 1, 0, true},
    {"stress/speed", "MPa/(m/s)", 6, 1, 0, true},
    {"degrees", "deg", 0, 1, 0, true},
    {"degrees", "degrees", 0, 1, 0, false},
    {"degrees", "grad", 0, 1, 0, false},
    {"degrees", "\xC2\xB0", 0, 1, 0, false}, /* degree sign, UTF-8 */
    {"degrees", "\xB0", 0, 1, 0, false},     /* degree sign, Latin-1 */
    {"degrees", "rad", 0, 180 / ASP_PI, 0, true},
    {"degrees", "radians", 0, 180 / ASP_PI, 0, false},
    {"K", "K", 0, 1, 0, true},
    {"K", "C", 0, 1, 273.15, true},
    {"1/K", "/K", 0, 1, 0, true},
    {"1/K", "1/K", 0, 1, 0, false},
    /* in use, and not read */
    {"", "%", 0, 0, 0, false},
    {"", "percent", 0, 0, 0, false},
    {"", "pct", 0, 0, 0, false},
    {"", "km/h", 0, 0, 0, false},
    {"", "kmh", 0, 0, 0, false},
    {"", "mph", 0, 0, 0, false},
    {"", "ft/s", 0, 0, 0, false},
    {"", "ft", 0, 0, 0, false},
    {"", "gon", 0, 0, 0, false},
    {"", "h", 0, 0, 0, false},
    {"", "s", 0, 0, 0, false},
};

const aspi_unit *aspi_unit_at(size_t index) {
  return index < sizeof units / sizeof *units ? &units[index] : NULL;
}

double aspi_unit_metres(const char *name, size_t length) {
  const aspi_unit *u;
  for (size_t i = 0; (u = aspi_unit_at(i)) != NULL; i++) {
    if (strcmp(u->kind, "length") != 0 || strlen(u->name) != length)
      continue;
    if (length == 1 ? *u->name == *name : strncasecmp(u->name, name, length) == 0)
      return u->factor * pow(10, u->exponent);
  }
  return 0;
}

static bool is_letter(char c) {
  return isalpha((unsigned char)c) || (unsigned char)c >= 0x80;
}

/* A unit in brackets, behind an underscore or a slash is one for certain; a word of its own is one
 * unless a number comes before it, or it is a single letter, or the word `in`. */
static bool states_unit(const char *line, const char *word, size_t length, bool named) {
  const char *before = word;
  while (before > line && before[-1] == ' ')
    before--;
  char c = before > line ? before[-1] : '\0';
  if ((c && strchr("([{_/", c)) ||
      (before - line >= 3 && strncmp(before - 3, "\xEF\xBC\x88", 3) == 0)) /* a wide bracket */
    return true;
  if (isdigit((unsigned char)c) || c == '.')
    return false;
  bool preposition = length == 2 && strncasecmp(word, "in", 2) == 0;
  return !preposition && (length > 1 || named);
}

int aspi_units_in(const char *line, double found[2]) {
  bool named = aspi_text_holds(line, "unit");
  int count = 0;
  for (const char *c = line; *c;) {
    size_t length = 0;
    while (is_letter(c[length]))
      length++;
    double metres = length ? aspi_unit_metres(c, length) : 0;
    if (metres > 0 && states_unit(line, c, length, named)) {
      if (count < 2)
        found[count] = metres;
      count++;
    }
    c += length ? length : 1;
  }
  return count;
}

int aspi_header_units(const char *line, double found[2]) {
  int count = aspi_units_in(line, found);
  if (count == 1 && aspi_text_holds(line, "unit")) {
    found[1] = found[0];
    count = 2;
  }
  return count;
}
