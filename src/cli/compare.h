/* What `asperity compare` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_COMPARE_H
#define ASP_CLI_COMPARE_H

#include "cli/cli.h"
#include "cli/scatter.h"

/* A sample in order; NAN where it is too small for a number. */
typedef struct compare_sample {
  double *values;
  size_t count;
  double mean, sd, median, low, high;
} compare_sample;

typedef struct compare_bin {
  double from, to, middle;
  bool closed; /* holds its upper edge too */
  compare_sample model, data;
  double in_band, distance, p;
} compare_bin;

typedef struct comparison {
  scatter_impacts impacts;
  scatter_data data;
  compare_bin *bins[COR_BOTH];
  size_t count;
} comparison;

/* Whether there is a measured value in a bin. */
bool cli_compare_has_data(const compare_bin *bin);

void cli_compare_plot(const cli_option *option, const comparison *comparison);

#endif
