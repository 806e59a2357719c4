/* One face, and one hit on it, of a sphere or of a body.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "wall/roughness.h"

/* The rebound from a face of normal m, in (t, b, n): `out` is the velocity afterwards (of a body:
 * of its touching sphere), `spin` in the lab frame. False if the particle cannot hit the face. A
 * face tilted in the plane of incidence only keeps a sphere in that plane.
 */
bool aspi_hit_rebound(const asp_wall *wall, const asp_particle *particle, const frame *f, vec m,
                      bool in_plane, aspi_stream *stream, vec *spin, vec *out, bool *deposit);

/* A face by its normal in (t, b, n), its angle along the flight, and its slope across it. */
typedef struct aspi_tilt {
  vec m;
  double delta, q;
} aspi_tilt;

/* The face of slope angle `delta` along the flight. On isotropic walls its slope across the flight
 * is drawn, unless the model has done so (`path`, else NULL). */
aspi_tilt aspi_tilt_at(const asp_wall *wall, const aspi_slopes_along *slopes, double delta,
                       const aspi_path *path, aspi_stream *stream);

/* v, or if it points into the wall by its last bits, turned off it. */
vec aspi_hit_leaving(const frame *f, vec v);

/* The velocity of the touching sphere. */
static inline vec aspi_touching(const asp_particle *particle, vec v) {
  return particle->body ? plus(v, 1, cross(load(particle->omega), load(particle->body->lever))) : v;
}

/* Turns the velocity of the touching sphere into that of the center of mass. */
static inline void aspi_to_center(const asp_particle *particle, asp_impact *impact) {
  if (particle->body)
    store(plus(load(impact->v2), -1, cross(load(impact->omega), load(particle->body->lever))),
          impact->v2);
}

/* Eroded mass per particle mass of a hit on a face of normal m. */
double aspi_hit_erosion(const asp_wall *wall, const asp_particle *particle, const frame *f, vec m);

/* The same if faces count for it, else 0. */
static inline double aspi_hit_eroded(const asp_wall *wall, const asp_particle *particle,
                                     const frame *f, vec m) {
  return wall->erosion.tilted ? aspi_hit_erosion(wall, particle, f, m) : 0;
}
