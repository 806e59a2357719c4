/* The motion of a free rigid body.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_BODY_MOTION_H
#define ASPERITY_DEM_BODY_MOTION_H

#include "dem/step/bodies.h"

namespace asperity {

/* Turns axes by an angular velocity. */
void turn_by(const double omega[3], double time, double axes[3][3]);

/* Turns the axes of a free body by turns about one axis after another (Dullweber, Leimkuhler &
 * McLachlan 1997): the angular momentum stays, and the energy does not drift. */
void turn_free(const double inertia[3], const double momentum[3], double time, double axes[3][3]);

/* Moves a free body straight, and turns it. */
void advance(Body &body, double time);

/* From the center of mass to the center of a sphere. */
void arm_of(const Body &body, const BodySphere &sphere, double arm[3]);

/* Angular velocity from angular momentum, and back. */
void spin_of(const Body &body, double omega[3]);
void momentum_of(const Body &body, const double omega[3], double momentum[3]);

} // namespace asperity

#endif
