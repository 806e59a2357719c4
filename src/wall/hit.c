/* One hit on one face: the velocity in the face's frame, the restitution law, and back.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/hit.h"
#include "wall/body.h"

aspi_tilt aspi_tilt_at(const asp_wall *wall, const aspi_slopes_along *slopes, double delta,
                       const aspi_path *path, aspi_stream *stream) {
  double sine = sin(delta), cosine = cos(delta);
  if (!wall->isotropic)
    return (aspi_tilt){{-sine, 0, cosine}, delta, 0};
  double q = wall->has_cross_slope && path
                 ? path->q
                 : slopes->beta * (sine / cosine) + slopes->sd * aspi_stream_normal(stream),
         side = q * cosine;
  return (aspi_tilt){scaled((vec){-sine, -side, cosine}, 1 / sqrt(1 + side * side)), delta, q};
}

/* Turns v off the wall by some last bits, taken from the speed along the wall, so that the kinetic
 * energy does not grow. */
static vec turned_off(const frame *f, vec v) {
  for (int i = 0; i < 8 && !clearly_leaves(v, f->n); i++) {
    double speed = sqrt(dot(v, v)), step = 4 * (double)(1 << i) * DBL_EPSILON;
    v = plus(scaled(v, 1 - step), step * speed, f->n);
  }
  return v;
}

/* Makes sure that v leaves the wall in the lab frame, too: a grazing one may point into it by its
 * last bits. */
vec aspi_hit_leaving(const frame *f, vec v) {
  return clearly_leaves(v, f->n) ? v : turned_off(f, v);
}

/* Applies the rebound law to the speeds of approach, of the center along the face, and of the
 * surface along it; true if the particle deposits. */
static bool sticks(const asp_wall *wall, const asp_particle *particle, double density,
                   const double speed[3], aspi_stream *stream, aspi_bounce *bounce) {
  bool holding = wall->deposit;
  const double kelvin = aspi_heat_of(wall->heat, particle->temperature);
  aspi_hit hit = {speed[0],       speed[1], speed[2],    particle->d_p, density,
                  particle->pair, holding,  wall->table, stream,        kelvin};
  *bounce = wall->law->rebound(wall->parameters, &hit);
  return holding && !(bounce->v_n2 > 0);
}

/* The rebound by a law that turns the particle, along a face of normal m: the particle's surface
 * moves there with v_t - r omega x m, and the law's impulse acts against that. `spin` in the lab
 * frame. */
static bool rebound_spinning(const asp_wall *wall, const asp_particle *particle, const frame *f,
                             vec m, double approach, aspi_stream *stream, vec *spin, vec *out) {
  double r = particle->d_p / 2;
  vec t = scaled(f->along, f->per_length),
      turn = {dot(*spin, t), dot(*spin, cross(f->n, t)), dot(*spin, f->n)};
  vec along = plus((vec){f->v_t, 0, -f->v_n}, approach, m);
  vec surface = plus(along, -r, cross(turn, m));
  double u = sqrt(dot(surface, surface));
  aspi_bounce bounce;
  if (sticks(wall, particle, particle->density, (double[]){approach, sqrt(dot(along, along)), u},
             stream, &bounce)) {
    *spin = *out = (vec){0, 0, 0};
    return true;
  }
  double share = u > 0 ? bounce.rub / u : 0;
  *out = plus(plus(scaled(m, bounce.v_n2), 1, along), -share, surface);
  *spin = to_lab(f, plus(turn, 2.5 * share / r, cross(m, surface)));
  return false;
}

/* The inverse of the mass that a face of normal m meets, m in the lab frame. */
static double inverse_mass(const asp_body *body, vec m) {
  return dot(m, aspi_body_kick(body, load(body->lever), m));
}

/* The rebound of a body. The law acts as on a sphere of the effective mass 1/(m.K m): its
 * restitution and its friction are those of the contact. Friction acts at the point of contact if
 * the law turns spheres, otherwise at the center of the touching sphere. A deposit holds the whole
 * body. */
static bool rebound_body(const asp_wall *wall, const asp_particle *particle, const frame *f,
                         vec local, double approach, aspi_stream *stream, vec *spin, vec *out) {
  const asp_body *body = particle->body;
  double r = particle->d_p / 2, volume = ASP_SPHERE_VOLUME(particle->d_p);
  vec m = to_lab(f, local), lever = load(body->lever), arm = plus(lever, wall->spins ? -r : 0, m);
  vec before = to_lab(f, (vec){f->v_t, 0, -f->v_n});
  vec at = wall->spins ? plus(before, -r, cross(*spin, m)) : before;
  vec along = plus(before, approach, m), surface = plus(at, -dot(at, m), m);
  double speed[3] = {approach, sqrt(dot(along, along)), sqrt(dot(surface, surface))};
  aspi_bounce bounce;
  if (sticks(wall, particle, 1 / (inverse_mass(body, m) * volume), speed, stream, &bounce)) {
    *spin = *out = (vec){0, 0, 0};
    return true;
  }
  vec impulse =
      aspi_body_impulse(body, arm, m, at, fmin(1, bounce.v_n2 / approach), bounce.friction);
  vec turn = aspi_body_turn(body, arm, impulse);
  vec v = plus(plus(before, body->inverse_mass, impulse), 1, cross(turn, lever));
  vec t = scaled(f->along, f->per_length);
  *out = (vec){dot(v, t), dot(v, cross(f->n, t)), dot(v, f->n)};
  *spin = plus(*spin, 1, turn);
  return false;
}

bool aspi_hit_rebound(const asp_wall *wall, const asp_particle *particle, const frame *f, vec m,
                      bool in_plane, aspi_stream *stream, vec *spin, vec *out, bool *deposit) {
  double approach = f->v_n * m.z - f->v_t * m.x, speed;
  if (!(approach > 0))
    return false;
  if (particle->body) {
    *deposit = rebound_body(wall, particle, f, m, approach, stream, spin, out);
    return true;
  }
  if (wall->spins) {
    *deposit = rebound_spinning(wall, particle, f, m, approach, stream, spin, out);
    return true;
  }
  vec along; /* of unit length, or of `speed` */
  if (in_plane) {
    speed = f->v_t * m.z + f->v_n * m.x;
    along = speed < 0 ? (vec){-m.z, 0, m.x} : (vec){m.z, 0, -m.x};
    speed = fabs(speed);
  } else {
    along = plus((vec){f->v_t, 0, -f->v_n}, approach, m);
    speed = sqrt(dot(along, along));
  }
  aspi_bounce bounce;
  *deposit = sticks(wall, particle, particle->density, (double[]){approach, speed, speed}, stream,
                    &bounce);
  if (*deposit)
    *spin = (vec){0, 0, 0};
  double kept = in_plane ? bounce.v_t2 : speed > 0 ? bounce.v_t2 / speed : 0;
  *out = *deposit ? (vec){0, 0, 0} : plus(scaled(m, bounce.v_n2), kept, along);
  return true;
}

double aspi_hit_erosion(const asp_wall *wall, const asp_particle *particle, const frame *f, vec m) {
  double approach = f->v_n * m.z - f->v_t * m.x, v = hypot(f->v_t, f->v_n);
  double sine = v > 0 ? fmin(1, fmax(0, approach / v)) : 0, share = 1;
  if (particle->body)
    share = particle->body->inverse_mass / inverse_mass(particle->body, to_lab(f, m));
  return share * aspi_erosion_ratio(&wall->erosion,
                                    particle->pair ? particle->pair->wall_density : 0, v, sine,
                                    sqrt((1 - sine) * (1 + sine)), particle->d_p);
}
