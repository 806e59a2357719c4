/* What differs from grain to grain: its yield stress and adhesion, and its lever, how far its
 * center of mass is off.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/impact.h"

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
  own.pair = pair;
  return own;
}

asp_removal asp_wall_removal(const asp_wall *wall, const asp_particle *particle,
                             const asp_key *key) {
  asp_particle own = aspi_with_pair(wall, particle);
  return aspi_flow_removal(&wall->flow, &own, key);
}
