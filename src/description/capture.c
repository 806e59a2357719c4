/* The speed below which a normal impact sticks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "description/description.h"

#include <math.h>

/* Speeds at which an impact is tried, in m/s; over the range of all that flies. */
#define SPEED_LEAST 1e-3
#define SPEED_MOST 1e4
enum { SPEEDS = 64 };

/* Relative precision of a critical speed. */
#define PRECISION 1e-4

/* True if a normal impact at v sticks; oblique ones have less normal speed. */
static bool sticks_at(const asp_description *d, const asp_particle *particle, double v) {
  aspi_hit hit = {.v_n1 = v,
                  .d_p = particle->d_p,
                  .density = particle->density,
                  .pair = particle->pair,
                  .adhesion = true,
                  .temperature = d->choice.heat.temperature};
  return !(d->choice.law->rebound(d->choice.parameters, &hit).v_n2 > 0);
}

double asp_description_capture_speed(const asp_description *d, const asp_particle *particle) {
  double unit = aspi_quantity_factor("speed", &d->units);
  if (!d->choice.law->needs_pair || !particle->pair || !(unit > 0) || !(particle->d_p > 0) ||
      !(particle->density > 0) || d->deposit == ASPI_DEPOSIT_OFF)
    return 0;
  asp_pair pair = *particle->pair;
  asp_particle held = *particle;
  held.pair = &pair;
  pair.surface_energy *= d->choice.flow.adhesion > 0 ? d->choice.flow.adhesion : 1;
  if (d->choice.heat.temperature > 0)
    aspi_heat_soften(&d->choice.heat, d->choice.heat.temperature, &pair);
  particle = &held;
  double low = SPEED_LEAST * unit, step = pow(SPEED_MOST / SPEED_LEAST, 1 / (SPEEDS - 1.0));
  if (!sticks_at(d, particle, low))
    return 0;
  int i = 1;
  while (i < SPEEDS && sticks_at(d, particle, low * step)) {
    low *= step;
    i++;
  }
  if (i == SPEEDS)
    return INFINITY;
  for (double high = low * step; high > (1 + PRECISION) * low;) {
    double middle = sqrt(low * high);
    *(sticks_at(d, particle, middle) ? &low : &high) = middle;
  }
  return low;
}
