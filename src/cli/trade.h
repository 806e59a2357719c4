/* What `asperity trade` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_TRADE_H
#define ASP_CLI_TRADE_H

#include "cli/description.h"
#include "cli/measure.h"

/* The options of the command. */
enum {
  DP,
  ANGLES,
  RAYS,
  PROFILES,
  COLLISIONS,
  THREE_D,
  SURFACES,
  POINTS,
  OUTPUT,
  PLOT,
  N = PLOT + PLOT_OPTIONS
};

/* A model at one impact angle. */
typedef struct trade_row {
  const asp_spread_model *model;
  double angle, cost, first_hit;
  measure_divergence rebound;
} trade_row;

/* The cost of every model against its worst divergence; of every angle all models, in their order.
 */
void cli_trade_plot(const cli_option *options, const cli_description *wall, double d_p,
                    const trade_row *rows, size_t n);

#endif
