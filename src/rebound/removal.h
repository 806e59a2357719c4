/* Removal of deposits by the shear of a flow.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"
#include "rebound/materials.h"

/* A flow along a wall; density 0: no flow. */
typedef struct aspi_flow {
  double u_tau;            /* friction velocity where the particle's gas is not known */
  double density;          /* of the gas */
  double viscosity;        /* of the gas, kinematic */
  double adhesion, spread; /* median and geometric sd of the share of a smooth contact's adhesion;
                              median 0: both by the size, and full adhesion at the arrival */
  double micron;           /* in the units of the lengths */
} aspi_flow;

/* Median share of a smooth contact's adhesion for a diameter; 0: nothing holds. */
double aspi_flow_adhesion(const aspi_flow *flow, double d_p);

/* The grain's own share of a smooth contact's adhesion, from its key. */
double aspi_flow_share(const aspi_flow *flow, double d_p, const asp_key *key);

/* The rate at which the flow removes a deposit with this share of adhesion; 0: no flow, or unknown
 * adhesion. */
double aspi_flow_rate(const aspi_flow *flow, const asp_particle *particle, double share);

/* Rate of removal, and when the deposit goes: see asp_wall_removal. */
asp_removal aspi_flow_removal(const aspi_flow *flow, const asp_particle *particle,
                              const asp_key *key);
