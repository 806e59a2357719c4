/* The turning of a rigid body in a step as LAMMPS's fix rigid computes it: by Richardson's rule, at
 * constant angular momentum.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_LAMMPS_BODY_TURN_H
#define ASPERITY_LAMMPS_BODY_TURN_H

#include "dem/step/bodies.h"

namespace asperity {

/* Turns the axes by a step; omega: the angular velocity in its middle. */
void turn_step(Body &body, double dt, double omega[3]);

/* The rotation that takes axes to others: its axis times the angle. */
void rotation(const double from[3][3], const double to[3][3], double vector[3]);

/* The angular momentum that turns a body to other axes in a step; false where none was found. */
bool momentum_to(const Body &body, double dt, const double axes[3][3], double momentum[3]);

} // namespace asperity

#endif
