/* What `asperity doe` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_DOE_H
#define ASP_CLI_DOE_H

#include "cli/slopes.h"

/* All combinations, r_q slowest, d_p fastest. */
typedef struct cli_grid {
  cli_list r_q, lambda_c, d_p;
  size_t count;
  cli_slopes *rows;
} cli_grid;

/* Variance of the angles over phi_r at d_p nearest 40 um, over d_p, and over both (figures 10 to
 * 12), with the size law drawn in. */
void cli_doe_plot(const cli_option *option, const cli_grid *grid);

#endif
