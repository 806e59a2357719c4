/* The motion of a free rigid body.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_BODY_MOTION_H
#define ASPERITY_DEM_BODY_MOTION_H

#include "asperity.h"
#include "dem/step/bodies.h"

namespace asperity {

/* Turns axes by an angular velocity. */
void turn_by(const double omega[3], double time, double axes[3][3]);

/* Moves a body straight, and turns it by the midpoint rule. */
void advance(Body &body, double time);

/* From the center of mass to the center of a sphere. */
void arm_of(const Body &body, const BodySphere &sphere, double arm[3]);

/* Angular velocity from angular momentum, and back. */
void spin_of(const Body &body, double omega[3]);
void momentum_of(const Body &body, const double omega[3], double momentum[3]);

/* Energy with this velocity of the center of mass. */
double energy_of(const Body &body, const double v[3]);

/* The body as the core has it, with this lever. */
asp_body inverse_of(const Body &body, const double arm[3]);

/* The inverse of the mass that a direction n meets at a point. */
double inverse_mass_at(const asp_body &inverse, const double arm[3], const double n[3]);

} // namespace asperity

#endif
