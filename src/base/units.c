/* Units by the names that people and instruments give them, and where the header of a text file
 * states those of length.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "base/error.h"
#include "base/text.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>
#include <strings.h>

/* Behind the Latin names those in UTF-8 and Latin-1, with a micro sign or a Greek mu. */
static const aspi_unit units[] = {
    {"length", "m meter meters metre metres", 0, 1, 0, true},
    {"length", "cm", -2, 1, 0, true},
    {"length", "mm millimeter millimeters millimetre millimetres", -3, 1, 0, true},
    {"length",
     "um micrometer micrometers micrometre micrometres micron microns mikrometer "
     "\xB5m \xC2\xB5m \xCE\xBCm",
     -6, 1, 0, true},
    {"length", "nm nanometer nanometers nanometre nanometres", -9, 1, 0, true},
    {"length", "in inch inches", -3, 25.4, 0, false},
    {"length", "mil mils thou", -6, 25.4, 0, false},
    {"length", "uin \xB5in \xC2\xB5in \xCE\xBCin uinch microinch microinches", -9, 25.4, 0, false},
    {"length", "A Angstrom Angstroms \xC5 \xC3\x85 \xE2\x84\xAB", -10, 1, 0, false},
    {"speed", "m/s", 0, 1, 0, true},
    {"speed", "cm/s", -2, 1, 0, true},
    {"speed", "mm/s", -3, 1, 0, true},
    {"speed", "km/s", 3, 1, 0, true},
    {"stress", "Pa", 0, 1, 0, true},
    {"stress", "kPa", 3, 1, 0, true},
    {"stress", "MPa", 6, 1, 0, true},
    {"stress", "GPa", 9, 1, 0, true},
    {"density", "kg/m3 kg/m^3", 0, 1, 0, true},
    {"density", "g/cm3 g/cm^3", 3, 1, 0, true},
    {"energy/area", "J/m2 J/m^2 N/m", 0, 1, 0, true},
    {"energy/area", "mJ/m2 mJ/m^2", -3, 1, 0, true},
    {"stress/speed", "Pa/(m/s)", 0, 1, 0, true},
    {"stress/speed", "kPa/(m/s)", 3, 1, 0, true},
    {"stress/speed", "MPa/(m/s)", 6, 1, 0, true},
    {"degrees", "deg degrees \xC2\xB0 \xB0", 0, 1, 0, true},
    {"degrees", "rad radians", 0, 180 / ASP_PI, 0, true},
    {"K", "K", 0, 1, 0, true},
    {"K", "C", 0, 1, 273.15, true},
    {"1/K", "/K 1/K", 0, 1, 0, true},
    {"unread", "% percent pct km/h kmh mph ft/s ft gon grad h s", 0, 0, 0, false},
};

const aspi_unit *aspi_unit_at(size_t index) {
  return index < sizeof units / sizeof *units ? &units[index] : NULL;
}

const aspi_unit *aspi_unit_find(const char *kind, const char *name, size_t length, bool exact) {
  for (size_t i = 0; i < sizeof units / sizeof *units; i++)
    if ((!kind || strcmp(units[i].kind, kind) == 0) &&
        aspi_word_index(units[i].names, name, length, exact || length == 1) >= 0)
      return &units[i];
  return NULL;
}

double aspi_unit_metres(const char *name, size_t length) {
  const aspi_unit *u = aspi_unit_find("length", name, length, false);
  return u ? u->factor * pow(10, u->exponent) : 0;
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
  if (c && strchr("([{_/", c))
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
