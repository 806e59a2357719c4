/* First-hit and shadowing tables of a map, by size and direction.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_MAP_TABLE_H
#define ASP_SPREAD_MAP_TABLE_H

#include "spread/line_table.h"
#include "spread/models.h"
#include "surface/ball.h"

typedef struct aspi_map_table aspi_map_table;

/* For spheres of the sizes; the map need not outlive it. NULL on error. */
aspi_map_table *aspi_map_table_create(const asp_map *map, const aspi_sizes *sizes,
                                      asp_error *error);
void aspi_map_table_free(aspi_map_table *tables);

/* The next face of a particle, first or later, as asp_spread_model.follow; path->q is the slope
 * across the flight. */
bool aspi_map_table_follow(const aspi_map_table *tables, const aspi_view *view, aspi_stream *stream,
                           aspi_path *path, double *delta);

/* The tables of flights along an azimuth (rad, from x toward y), [0], and against it, [1], from
 * lines across the whole map with about `points` points in all, `step` apart, joined to one line
 * where they agree best; rms: of the map's heights and slopes, to compare them by. The sphere
 * touches the map only, not what is beyond its edges. ASP_ENOMEM. */
asp_code aspi_map_line_tables(const aspi_ball *ball, const asp_map *map, double azimuth,
                              double step, size_t points, const double rms[2],
                              aspi_line_table *tables[2], asp_error *error);

#endif
