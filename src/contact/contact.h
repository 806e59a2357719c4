/* The first contact of a sphere on a straight path with a triangle. Pure geometry: no engine, no
 * roughness, no physics. Lengths and times are in any consistent units. A triangle is at rest; for
 * a moving one the caller passes the path relative to it.
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

/* The first contact of the path of a sphere at or before `latest`; false: none. */
bool aspi_triangle_find(const ContactTriangle *triangle, const ContactPath *path, double radius,
                        double latest, ContactTouch *touch);

#ifdef __cplusplus
}
#endif
