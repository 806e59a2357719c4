/* Rigid bodies of spheres in a step. A body moves straight and turns; the spheres of it take
 * straight stretches of path between which it turns by a tenth of a radian at most. At the first
 * contact the body rebounds as a whole, and goes on with its new velocity for the rest of the step,
 * through any number of contacts. An impact is that of asp_wall_impact for the sphere that touches;
 * spheres that touch a smooth wall at one instant, and those that stay at a wall, are solved
 * together (body_solve.h), on the mean wall. A body that sticks with one sphere is held as a whole.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_BODIES_H
#define ASPERITY_DEM_BODIES_H

#include <vector>

#include "dem/step/body_ahead.h"
#include "dem/step/stepper.h"

namespace asperity {

struct BodySphere {
  double arm[3]; /* from the center of mass, along the body's axes */
  double radius;
  int type, mask;
  int64_t tag;
};

/* A face that a sphere of a body has met last. */
struct BodyFace {
  double sphere; /* its tag */
  FacePlace face;
};

/* Where a stuck body is held: the center of one of its spheres, in the frame of the shape, and the
 * body's axes; and the velocities that it has there. */
struct StuckBody {
  double sphere; /* its tag */
  double shape;  /* from 1; 0: gone, and the place is one of the world */
  double piece, at[3], axes[3][3], v[3], omega[3];
};

/* What a body remembers of a wall, all 0 at first: numbers that the engine stores, moves between
 * ranks, and writes into restart files. */
struct BodyMemory {
  static const size_t FACES = 6;
  double impacts, draws; /* as of a particle */
  double status;         /* a Status: FREE, STUCK or TO_DELETE */
  double stayed;         /* one more than the last step in which it stayed at the wall */
  BodyFace faces[FACES]; /* of spheres that met the wall last */
  StuckBody stuck;

  bool is_stuck() const {
    return status > 0;
  }
};

/* Its row in a restart file. */
struct BodyRow {
  double tag;
  BodyMemory memory;
};

/* A body at the end of a step without walls; the velocities are those of the middle of the step. */
struct Body {
  int64_t tag; /* from 0 */
  double mass, inertia[3];
  double axes[3][3]; /* unit vectors of the principal axes */
  double x[3], v[3], angular_momentum[3], acceleration[3], torque[3];
  size_t first, count; /* its spheres */
  bool is_led;         /* its engine moves it along a given way: it meets no wall */
  bool is_changed;     /* by contacts */
};

/* The bodies of this rank. */
struct Bodies {
  int64_t step;
  double dt;
  bool begins; /* the run, with this step */
  std::vector<Body> all;
  std::vector<BodySphere> spheres;
  std::vector<std::vector<BodyMemory *>> memory; /* of each wall of the run, for each body */

  bool any_stuck() const;
  BodyAhead ahead;
};

/* All contacts of the bodies in a step, after step_walls(). */
void step_bodies(const std::vector<Stepper *> &walls, Bodies &bodies);

/* The end of a step, after its forces: stuck bodies get their wall's velocity. */
void hold_bodies(const std::vector<Stepper *> &walls, Bodies &bodies);

} // namespace asperity

#endif
