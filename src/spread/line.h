/* A line over a wall, along which a particle flies: heights of its centre, and the slope of the
 * contact at each of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_LINE_H
#define ASP_SPREAD_LINE_H

#include "asperity.h"

/* Faces over a period: face i is straight, has the slope[i] of the contact at point i, and ends at
 * (end_x, end_z)[i], between the points i and i + 1. Flight is towards larger x. */
typedef struct aspi_line {
  size_t n;
  double step; /* between points */
  double *slope, *end_x, *end_z;
  double *memory; /* that of all three */
} aspi_line;

/* Room for a line of n points; ASP_ENOMEM. */
asp_code aspi_line_create(aspi_line *line, size_t n, double step, asp_error *error);
void aspi_line_free(aspi_line *line);

/* Takes heights and slopes, each `stride` apart (negative: from the far end, and flight the other
 * way, in which slopes change their sign). Two neighbours meet where their tangents do. */
void aspi_line_set(aspi_line *line, const float *z, const float *p, ptrdiff_t stride);

/* The height that the line rises against a beam that falls by `fall` > 0 a length, over a period.
 */
double aspi_line_rise(const aspi_line *line, double fall);

/* The least fall of a beam that this line can tell: below it the first hits would be a handful of
 * its peaks, and it stands for every smaller one. */
double aspi_line_fall_least(const aspi_line *line);

/* The first hits of a beam: what each face adds to the running maximum of g = z + x fall, the
 * second of two periods; the sum over the faces is aspi_line_rise. */
void aspi_line_first_hit(const aspi_line *line, double fall, double *weight);

/* A place on a line. */
typedef struct aspi_spot {
  size_t face;
  double x, z;
} aspi_spot;

/* Where the particles at these places in the beam, rising shares of a period from 0 to 1, first
 * hit.
 */
void aspi_line_hits(const aspi_line *line, double fall, const double *share, size_t count,
                    aspi_spot *spots);

#endif
