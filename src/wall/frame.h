/* Vectors, and the frame of a contact: the wall's normal, and the velocity along the wall.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/tolerances.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

typedef struct vec {
  double x, y, z;
} vec;

typedef struct frame {
  vec n, along;      /* along: the velocity along the wall, t times v_t */
  double v_n, v_t;   /* approach and tangential speed, v_t >= 0 */
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

static inline vec unit(vec n) {
  return scaled(n, 1 / sqrt(dot(n, n)));
}

/* A unit vector across a unit vector. */
static inline vec across(vec n) {
  return unit(cross(n, fabs(n.x) < 0.6 ? (vec){1, 0, 0} : (vec){0, 1, 0}));
}

/* The frame of a velocity at a wall. A speed along it that is rounding has no direction. For a
 * velocity nearly along the normal the tangential rest has a normal part from rounding; it is
 * subtracted once more. */
static inline frame frame_of(vec v, vec normal) {
  frame f = {.n = unit(normal)};
  f.v_n = -dot(v, f.n);
  f.along = plus(v, f.v_n, f.n);
  f.along = plus(f.along, -dot(f.along, f.n), f.n);
  f.v_t = sqrt(dot(f.along, f.along));
  if (f.v_t > 0 && f.v_t >= ASPI_ROUNDING_DOUBLE * fabs(f.v_n))
    f.per_length = 1 / f.v_t;
  return f;
}

static inline bool has_direction(const frame *f) {
  return f->per_length > 0;
}

static inline vec to_lab(const frame *f, vec local) {
  vec v = plus(scaled(f->along, local.x * f->per_length), local.z, f->n);
  return plus(v, local.y * f->per_length, cross(f->n, f->along));
}

/* True if v.n > 0 even with a normal that is off by its last bits. */
static inline bool clearly_leaves(vec v, vec n) {
  double sum = fabs(v.x * n.x) + fabs(v.y * n.y) + fabs(v.z * n.z);
  return dot(v, n) > 4 * DBL_EPSILON * sum;
}
