/* A wall over an area as the centre of a sphere sees it: heights, contact gradients, and flights
 * from one face to the next.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_FIELD_H
#define ASP_SPREAD_FIELD_H

#include "surface/map.h"

enum { ASP_FIELD_LEVELS = 20 };

/* The dilation of a map by a sphere, periodic whatever the map is. */
typedef struct aspi_field {
  size_t columns, rows;
  double step[2];
  float *z, *p, *q; /* height of the centre; gradient of the contact */
  bool
      crests; /* sharp ones, as on a measured map: gradients of hits are taken between the points */
  double top;
  int levels; /* of maxima over blocks of 2^k x 2^k cells between four points */
  size_t across[ASP_FIELD_LEVELS];
  float *level[ASP_FIELD_LEVELS], *memory;
} aspi_field;

/* Room for the dilation of a map: z, p and q are for the caller to fill (aspi_ball_rows), and
 * aspi_field_finish to be called then. */
asp_code aspi_field_create(aspi_field *field, const asp_map *map, asp_error *error);
void aspi_field_finish(aspi_field *field);
void aspi_field_free(aspi_field *field);

/* Turns the field by 180 degrees, for flights the other way. */
void aspi_field_turn(aspi_field *field);

/* A particle on its way: where its centre is, and where it flies. */
typedef struct aspi_flight {
  double x[3], v[3];
} aspi_flight;

/* Moves the particle, which a face at its place has just sent off, to the next face on its way, and
 * tells the gradient there; false when it leaves the wall. */
bool aspi_field_next(const aspi_field *field, aspi_flight *flight, double gradient[2]);

#endif
