/* Material presets, and the pair of a particle's and a wall's material. The
 * values are common handbook values, not those of the papers on rebound (which state few); none was
 * checked against an original. All of them are defaults that a user can replace. */
#include "base/error.h"

#include <math.h>
#include <string.h>

#define HANDBOOK "handbook values"

static const asp_material materials[] = {
    {"ard", "Arizona Road Dust, as quartz", 70e9, 0.17, 2650, 200e6, HANDBOOK, false},
    {"quartz", "quartz", 70e9, 0.17, 2650, 200e6, HANDBOOK, false},
    {"ti-6al-4v", "titanium alloy Ti-6Al-4V", 114e9, 0.34, 4430, 0, HANDBOOK, false},
    {"hastelloy-x", "nickel alloy Hastelloy X", 205e9, 0.32, 8220, 0, HANDBOOK, false},
    {"304-ss", "stainless steel 304", 193e9, 0.29, 8000, 0, HANDBOOK, false},
    {"al-2024", "aluminium alloy 2024", 73e9, 0.33, 2780, 0, HANDBOOK, false},
};

int asp_material_count(void) {
  return (int)(sizeof materials / sizeof *materials);
}

const asp_material *asp_material_at(int index) {
  return &materials[index];
}

static const char *name_at(int index) {
  return materials[index].name;
}

const asp_material *asp_material_find(const char *name, asp_error *error) {
  for (int i = 0; name && i < asp_material_count(); i++)
    if (strcmp(materials[i].name, name) == 0)
      return &materials[i];
  asp_fail_name(error, "material", name, asp_material_count(), name_at);
  return NULL;
}

static asp_code check_poisson(asp_error *error, const char *name, double value) {
  if (value > -1 && value < 0.5)
    return ASP_OK;
  return asp_fail(error, ASP_EARG, "%s is %g; it must be more than -1 and less than 0.5", name,
                  value);
}

asp_code asp_pair_create(double youngs_modulus_p, double poissons_ratio_p, double youngs_modulus_w,
                         double poissons_ratio_w, double yield_stress, double surface_energy,
                         double friction, asp_pair *pair, asp_error *error) {
  asp_code code;
  if ((code = asp_check_positive(error, "Young's modulus of the particle", "", youngs_modulus_p)) ||
      (code = asp_check_positive(error, "Young's modulus of the wall", "", youngs_modulus_w)) ||
      (code = check_poisson(error, "Poisson's ratio of the particle", poissons_ratio_p)) ||
      (code = check_poisson(error, "Poisson's ratio of the wall", poissons_ratio_w)) ||
      (code = asp_check_range(error, "yield stress", "", yield_stress, 0, INFINITY)) ||
      (code = asp_check_range(error, "surface energy", "", surface_energy, 0, INFINITY)) ||
      (code = asp_check_range(error, "friction coefficient", "", friction, 0, INFINITY)))
    return code;
  double compliance = (1 - poissons_ratio_p * poissons_ratio_p) / youngs_modulus_p +
                      (1 - poissons_ratio_w * poissons_ratio_w) / youngs_modulus_w;
  if (!(compliance > 0 && compliance < INFINITY && 1 / compliance < INFINITY))
    return asp_fail(error, ASP_EARG, "Young's moduli are %g and %g; their composite is no number",
                    youngs_modulus_p, youngs_modulus_w);
  *pair = (asp_pair){1 / compliance, yield_stress, surface_energy, friction};
  return ASP_OK;
}
