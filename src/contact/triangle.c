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
  const double share = square > 0 ? aspi_dot(arm, edge) / square : 0;
  aspi_add_scaled(a, fmin(1, fmax(0, share)), edge, nearest);
  aspi_subtract(x, nearest, arm);
  return aspi_length(arm);
}

/* The normal, and its length, which is not 1; false where the triangle is degenerate. */
static bool face_normal(const ContactTriangle *triangle, double normal[3], double *length) {
  double ab[3], ac[3], bc[3];
  aspi_subtract(triangle->node[1], triangle->node[0], ab);
  aspi_subtract(triangle->node[2], triangle->node[0], ac);
  aspi_subtract(triangle->node[2], triangle->node[1], bc);
  aspi_cross(ab, ac, normal);
  const double b = aspi_dot(ab, ab), c = aspi_dot(ac, ac), d = aspi_dot(bc, bc);
  const double longest = b > c ? b : c; /* fmax would be a call */
  *length = aspi_length(normal);
  return *length > SUM_ROUNDING * (longest > d ? longest : d);
}

/* True if the foot of x on the triangle's plane lies inside all three edges. */
static bool above_face(const ContactTriangle *triangle, const double normal[3], const double x[3]) {
  for (int k = 0; k < 3; k++) {
    double edge[3], inward[3], arm[3];
    aspi_subtract(triangle->node[(k + 1) % 3], triangle->node[k], edge);
    aspi_cross(normal, edge, inward);
    aspi_subtract(x, triangle->node[k], arm);
    if (aspi_dot(arm, inward) < 0)
      return false;
  }
  return true;
}

void aspi_triangle_normal(const ContactTriangle *triangle, double normal[3]) {
  double length;
  const bool flat = face_normal(triangle, normal, &length);
  aspi_scale(flat ? 1 / length : 0, normal);
}

bool aspi_triangle_is_under(const ContactTriangle *triangle, const double x[3], double normal[3]) {
  double length;
  if (!face_normal(triangle, normal, &length) || !above_face(triangle, normal, x))
    return false;
  aspi_scale(1 / length, normal);
  return true;
}

double aspi_triangle_area(const ContactTriangle *triangle) {
  double normal[3], length;
  face_normal(triangle, normal, &length);
  return 0.5 * length;
}

/* The point of the triangle that is nearest to x, and its distance. normal: from face_normal(),
 * with its result and its length. */
static double nearest_point(const ContactTriangle *triangle, const double normal[3], bool flat,
                            double length, const double x[3], double nearest[3]) {
  if (flat && above_face(triangle, normal, x)) {
    double arm[3], unit[3];
    aspi_copy(normal, unit);
    aspi_scale(1 / length, unit);
    aspi_subtract(x, triangle->node[0], arm);
    const double height = aspi_dot(arm, unit);
    aspi_add_scaled(x, -height, unit, nearest);
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
  double normal[3], length;
  const bool flat = face_normal(triangle, normal, &length);
  return nearest_point(triangle, normal, flat, length, x, nearest);
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
static void normal_at(const ContactTriangle *triangle, const ContactPath *path, double radius,
                      const double arm[3], double distance, ContactTouch *touch) {
  if (distance > 1e-12 * radius) {
    aspi_copy(arm, touch->n);
    aspi_scale(1 / distance, touch->n);
    return;
  }
  touch->overlapped = true;
  aspi_triangle_normal(triangle, touch->n);
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
  double across[3], normal[3], x[3], nearest[3], arm[3], length;
  const bool flat = face_normal(triangle, across, &length);
  aspi_copy(across, normal);
  aspi_scale(flat ? 1 / length : 0, normal);
  double time = time_to_plane(normal, triangle, path, radius);
  touch->overlapped = false;
  touch->overlap = 0;
  for (int i = 0; i < NEWTON_MAX; i++) {
    if (!(time <= latest))
      return false;
    aspi_add_scaled(path->x, time, path->v, x);
    const double distance = nearest_point(triangle, across, flat, length, x, nearest);
    aspi_subtract(x, nearest, arm);
    normal_at(triangle, path, radius, arm, distance, touch);
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
    time = fmax(0, time + gap / approach);
  }
  touch->time = time;
  aspi_cross(touch->n, normal, arm);
  touch->edge_sine = aspi_length(arm);
  return time <= latest;
}
