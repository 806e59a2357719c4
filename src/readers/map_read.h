/* What the readers of maps hand to each other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SURFACE_MAP_READ_H
#define ASP_SURFACE_MAP_READ_H

#include "surface/map.h"
#include "readers/read.h"

/* Heights as a file has them, in metres over the first good one, NAN where one is bad or missing;
 * they grow with what is read, so that a header's counts alone allocate nothing. */
typedef struct aspi_raw_map {
  float *heights;
  size_t points, room, columns, rows;
  double step[2]; /* m */
  double zero;    /* m; NAN before the first good height */
  size_t bad;
} aspi_raw_map;

/* How a map is read besides what it has in common with a profile. */
typedef struct aspi_map_options {
  const aspi_profile_options *read;
  double step[2]; /* m between the columns and the rows of a matrix; 0: as the file states */
} aspi_map_options;

/* Adds a height (m; NAN: bad). */
asp_code aspi_raw_map_add(aspi_raw_map *raw, double height, asp_error *error);

/* Text, a matrix of heights or lines of x, y, z, from a stream at its beginning. raw->heights is
 * for the caller to free, on error too. */
asp_code aspi_read_map_text(FILE *stream, const char *path, const aspi_map_options *options,
                            aspi_raw_map *raw, asp_error *error);

/* A map from an open stream, levelled and mended as the options say. `path` is for messages. */
asp_map *aspi_map_read_stream(FILE *stream, const char *path, const aspi_map_options *options,
                              aspi_profile_report *report, asp_error *error);

/* Takes a polynomial in x and y of that total degree out of the good heights (-1: none), marks
 * spikes, fills gaps or refuses them; as a profile's reader does. */
asp_code aspi_map_mend(aspi_raw_map *raw, const char *path, const aspi_profile_options *options,
                       aspi_profile_report *report, asp_error *error);

#endif
