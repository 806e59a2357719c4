/* Lines over a map, in any direction, as particles of one size fly along them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_COURSES_H
#define ASP_SPREAD_COURSES_H

#include "spread/law.h"
#include "surface/ball.h"

/* The laws of flights both ways along an azimuth (rad, from x towards y): [0] along it, [1] against
 * it. From lines across the whole map, about `points` of them `step` apart, joined to one line.
 * Each at a place of its own between its neighbours; the sphere touches the map only, not what is
 * beyond it. ASP_ENOMEM. */
asp_code aspi_courses_laws(const aspi_ball *ball, const asp_map *map, double azimuth, double step,
                           size_t points, aspi_law *laws[2], asp_error *error);

#endif
