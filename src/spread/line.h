/* A line over a wall, along which a particle flies: heights of its center, and the slope of the
 * contact at each of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_LINE_H
#define ASP_SPREAD_LINE_H

#include "asperity_internal.h"

/* Rms heights that a beam must fall over a period, or over a piece of a map, so that its first hits
 * lie on many peaks. */
#define ASPI_RISE_LEAST 16

/* Points of the path over a profile, unless the profile has more. */
#define ASP_LINE_POINTS_MOST ((size_t)131072)

/* Faces over a period: face i is straight, has the slope[i] of the contact at point i, and ends at
 * (end_x, end_z)[i], between the points i and i + 1. Flight is toward larger x. */
typedef struct aspi_line {
  size_t n;
  double step;       /* between points */
  double fall_least; /* least slope of a beam that the line resolves */
  double *slope, *end_x, *end_z;
  double *memory; /* that of all three */
} aspi_line;

/* Room for a line of n points; ASP_ENOMEM. */
asp_code aspi_line_create(aspi_line *line, size_t n, double step, asp_error *error);
void aspi_line_free(aspi_line *line);

/* The path of the center of a disc of diameter 0 <= d_p <= length over a profile, in units of its
 * spacing (aspi_profile_path); a measured profile continues as its mirror image. To be freed. */
asp_code aspi_line_over_profile(aspi_line *line, const asp_profile *profile, double d_p,
                                asp_error *error);

/* The slope tan(alpha1) at which a beam falls, within what the line resolves: a flatter beam would
 * meet a handful of its peaks only. */
double aspi_line_fall(const aspi_line *line, double alpha1);

/* The share of a beam that first hits each face, into weight[n], sum 1: what the face adds to the
 * running maximum of g = z + x fall, in the second of two periods. */
void aspi_line_first_hits(const aspi_line *line, double fall, double *weight);

#endif
