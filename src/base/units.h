/* Units by name, and in the header of a text file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_BASE_UNITS_H
#define ASP_BASE_UNITS_H

#include "asperity.h"

/* One unit: factor 10^exponent of SI (or degrees), plus `offset`. Kinds are those of quantity.h, or
 * "unread" of units that are known but not read (factor 0). Names have blanks between; the first
 * one of units that are listed is shown to the user. */
typedef struct aspi_unit {
  const char *kind, *names;
  int exponent;
  double factor, offset;
  bool listed;
} aspi_unit;

/* The units in turn; NULL behind the last one. */
const aspi_unit *aspi_unit_at(size_t index);

/* The unit of a kind (NULL: of any) that has that name; where it need not be exact, in upper or
 * lower case (but for names of one letter). NULL: there is none. */
const aspi_unit *aspi_unit_find(const char *kind, const char *name, size_t length, bool exact);

/* Meters in a unit of length by its name (m cm mm um nm, or as instruments write them:
 * `Micrometer`, the Greek letter in UTF-8 or Latin-1, `Angstrom`); 0 when it is none. */
double aspi_unit_meters(const char *name, size_t length);

static inline double aspi_degrees(double radians) {
  return radians * (180 / ASP_PI);
}

static inline double aspi_radians(double degrees) {
  return degrees * (ASP_PI / 180);
}

#endif
