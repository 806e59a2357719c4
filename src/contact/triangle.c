/* A sphere and a triangle; see contact.h. The distance of a point that moves on a straight line
 * from a triangle, which is convex, is a convex function of time: so Newton's method from the
 * beginning of the path comes to the instant of contact from below, and a sphere that moves away at
 * the beginning never comes back.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "contact/contact.h"
#include "contact/vector.h"

static const int NEWTON_MAX = 60;

/* A triangle whose height is less than this share of its longest edge has no face. */
static const double DEGENERATE = 1e-12;

/* The nearest point of the edge from a to b. */
static double nearest_on_edge(const double a[3], const double b[3], const double x[3],
                              double nearest[3]) {
  double edge[3], arm[3];
  vector_subtract(b, a, edge);
  vector_subtract(x, a, arm);
  const double square = vector_dot(edge, edge);
  const double share = square > 0 ? vector_dot(arm, edge) / square : 0;
  vector_add_scaled(a, fmin(1, fmax(0, share)), edge, nearest);
  vector_subtract(x, nearest, arm);
  return vector_length(arm);
}

/* The normal, not of unit length; false where the triangle is degenerate. */
static bool face_normal(const ContactTriangle *triangle, double normal[3]) {
  double ab[3], ac[3], bc[3];
  vector_subtract(triangle->node[1], triangle->node[0], ab);
  vector_subtract(triangle->node[2], triangle->node[0], ac);
  vector_subtract(triangle->node[2], triangle->node[1], bc);
  vector_cross(ab, ac, normal);
  const double longest = fmax(vector_dot(ab, ab), fmax(vector_dot(ac, ac), vector_dot(bc, bc)));
  return vector_length(normal) > DEGENERATE * longest;
}

void contact_triangle_normal(const ContactTriangle *triangle, double normal[3]) {
  const bool flat = face_normal(triangle, normal);
  vector_scale(flat ? 1 / vector_length(normal) : 0, normal);
}

double contact_triangle_area(const ContactTriangle *triangle) {
  double normal[3];
  face_normal(triangle, normal);
  return 0.5 * vector_length(normal);
}

/* Whether the foot of x on the triangle's plane lies within it: on the inner side of each edge. */
static bool above_face(const ContactTriangle *triangle, const double normal[3], const double x[3]) {
  for (int k = 0; k < 3; k++) {
    double edge[3], inward[3], arm[3];
    vector_subtract(triangle->node[(k + 1) % 3], triangle->node[k], edge);
    vector_cross(normal, edge, inward);
    vector_subtract(x, triangle->node[k], arm);
    if (vector_dot(arm, inward) < 0)
      return false;
  }
  return true;
}

/* The point of the triangle that is nearest to x, and its distance. normal: from face_normal(),
 * with its result and its length. */
static double nearest_point(const ContactTriangle *triangle, const double normal[3], bool flat,
                            double length, const double x[3], double nearest[3]) {
  if (flat && above_face(triangle, normal, x)) {
    double arm[3], unit[3];
    vector_copy(normal, unit);
    vector_scale(1 / length, unit);
    vector_subtract(x, triangle->node[0], arm);
    const double height = vector_dot(arm, unit);
    vector_add_scaled(x, -height, unit, nearest);
    return fabs(height);
  }
  double least = INFINITY;
  for (int k = 0; k < 3; k++) {
    double point[3];
    const double distance =
        nearest_on_edge(triangle->node[k], triangle->node[(k + 1) % 3], x, point);
    if (distance < least) {
      least = distance;
      vector_copy(point, nearest);
    }
  }
  return least;
}

double contact_triangle_nearest(const ContactTriangle *triangle, const double x[3],
                                double nearest[3]) {
  double normal[3];
  const bool flat = face_normal(triangle, normal);
  return nearest_point(triangle, normal, flat, vector_length(normal), x, nearest);
}

/* When a path comes within the sphere's radius of the triangle's plane, before which it cannot
 * touch; 0 where it begins there, infinite where it never does. */
static double time_to_plane(const double normal[3], const ContactTriangle *triangle,
                            const ContactPath *path, double radius) {
  double arm[3];
  vector_subtract(path->x, triangle->node[0], arm);
  const double from = vector_dot(normal, arm), rate = vector_dot(normal, path->v);
  const double gap = fabs(from) - radius;
  if (gap <= 0)
    return 0;
  return from * rate < 0 ? gap / fabs(rate) : INFINITY;
}

/* The normal from the triangle to the centre. A centre on the triangle has none: then that side is
 * taken which it comes from. */
static void normal_at(const ContactTriangle *triangle, const ContactPath *path, double radius,
                      const double arm[3], double distance, ContactTouch *touch) {
  if (distance > 1e-12 * radius) {
    vector_copy(arm, touch->n);
    vector_scale(1 / distance, touch->n);
    return;
  }
  touch->guarded = true;
  contact_triangle_normal(triangle, touch->n);
  const double along = vector_dot(path->v, touch->n);
  if (along > 0)
    vector_scale(-1, touch->n);
  else if (!(along < 0)) {
    vector_copy(path->v, touch->n);
    vector_scale(-1 / vector_length(path->v), touch->n);
  }
}

bool contact_triangle_find(const ContactTriangle *triangle, const ContactPath *path, double radius,
                           double latest, ContactTouch *touch) {
  const double speed = vector_length(path->v);
  if (!(speed > 0))
    return false;
  double across[3], normal[3], x[3], nearest[3], arm[3];
  const bool flat = face_normal(triangle, across);
  const double length = vector_length(across);
  vector_copy(across, normal);
  vector_scale(flat ? 1 / length : 0, normal);
  double time = time_to_plane(normal, triangle, path, radius);
  touch->guarded = false;
  touch->lift = 0;
  for (int i = 0; i < NEWTON_MAX; i++) {
    if (!(time <= latest))
      return false;
    vector_add_scaled(path->x, time, path->v, x);
    const double distance = nearest_point(triangle, across, flat, length, x, nearest);
    vector_subtract(x, nearest, arm);
    normal_at(triangle, path, radius, arm, distance, touch);
    const double gap = distance - radius, approach = -vector_dot(path->v, touch->n);
    if (!(approach > CONTACT_APPROACH * speed))
      return false;
    if (fabs(gap) <= CONTACT_TOLERANCE * radius)
      break;
    if (gap < 0 && time <= 0) {
      touch->guarded = true;
      touch->lift = -gap;
      break;
    }
    time = fmax(0, time + gap / approach);
  }
  touch->time = time;
  vector_cross(touch->n, normal, arm);
  touch->slant = vector_length(arm);
  return time <= latest;
}
