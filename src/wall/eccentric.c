/* The impact of an eccentric grain, whose center of mass is off by a lever that is drawn.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/impact.h"

#include <string.h>

/* Draws the lever of a sphere whose center of mass is off by N(0, sd) per axis, given that its
 * center touches the wall with the approach speed v_n. Levers are met in proportion to the speed at
 * which the sphere then approaches, v_n - (omega x r).n: along n x omega that is the law of visible
 * slopes. */
static vec draw_lever(const asp_wall *wall, double sd, vec omega, double v_n, vec n,
                      aspi_stream *stream) {
  vec turning = cross(n, omega), other[2];
  double rate = sqrt(dot(turning, turning));
  turning = rate > 0 ? scaled(turning, 1 / rate) : across(n);
  aspi_spread_input input = {.slope = 1, .sigma = ASP_PI / 4, .alpha1 = atan2(v_n, sd * rate)};
  double delta = wall->rising->quantile(&input, aspi_stream_uniform(stream));
  other[0] = plus(scaled(n, aspi_stream_normal(stream)), -tan(delta), turning);
  return scaled(plus(other[0], aspi_stream_normal(stream), cross(n, turning)), sd);
}

void aspi_impact_eccentric(const asp_wall *wall, bool rough, const asp_particle *particle, vec v,
                           vec n, aspi_stream *stream, const aspi_ratios *ratios,
                           asp_impact *impact) {
  double d = particle->d_p, mass = particle->density * ASP_SPHERE_VOLUME(d);
  double turn = 10 / (mass * d * d);
  asp_body body = {.inverse_mass = 1 / mass, .inverse_inertia = {turn, turn, turn, 0, 0, 0}};
  asp_particle own = *particle;
  own.body = &body;
  asp_impact sum = {.hits = 0};
  do {
    if (sum.hits >= ASP_HITS_MAX)
      own.body = NULL;
    else
      store(draw_lever(wall, wall->lever * d, load(own.omega), -dot(v, n), n, stream), body.lever);
    aspi_impact_at(wall, rough, &own, v, n, stream, ratios, impact);
    if (sum.hits == 0) {
      sum.delta_alpha = impact->delta_alpha;
      sum.tilt_out = impact->tilt_out;
    }
    sum.hits += impact->hits;
    sum.eroded += impact->eroded;
    sum.capped |= impact->capped;
    v = load(impact->v2);
    memcpy(own.omega, impact->omega, sizeof own.omega);
  } while (impact->outcome != ASP_DEPOSIT && own.body && !clearly_leaves(v, n));
  impact->delta_alpha = sum.delta_alpha;
  impact->tilt_out = sum.tilt_out;
  impact->capped = sum.capped || !own.body;
  impact->hits = sum.hits;
  impact->eroded = sum.eroded;
}
