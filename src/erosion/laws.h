/* The list of the erosion laws. A law gives the eroded mass of one impact from speed, impact angle
 * and diameter. To add a law, write one file with its record and add one line here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "rebound/laws.h"

enum { ASPI_EROSION_PARAMETERS = 13 };

typedef struct aspi_erosion_law {
  const char *name;
  const char *summary;
  const char *source;
  bool is_volume; /* the law gives an eroded volume, otherwise a mass */
  int n_parameters;
  const aspi_keyword *parameters; /* default_value NaN: derived from other parameters */
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
  double density; /* of the wall, in the caller's units; 0: use the pair's material */
  bool tilted;    /* use the faces that are hit, otherwise the mean wall */
  double meter, meter_per_second, density_unit; /* the caller's units per SI unit */
} aspi_erosion;

/* Sets a law with its defaults. */
void aspi_erosion_take(aspi_erosion *erosion, const aspi_erosion_law *law, const asp_units *units);

/* Eroded wall mass per particle mass of one hit, in the caller's units. wall_density: of the pair's
 * material; 0: unknown. */
double aspi_erosion_ratio(const aspi_erosion *erosion, double wall_density, double v, double sine,
                          double cosine, double d_p);
