/* Units by the names that people and instruments give them, and where the header of a text file
 * states those of length.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "base/error.h"

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
    {"length2/time", "m2/s m^2/s", 0, 1, 0, true},
    {"length2/time", "mm2/s mm^2/s", -6, 1, 0, true},
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

double aspi_unit_meters(const char *name, size_t length) {
  const aspi_unit *u = aspi_unit_find("length", name, length, false);
  return u ? u->factor * pow(10, u->exponent) : 0;
}
