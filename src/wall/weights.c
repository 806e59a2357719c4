/* Likelihood ratios of impacts on other walls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "wall/impact.h"
#include "wall/roughness.h"

#include <string.h>

static bool has_weights(const asp_wall *wall) {
  return wall->rough && wall->multiple && !wall->follow && wall->spread->density;
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
    asp_code code = aspi_impact_of_grain(wall, true, &particles[i], v1 + 3 * i, normals + 3 * i,
                                         &keys[i], &ratios, &impacts[i]);
    if (code)
      return aspi_fail_impact(wall, code, &particles[i], error);
  }
  for (size_t i = 0; i < n * n_others; i++)
    weights[i] = exp(weights[i]);
  return ASP_OK;
}
