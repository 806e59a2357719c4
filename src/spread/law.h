/* What a line over a wall does to the particles that fly along it, as tables: which face they hit
 * first, whether they leave from there, and which face is next when they do not.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_LAW_H
#define ASP_SPREAD_LAW_H

#include "base/stream.h"
#include "spread/line.h"

typedef struct aspi_law aspi_law;

/* The law of a line; `q` is the slope of each face across it, or NULL for none. */
aspi_law *aspi_law_create(const aspi_line *line, const float *q, asp_error *error);
void aspi_law_free(aspi_law *law);

/* A kind of face that a particle is on: all that is remembered of the place. */
typedef struct aspi_kind {
  bool later; /* not the first hit */
  int node;   /* of the impact angle, or for a later hit of the class and the elevation */
} aspi_kind;

/* The kind of a face that is hit first at alpha1 (0 to pi/2). */
aspi_kind aspi_law_kind(double alpha1, aspi_stream *stream);

/* The first face at alpha1: its slopes along the flight and across it. */
aspi_kind aspi_law_first(const aspi_law *law, double alpha1, aspi_stream *stream, double *p,
                         double *q);

/* Whether a particle leaves that a face has sent off at the slope `rise` > 0 over the mean wall;
 * `back` when against the law's direction of flight. `slope` is that of the face along this
 * direction. */
bool aspi_law_leaves(const aspi_law *law, const aspi_kind *kind, double slope, double rise,
                     bool back, aspi_stream *stream);

/* The next face of a particle that does not leave, but flies at the elevation theta (-pi/2 to pi/2)
 * along this line from a face on which it came in at alpha1. */
aspi_kind aspi_law_next(const aspi_law *law, double alpha1, double theta, aspi_stream *stream,
                        double *p, double *q);

#endif
