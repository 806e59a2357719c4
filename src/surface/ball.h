/* A sphere on a map.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"

/* Center height of a sphere that rests on the map, and the gradient of the surface where it
 * touches; the center's height has the same gradient. */
typedef struct aspi_touch {
  double height, p, q;
} aspi_touch;

typedef struct aspi_ball aspi_ball;

/* A sphere of diameter d_p (0 <= d_p <= the shorter side) on a map, which must outlive it. */
aspi_ball *aspi_ball_create(const asp_heights *map, double d_p, asp_error *error);
void aspi_ball_free(aspi_ball *ball);

/* The dilation of the map by the sphere: row after row from `first` to before `end`, into arrays of
 * the whole map's size. The sphere rests on the sampled points, exactly; then place and gradient of
 * the contact are those of the surface between them. The time per point hardly depends on d_p.
 * Threads may share one ball. p and q may be NULL. */
void aspi_ball_rows(const aspi_ball *ball, size_t first, size_t end, float *height, float *p,
                    float *q);

/* Centers anywhere over the map, each best near the one before; by lengths from the first point,
 * within a periodic map's first period. */
typedef struct aspi_ball_search {
  const aspi_ball *ball;
  ptrdiff_t from[2]; /* from the last center to its contact point */
} aspi_ball_search;

aspi_ball_search aspi_ball_begin(const aspi_ball *ball);
aspi_touch aspi_ball_at(aspi_ball_search *search, double x, double y);

/* Center height over one grid point. sampled: use grid points only, no interpolation. */
aspi_touch aspi_ball_touch(const aspi_ball *ball, size_t column, size_t row, bool sampled);
