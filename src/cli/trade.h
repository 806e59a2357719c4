/* What `asperity trade` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_TRADE_H
#define ASP_CLI_TRADE_H

#include "cli/measure.h"
#include "cli/walls.h"

/* The options of the command. */
enum {
  ROUGH,
  DP = ROUGH + ROUGH_OPTIONS,
  ANGLES,
  RAYS,
  SEED,
  PROFILES,
  COLLISIONS,
  GRID,
  THREE_D,
  SURFACES,
  POINTS,
  OUTPUT,
  PLOT,
  N
};

/* A model at one impact angle. */
typedef struct trade_row {
  const asp_spread_model *model;
  double angle, cost, first_hit;
  measure_divergence rebound;
} trade_row;

/* The cost of every model against its worst divergence; of every angle all models, in their order.
 */
void cli_trade_plot(const cli_option *options, const cli_rough *rough, const trade_row *rows,
                    size_t n);

#endif
