/* A sphere and a plane across a coordinate axis; see contact.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "contact/contact.h"
#include "contact/vector.h"

bool aspi_plane_find(const ContactPlane *plane, const ContactPath *path, double radius,
                     double latest, ContactTouch *touch) {
  const int axis = plane->axis;
  const double off = path->x[axis] - plane->at, v = path->v[axis];
  const bool centered = fabs(off) <= 1e-12 * radius;
  const double side = centered ? (v > 0 ? -1 : 1) : off > 0 ? 1 : -1;
  const double approach = -side * v, gap = fabs(off) - radius;
  if (!(approach > APPROACH * aspi_length(path->v)))
    return false;
  touch->time = gap > 0 ? gap / approach : 0;
  if (!(touch->time <= latest))
    return false;
  touch->overlap = gap < -TOUCHING * radius ? -gap : 0;
  touch->edge_sine = 0;
  touch->overlapped = centered || touch->overlap > 0;
  for (int d = 0; d < 3; d++)
    touch->n[d] = d == axis ? side : 0;
  return true;
}
