/* The motion of a free rigid body; see body_motion.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/body_motion.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

/* A turn is taken in parts of this angle at most, rad. */
static const double PART = 0.01;

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

void asperity::turn_free(const double inertia[3], const double momentum[3], double time,
                         double axes[3][3]) {
  static const int order[5] = {2, 1, 0, 1, 2};
  double rate = 0;
  for (int k = 0; k < 3; k++)
    if (inertia[k] > 0)
      rate = std::max(rate, fabs(aspi_dot(momentum, axes[k])) / inertia[k]);
  const double parts = 1 + floor(rate * fabs(time) / PART);
  for (double part = 0; part < parts; part++)
    for (int j = 0; j < 5; j++) {
      const int k = order[j];
      const double axis[3] = {axes[k][0], axes[k][1], axes[k][2]};
      if (inertia[k] > 0)
        turn_by(axis, (j == 2 ? 1 : 0.5) * time / parts * aspi_dot(momentum, axis) / inertia[k],
                axes);
    }
}

void asperity::advance(Body &body, double time) {
  turn_free(body.inertia, body.angular_momentum, time, body.axes);
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
