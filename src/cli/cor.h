/* Data that `asperity cor` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_COR_H
#define ASP_CLI_COR_H

#include "cli/description.h"

/* The options of the command. */
enum { DP, SPEED, ANGLES, SAMPLES, FLUX, SUMMARY, COLUMNS, OUTPUT, PLOT, N = PLOT + PLOT_OPTIONS };

typedef struct cor_scene {
  cli_description wall;
  cli_list speeds, sizes; /* of a log-normal law ln has the sd ln(most/least)/5 */
} cor_scene;

typedef struct cor_row {
  double d_p, alpha1;
  asp_impact impact;
  asp_coefficients cor;
} cor_row;

/* One impact at an angle in degrees. */
cor_row cli_cor_impact(const cor_scene *scene, double angle, size_t sample, uint64_t tag);

void cli_cor_plot(const cli_option *options, const cor_scene *scene, const cor_row *rows,
                  size_t count);

#endif
