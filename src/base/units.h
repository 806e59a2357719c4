/* Units by name, and in the header of a text file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity.h"

/* One unit: factor 10^exponent of SI (or degrees), plus `offset`. Kinds are those of
 * aspi_quantity_read, or "unread" of units that are known but not read (factor 0). Names have
 * blanks between; the first one of units that are listed is shown to the user. */
typedef struct aspi_unit {
  const char *kind, *names;
  int exponent;
  double factor, offset;
  bool listed;
} aspi_unit;

extern const asp_units aspi_si;

/* Finds a unit of a kind (NULL: any) by name; unless `exact`, in upper or lower case (except names
 * of one letter). NULL: there is none. */
const aspi_unit *aspi_unit_find(const char *kind, const char *name, size_t length, bool exact);

/* Meters in a unit of length by its name (m cm mm um nm, or as instruments write them:
 * `Micrometer`, the Greek letter in UTF-8 or Latin-1, `Angstrom`); 0 when it is none. */
double aspi_unit_meters(const char *name, size_t length);

/* Reads a whole text as a number of a kind: length, speed, stress,
 * stress/speed, energy/area, density, mass, rate, degrees, K, 1/K, or "" for one without a unit. A
 * number alone is in the caller's units; one with a unit is converted to them, exactly if these are
 * SI and the unit is a power of ten. ASP_EARG and a message with `name` and the units if the text
 * is not such a number. */
asp_code aspi_quantity_read(const char *name, const char *text, const char *kind,
                            const asp_units *units, double *value, asp_error *error);

/* ASP_EARG if a number that was read from `text` is not from `least` to `most`, or with `above`
 * not more than `least`; the message has the text, and the SI unit behind finite limits. */
asp_code aspi_quantity_check(const char *name, const char *text, const char *kind, double value,
                             double least, double most, bool above, asp_error *error);

/* The caller's units per SI unit of that kind; 0 if unknown. */
double aspi_quantity_factor(const char *kind, const asp_units *units);

/* The units of a kind, as "m cm mm um nm"; "" where it has none. At most `size` characters. */
void aspi_quantity_units(const char *kind, char *list, size_t size);

static inline double aspi_degrees(double radians) {
  return radians * (180 / ASP_PI);
}

static inline double aspi_radians(double degrees) {
  return degrees * (ASP_PI / 180);
}
