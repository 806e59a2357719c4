/* What `asperity rebound` hands to its pictures.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_REBOUND_H
#define ASP_CLI_REBOUND_H

#include "cli/law.h"

/* Speeds between which the capture speed is looked for, m/s. */
#define REBOUND_SLOWEST 1e-9
#define REBOUND_FASTEST 1e5

/* The options of the command. */
enum { MAP, LIST, DP, SPEED, ANGLES, POINTS, OUTPUT, PLOT, LAW, N = LAW + LAW_OPTIONS };

/* One wall material under one law: its name and what comes of it. */
typedef struct rebound_wall {
  char name[64];
  const cli_law *law;
  asp_pair *pair;
} rebound_wall;

enum { REBOUND_LAWS_MOST = 16 };

typedef struct rebound_map {
  cli_law laws[REBOUND_LAWS_MOST];
  rebound_wall *walls; /* every material under the first law, then under the next one */
  size_t n_laws, n_walls;
  cli_list sizes, speeds, angles;
} rebound_map;

typedef struct rebound_row {
  asp_coefficients cor;
  bool deposit;
} rebound_row;

/* What comes of one impact. */
rebound_row cli_rebound_row(const rebound_wall *wall, double d_p, double speed, double degrees);

/* The speed under which a particle sticks: 0 where it never does, INFINITY where it always does. */
double cli_rebound_capture_speed(const rebound_wall *wall, double d_p, double degrees);

const char *cli_rebound_law_name(const rebound_wall *wall);

void cli_rebound_plot_regimes(cli_plot *picture, const rebound_map *map);
void cli_rebound_plot_capture(cli_plot *picture, const rebound_map *map);
void cli_rebound_plot_angles(cli_plot *picture, const rebound_map *map);

#endif
