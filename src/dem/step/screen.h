/* What stands between a particle and a wall that it is near: planes, and balls in hollow faces. One
 * that lies on a wall, or moves along it, is near for many steps and meets no other face; this is
 * seen with no search.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "dem/setup.h"
#include "dem/step/memory.h"

namespace asperity {

class Screen {
public:
  int i; /* of the particle */

  /* How far a particle and the walls may move together before it is to be made anew; and how far
   * one that rests looks ahead: many triangles are near. */
  static double range(double radius);

  /* A screen around a particle, as yet in front of nothing. */
  Screen(const Spheres &spheres, int i);
  /* Adds one shape, but for the faces at which the particle stays; false where it has none. */
  bool add(const Setup &setup, size_t shape, const FaceList &stays);
  bool is_empty() const {
    return barriers_.count == 0;
  }

  /* True if the particle meets nothing in this step, in which shapes move by `travel` at most. To
   * be asked once in each step, from that in which it is made. */
  bool holds(const Setup &setup, const Spheres &spheres, double travel);

private:
  double radius_, x_[3], way_; /* of the particle; the way that is left, from x */
  double at_[3], gap_;         /* twice the way that is left from `at` before the next look */
  BarrierList barriers_;
};

} // namespace asperity
