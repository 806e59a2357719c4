/* The contact of a particle: of a sphere, a body or an eccentric grain, on the wall's faces or on
 * the mean wall.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "wall/impact.h"

/* No impact: a rebound without hits. */
static void pass(vec v2, vec omega, asp_impact *impact) {
  *impact = (asp_impact){.outcome = ASP_REBOUND};
  store(v2, impact->v2);
  store(omega, impact->omega);
}

static bool is_finite(const asp_particle *particle, const double v1[3], const double n[3]) {
  const asp_body *body = particle->body;
  double sum =
      particle->d_p + particle->temperature + (body ? body->inverse_mass : particle->density);
  for (int i = 0; i < 3; i++)
    sum += v1[i] + n[i] + particle->omega[i] + (particle->lay ? particle->lay[i] : 0);
  for (int i = 0; i < 3 && body; i++)
    sum += body->lever[i] + body->inverse_inertia[i] + body->inverse_inertia[3 + i];
  return isfinite(sum);
}

static asp_code impact_on(const asp_wall *wall, bool rough, const asp_particle *particle,
                          const double v1[3], const double n[3], const asp_key *key,
                          const aspi_ratios *ratios, asp_impact *impact) {
  asp_particle own;
  if (!particle->pair && wall->law->needs_pair) {
    if (!wall->pair) {
      pass(load(v1), load(particle->omega), impact);
      return ASP_EARG;
    }
    own = aspi_with_pair(wall, particle);
    particle = &own;
  }
  if (!is_finite(particle, v1, n)) {
    pass((vec){NAN, NAN, NAN}, (vec){NAN, NAN, NAN}, impact);
    return ASP_OK;
  }
  const bool is_eccentric = wall->lever > 0 && !particle->body;
  if (is_eccentric && !(particle->density > 0)) {
    pass(load(v1), load(particle->omega), impact);
    return ASP_EARG;
  }
  aspi_stream stream = aspi_stream_begin(key);
  if (is_eccentric)
    aspi_impact_eccentric(wall, rough, particle, load(v1), unit(load(n)), &stream, ratios, impact);
  else
    aspi_impact_at(wall, rough, particle, load(v1), load(n), &stream, ratios, impact);
  return ASP_OK;
}

/* The impact on a wall whose grains differ; a function of its own, so that other walls need no
 * space for a pair. */
asp_code aspi_impact_of_grain(const asp_wall *wall, bool rough, const asp_particle *particle,
                              const double v1[3], const double n[3], const asp_key *key,
                              const aspi_ratios *ratios, asp_impact *impact) {
  asp_pair pair;
  asp_wall held;
  const asp_wall *met = aspi_wall_met(wall, particle, key, &held);
  if (!met) {
    pass(load(v1), load(particle->omega), impact);
    return ASP_ERANGE;
  }
  asp_particle own = aspi_as_grain(wall, particle, key, &pair);
  return impact_on(met, rough, &own, v1, n, key, ratios, impact);
}

asp_code asp_wall_impact(const asp_wall *wall, const asp_particle *particle, const double v1[3],
                         const double n[3], const asp_key *key, asp_impact *impact) {
  return wall->varies ? aspi_impact_of_grain(wall, wall->rough, particle, v1, n, key, NULL, impact)
                      : impact_on(wall, wall->rough, particle, v1, n, key, NULL, impact);
}

asp_code asp_wall_impact_mean(const asp_wall *wall, const asp_particle *particle,
                              const double v1[3], const double n[3], const asp_key *key,
                              asp_impact *impact) {
  return wall->varies ? aspi_impact_of_grain(wall, false, particle, v1, n, key, NULL, impact)
                      : impact_on(wall, false, particle, v1, n, key, NULL, impact);
}

asp_code aspi_fail_impact(const asp_wall *wall, asp_code code, const asp_particle *particle,
                          asp_error *error) {
  if (code == ASP_ERANGE)
    return asp_wall_sticking(wall, particle->temperature, NULL, error);
  if (wall->lever > 0 && !particle->body && !(particle->density > 0))
    return aspi_fail(error, code, "density is %g; it must be > 0 with 'grain lever'",
                     particle->density);
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
      return aspi_fail_impact(wall, code, &particles[i], error);
  }
  return ASP_OK;
}
