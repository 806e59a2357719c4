/* One contact, over all the faces that it hits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "wall/frame.h"
#include "wall/wall.h"

/* The particle, with the wall's pair if it has none; its material's constants. */
static inline asp_particle aspi_with_pair(const asp_wall *wall, const asp_particle *particle) {
  asp_particle own = *particle;
  own.pair = own.pair ? own.pair : wall->pair;
  return own;
}

/* The same with the grain's own yield stress and adhesion, and the modulus at its temperature, in
 * *pair. */
asp_particle aspi_as_grain(const asp_wall *wall, const asp_particle *particle, const asp_key *key,
                           asp_pair *pair);

/* The wall that a grain meets: this one, or `held`, a copy from which nothing rebounds, where the
 * grain sticks by its viscosity. NULL if the wall's curves do not hold at its temperature. */
const asp_wall *aspi_wall_met(const asp_wall *wall, const asp_particle *particle,
                              const asp_key *key, asp_wall *held);

/* Log likelihood ratios of an impact's draws: on each of n other walls, over the impact's wall. */
typedef struct aspi_ratios {
  size_t n;
  const asp_wall *const *walls;
  double *log;
} aspi_ratios;

/* asp_wall_impact for a sphere or body with its pair, on the wall's faces or, if not `rough`, on
 * the mean wall. Adds to the ratios, which may be NULL. */
void aspi_impact_at(const asp_wall *wall, bool rough, const asp_particle *particle, vec v, vec n,
                    aspi_stream *stream, const aspi_ratios *ratios, asp_impact *impact);

/* The same for an eccentric grain, whose lever is drawn. If its center still approaches the wall
 * after a hit, it hits again with another point, and after ASP_HITS_MAX hits as a sphere. */
void aspi_impact_eccentric(const asp_wall *wall, bool rough, const asp_particle *particle, vec v,
                           vec n, aspi_stream *stream, const aspi_ratios *ratios,
                           asp_impact *impact);

/* asp_wall_impact on a wall whose grains may differ. Adds to the ratios, which may be NULL. */
asp_code aspi_impact_of_grain(const asp_wall *wall, bool rough, const asp_particle *particle,
                              const double v1[3], const double n[3], const asp_key *key,
                              const aspi_ratios *ratios, asp_impact *impact);

/* The message of the code of an impact. */
asp_code aspi_fail_impact(const asp_wall *wall, asp_code code, const asp_particle *particle,
                          asp_error *error);
