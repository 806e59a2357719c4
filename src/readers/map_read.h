/* Shared by the readers of maps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_MAP_READ_H
#define ASP_READERS_MAP_READ_H

#include "surface/map.h"
#include "readers/read.h"

/* Options of a map beyond those that it shares with a profile. */
typedef struct aspi_map_options {
  const aspi_profile_options *read;
  double step[2]; /* m between the columns and the rows of a matrix; 0: as the file states */
} aspi_map_options;

/* Text, a matrix of heights or lines of x, y, z, from a stream at its beginning. raw->heights is
 * for the caller to free, on error too. */
asp_code aspi_read_map_text(FILE *stream, const char *path, const aspi_map_options *options,
                            aspi_raw *raw, asp_error *error);

/* Points in x, y and z, as they come. */
enum { ASP_MAP_AXES = 3 };
typedef struct aspi_map_points {
  double (*at)[ASP_MAP_AXES];
  size_t count, room;
} aspi_map_points;

asp_code aspi_map_points_add(aspi_map_points *points, const double point[ASP_MAP_AXES],
                             asp_error *error);

/* Puts them on their grid; unit: meters in one of each axis. ASP_EDATA where there is none. */
asp_code aspi_map_points_place(const aspi_map_points *points, const char *path,
                               const double unit[ASP_MAP_AXES], aspi_raw *raw, asp_error *error);

/* Reads a map from an open stream, levels and repairs it as the options ask. `path` is for
 * messages. */
asp_map *aspi_map_read_stream(FILE *stream, const char *path, const aspi_map_options *options,
                              aspi_profile_report *report, asp_error *error);

#endif
