/* First-hit and shadowing tables of one profile line: which face a particle hits first, whether it
 * escapes from there, and which face is next when it does not.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_LINE_TABLE_H
#define ASP_SPREAD_LINE_TABLE_H

#include "base/stream.h"
#include "spread/line.h"

typedef struct aspi_line_table aspi_line_table;

/* The tables of a line; `q` is the slope of each face across it, or NULL for none. */
aspi_line_table *aspi_line_table_create(const aspi_line *line, const float *q, asp_error *error);
void aspi_line_table_free(aspi_line_table *table);

/* The class of a face that is hit first at alpha1 (0 to pi/2): all that is remembered of its place.
 * One of the two impact angles of the table around alpha1, drawn by nearness. */
int aspi_line_table_class(double alpha1, aspi_stream *stream);

/* Draws the first face at alpha1, its slopes along the flight and across it; returns its class. */
int aspi_line_table_first(const aspi_line_table *table, double alpha1, aspi_stream *stream,
                          double *p, double *q);

/* Draws whether a particle escapes that a face has sent off at the slope `rise` > 0 over the mean
 * wall; `back`: against the line's direction of flight. `slope` is that of the face along the line.
 */
bool aspi_line_table_escapes(const aspi_line_table *table, int face_class, double slope,
                             double rise, bool back, aspi_stream *stream);

/* Draws the next face of a particle that does not escape: it flies at the elevation theta (-pi/2 to
 * pi/2) along this line from a face that it hit at alpha1. Returns the class of the new face. */
int aspi_line_table_next(const aspi_line_table *table, double alpha1, double theta,
                         aspi_stream *stream, double *p, double *q);

#endif
