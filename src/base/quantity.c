/* Numbers with units; see quantity.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/quantity.h"
#include "base/error.h"
#include "base/number.h"
#include "base/units.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A kind of quantity, and the powers of meter, kilogram and second in its unit. */
static const struct {
  const char *name;
  int meter, kilogram, second;
} kinds[] = {
    {"length", 1, 0, 0},       {"speed", 1, 0, -1},
    {"stress", -1, 1, -2},     {"density", -3, 1, 0},
    {"energy/area", 0, 1, -2}, {"stress/speed", -2, 1, -1},
    {"degrees", 0, 0, 0},      {"K", 0, 0, 0},
    {"1/K", 0, 0, 0},          {"length2/time", 2, 0, -1},
};

double aspi_quantity_factor(const char *kind, const asp_units *units) {
  for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
    if (strcmp(kinds[i].name, kind) != 0)
      continue;
    int m = kinds[i].meter, kg = kinds[i].kilogram, s = kinds[i].second;
    if (m == 0 && kg == 0 && s == 0)
      return 1;
    if (!(units->meter > 0 && units->kilogram > 0 && units->second > 0))
      return 0;
    double above = 1, below = 1;
    for (int k = 0; k < abs(kg); k++)
      *(kg > 0 ? &above : &below) *= units->kilogram;
    for (int k = 0; k < abs(m); k++)
      *(m > 0 ? &above : &below) *= units->meter;
    for (int k = 0; k < abs(s); k++)
      *(s > 0 ? &above : &below) *= units->second;
    return above / below;
  }
  return 1;
}

void aspi_quantity_units(const char *kind, char *list, size_t size) {
  const aspi_unit *u;
  *list = '\0';
  for (size_t i = 0; (u = aspi_unit_at(i)) != NULL; i++)
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

void aspi_quantity_print_length(double meters, char text[32]) {
  char um[32];
  aspi_number_print(meters, text);
  double value = shifted(text, strlen(text), 6), again;
  aspi_number_print(value, um);
  again = shifted(um, strlen(um), -6);
  bool same = again >= meters && again <= meters && value >= 1e-3 && strlen(um) < 24;
  if (same)
    memcpy(text, um, sizeof um);
  strcat(text, same ? "um" : "m");
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
