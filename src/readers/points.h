/* Points of a measured wall as a file has them, and their places on a line or a grid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "readers/read.h"

/* x and y in the file's units, the height in m. */
typedef struct aspi_xyz {
  double x, y, z;
  size_t line;
} aspi_xyz;

typedef struct aspi_points {
  aspi_xyz *list; /* for the caller to free */
  size_t count;
  int decimals, digits; /* the most that any position is written with */
} aspi_points;

asp_code aspi_points_add(aspi_points *points, aspi_xyz point, asp_error *error);

/* Notes how finely a position is written. */
void aspi_points_precision(aspi_points *points, const char *written);

/* Put the points into `raw` at equal spacing on a line, or on their grid. unit: meters per unit of
 * x and y. On a line in x and y (`in_plane`) a position is the distance from the first point.
 * Unequal spacing is interpolated. ASP_EDATA if the points are neither on a line nor on a grid. */
asp_code aspi_points_line(aspi_points *points, const double unit[2], bool in_plane, aspi_raw *raw,
                          asp_error *error);
asp_code aspi_points_grid(const aspi_points *points, const double unit[2], aspi_raw *raw,
                          asp_error *error);
