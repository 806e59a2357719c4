/* The map of a wall for its picture; see map.c and map_picture.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "analysis/faces.h"
#include "cli/cli.h"

/* A particle that stuck. */
typedef struct cli_deposit {
  double x[3], d_p;
} cli_deposit;

/* The picture: a value of each face, per area or alone (NAN: none), and deposits as dots. */
typedef struct cli_map {
  const aspi_faces *faces;
  double *value;
  char label[40]; /* of the values */
  cli_deposit *deposits;
  size_t n_deposits;
} cli_map;

/* Draws it as the options view and clip tell. */
void cli_map_draw(const cli_call *call, const cli_map *map);
