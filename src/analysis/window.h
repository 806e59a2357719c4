/* Statistics of the coefficients within an interval of angles that moves up: each move and each
 * question costs the logarithm of the number of points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_WINDOW_H
#define ASP_ANALYSIS_WINDOW_H

#include <stddef.h>

typedef struct aspi_window aspi_window;

/* A window over `count` points in order of their angle; points whose value is NAN are left out.
 * Angles and values are `stride` bytes apart. NULL: out of memory. */
aspi_window *aspi_window_create(const double *angles, const double *values, size_t stride,
                                size_t count);
void aspi_window_free(aspi_window *window);

/* Takes in the angles from `from` to `to`, both included and neither smaller than before. */
void aspi_window_move(aspi_window *window, double from, double to);

size_t aspi_window_count(const aspi_window *window);

/* Mean and standard deviation (over n - 1) of at least one point; the sd of one is 0. */
void aspi_window_moments(const aspi_window *window, double *mean, double *sd);

/* The value below which `share` (0 to 1) of the points lie, of at least one; straight between two
 * values, as gsl_stats_quantile_from_sorted_data. */
double aspi_window_quantile(const aspi_window *window, double share);

#endif
