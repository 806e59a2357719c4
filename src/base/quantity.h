/* Numbers that may carry a unit, as `5um`, `200MPa` or `500C`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_BASE_QUANTITY_H
#define ASP_BASE_QUANTITY_H

#include "asperity.h"

/* Reads all of a text as a number of the kind that `kind` names: length, speed, stress,
 * stress/speed, energy/area, density, degrees, K, 1/K, or "" for one without a unit. A number alone
 * is in the caller's units; one with a unit is converted to them, exactly if these are SI and the
 * unit is a power of ten. ASP_EARG if it is no such number; the message calls it `name` and lists
 * the units. */
asp_code aspi_quantity_read(const char *name, const char *text, const char *kind,
                            const asp_units *units, double *value, asp_error *error);

/* ASP_EARG where a number that was read from `text` is not from `least` to `most`, or with `above`
 * not more than `least`; the message has the text, and the SI unit behind finite limits. */
asp_code aspi_quantity_check(const char *name, const char *text, const char *kind, double value,
                             double least, double most, bool above, asp_error *error);

/* A length with its unit, um from 1e-9 m on, that reads as the same number of meters. */
void aspi_quantity_print_length(double meters, char text[32]);

/* Number of the caller's units in one SI unit of that kind; 0 if the units are unknown. */
double aspi_quantity_factor(const char *kind, const asp_units *units);

/* The units of a kind, as "m cm mm um nm"; "" where it has none. At most `size` characters. */
void aspi_quantity_units(const char *kind, char *list, size_t size);

#endif
