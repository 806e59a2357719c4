/* Effects of a particle's temperature: on the viscosity of molten ash, by which it sticks, and on
 * Young's modulus. To add a form of one, add its record to the table in heat.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/keyword.h"
#include "rebound/materials.h"

enum { ASPI_CURVE_PARAMETERS = 5, ASPI_CURVE_POINTS = 64 };

/* A property over the temperature (K): a form with its numbers. */
typedef struct aspi_curve {
  const struct aspi_curve_form *form; /* NULL: none */
  double parameters[ASPI_CURVE_PARAMETERS];
  double unit;     /* the caller's per SI unit, where the form is in SI */
  double least;    /* it holds above */
  char *file;      /* of a table; the description's */
  size_t n_points; /* the same, rising */
  double kelvin[ASPI_CURVE_POINTS], log_value[ASPI_CURVE_POINTS];
} aspi_curve;

typedef struct aspi_curve_form {
  const char *name;
  const char *keywords; /* that take it */
  const char *summary, *source;
  int n_parameters; /* 0: a table */
  const aspi_keyword *parameters;
  double (*log_value)(const aspi_curve *curve, double kelvin); /* natural, in the caller's units */
  asp_code (*begin)(aspi_curve *curve,
                    asp_error *error); /* with its numbers; NULL: all are right */
} aspi_curve_form;

/* The forms; the last one has no name. */
extern const aspi_curve_form aspi_curve_forms[];

/* Reads the table of a curve, with temperature_k and this column, in SI. */
asp_code aspi_curve_read(aspi_curve *curve, const char *column, asp_error *error);

/* How hot particles change a wall. Temperatures in K. */
typedef struct aspi_heat {
  aspi_curve viscosity, modulus;
  double critical;                      /* what is less viscous sticks at each impact */
  double temperature, wall_temperature; /* of particles that have none of their own, 0: unknown */
} aspi_heat;

/* True if an impact depends on the curves. */
static inline bool aspi_heat_counts(const aspi_heat *heat) {
  return heat->viscosity.form || heat->modulus.form;
}

/* The temperature of a particle that has this one of its own; 0: it has none. */
static inline double aspi_heat_of(const aspi_heat *heat, double own) {
  return own > 0 ? own : heat->temperature;
}

/* ASP_ERANGE and a message if the curves do not hold at this temperature of a particle. */
asp_code aspi_heat_check(const aspi_heat *heat, double kelvin, asp_error *error);

/* The probability with which an impact sticks by the viscosity. */
double aspi_heat_share(const aspi_heat *heat, double kelvin);

/* Gives a pair the modulus at this temperature. */
void aspi_heat_soften(const aspi_heat *heat, double kelvin, asp_pair *pair);
