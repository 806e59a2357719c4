/* Data that `asperity rebound` hands to its pictures.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_REBOUND_H
#define ASP_CLI_REBOUND_H

#include "cli/description.h"

/* Speeds between which the capture speed is looked for, m/s. */
#define REBOUND_SLOWEST 1e-9
#define REBOUND_FASTEST 1e5

/* The options of the command. */
enum { MAP, LIST, DP, SPEED, ANGLES, POINTS, OUTPUT, PLOT, N = PLOT + PLOT_OPTIONS };

/* Kind of map: its quantity and axes. */
typedef enum rebound_kind { REBOUND_REGIMES, REBOUND_CAPTURE, REBOUND_ANGLES } rebound_kind;

typedef struct rebound_map {
  rebound_kind kind;
  cli_description *walls;
  size_t n_walls;
  bool several_laws;
  cli_list sizes, speeds, angles;
} rebound_map;

typedef struct rebound_row {
  asp_coefficients cor;
  bool deposit;
} rebound_row;

/* Result of one impact. */
rebound_row cli_rebound_row(const cli_description *wall, double d_p, double speed, double degrees);

/* The speed under which a particle sticks: 0 where it never does, INFINITY where it always does. */
double cli_rebound_capture_speed(const cli_description *wall, double d_p, double degrees);

/* Its law, and the material of the wall, "" where the law takes none. */
const char *cli_rebound_law_name(const cli_description *wall);
const char *cli_rebound_wall_name(const cli_description *wall);

void cli_rebound_plot(const cli_option *option, const rebound_map *map);

#endif
