/* The path of a particle's centre over a profile, face by face: what `traced` draws from, and what
 * the tables of `profile` are made of.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_TRACE_H
#define ASP_SPREAD_TRACE_H

#include "spread/law.h"

/* Points of the path of one track, unless its profile has more. */
#define ASP_TRACK_MOST ((size_t)131072)

/* The diameters that a wall is made for: `bins` of them from least to most at equal ratios; one
 * bin is their geometric mean. 0 < least <= most, bins >= 1. */
typedef struct aspi_sizes {
  double least, most;
  int bins;
} aspi_sizes;

/* The track that belongs to a diameter, of `bins` at equal ratios: the nearest. */
int aspi_sizes_nearest(const aspi_sizes *sizes, double d_p);

/* The diameter of a bin. */
double aspi_sizes_at(const aspi_sizes *sizes, int bin);

/* ASP_OK, or ASP_EARG and a message. */
asp_code aspi_sizes_check(const aspi_sizes *sizes, asp_error *error);

/* Where a particle is that a model follows over a profile: nowhere yet, when all is 0. */
typedef struct aspi_path {
  bool begun;
  bool back;   /* flies towards smaller x of the profile */
  double turn; /* from the flight before to this one, from t towards b */
  double x, z; /* place along the profile and height, in points */
  size_t face; /* that it last hit */
  int hits;    /* so far */
  int profile; /* of those that the model has, from 0 */
  /* Of a model that knows kinds of faces instead of places: the face that it is on, its slopes
   * along the flight that came to it and across it, and that flight: whether it was `back`, its
   * azimuth, and its impact angle or, where it flew up, the steepest of those before. */
  aspi_kind kind;
  double p, q;
  int size;
  bool came_back;
  double azimuth, came;
} aspi_path;

/* The path of the centre of a disc over a profile (aspi_profile_path), as straight faces between
 * its points, periodic (a measured profile goes on as its mirror image): particles that fall on it
 * at an angle, and where they hit it, without a model. */
typedef struct aspi_track aspi_track;

/* For a particle of diameter 0 <= d_p <= length of the profile, which need not outlive it. NULL on
 * error. */
aspi_track *aspi_track_create(const asp_profile *profile, double d_p, asp_error *error);
void aspi_track_free(aspi_track *track);

size_t aspi_track_faces(const aspi_track *track);
double aspi_track_slope_rms(const aspi_track *track); /* s_eff of these very faces */

/* Slope of a face in the direction of flight, 0 <= face < aspi_track_faces(); particles fly towards
 * larger x. */
double aspi_track_face_slope(const aspi_track *track, size_t face);

/* The smallest impact angle that a track of this length can tell: below it particles would see no
 * more than a handful of its peaks, and it stands for every smaller one. */
double aspi_track_alpha_least(const aspi_track *track);

/* The exact law of the first hit at alpha1 (0 to pi/2): the share of the particles that first touch
 * each face, into weight[aspi_track_faces()], sum 1. A path is a constant value of g = D + x tan
 * alpha1, and touches where g passes its running maximum. */
void aspi_track_first_hit(const aspi_track *track, double alpha1, double *weight);

/* Puts a particle of an even beam in front of the track: u, 0 < u < 1, is its place in the beam. */
void aspi_track_enter(const aspi_track *track, double u, aspi_path *path);

/* Moves the particle to the next face on its way, at an elevation of -alpha1 (from -pi/2 to pi/2;
 * negative alpha1 is a flight up), and tells the face's tilt as the particle sees it; false when it
 * leaves. */
bool aspi_track_next(const aspi_track *track, double alpha1, aspi_path *path, double *delta);

#endif
