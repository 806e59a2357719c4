/* asperity surface of a map.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SURFACE_MAP_H
#define ASP_CLI_SURFACE_MAP_H

#include "cli/cli.h"
#include "surface/describe.h"
#include "readers/read.h"

/* A measured map, what was done to it, and what it is. */
typedef struct cli_map {
  asp_map *map;
  aspi_profile_report report;
  aspi_map_description description;
  const char *name;
} cli_map;

/* Reads and describes a map, in meters; exits on an error. */
cli_map cli_map_read(const char *path, const aspi_profile_options *options);
void cli_map_free(cli_map *map);

/* The contact slopes of a sphere; see aspi_gradient_describe. */
typedef struct cli_map_slopes {
  double d_p, rms[2], skewness[2], mixed;
} cli_map_slopes;

/* The dilation of the map by a sphere of each size, all of its points on all cores. */
void cli_map_slopes_measure(const cli_map *map, const cli_list *sizes, cli_map_slopes *rows);

/* Prints the description of the map, and a row per size. */
void cli_map_print(FILE *out, const cli_map *map, const cli_map_slopes *rows, size_t count);

/* The heights as SDF in text (ISO 25178-71), for the other commands and the wall's fix. */
void cli_map_save(const cli_option *option, const cli_map *map);

/* The picture of the first two sizes. */
void cli_map_plot(const cli_option *option, const cli_map *map, const cli_map_slopes *rows,
                  size_t count);

#endif
