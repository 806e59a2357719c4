/* Statistics of the coefficients within an interval of angles that moves up: each move and each
 * question costs the logarithm of the number of points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_WINDOW_H
#define ASP_CLI_WINDOW_H

#include "cli/scatter.h"

typedef struct cli_window cli_window;

/* Of the points' coefficient `which`, where they have one; the points are in order of their angle.
 */
cli_window *cli_window_create(const scatter_point *points, size_t count, int which);
void cli_window_free(cli_window *window);

/* Takes in the angles from `from` to `to`, both included and neither smaller than before. */
void cli_window_move(cli_window *window, double from, double to);

size_t cli_window_count(const cli_window *window);

/* Mean and standard deviation (over n - 1) of at least one point; the sd of one is 0. */
void cli_window_moments(const cli_window *window, double *mean, double *sd);

/* The value below which `share` (0 to 1) of the points lie, of at least one; straight between two
 * values, as gsl_stats_quantile_from_sorted_data. */
double cli_window_quantile(const cli_window *window, double share);

#endif
