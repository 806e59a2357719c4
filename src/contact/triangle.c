/* A sphere and a triangle; see contact.h. The distance of a point that moves on a straight line
 * from a triangle is a convex function of time, so Newton's method from the beginning of the path
 * approaches the instant of contact from below, and a sphere that moves away at first never
 * returns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "contact/contact.h"
#include "contact/vector.h"

static const int NEWTON_MAX = 60;

/* The nearest point of the edge from a to b. */
static double nearest_on_edge(const double a[3], const double b[3], const double x[3],
                              double nearest[3]) {
  double edge[3], arm[3];
  aspi_subtract(b, a, edge);
  aspi_subtract(x, a, arm);
  const double square = aspi_dot(edge, edge);
  const double along = aspi_dot(arm, edge); /* fmax and fmin would be calls */
  const double share = !(square > 0 && along > 0) ? 0 : along < square ? along / square : 1;
  aspi_add_scaled(a, share, edge, nearest);
  aspi_subtract(x, nearest, arm);
  return aspi_length(arm);
}

/* What a triangle is for points near it: its edges from node 0, and its unit normal, which is 0
 * where the triangle is degenerate. */
typedef struct Face {
  double ab[3], ac[3], normal[3];
  double twice; /* its area */
  bool is_flat;
} Face;

static inline void make_face(const ContactTriangle *triangle, Face *face) {
  aspi_subtract(triangle->node[1], triangle->node[0], face->ab);
  aspi_subtract(triangle->node[2], triangle->node[0], face->ac);
  aspi_cross(face->ab, face->ac, face->normal);
  const double b = aspi_dot(face->ab, face->ab), c = aspi_dot(face->ac, face->ac);
  const double d = b + c - 2 * aspi_dot(face->ab, face->ac);
  const double longest = b > c ? b : c; /* fmax would be a call */
  face->twice = aspi_length(face->normal);
  face->is_flat = face->twice > SUM_ROUNDING * (longest > d ? longest : d);
  aspi_scale(face->is_flat ? 1 / face->twice : 0, face->normal);
}

/* True if the foot of a point on the triangle's plane lies inside all three edges. arm: of the
 * point from node 0. */
static inline bool above_face(const Face *face, const double arm[3]) {
  double side[3];
  if (!face->is_flat)
    return false;
  aspi_cross(face->ab, arm, side);
  const double c = aspi_dot(face->normal, side);
  aspi_cross(arm, face->ac, side);
  const double b = aspi_dot(face->normal, side);
  const double rounding = SUM_ROUNDING * face->twice;
  return b >= -rounding && c >= -rounding && b + c <= face->twice + rounding;
}

void aspi_triangle_normal(const ContactTriangle *triangle, double normal[3]) {
  Face face;
  make_face(triangle, &face);
  aspi_copy(face.normal, normal);
}

bool aspi_triangle_is_under(const ContactTriangle *triangle, const double x[3], double normal[3],
                            double *height) {
  Face face;
  double arm[3];
  make_face(triangle, &face);
  aspi_subtract(x, triangle->node[0], arm);
  aspi_copy(face.normal, normal);
  *height = aspi_dot(arm, normal);
  return above_face(&face, arm);
}

double aspi_triangle_area(const ContactTriangle *triangle) {
  Face face;
  make_face(triangle, &face);
  return 0.5 * face.twice;
}

/* The point of the triangle that is nearest to x, and its distance. */
static double nearest_point(const ContactTriangle *triangle, const Face *face, const double x[3],
                            double nearest[3]) {
  double arm[3];
  aspi_subtract(x, triangle->node[0], arm);
  if (above_face(face, arm)) {
    const double height = aspi_dot(arm, face->normal);
    aspi_add_scaled(x, -height, face->normal, nearest);
    return fabs(height);
  }
  double least = INFINITY;
  for (int k = 0; k < 3; k++) {
    double point[3];
    const double distance =
        nearest_on_edge(triangle->node[k], triangle->node[(k + 1) % 3], x, point);
    if (distance < least) {
      least = distance;
      aspi_copy(point, nearest);
    }
  }
  return least;
}

double aspi_triangle_nearest(const ContactTriangle *triangle, const double x[3],
                             double nearest[3]) {
  Face face;
  make_face(triangle, &face);
  return nearest_point(triangle, &face, x, nearest);
}

/* The time at which a path comes within the sphere's radius of the triangle's plane: a lower bound
 * of the contact; 0 if it begins there, infinite for never. */
static double time_to_plane(const double normal[3], const ContactTriangle *triangle,
                            const ContactPath *path, double radius) {
  double arm[3];
  aspi_subtract(path->x, triangle->node[0], arm);
  const double from = aspi_dot(normal, arm), rate = aspi_dot(normal, path->v);
  const double gap = fabs(from) - radius;
  if (gap <= 0)
    return 0;
  return from * rate < 0 ? gap / fabs(rate) : INFINITY;
}

/* The normal from the triangle to the center. For a center on the triangle it is the side
 * that it comes from. */
static void normal_at(const double normal[3], const ContactPath *path, double radius,
                      const double arm[3], double distance, ContactTouch *touch) {
  if (distance > 1e-12 * radius) {
    aspi_copy(arm, touch->n);
    aspi_scale(1 / distance, touch->n);
    return;
  }
  touch->overlapped = true;
  aspi_copy(normal, touch->n);
  const double along = aspi_dot(path->v, touch->n);
  if (along > 0)
    aspi_scale(-1, touch->n);
  else if (!(along < 0)) {
    aspi_copy(path->v, touch->n);
    aspi_scale(-1 / aspi_length(path->v), touch->n);
  }
}

bool aspi_triangle_find(const ContactTriangle *triangle, const ContactPath *path, double radius,
                        double latest, ContactTouch *touch) {
  const double speed = aspi_length(path->v);
  if (!(speed > 0))
    return false;
  double x[3], nearest[3], arm[3];
  Face face;
  make_face(triangle, &face);
  double time = time_to_plane(face.normal, triangle, path, radius);
  touch->overlapped = false;
  touch->overlap = 0;
  for (int i = 0; i < NEWTON_MAX; i++) {
    if (!(time <= latest))
      return false;
    aspi_add_scaled(path->x, time, path->v, x);
    const double distance = nearest_point(triangle, &face, x, nearest);
    aspi_subtract(x, nearest, arm);
    normal_at(face.normal, path, radius, arm, distance, touch);
    const double gap = distance - radius, approach = -aspi_dot(path->v, touch->n);
    if (!(approach > APPROACH * speed))
      return false;
    if (fabs(gap) <= TOUCHING * radius)
      break;
    if (gap < 0 && time <= 0) {
      touch->overlapped = true;
      touch->overlap = -gap;
      break;
    }
    time += gap / approach;
    time = time > 0 ? time : 0;
  }
  touch->time = time;
  aspi_cross(touch->n, face.normal, arm);
  touch->edge_sine = aspi_length(arm);
  return time <= latest;
}
