/* Valleys and faces of a measured wall: tables from lines over the heights of a sphere's center
 * (the rolled heights), for spheres that stay at the wall. Gaussian walls have closed forms.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "spread/models.h"

/* The next face on the way: its slopes along the way and across it; in a kink of the center's path,
 * the slope along the way before it. length: from a smooth trough to the next crest; 0: a kink. */
typedef struct aspi_face {
  float down, up, side, length;
} aspi_face;

/* What one diameter meets in one direction. The lists of valleys are in order: a valley of a rank
 * has the start and the height of this rank. */
typedef struct aspi_valley_table {
  const float *start, *height;
  const aspi_face *face;
  size_t starts, heights, faces; /* all 0: nothing is known, as of a wall of a single slope */
  double face_length;            /* mean distance between faces */
} aspi_valley_table;

/* For each diameter of the sizes and, over a map, 16 directions, from the fields in a model's data.
 * NULL on error. */
typedef struct aspi_valleys aspi_valleys;
aspi_valleys *aspi_valleys_create(const asp_spread_model *model, const void *data,
                                  const aspi_height_field *of, const aspi_sizes *sizes,
                                  asp_error *error);
void aspi_valleys_free(aspi_valleys *valleys);

/* For the nearest of the diameters; azimuth as in aspi_spread_input, NULL: all directions. */
aspi_valley_table aspi_valleys_at(const aspi_valleys *valleys, double d_p, const double *azimuth);
