/* One contact, over all the faces that it hits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_WALL_IMPACT_H
#define ASP_WALL_IMPACT_H

#include "wall/frame.h"
#include "wall/wall.h"

/* The particle with the wall's pair where it has none of its own. */
static inline asp_particle aspi_with_pair(const asp_wall *wall, const asp_particle *particle) {
  asp_particle own = *particle;
  own.pair = own.pair ? own.pair : wall->pair;
  return own;
}

/* Other walls of the same law, and for each the logarithm of how likely the draws of an impact are
 * there, over how likely they are on its own wall. */
typedef struct aspi_rivals {
  size_t n;
  const asp_wall *const *walls;
  double *sums;
} aspi_rivals;

/* An impact as asp_wall_impact has it, of a sphere or a body that has its pair, on the wall's faces
 * or, not `rough`, on the mean wall. Adds to the sums of rivals, which may be NULL. */
void aspi_impact_at(const asp_wall *wall, bool rough, const asp_particle *particle, vec v, vec n,
                    aspi_stream *stream, const aspi_rivals *rivals, asp_impact *impact);

#endif
