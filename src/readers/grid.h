/* Heights on a grid, as SDF, SUR and X3P have them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "readers/read.h"

#include <stdint.h>

/* Numbers of a header; scales in m. NAN: not stated. */
typedef struct aspi_height_grid {
  double points, profiles, x_scale, y_scale, z_scale, compression;
  int type;    /* of binary heights, by their number in SDF; -1 in ASCII */
  double mark; /* mark of a missing height, before z_scale; NAN: none */
} aspi_height_grid;

/* The number of a header by its key in SDF; NULL for another key. */
double *aspi_grid_number(const aspi_height_grid *grid, const char *key);

/* Reads the heights: a map, or the row or column of it that is the profile. */
asp_code aspi_read_grid(aspi_text *text, const aspi_height_grid *grid,
                        const aspi_profile_options *options, aspi_raw *raw, asp_error *error);

/* Numbers in little-endian order. */
uint64_t aspi_bytes_whole(const unsigned char *bytes, int size);
double aspi_bytes_double(const unsigned char *bytes);
double aspi_bytes_real(const unsigned char *bytes); /* of four bytes */

/* A height of a type, by its number in SDF; NAN if it is marked as bad. */
double aspi_bytes_height(const unsigned char *bytes, int type);

asp_code aspi_cut_short(const aspi_text *text, const char *what, asp_error *error);
