/* Flights of a sphere over a measured or generated wall, from one face to the next.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_FLIGHT_H
#define ASP_SPREAD_FLIGHT_H

#include "surface/map.h"

/* Maxima over blocks of cells, which tell what is high without a look at each: level k has one for
 * each block of 4^k x 4^k cells. Those of a tile of 4 x 4 blocks stand together. */
typedef struct aspi_tops {
  ptrdiff_t across, tiles; /* number of tiles along x, and of all */
  float *most;
} aspi_tops;

enum { ASPI_TOPS_MOST = 32 };

/* Heights of the center of a sphere that rests on the wall (the dilated wall), bilinear between
 * points; a profile is one row. */
typedef struct aspi_field {
  ptrdiff_t columns, rows, cells[2]; /* cells between points along x and y */
  double step[2];
  bool wraps;       /* repeats beyond its edges */
  ptrdiff_t stride; /* numbers of a point: 1, or 3 with the gradient of the contact there */
  float *z;         /* of all points, row after row; then the maxima */
  ptrdiff_t tile;   /* blocks in a tile: 16, or 4 of one row */
  int levels;
  aspi_tops level[ASPI_TOPS_MOST];
  double top;        /* the highest point */
  double bottom;     /* a height below all points */
  double fall_least; /* least slope of a beam that meets many peaks */
} aspi_field;

/* False: the gradient at a hit is that of the heights. */
static inline bool aspi_field_has_gradients(const aspi_field *field) {
  return field->stride > 1;
}

/* The path of the center of a disc of diameter d_p over a profile, 0 <= d_p <= length. A measured
 * profile continues as its mirror image. */
asp_code aspi_field_over_profile(aspi_field *field, const asp_profile *profile, double d_p,
                                 asp_error *error);

/* Points of a map: every `stride`th of each side, from `first` on. */
typedef struct aspi_grid {
  size_t stride, first[2], count[2];
} aspi_grid;

/* The dilation of a map by a sphere at these points, 0 <= d_p <= the shorter side. It repeats if
 * the map does and all of its points are there. */
asp_code aspi_field_over_map(aspi_field *field, const asp_map *map, double d_p,
                             const aspi_grid *grid, asp_error *error);
void aspi_field_free(aspi_field *field);

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

#endif
