/* The dilation of a map by a sphere: heights of its center, contact gradients, and flights from one
 * face to the next.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SWEEP_DILATED_MAP_H
#define ASP_SWEEP_DILATED_MAP_H

#include "surface/map.h"

/* The dilated map is periodic, even if the map is not. */
typedef struct aspi_dilated_map {
  size_t columns, rows;
  double step[2];
  float *z, *p, *q; /* height of the center; gradient of the contact */
  bool crests;      /* has sharp crests, as measured maps do: interpolate the gradient at a hit */
  float *cells; /* the highest of the four points of each cell, and maxima over blocks of them */
  aspi_pyramid pyramid;
  float *memory; /* of all points and cells */
} aspi_dilated_map;

/* Memory for the dilation of a map. The caller fills z, p and q (aspi_ball_rows), then calls
 * aspi_dilated_map_finish. */
asp_code aspi_dilated_map_create(aspi_dilated_map *field, const asp_map *map, asp_error *error);
void aspi_dilated_map_finish(aspi_dilated_map *field);
void aspi_dilated_map_free(aspi_dilated_map *field);

/* Turns the field by 180 degrees, for flights the other way. */
void aspi_dilated_map_turn(aspi_dilated_map *field);

/* Position and velocity of the center of a particle. */
typedef struct aspi_flight {
  double x[3], v[3];
} aspi_flight;

/* Moves a particle from the face that it has just left to the next face on its way, and returns the
 * gradient there; false when it leaves the wall. */
bool aspi_dilated_map_next(const aspi_dilated_map *field, aspi_flight *flight, double gradient[2]);

#endif
