/* Flights of a sphere over a measured or generated wall, from one face to the next.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "spread/field.h"
#include "surface/ball.h"

/* Where a sphere lies between two contacts, its contact moves by more steps than this while its
 * center moves by one. */
#define ASPI_KINK 3.0

/* The center and its contact over a place of a map, in points: 0 <= at <= cells. */
aspi_touch aspi_field_at(const aspi_field *field, const double at[2]);

/* A particle on the field, x and y in points. */
typedef struct aspi_spot {
  double x[2], z;
  bool lies; /* on a face, from which it starts; false: anywhere above */
} aspi_spot;

/* A place in an even beam over the field, at its highest point: 0 <= u, v < 1. */
aspi_spot aspi_field_enter(const aspi_field *field, double u, double v);

/* Moves a particle of velocity v to the next face on its way, and returns the gradient there; false
 * when it leaves the wall. */
bool aspi_field_next(const aspi_field *field, const double v[3], aspi_spot *spot,
                     double gradient[2]);
