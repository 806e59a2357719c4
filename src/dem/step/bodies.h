/* Rigid bodies of spheres in a step: what engines give, and what a body remembers. How a body
 * moves and meets walls is what a grain does (mover.h, flight.h); its spheres take straight
 * stretches of path between which it turns by a tenth of a radian at most.
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
  static const size_t FACES = 8, RESTS = 10;
  double impacts, draws, status; /* as of a particle */
  double turned, axes[3][3];     /* of the run's first wall: the body's axes at the end of the step
                                    before that of this number, from 1; 0: not known */
  FacePlace faces[FACES];
  union { /* by the status */
    Rest rests[RESTS];
    ReboundPlace rebound;
    StuckBody stuck;
  };

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
  BodyAhead ahead;
};

/* All contacts of the bodies in a step, after step_walls(). */
void step_bodies(const std::vector<Stepper *> &walls, Bodies &bodies);

/* The end of a step, after its forces: stuck bodies get their wall's velocity, and walls hold those
 * that rest. */
void end_bodies(const std::vector<Stepper *> &walls, Bodies &bodies);

/* body_stick.cpp: what sticks with one of its spheres is held as a whole. Notes where a sphere has
 * stuck, and takes the body along with the wall for the rest of the step; moves a stuck body with
 * its wall for a whole step, false: it is not stuck; gives it the wall's velocity at the end. */
void stick_body(const std::vector<Stepper *> &walls, Bodies &bodies, size_t number, Stepper &wall,
                size_t shape, size_t sphere, const Path &before, const Contact &contact,
                double left);
bool carry_body(const std::vector<Stepper *> &walls, Bodies &bodies, size_t number);
bool hold_body(const std::vector<Stepper *> &walls, Bodies &bodies, size_t number);

} // namespace asperity

#endif
