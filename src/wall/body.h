/* The impulse that a face gives to a body at one point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"
#include "wall/frame.h"

/* The change of the angular velocity by an impulse at `arm` from the center of mass. */
vec aspi_body_turn(const asp_body *body, vec arm, vec impulse);

/* The change of the velocity of that point: K impulse, K = 1/m + [arm]x^T I^-1 [arm]x. */
vec aspi_body_kick(const asp_body *body, vec arm, vec impulse);

/* The impulse of a face of unit normal m, for a velocity u of that point that approaches it (u.m <
 * 0): with the energetic restitution e and Coulomb's friction. */
vec aspi_body_impulse(const asp_body *body, vec arm, vec m, vec u, double e, double friction);
