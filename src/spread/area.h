/* The laws of a map, by size and direction.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_AREA_H
#define ASP_SPREAD_AREA_H

#include "spread/models.h"

typedef struct aspi_area aspi_area;

/* For spheres of the sizes; the map need not outlive it. NULL on error. */
aspi_area *aspi_area_create(const asp_map *map, const aspi_sizes *sizes, asp_error *error);
void aspi_area_free(aspi_area *area);

/* The next face of a particle, first or later, as asp_spread_model.follow; path->q is the slope
 * across the flight. */
bool aspi_area_follow(const aspi_area *area, const aspi_view *view, aspi_stream *stream,
                      aspi_path *path, double *delta);

#endif
