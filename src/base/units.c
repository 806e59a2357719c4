/* Units by the names that people and instruments give them, and numbers that carry one; see
 * units.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "base/error.h"
#include "base/number.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const asp_units aspi_si = {.name = "SI", .meter = 1, .kilogram = 1, .second = 1};

/* Behind the Latin names those in UTF-8 and Latin-1, with a micro sign or a Greek mu. */
static const aspi_unit known[] = {
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
    {"viscosity", "Pa*s Pa.s", 0, 1, 0, true},
    {"viscosity", "P", -1, 1, 0, true},
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

const aspi_unit *aspi_unit_find(const char *kind, const char *name, size_t length, bool exact) {
  for (size_t i = 0; i < sizeof known / sizeof *known; i++)
    if ((!kind || strcmp(known[i].kind, kind) == 0) &&
        aspi_word_index(known[i].names, name, length, exact || length == 1) >= 0)
      return &known[i];
  return NULL;
}

double aspi_unit_meters(const char *name, size_t length) {
  const aspi_unit *u = aspi_unit_find("length", name, length, false);
  return u ? u->factor * pow(10, u->exponent) : 0;
}

/* The kinds of quantities that have powers of meter, kilogram and second in their units. */
static const struct {
  const char *name;
  int meter, kilogram, second;
} kinds[] = {
    {"length", 1, 0, 0},        {"speed", 1, 0, -1},       {"stress", -1, 1, -2},
    {"density", -3, 1, 0},      {"energy/area", 0, 1, -2}, {"stress/speed", -2, 1, -1},
    {"length2/time", 2, 0, -1}, {"mass", 0, 1, 0},         {"rate", 0, 0, -1},
    {"viscosity", -1, 1, -1},
};

static double power(double base, int exponent) {
  double made = 1;
  for (; exponent > 0; exponent--)
    made *= base;
  return made;
}

double aspi_quantity_factor(const char *kind, const asp_units *units) {
  double m = units->meter, kg = units->kilogram, s = units->second;
  for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
    int of_m = kinds[i].meter, of_kg = kinds[i].kilogram, of_s = kinds[i].second;
    if (strcmp(kinds[i].name, kind) != 0)
      continue;
    double below = power(m, -of_m) * power(kg, -of_kg) * power(s, -of_s);
    return m > 0 && kg > 0 && s > 0 ? power(kg, of_kg) * power(m, of_m) * power(s, of_s) / below
                                    : 0;
  }
  return 1;
}

void aspi_quantity_units(const char *kind, char *list, size_t size) {
  *list = '\0';
  for (const aspi_unit *u = known; u < known + sizeof known / sizeof *known; u++)
    if (u->listed && strcmp(u->kind, kind) == 0)
      aspi_append(list, size, "%s%.*s", *list ? " " : "", (int)strcspn(u->names, " "), u->names);
}

asp_code aspi_quantity_check(const char *name, const char *text, const char *kind, double value,
                             double least, double most, bool above, asp_error *error) {
  if (isfinite(value) && value <= most && (above ? value > least : value >= least))
    return ASP_OK;
  char units[120];
  aspi_quantity_units(kind, units, sizeof units);
  const int length = (int)strcspn(units, " ");
  if (isinf(most))
    return aspi_fail(error, ASP_EARG, "%s is %.100s; it must be a finite number %s %g", name, text,
                     above ? ">" : ">=", least);
  return aspi_fail(error, ASP_EARG, "%s is %.100s; it must be %g to %g%s%.*s", name, text, least,
                   most, length > 0 ? " " : "", length, units);
}

/* The first `length` characters as a number, times 10^exponent, rounded once. */
static double shifted(const char *text, size_t length, int exponent) {
  char copy[80], *end;
  if (length >= 60 || strspn(text, "+-.0123456789eE") < length)
    return aspi_number(text, &end) * pow(10, exponent);
  size_t mantissa = strcspn(text, "eE");
  long own = mantissa < length ? strtol(text + mantissa + 1, NULL, 10) : 0;
  mantissa = mantissa < length ? mantissa : length;
  snprintf(copy, sizeof copy, "%.*se%ld", (int)mantissa, text, own + exponent);
  return aspi_number(copy, &end);
}

static asp_code fail_unit(const char *name, const char *text, const char *kind, bool is_number,
                          asp_error *error) {
  char list[120];
  aspi_quantity_units(kind, list, sizeof list);
  if (!*list)
    return aspi_fail(error, ASP_EARG, "%s is '%.100s'; it must be a number", name, text);
  if (!is_number)
    return aspi_fail(error, ASP_EARG,
                     "%s is '%.100s'; it must be a number, behind which there may be one of: %s",
                     name, text, list);
  return aspi_fail(error, ASP_EARG, "%s is '%.100s'; its unit must be one of: %s", name, text,
                   list);
}

asp_code aspi_quantity_read(const char *name, const char *text, const char *kind,
                            const asp_units *units, double *value, asp_error *error) {
  char *end;
  *value = aspi_number(text, &end);
  if (end > text && !*end)
    return ASP_OK;
  const aspi_unit *u = end > text ? aspi_unit_find(kind, end, strlen(end), true) : NULL;
  if (!u)
    return fail_unit(name, text, kind, end > text, error);
  double factor = aspi_quantity_factor(kind, units);
  if (!(factor > 0))
    return aspi_fail(error, ASP_EARG, "%s is '%.100s', which cannot be converted to %s", name, text,
                     units->name);
  *value = (shifted(text, (size_t)(end - text), u->exponent) * u->factor + u->offset) * factor;
  return ASP_OK;
}
