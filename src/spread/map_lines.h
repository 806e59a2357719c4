/* Lines over a map, in any direction, for particles of one size.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_MAP_LINES_H
#define ASP_SPREAD_MAP_LINES_H

#include "spread/line_table.h"
#include "surface/ball.h"

/* The tables of flights along an azimuth (rad, from x toward y), [0], and against it, [1], from
 * lines across the whole map with about `points` points in all, `step` apart, joined to one line.
 * The sphere touches the map only, not what is beyond its edges. ASP_ENOMEM. */
asp_code aspi_map_line_tables(const aspi_ball *ball, const asp_map *map, double azimuth,
                              double step, size_t points, aspi_line_table *tables[2],
                              asp_error *error);

#endif
