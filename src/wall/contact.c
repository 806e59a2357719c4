/* The contact of a particle: of a sphere or a body, or of an eccentric grain, whose lever is drawn
 * here; and its coefficients of restitution.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "wall/impact.h"
#include "wall/roughness.h"

#include <string.h>

/* The particle keeps its velocity: the law lacks its pair, or the velocity is not finite.
 */
static void pass(const asp_particle *particle, const double v1[3], asp_impact *impact) {
  *impact = (asp_impact){.outcome = ASP_REBOUND};
  store(load(v1), impact->v2);
  store(load(particle->omega), impact->omega);
}

/* Draws the lever of a sphere whose center of mass is off by N(0, sd) per axis, given that its
 * center touches the wall with the approach speed v_n. Levers are met in proportion to the speed at
 * which the sphere then approaches, v_n - (omega x r).n: along n x omega that is the law of visible
 * slopes. */
static vec draw_lever(const asp_wall *wall, double sd, vec omega, double v_n, vec n,
                      aspi_stream *stream) {
  vec turning = cross(n, omega), other[2];
  double rate = sqrt(dot(turning, turning)), delta = 0;
  turning = rate > 0 ? scaled(turning, 1 / rate) : across(n);
  aspi_spread_input view = {.slope = 1, .sigma = ASP_PI / 4, .alpha1 = atan2(v_n, sd * rate)};
  while (!aspi_spread_draw(wall->rising, &view, stream, &delta))
    ;
  other[0] = plus(scaled(n, aspi_stream_normal(stream)), -tan(delta), turning);
  return scaled(plus(other[0], aspi_stream_normal(stream), cross(n, turning)), sd);
}

/* The impact of an eccentric grain. If its center still approaches the wall after a hit, it hits
 * again with another point, at last as a sphere. */
static void impact_eccentric(const asp_wall *wall, bool rough, const asp_particle *particle, vec v,
                             vec n, aspi_stream *stream, const aspi_ratios *ratios,
                             asp_impact *impact) {
  double d = particle->d_p, mass = ASP_PI / 6 * particle->density * d * d * d;
  double turn = 10 / (mass * d * d);
  asp_body body = {1 / mass, {turn, turn, turn, 0, 0, 0}, {0, 0, 0}};
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
    v = load(impact->v2);
    memcpy(own.omega, impact->omega, sizeof own.omega);
  } while (impact->outcome != ASP_DEPOSIT && own.body && !clearly_leaves(v, n));
  impact->delta_alpha = sum.delta_alpha;
  impact->tilt_out = sum.tilt_out;
  impact->capped |= !own.body;
  impact->hits = sum.hits;
  impact->eroded = sum.eroded;
}

static asp_code impact_on(const asp_wall *wall, bool rough, const asp_particle *particle,
                          const double v1[3], const double n[3], const asp_key *key,
                          const aspi_ratios *ratios, asp_impact *impact) {
  asp_particle own;
  if (!particle->pair && wall->law->needs_pair) {
    if (!wall->pair) {
      pass(particle, v1, impact);
      return ASP_EARG;
    }
    own = aspi_with_pair(wall, particle);
    particle = &own;
  }
  if (!isfinite(v1[0] + v1[1] + v1[2])) {
    pass(particle, v1, impact);
    return ASP_OK;
  }
  aspi_stream stream = aspi_stream_begin(key);
  if (wall->lever > 0 && !particle->body)
    impact_eccentric(wall, rough, particle, load(v1), unit(load(n)), &stream, ratios, impact);
  else
    aspi_impact_at(wall, rough, particle, load(v1), load(n), &stream, ratios, impact);
  return ASP_OK;
}

/* The impact on a wall whose grains differ; a function of its own, so that other walls need no
 * space for a pair. */
static asp_code impact_of_grain(const asp_wall *wall, bool rough, const asp_particle *particle,
                                const double v1[3], const double n[3], const asp_key *key,
                                const aspi_ratios *ratios, asp_impact *impact) {
  asp_pair pair;
  asp_wall held;
  const asp_wall *met = aspi_wall_met(wall, particle, key, &held);
  if (!met) {
    pass(particle, v1, impact);
    return ASP_ERANGE;
  }
  asp_particle own = aspi_as_grain(wall, particle, key, &pair);
  return impact_on(met, rough, &own, v1, n, key, ratios, impact);
}

asp_code asp_wall_impact(const asp_wall *wall, const asp_particle *particle, const double v1[3],
                         const double n[3], const asp_key *key, asp_impact *impact) {
  return wall->varies ? impact_of_grain(wall, wall->rough, particle, v1, n, key, NULL, impact)
                      : impact_on(wall, wall->rough, particle, v1, n, key, NULL, impact);
}

asp_code asp_wall_impact_mean(const asp_wall *wall, const asp_particle *particle,
                              const double v1[3], const double n[3], const asp_key *key,
                              asp_impact *impact) {
  return wall->varies ? impact_of_grain(wall, false, particle, v1, n, key, NULL, impact)
                      : impact_on(wall, false, particle, v1, n, key, NULL, impact);
}

static asp_code fail_law(const asp_wall *wall, asp_code code, double temperature,
                         asp_error *error) {
  if (code == ASP_ERANGE)
    return asp_wall_sticking(wall, temperature, NULL, error);
  return aspi_fail(error, code,
                   "rebound law '%s' needs a pair of materials, and neither the particle nor the "
                   "wall has one",
                   wall->law->name);
}

asp_code asp_wall_impacts(const asp_wall *wall, size_t n, const asp_particle *particles,
                          const double *v1, const double *normals, const asp_key *keys,
                          asp_impact *impacts, asp_error *error) {
  for (size_t i = 0; i < n; i++) {
    asp_code code =
        asp_wall_impact(wall, &particles[i], v1 + 3 * i, normals + 3 * i, &keys[i], &impacts[i]);
    if (code)
      return fail_law(wall, code, particles[i].temperature, error);
  }
  return ASP_OK;
}

static bool has_weights(const asp_wall *wall) {
  const asp_spread_model *model = wall->spread;
  return wall->rough && wall->multiple && !wall->follow && model->density && !model->escape;
}

/* Beyond sqrt(2) the variance of the weights is infinite: densities have Gaussian tails. */
#define STEEPER_MOST 1.4

double asp_wall_steeper(const asp_wall *wall, const asp_wall *other, const asp_particle *particle,
                        const double n[3]) {
  static const aspi_heading axes[] = {{1, 0}, {0, 1}};
  aspi_roughness own = aspi_roughness_of(wall, particle, load(n)),
                 its = aspi_roughness_of(other, particle, load(n));
  double most = 0;
  for (int i = 0; i < 2; i++)
    most = fmax(most, aspi_roughness_along(&its, axes[i]).slope /
                          aspi_roughness_along(&own, axes[i]).slope);
  return most;
}

/* ASP_ERANGE if impacts on this wall say too little about another one. */
static asp_code check_steeper(const asp_wall *wall, const asp_particle *particle, const double n[3],
                              const aspi_ratios *ratios, asp_error *error) {
  for (size_t k = 0; k < ratios->n; k++) {
    double steeper = asp_wall_steeper(wall, ratios->walls[k], particle, n);
    if (!(steeper <= STEEPER_MOST))
      return aspi_fail(
          error, ASP_ERANGE,
          "for a diameter of %g the other wall is %.3g times as steep (rms slope) as "
          "that of the impacts; it must be at most %g times, as beyond the variance of "
          "the weights is infinite",
          particle->d_p, steeper, STEEPER_MOST);
  }
  return ASP_OK;
}

asp_code asp_wall_weights(const asp_wall *wall, size_t n, const asp_particle *particles,
                          const double *v1, const double *normals, const asp_key *keys,
                          size_t n_others, const asp_wall *const *others, asp_impact *impacts,
                          double *weights, asp_error *error) {
  for (size_t k = 0; k <= n_others; k++) {
    const asp_wall *of = k < n_others ? others[k] : wall;
    if (!has_weights(of) || of->isotropic != wall->isotropic)
      return aspi_fail(
          error, ASP_EARG,
          "a wall with spread '%s' has no weights; it must be rough, with a model that "
          "has a density, as visible, collisions multiple, and the same tilt",
          of->spread->name);
  }
  for (size_t i = 0; i < n; i++) {
    aspi_ratios ratios = {n_others, others, weights + i * n_others};
    memset(ratios.log, 0, n_others * sizeof *ratios.log);
    if (check_steeper(wall, &particles[i], normals + 3 * i, &ratios, error))
      return ASP_ERANGE;
    asp_code code = impact_of_grain(wall, true, &particles[i], v1 + 3 * i, normals + 3 * i,
                                    &keys[i], &ratios, &impacts[i]);
    if (code)
      return fail_law(wall, code, particles[i].temperature, error);
  }
  for (size_t i = 0; i < n * n_others; i++)
    weights[i] = exp(weights[i]);
  return ASP_OK;
}

asp_coefficients asp_impact_coefficients(const double v1[3], const double n[3],
                                         const asp_impact *impact) {
  vec before = load(v1), after = load(impact->v2);
  frame f = frame_of(before, load(n));
  double n2 = dot(after, f.n), along = dot(after, f.along) * f.per_length;
  asp_coefficients c = {.v1 = sqrt(dot(before, before)),
                        .alpha1 = atan2(fmax(f.v_n, 0), f.v_t),
                        .v2 = sqrt(dot(after, after))};
  if (impact->outcome == ASP_DEPOSIT) {
    c.cor_v = c.cor_alpha = c.cor_n = c.cor_t = c.cor_v_space = c.cor_alpha_space = NAN;
    return c;
  }
  double along_space = sqrt(fmax(0, c.v2 * c.v2 - n2 * n2));
  if (!has_direction(&f))
    along = along_space;
  c.alpha2 = atan2(n2, along);
  c.cor_v = aspi_quotient(hypot(n2, along), c.v1, c.v1);
  c.cor_alpha = aspi_quotient(c.alpha2, c.alpha1, 1);
  c.cor_v_space = aspi_quotient(c.v2, c.v1, c.v1);
  c.cor_alpha_space = aspi_quotient(atan2(n2, along_space), c.alpha1, 1);
  c.cor_n = aspi_quotient(n2, f.v_n, c.v1);
  c.cor_t = aspi_quotient(along, f.v_t, c.v1);
  return c;
}

void asp_impacts_coefficients(size_t n, const double *v1, const double *normals,
                              const asp_impact *impacts, asp_coefficients *coefficients) {
  for (size_t i = 0; i < n; i++)
    coefficients[i] = asp_impact_coefficients(v1 + 3 * i, normals + 3 * i, &impacts[i]);
}

asp_removal asp_wall_removal(const asp_wall *wall, const asp_particle *particle,
                             const asp_key *key) {
  asp_particle own = aspi_with_pair(wall, particle);
  return aspi_flow_removal(&wall->flow, &own, key);
}
