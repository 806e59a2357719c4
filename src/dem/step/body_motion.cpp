/* The motion of a free rigid body; see body_motion.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/body_motion.h"

#include <math.h>

#include "contact/vector.h"
#include "dem/step/body_solve.h"

using namespace asperity;

void asperity::turn_by(const double omega[3], double time, double axes[3][3]) {
  const double rate = aspi_length(omega), angle = rate * time;
  if (!(rate > 0))
    return;
  for (int k = 0; k < 3; k++) {
    double side[3], along = aspi_dot(omega, axes[k]) / (rate * rate);
    aspi_cross(omega, axes[k], side);
    for (int d = 0; d < 3; d++)
      axes[k][d] = axes[k][d] * cos(angle) + side[d] * sin(angle) / rate +
                   omega[d] * along * (1 - cos(angle));
  }
}

void asperity::advance(Body &body, double time) {
  double omega[3];
  Body half = body;
  spin_of(body, omega);
  turn_by(omega, 0.5 * time, half.axes);
  spin_of(half, omega);
  turn_by(omega, time, body.axes);
  aspi_add_scaled(body.x, time, body.v, body.x);
}

void asperity::arm_of(const Body &body, const BodySphere &sphere, double arm[3]) {
  for (int d = 0; d < 3; d++)
    arm[d] = sphere.arm[0] * body.axes[0][d] + sphere.arm[1] * body.axes[1][d] +
             sphere.arm[2] * body.axes[2][d];
}

void asperity::spin_of(const Body &body, double omega[3]) {
  for (int d = 0; d < 3; d++)
    omega[d] = 0;
  for (int k = 0; k < 3; k++)
    if (body.inertia[k] > 0)
      aspi_add_scaled(omega, aspi_dot(body.angular_momentum, body.axes[k]) / body.inertia[k],
                      body.axes[k], omega);
}

void asperity::momentum_of(const Body &body, const double omega[3], double momentum[3]) {
  for (int d = 0; d < 3; d++)
    momentum[d] = 0;
  for (int k = 0; k < 3; k++)
    aspi_add_scaled(momentum, body.inertia[k] * aspi_dot(omega, body.axes[k]), body.axes[k],
                    momentum);
}

double asperity::energy_of(const Body &body, const double v[3]) {
  double omega[3];
  spin_of(body, omega);
  return 0.5 * (body.mass * aspi_dot(v, v) + aspi_dot(omega, body.angular_momentum));
}

asp_body asperity::inverse_of(const Body &body, const double arm[3]) {
  static const int of[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  asp_body made = {1 / body.mass, {0, 0, 0, 0, 0, 0}, {arm[0], arm[1], arm[2]}};
  for (int k = 0; k < 3; k++)
    for (int j = 0; j < 6 && body.inertia[k] > 0; j++)
      made.inverse_inertia[j] += body.axes[k][of[j][0]] * body.axes[k][of[j][1]] / body.inertia[k];
  return made;
}

double asperity::inverse_mass_at(const asp_body &inverse, const double arm[3], const double n[3]) {
  double couple[3], turn[3];
  aspi_cross(arm, n, couple);
  multiply(inverse.inverse_inertia, couple, turn);
  return inverse.inverse_mass + aspi_dot(couple, turn);
}
