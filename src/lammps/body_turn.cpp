/* The turning of a rigid body in a step; see body_turn.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "body_turn.h"

#include <cmath>
#include <algorithm>

#include "contact/vector.h"
#include "dem/step/body_motion.h"

using namespace asperity;

/* Rounds of the searches below, at most, and the angle at which they end. */
static const int ROUNDS = 50;
static const double CONVERGED = 1e-14;

namespace {

struct Quaternion {
  double w, v[3];
};

/* The quaternion from + s (0, omega) a, of length 1. */
Quaternion moved(const Quaternion &from, double s, const double omega[3], const Quaternion &a) {
  Quaternion to = from;
  double side[3];
  aspi_cross(omega, a.v, side);
  to.w -= s * aspi_dot(omega, a.v);
  aspi_add_scaled(to.v, s * a.w, omega, to.v);
  aspi_add_scaled(to.v, s, side, to.v);
  const double length = sqrt(to.w * to.w + aspi_dot(to.v, to.v));
  to.w /= length;
  aspi_scale(1 / length, to.v);
  return to;
}

void turn(const Quaternion &by, const double from[3][3], double axes[3][3]) {
  for (int k = 0; k < 3; k++) {
    double side[3], twice[3];
    aspi_cross(by.v, from[k], side);
    aspi_cross(by.v, side, twice);
    aspi_add_scaled(from[k], 2 * by.w, side, axes[k]);
    aspi_add_scaled(axes[k], 2, twice, axes[k]);
  }
}

} // namespace

void asperity::turn_step(Body &body, double dt, double omega[3]) {
  const Quaternion none = {1, {0, 0, 0}};
  const Body start = body;
  spin_of(start, omega);
  const Quaternion full = moved(none, 0.5 * dt, omega, none);
  const Quaternion half = moved(none, 0.25 * dt, omega, none);
  turn(half, start.axes, body.axes);
  spin_of(body, omega);
  const Quaternion both = moved(half, 0.25 * dt, omega, half);
  Quaternion end = {2 * both.w - full.w, {0, 0, 0}};
  for (int d = 0; d < 3; d++)
    end.v[d] = 2 * both.v[d] - full.v[d];
  turn(moved(end, 0, omega, none), start.axes, body.axes);
}

void asperity::rotation(const double from[3][3], const double to[3][3], double vector[3]) {
  double cosine = -1;
  vector[0] = vector[1] = vector[2] = 0;
  for (int k = 0; k < 3; k++) {
    double side[3];
    aspi_cross(from[k], to[k], side);
    aspi_add_scaled(vector, 0.5, side, vector);
    cosine += aspi_dot(from[k], to[k]);
  }
  const double sine = aspi_length(vector);
  aspi_scale(sine > 0 ? atan2(sine, 0.5 * cosine) / sine : 0, vector);
}

bool asperity::momentum_to(const Body &body, double dt, const double axes[3][3],
                           double momentum[3]) {
  Body trial = body;
  double off[3], more[3];
  rotation(body.axes, axes, off);
  momentum[0] = momentum[1] = momentum[2] = 0;
  for (int i = 0; i < ROUNDS; i++) {
    if (!(aspi_length(off) > CONVERGED))
      return true;
    aspi_scale(1 / dt, off);
    momentum_of(trial, off, more);
    aspi_add_scaled(momentum, 1, more, momentum);
    for (int k = 0; k < 3; k++)
      aspi_copy(body.axes[k], trial.axes[k]);
    aspi_copy(momentum, trial.angular_momentum);
    turn_step(trial, dt, off);
    rotation(trial.axes, axes, off);
  }
  return aspi_length(off) < 1e-9;
}
