/* Steps of random spheres at a shape: what they meet, and what keeps in front of barriers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "contact/vector.h"
#include "dem/shapes/shape.h"

#include "random.h"

namespace asperity {

struct BarrierCounts {
  int near, before, met, both; /* spheres with barriers, in front of all, that meet one, and both */
};

/* Adds one sphere of a radius whose step of length dt has ended. */
inline void count_sphere(const Shape &shape, double radius, double dt, BarrierCounts &counts) {
  double x[3], v[3], from[3];
  random_vector(1, x);
  random_vector(0.5, v);
  aspi_add_scaled(x, -dt, v, from);
  BarrierList made;
  made.count = 0;
  const double way = dt * aspi_length(v) + shape.travel(dt);
  if (!shape.separate(x, 1.01 * radius + way, FaceList(), made))
    return;
  Path path;
  Contact contact = Contact();
  aspi_copy(from, path.x);
  aspi_copy(v, path.v);
  path.left = path.dt = dt;
  path.rest = 0;
  const bool is_near = made.count > 0;
  const bool is_before = !is_near || shape.gap(made.of(0), from, x, radius) >= 0;
  const bool is_met = shape.find(path, radius, dt, contact);
  counts.near += is_near;
  counts.before += is_near && is_before;
  counts.met += is_met;
  counts.both += is_met && is_before;
}

} // namespace asperity
