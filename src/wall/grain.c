/* What differs from grain to grain: its yield stress, its adhesion and its heat.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/impact.h"

#include <string.h>

asp_particle aspi_as_grain(const asp_wall *wall, const asp_particle *particle, const asp_key *key,
                           asp_pair *pair) {
  asp_particle own = aspi_with_pair(wall, particle);
  if (!wall->varies || !own.pair)
    return own;
  *pair = *own.pair;
  if (wall->scatter > 0) {
    pair->yield_excess = expm1(wall->scatter * aspi_stream_trait(key, ASPI_TRAIT_YIELD));
    pair->yield_stress *= 1 + pair->yield_excess;
  }
  if (wall->flow.adhesion > 0)
    pair->surface_energy *= aspi_flow_share(&wall->flow, own.d_p, key);
  aspi_heat_soften(wall->heat, aspi_heat_of(wall->heat, own.temperature), pair);
  own.pair = pair;
  return own;
}

const asp_wall *aspi_wall_met(const asp_wall *wall, const asp_particle *particle,
                              const asp_key *key, asp_wall *held) {
  const double kelvin = aspi_heat_of(wall->heat, particle->temperature);
  if (!aspi_heat_counts(wall->heat) || (wall->law->needs_pair && !particle->pair && !wall->pair))
    return wall;
  if (aspi_heat_check(wall->heat, kelvin, NULL))
    return NULL;
  aspi_stream stream = aspi_stream_begin(key);
  stream.counter[3] = UINT32_MAX; /* the last block, to which no other draw comes */
  if (!(aspi_stream_uniform(&stream) < aspi_heat_share(wall->heat, kelvin)))
    return wall;
  *held = *wall;
  held->law = &aspi_rebound_constant; /* of coefficients that are 0 */
  held->spins = false;
  memset(held->parameters, 0, sizeof held->parameters);
  return held;
}

asp_removal asp_wall_removal(const asp_wall *wall, const asp_particle *particle,
                             const asp_key *key) {
  asp_particle own = aspi_with_pair(wall, particle);
  return aspi_flow_removal(&wall->flow, &own, key);
}
