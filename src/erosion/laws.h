/* The list of the erosion laws. A law gives the mass that one impact wears off, by speed,
 * impact angle and diameter. A new law is one file that defines its record, and one line here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_EROSION_LAWS_H
#define ASP_EROSION_LAWS_H

#include "rebound/laws.h"

enum { ASPI_EROSION_PARAMETERS = 13 };

typedef struct aspi_erosion_law {
  const char *name;
  const char *summary;
  const char *source;
  bool is_volume; /* the law gives a volume of the wall, else a mass */
  int n_parameters;
  const aspi_keyword *parameters; /* default_value NaN: it follows from others; see the law */
  /* Parameters and all that follows in SI: m^3 or kg of the wall per kg of the particle, at the
   * speed v, under the impact angle of this sine and cosine. */
  double (*rate)(const double *parameters, double v, double sine, double cosine, double d_p);
} aspi_erosion_law;

#define ASPI_EROSION_LAWS(X) X(dnv) X(ecrc) X(finnie) X(oka)

#define ASPI_EROSION_DECLARE(name) extern const aspi_erosion_law aspi_erosion_##name;
ASPI_EROSION_LAWS(ASPI_EROSION_DECLARE)
#undef ASPI_EROSION_DECLARE

int aspi_erosion_count(void);
const aspi_erosion_law *aspi_erosion_at(int index);
const aspi_erosion_law *aspi_erosion_find(const char *name, asp_error *error);

/* A law with its numbers, as a wall has it. */
typedef struct aspi_erosion {
  const aspi_erosion_law *law;           /* NULL: nothing is worn */
  double given[ASPI_EROSION_PARAMETERS]; /* in the caller's units */
  double si[ASPI_EROSION_PARAMETERS];
  double density; /* of the wall, in the caller's units; 0: that of the pair's material */
  bool tilted;    /* by the faces that are hit, else by the mean wall */
  double meter, meter_per_second, density_unit; /* how many of the caller's units make one of SI */
} aspi_erosion;

/* Takes a law and its defaults, as if they were given. */
void aspi_erosion_take(aspi_erosion *erosion, const aspi_erosion_law *law, const asp_units *units);

/* Eroded wall mass per particle mass of one hit, in the caller's units. wall_density: of the pair's
 * material; 0: unknown. */
double aspi_erosion_ratio(const aspi_erosion *erosion, double wall_density, double v, double sine,
                          double cosine, double d_p);

#endif
