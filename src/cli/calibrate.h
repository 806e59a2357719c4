/* Data that `asperity calibrate` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_CALIBRATE_H
#define ASP_CLI_CALIBRATE_H

#include "analysis/calibrate.h"
#include "cli/description.h"
#include "cli/measured.h"

/* The options of the command. */
enum {
  DP,
  SPEED,
  NOISE,
  HUBER,
  MEASURED,
  BIN = MEASURED + MEASURED_OPTION_COUNT,
  SAMPLES,
  OUTPUT,
  PLOT,
  N = PLOT + PLOT_OPTIONS
};

void cli_calibrate_plot(const cli_option *option, const aspi_calibration *c, const char *data,
                        const char *title);

#endif
