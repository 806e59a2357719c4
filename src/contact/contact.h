/* The first contact of a sphere on a straight path with a plane, a cylinder or a triangle. Pure
 * geometry: no engine, no roughness, no physics. Lengths and times are in any consistent units. A
 * wall piece is at rest; for a moving one the caller passes the path relative to it.
 *
 * All functions take the path, the sphere's radius, and the latest time of interest. They return
 * true if there is a contact at or before it, and fill `touch` then.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdbool.h>

#include "contact/tolerances.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The center of a sphere moves from x with velocity v for the time `left`. */
typedef struct ContactPath {
  double x[3], v[3], left;
} ContactPath;

typedef struct ContactTouch {
  double time;      /* since the beginning of the path, 0 to left */
  double n[3];      /* unit normal from the wall to the center, v.n < 0 */
  double overlap;   /* >= 0: overlap at the beginning, along n */
  bool overlapped;  /* it overlapped, or its center lay on the wall, where the side is a guess */
  double edge_sine; /* sine between n and the normal of what is touched: 0 for a face, more for an
                   edge or a corner */
} ContactTouch;

/* The plane x[axis] = at, met from both sides. axis 0 to 2. */
typedef struct ContactPlane {
  int axis;
  double at;
} ContactPlane;

bool aspi_plane_find(const ContactPlane *plane, const ContactPath *path, double radius,
                     double latest, ContactTouch *touch);

/* A cylinder of infinite length around an axis parallel to a coordinate axis, through `center`
 * (whose component along the axis is not used), met from inside or outside. A sphere inside that is
 * wider than the cylinder is put back on the axis. */
typedef struct ContactCylinder {
  int axis;
  double center[3], radius;
} ContactCylinder;

/* A sphere that touches the inside and slides along it, with next to no normal speed, but would
 * leave the wall's curve by the end of its path, touches at time 0; v.n may be 0 then. */
bool aspi_cylinder_find(const ContactCylinder *cylinder, const ContactPath *path, double radius,
                        double latest, ContactTouch *touch);

/* A triangle, met from both sides, at its edges and corners too. A degenerate one is its edges. */
typedef struct ContactTriangle {
  double node[3][3];
} ContactTriangle;

/* The point of the triangle that is nearest to x; returns its distance. */
double aspi_triangle_nearest(const ContactTriangle *triangle, const double x[3], double nearest[3]);

/* The unit normal by the right-hand rule; zero for a degenerate triangle. */
void aspi_triangle_normal(const ContactTriangle *triangle, double normal[3]);

/* True if the foot of x on the triangle's plane is on the triangle. Fills its normal, and the
 * height of x over the plane on that side. */
bool aspi_triangle_is_under(const ContactTriangle *triangle, const double x[3], double normal[3],
                            double *height);
double aspi_triangle_area(const ContactTriangle *triangle);

bool aspi_triangle_find(const ContactTriangle *triangle, const ContactPath *path, double radius,
                        double latest, ContactTouch *touch);

#ifdef __cplusplus
}
#endif
