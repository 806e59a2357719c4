/* What `asperity compare` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_COMPARE_H
#define ASP_CLI_COMPARE_H

#include "analysis/sample.h"
#include "cli/cli.h"
#include "cli/measured.h"
#include "cli/scatter.h"

/* The measurements at one angle, speed and size, or those of some such places together; and the
 * impacts there. */
typedef struct compare_bin {
  size_t first, end;       /* rows of the data */
  double degrees, v1, d_p; /* their mean place; NAN where there is none */
  double from, to;         /* the angles that impacts were taken from */
  aspi_sample model[COR_BOTH], data[COR_BOTH];
  double in_band[COR_BOTH], distance[COR_BOTH], p[COR_BOTH];
  double model_all, model_deposits, data_deposits, deposits_p; /* counts; of all of either kind */
} compare_bin;

typedef struct comparison {
  const char *names[2]; /* of the files: impacts, data; no second one: the impacts alone */
  scatter_impacts impacts;
  measured data; /* of impacts alone, these */
  compare_bin *bins;
  size_t count;
} comparison;

/* True if a bin has a measured value and impacts. */
bool cli_compare_has_both(const compare_bin *bin, int which);

/* True if a bin is drawn: of impacts alone, where there are some. */
bool cli_compare_is_drawn(const comparison *c, const compare_bin *bin, int which);

void cli_compare_plot(const cli_option *option, const comparison *comparison);

#endif
