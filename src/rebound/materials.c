/* Material presets, and the pair of a particle's and a wall's material. The
 * values are common handbook values, not those of the papers on rebound (which state few); none was
 * checked against an original. All of them are defaults that a user can replace. */
#include "rebound/materials.h"
#include "base/error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define HANDBOOK "handbook values"

static const asp_material presets[] = {
    {"ard", "Arizona Road Dust, as quartz", 70e9, 0.17, 2650, 200e6, HANDBOOK, false},
    {"quartz", "quartz", 70e9, 0.17, 2650, 200e6, HANDBOOK, false},
    {"ti-6al-4v", "titanium alloy Ti-6Al-4V", 114e9, 0.34, 4430, 0, HANDBOOK, false},
    {"hastelloy-x", "nickel alloy Hastelloy X", 205e9, 0.32, 8220, 0, HANDBOOK, false},
    {"304-ss", "stainless steel 304", 193e9, 0.29, 8000, 0, HANDBOOK, false},
    {"al-2024", "aluminium alloy 2024", 73e9, 0.33, 2780, 0, HANDBOOK, false},
};

int asp_material_count(void) {
  return (int)(sizeof presets / sizeof *presets);
}

const asp_material *asp_material_at(int index) {
  return &presets[index];
}

static const char *name_at(int index) {
  return presets[index].name;
}

const asp_material *aspi_material_find(const char *name, asp_error *error) {
  int index = aspi_find_name("material", name, asp_material_count(), name_at, error);
  return index < 0 ? NULL : &presets[index];
}

const char *asp_material_name(const asp_material *material) {
  return material->name;
}

const char *asp_material_title(const asp_material *material) {
  return material->title;
}

const char *asp_material_source(const asp_material *material) {
  return material->source;
}

bool asp_material_seen(const asp_material *material) {
  return material->seen;
}

asp_material *asp_material_create(const char *name, asp_error *error) {
  size_t length = strlen(name) + 1;
  asp_material *material = malloc(sizeof *material + length);
  if (!material) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for material '%s'", name);
    return NULL;
  }
  char *copy = (char *)(material + 1);
  memcpy(copy, name, length);
  *material = (asp_material){.name = copy, .title = "", .source = ""};
  return material;
}

void asp_material_free(asp_material *material) {
  free(material);
}

/* The number of that name; NULL where there is none. */
static double *number_of(asp_material *material, const char *name) {
  return strcmp(name, "youngs_modulus") == 0   ? &material->youngs_modulus
         : strcmp(name, "poissons_ratio") == 0 ? &material->poissons_ratio
         : strcmp(name, "density") == 0        ? &material->density
         : strcmp(name, "yield_stress") == 0   ? &material->yield_stress
                                               : NULL;
}

asp_code asp_material_set(asp_material *material, const char *name, double value,
                          asp_error *error) {
  double *number = number_of(material, name);
  if (!number)
    return aspi_fail(error, ASP_ENAME,
                     "number '%s' is unknown to a material; there are: youngs_modulus "
                     "poissons_ratio density yield_stress",
                     name);
  bool inside = strcmp(name, "poissons_ratio") == 0 ? value > -1 && value < 0.5
                : strcmp(name, "yield_stress") == 0 ? value >= 0
                                                    : value > 0;
  if (!inside || !isfinite(value))
    return aspi_fail(error, ASP_EARG, "%s of '%s' is %g; it must be %s", name, material->name,
                     value,
                     strcmp(name, "poissons_ratio") == 0 ? "more than -1 and less than 0.5"
                     : strcmp(name, "yield_stress") == 0 ? "a finite number >= 0"
                                                         : "a finite number > 0");
  *number = value;
  return ASP_OK;
}

double asp_material_get(const asp_material *material, const char *name) {
  asp_material copy = *material;
  const double *number = number_of(&copy, name);
  return number ? *number : NAN;
}
