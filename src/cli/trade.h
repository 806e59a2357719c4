/* Data that `asperity trade` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_TRADE_H
#define ASP_CLI_TRADE_H

#include "analysis/judge.h"
#include "cli/description.h"

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

/* A number of the model and of the judge. */
typedef struct trade_pair {
  double model, judge;
} trade_pair;

/* A model at one impact angle; degrees. What stands below `space` is of three dimensions only. */
typedef struct trade_row {
  const asp_spread_model *model;
  double angle, cost, first_hit;
  struct {
    double kl, se, mean, reference_mean;
  } rebound;
  bool space;
  double reference_se;
  aspi_estimate lateral;
  trade_pair lateral_mean, lateral_sd, later;
} trade_row;

/* The cost of every model against its worst divergence; of every angle all models, in their order.
 */
void cli_trade_plot(const cli_option *options, const cli_description *wall, double d_p,
                    const trade_row *rows, size_t n);

#endif
