/* The pair of a particle's and a wall's material.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "rebound/materials.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A new material has none. */
static asp_code check(const asp_material *m, const char *of, asp_error *error) {
  return m->youngs_modulus > 0
             ? ASP_OK
             : aspi_fail(error, ASP_EARG,
                         "Young's modulus of the %s is %g; it must be a finite number > 0", of,
                         m->youngs_modulus);
}

/* 1 - nu^2 */
static double give(const asp_material *m) {
  return 1 - m->poissons_ratio * m->poissons_ratio;
}

asp_pair *asp_pair_create(const asp_material *particle, const asp_material *wall,
                          asp_error *error) {
  if (!particle || !wall)
    return aspi_fail_null(error, ASP_EARG, "a pair needs two materials; the %s's is NULL",
                          particle ? "wall" : "particle");
  if (check(particle, "particle", error) || check(wall, "wall", error))
    return NULL;
  double modulus =
      1 / (give(particle) / particle->youngs_modulus + give(wall) / wall->youngs_modulus);
  if (!(modulus > 0 && isfinite(modulus)))
    return aspi_fail_null(error, ASP_EARG,
                          "Young's moduli %g and %g give no finite composite modulus",
                          particle->youngs_modulus, wall->youngs_modulus);
  asp_pair *pair = malloc(sizeof *pair);
  if (pair)
    *pair = (asp_pair){.modulus = modulus,
                       .yield_stress = particle->yield_stress,
                       .surface_energy = ASP_SURFACE_ENERGY,
                       .friction = ASP_FRICTION,
                       .wall_density = wall->density,
                       .give = give(particle) + give(wall)};
  else
    aspi_fail(error, ASP_ENOMEM, "out of memory for a pair of materials");
  return pair;
}

void asp_pair_free(asp_pair *pair) {
  free(pair);
}

/* The number of that name; NULL if there is none. */
static double *number_of(asp_pair *pair, const char *name) {
  return strcmp(name, "modulus") == 0          ? &pair->modulus
         : strcmp(name, "yield_stress") == 0   ? &pair->yield_stress
         : strcmp(name, "surface_energy") == 0 ? &pair->surface_energy
         : strcmp(name, "friction") == 0       ? &pair->friction
                                               : NULL;
}

asp_code asp_pair_set(asp_pair *pair, const char *name, double value, asp_error *error) {
  name = aspi_word_or_empty(name);
  double *number = number_of(pair, name);
  if (!number || number == &pair->modulus)
    return aspi_fail(error, ASP_ENAME,
                     "number '%s' of a pair of materials cannot be set; there are: yield_stress "
                     "surface_energy friction",
                     name);
  asp_code code = aspi_check_range(error, name, "", value, 0, INFINITY);
  if (!code)
    *number = value;
  return code;
}

double asp_pair_get(const asp_pair *pair, const char *name) {
  asp_pair copy = *pair;
  const double *number = number_of(&copy, aspi_word_or_empty(name));
  return number ? *number : NAN;
}
