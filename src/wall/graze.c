/* The next face of a particle that stays at the wall, hit at grazing incidence.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/size_law.h"
#include "wall/hit.h"
#include "wall/impact.h"
#include "wall/roughness.h"

#include <math.h>

/* A slope s_eff x with the density x exp(-x^2/2), the law of faces met along the wall. */
static double rayleigh(const aspi_slopes_along *slopes, aspi_stream *stream) {
  return slopes->slope * sqrt(-2 * log(aspi_stream_uniform(stream)));
}

/* The frame of a particle whose center of mass, with the velocity v along the wall, has turned down
 * a slope p at the same speed. */
static frame turned_down(const asp_particle *particle, const frame *f, vec v, double p) {
  vec t = scaled(f->along, f->per_length);
  double along = dot(v, t), up = dot(v, f->n), cosine = 1 / sqrt(1 + p * p), sine = p * cosine;
  v = plus(v, along * (cosine - 1) + up * sine, t);
  v = plus(v, up * (cosine - 1) - along * sine, f->n);
  return frame_of(aspi_touching(particle, v), f->n);
}

/* True if the trough between two faces is sharper than the sphere: then the path of its center has
 * a kink there. Curvatures in troughs have the density x exp(-x^2/2) over their rms value c, kappa
 * = c d_p/2. On a surface the one across is a third of that on the average, with the variance (8/9)
 * c^2, and the mixed one has c^2/3: moments of Gaussian heights whose autocovariance depends on the
 * distance alone. */
static bool has_kink(const asp_wall *wall, const aspi_slopes_along *slopes, aspi_stream *stream) {
  double along = slopes->kappa * sqrt(-2 * log(aspi_stream_uniform(stream)));
  if (along > 1 || !wall->isotropic)
    return along > 1;
  double across = along / 3 + slopes->kappa_across * sqrt(8) / 3 * aspi_stream_normal(stream);
  double mixed2 = slopes->kappa * slopes->kappa_across / 3, draw = aspi_stream_normal(stream);
  return (1 - along) * (1 - across) < mixed2 * draw * draw;
}

/* The next face of a particle that stays at the wall. */
typedef struct next_face {
  bool kink;       /* the particle comes down to it with the slope `down` */
  double down, up; /* else from a crest of the curvature up bend/length */
  double bend, length;
} next_face;

static next_face gaussian_face(const aspi_roughness *rough, aspi_heading heading, double length,
                               aspi_stream *stream) {
  aspi_slopes_along slopes = aspi_roughness_along(rough, heading);
  next_face next = {
      .up = rayleigh(&slopes, stream), .bend = sqrt(6), .length = length / ASPI_FACE_LENGTH};
  next.kink = has_kink(rough->wall, &slopes, stream);
  if (next.kink)
    next.down = rayleigh(&slopes, stream);
  return next;
}

/* A face of the wall's table; *path: its slope across the way. */
static next_face face_of(const aspi_valley_table *table, aspi_stream *stream, aspi_path *path) {
  const aspi_face *at = &table->face[(size_t)((double)table->faces * aspi_stream_uniform(stream))];
  path->q = at->side;
  return (next_face){!(at->length > 0), -at->down, at->up, ASP_PI, at->length};
}

/* The first-hit law at grazing incidence has smaller slopes than these (aspi_grazing), because
 * those particles come from afar, over the highest summits.
 *
 * In a kink the particle comes to the face down that behind it, and hits it with the sum of both
 * slopes. Otherwise it hits a face only if it has left the wall on the crest before, a sine of
 * steepest slope p and curvature p sqrt(6)/lambda_c (Rice's ratio of both rms values for Gaussian
 * heights): if the press is a share b < 1 of what holds it there. It comes down on the parabola
 * with p sqrt(12) (1 - b)^(3/2) against the wall, to the first order of 1 - b, which is p at b =
 * 0.56; faster ones meet p. */
asp_code asp_wall_impact_grazing(const asp_wall *wall, const asp_particle *particle,
                                 const double v1[3], const double n[3], double press,
                                 const asp_key *key, asp_impact *impact) {
  asp_pair pair;
  asp_wall held;
  *impact = (asp_impact){.hits = 0};
  store(load(v1), impact->v2);
  store(load(particle->omega), impact->omega);
  wall = aspi_wall_met(wall, particle, key, &held);
  if (!wall)
    return ASP_ERANGE;
  asp_particle own = aspi_as_grain(wall, particle, key, &pair);
  particle = &own;
  if (!particle->pair && wall->law->needs_pair)
    return ASP_EARG;
  frame f = frame_of(aspi_touching(particle, load(v1)), load(n));
  if (!wall->rough || !has_direction(&f))
    return ASP_OK;
  vec along = plus(load(v1), f.v_n, f.n);
  aspi_stream stream = aspi_stream_begin(key);
  aspi_roughness rough = aspi_roughness_of(wall, particle, f.n);
  aspi_heading heading = aspi_heading_of(&rough, &f);
  aspi_valley_table table = aspi_roughness_valleys(&rough, heading);
  aspi_path path = {0};
  next_face next =
      table.faces
          ? face_of(&table, &stream, &path)
          : gaussian_face(&rough, heading, asp_wall_face_length(wall, particle, v1, n), &stream);
  double p = next.up;
  f.v_n = 0;
  if (next.kink)
    f = turned_down(particle, &f, along, next.down);
  else {
    double loose = 1 - press * next.length / (f.v_t * f.v_t * p * next.bend);
    if (!(loose > 0))
      return ASP_OK;
    p *= fmin(1, sqrt(12) * pow(loose, 1.5));
  }
  aspi_slopes_along slopes = aspi_roughness_along(&rough, heading);
  aspi_tilt on = aspi_tilt_at(wall, &slopes, atan(p), table.faces ? &path : NULL, &stream);
  vec local, spin = load(particle->omega);
  bool deposit;
  if (!aspi_hit_rebound(wall, particle, &f, on.m, !wall->isotropic, &stream, &spin, &local,
                        &deposit) ||
      !(deposit || local.z > 0))
    return ASP_OK;
  *impact = (asp_impact){.delta_alpha = on.delta,
                         .tilt_out = atan(on.q),
                         .hits = 1,
                         .outcome = deposit ? ASP_DEPOSIT : ASP_REBOUND,
                         .eroded = aspi_hit_eroded(wall, particle, &f, on.m)};
  store(deposit ? local : aspi_hit_leaving(&f, to_lab(&f, local)), impact->v2);
  store(spin, impact->omega);
  aspi_to_center(particle, impact);
  return ASP_OK;
}
