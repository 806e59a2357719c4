/* One hit on one face, of a sphere or of a body.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_WALL_HIT_H
#define ASP_WALL_HIT_H

#include "wall/frame.h"
#include "wall/wall.h"

/* The rebound from a face of normal m, in (t, b, n): `out` is the velocity afterwards (of a body:
 * of its touching sphere), `spin` in the lab frame. False if the particle cannot hit the face. A
 * face tilted in the plane of incidence only keeps a sphere in that plane.
 */
bool aspi_hit_rebound(const asp_wall *wall, const asp_particle *particle, const frame *f, vec m,
                      bool in_plane, aspi_stream *stream, vec *spin, vec *out, bool *deposit);

/* Eroded mass per particle mass of a hit on a face of normal m. */
double aspi_hit_erosion(const asp_wall *wall, const asp_particle *particle, const frame *f, vec m);

#endif
