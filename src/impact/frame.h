/* The frame of a contact, as straight code for one contact and for loops over many. */
#ifndef ASP_IMPACT_FRAME_H
#define ASP_IMPACT_FRAME_H

#include "angle.h"
#include "asperity.h"

#include <float.h>
#include <math.h>

/* Below this share of the speed the tangential velocity has no direction. */
#define NO_DIRECTION 1e-12

/* Below this share of the energy along the wall, its direction is worked out with care. */
#define NEARLY_NORMAL 1e-4

/* By value, and by component: kept in registers. */
typedef struct vec {
  double x, y, z;
} vec;

typedef struct frame {
  vec n, along;      /* along: the velocity along the wall, t times v_t */
  double v_n, v_t;   /* approach and tangential speed, >= 0 */
  double per_length; /* of along: t = per_length along; 0 where it has no direction */
} frame;

static inline vec load(const double v[3]) {
  return (vec){v[0], v[1], v[2]};
}

static inline void store(vec a, double v[3]) {
  v[0] = a.x;
  v[1] = a.y;
  v[2] = a.z;
}

static inline double dot(vec a, vec b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec cross(vec a, vec b) {
  return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline vec scaled(vec a, double s) {
  return (vec){a.x * s, a.y * s, a.z * s};
}

/* a + s b */
static inline vec plus(vec a, double s, vec b) {
  return (vec){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

/* 1 over the root of the square of a length that is nearly 1, by a step of Newton's method. */
static inline double near_unit(double square) {
  return 1.5 - 0.5 * square;
}

static inline bool is_near_unit(double square) {
  return fabs(square - 1) < 1e-8;
}

/* The frame of a velocity at a wall of any normal, for nearly all contacts; *plain is false for one
 * that needs more care. Straight code, in which the normal's length and the speed along it are
 * found side by side. */
static inline frame plain_frame(vec v, vec normal, bool *plain) {
  double length2 = dot(normal, normal), per_length = near_unit(length2);
  double v_n = -dot(v, normal) * per_length;
  vec n = scaled(normal, per_length), along = plus(v, v_n, n);
  double square = dot(along, along), v_t = sqrt(square);
  *plain = is_near_unit(length2) & (square > NEARLY_NORMAL * v_n * v_n);
  return (frame){n, along, v_n, v_t, v_t > 0 ? 1 / v_t : 0};
}

/* The frame of a velocity at a wall of unit normal n. Of a velocity nearly along n, what is left of
 * the difference is rounding, and taken off again. */
static inline frame careful_frame(vec v, vec n) {
  frame f = {.n = n, .v_n = -dot(v, n)};
  f.along = plus(v, f.v_n, f.n);
  f.along = plus(f.along, -dot(f.along, f.n), f.n);
  f.v_t = sqrt(dot(f.along, f.along));
  bool has_direction = f.v_t >= NO_DIRECTION * fabs(f.v_n) && f.v_t > 0;
  f.per_length = has_direction ? 1 / f.v_t : 0;
  return f;
}

static inline vec unit(vec n) {
  return scaled(n, 1 / sqrt(dot(n, n)));
}

static inline frame frame_of(vec v, vec normal) {
  bool plain;
  frame f = plain_frame(v, normal, &plain);
  return plain ? f : careful_frame(v, unit(normal));
}

static inline bool has_direction(const frame *f) {
  return f->per_length > 0;
}

static inline vec to_lab(const frame *f, vec local) {
  vec v = plus(scaled(f->along, local.x * f->per_length), local.z, f->n);
  return fabs(local.y) > 0 ? plus(v, local.y * f->per_length, cross(f->n, f->along)) : v;
}

/* Whether v leaves the wall beyond doubt: whoever works out v.n, with a normal that is off by its
 * last bits, finds it positive. */
static inline bool clearly_leaves(vec v, vec n) {
  double sum = fabs(v.x * n.x) + fabs(v.y * n.y) + fabs(v.z * n.z);
  return dot(v, n) > 4 * DBL_EPSILON * sum;
}

#endif
