/* The places of a row by height, slope and curvature, for a flight that turns on an isotropic wall.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "spread/flight.h"

/* A face of the row: its middle. */
typedef struct aspi_row_place {
  float height, steepness, bend; /* the slope without its sign; the curvature, as a difference */
  int cell;
} aspi_row_place;

typedef struct aspi_row_places {
  size_t count, strip, strips; /* places, places of a strip, and strips */
  double unit, bend_unit;      /* of steepness and bend, where one of height is 1 */
  ptrdiff_t reach;             /* points from a face to those that its bend is measured by */
  aspi_row_place *place;       /* in strips of increasing height; within a strip by steepness */
  float *bottom;               /* the least height of each strip */
} aspi_row_places;

/* An index of a row; ASP_ENOMEM and a message, or ASP_OK. */
asp_code aspi_row_places_create(aspi_row_places *places, const aspi_field *row, asp_error *error);
void aspi_row_places_free(aspi_row_places *places);

/* Moves the particle to the place of the row with the nearest height, slope `slope` along its
 * flight and, if the wall keeps its curvature, curvature. *back: it flies toward smaller x there.
 * Returns how much `slope` exceeds the slope of that place. */
double aspi_row_places_move(const aspi_row_places *places, const aspi_field *row, double slope,
                            bool bends_alike, aspi_spot *spot, bool *back);
