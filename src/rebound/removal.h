/* Removal of deposits by the shear of a flow.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_REBOUND_REMOVAL_H
#define ASP_REBOUND_REMOVAL_H

#include "rebound/materials.h"

/* A work of adhesion, J/m^2, as one published code of El-Batsh's law has it. */
#define ASPI_REMOVAL_WORK 0.039

/* A flow along a wall; density 0: there is none. */
typedef struct aspi_flow {
  double u_tau;          /* friction velocity; 0: that of the particle counts alone */
  double density;        /* of the gas */
  double mean_free_path; /* in it */
  double work;           /* of adhesion, per area */
} aspi_flow;

/* True if it takes a particle away. */
bool aspi_flow_removes(const aspi_flow *flow, const asp_particle *particle);

#endif
