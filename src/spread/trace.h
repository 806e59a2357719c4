/* The path of a particle's center over a profile, hit by hit: what `traced` draws from.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_TRACE_H
#define ASP_SPREAD_TRACE_H

#include "asperity_internal.h"

/* The state of a particle that a model follows over a profile or a map; all 0 before the first
 * face. */
typedef struct aspi_path {
  bool begun;
  bool back;   /* flies toward smaller x of the profile */
  double turn; /* from the flight before to this one, from t toward b */
  /* For `traced`: */
  double x, z; /* place along the profile and height, in points */
  size_t face; /* last hit */
  int hits;    /* until now */
  int profile; /* index among those of the model */
  /* For `profile`: the class of the face (line_table.h), its slopes along and across the flight
   * that hit it, and that flight: direction, azimuth, and impact angle, or the steepest upward
   * angle before it. */
  int face_class;
  double p, q;
  int size;
  bool back_in;
  double azimuth, alpha_in;
} aspi_path;

/* The faces of a line over a profile (aspi_line_over_profile), searched by a pyramid of maxima. */
typedef struct aspi_track aspi_track;

/* For a particle of diameter 0 <= d_p <= length of the profile, which need not outlive it. NULL on
 * error. */
aspi_track *aspi_track_create(const asp_profile *profile, double d_p, asp_error *error);
void aspi_track_free(aspi_track *track);

/* Puts a particle of an even beam in front of the track: u, 0 < u < 1, is its place in the beam. */
void aspi_track_enter(const aspi_track *track, double u, aspi_path *path);

/* Moves the particle to the next face on its way, at an elevation of -alpha1 (from -pi/2 to pi/2;
 * negative alpha1 is a flight up). Returns the tilt of the face in the direction of flight in
 * *delta; false when the particle leaves the wall. */
bool aspi_track_next(const aspi_track *track, double alpha1, aspi_path *path, double *delta);

#endif
