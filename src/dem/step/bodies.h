/* Rigid bodies of spheres in a step. A body moves straight and turns; the spheres of it take
 * straight stretches of path between which it turns by a tenth of a radian at most. At the first
 * contact the body rebounds as a whole, and goes on with its new velocity for the rest of the step,
 * through any number of contacts. An impact is that of asp_wall_impact for the sphere that touches;
 * spheres that touch a smooth wall at one instant, and those that stay at a wall, are solved
 * together (body_solve.h), on the mean wall. Nothing sticks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_BODIES_H
#define ASPERITY_DEM_BODIES_H

#include <vector>

#include "dem/step/stepper.h"

namespace asperity {

struct BodySphere {
  double arm[3]; /* from the center of mass, along the body's axes */
  double radius;
  int type, mask;
  int64_t tag;
};

/* What a body remembers of a wall, 0 at first: its impacts, and the face that a sphere of it has
 * met last. */
struct BodyMemory {
  double impacts, sphere, at[3], n[3];
};

/* A body at the end of a step without walls; the velocities are those of the middle of the step. */
struct Body {
  int64_t tag;
  double mass, inertia[3];
  double axes[3][3]; /* unit vectors of the principal axes */
  double x[3], v[3], angular_momentum[3], acceleration[3];
  size_t first, count; /* its spheres */
  bool is_changed;     /* by contacts */
};

/* The bodies of this rank. */
struct Bodies {
  int64_t step;
  double dt;
  std::vector<Body> all;
  std::vector<BodySphere> spheres;
  std::vector<std::vector<BodyMemory *>> memory; /* of each wall of the run, for each body */
};

/* All contacts of the bodies in a step, after step_walls(). */
void step_bodies(const std::vector<Stepper *> &walls, Bodies &bodies);

/* The angular velocity of a body. */
void spin_of(const Body &body, double omega[3]);

} // namespace asperity

#endif
