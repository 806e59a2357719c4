/* Material presets, and a user's own materials. The presets are for room temperature, from
 * handbooks and open tables, not from the papers on rebound (which state few). No preset has all
 * four numbers checked against the source named. A user can replace all of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/materials.h"
#include "base/table.h"
#include "base/error.h"
#include "base/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define HANDBOOK "handbook values"

/* Moduli and Poisson's ratios by these tables, of which copies were seen; densities by handbooks.
 */
#define DOWLING "Dowling, Mechanical Behavior of Materials, table 5.2; density: " HANDBOOK
#define SMC_045 "Special Metals, data sheet SMC-045 (2007), at 21 C; density: " HANDBOOK

static const asp_material presets[] = {
    /* particles */
    {"ard", "Arizona Road Dust, as quartz", 70e9, 0.17, 2650, 200e6, HANDBOOK},
    {"quartz", "quartz", 70e9, 0.17, 2650, 200e6, HANDBOOK},
    /* metals */
    {"ti-6al-4v", "titanium alloy Ti-6Al-4V", 114e9, 0.34, 4430, 0, HANDBOOK},
    {"ti-48al-2cr-2nb", "gamma titanium aluminide", 170e9, 0.24, 3970, 0, HANDBOOK},
    {"hastelloy-x", "nickel alloy Hastelloy X", 205e9, 0.32, 8220, 0, HANDBOOK},
    {"inconel-718", "nickel alloy 718", 200e9, 0.29, 8220, 0, SMC_045},
    {"inconel-625", "nickel alloy 625", 208e9, 0.28, 8440, 0, HANDBOOK},
    {"304-ss", "stainless steel 304", 193e9, 0.29, 8000, 0, HANDBOOK},
    {"316-ss", "stainless steel 316", 193e9, 0.29, 8000, 0, HANDBOOK},
    {"steel", "mild steel", 212e9, 0.293, 7850, 0, DOWLING},
    {"al-2024", "aluminum alloy 2024", 73e9, 0.33, 2780, 0, HANDBOOK},
    {"copper", "copper", 130e9, 0.343, 8930, 0, DOWLING},
    /* ceramics and glasses */
    {"alumina", "aluminum oxide, dense", 400e9, 0.22, 3900, 0, DOWLING},
    {"zirconia", "yttria-stabilized zirconia, dense", 205e9, 0.31, 6050, 0, HANDBOOK},
    {"silicon-carbide", "silicon carbide", 396e9, 0.22, 3150, 0, DOWLING},
    {"glass", "soda-lime glass", 69e9, 0.20, 2500, 0, DOWLING},
    {"fused-silica", "fused silica glass", 70e9, 0.18, 2200, 0, DOWLING},
    /* polymers */
    {"acrylic", "acrylic glass (PMMA)", 2.7e9, 0.35, 1180, 0, DOWLING},
    {"polycarbonate", "polycarbonate", 2.4e9, 0.38, 1200, 0, DOWLING},
    {"rubber", "natural rubber, small strains", 5e6, 0.49, 1100, 0, HANDBOOK},
};

int asp_material_count(void) {
  return (int)(sizeof presets / sizeof *presets);
}

const asp_material *asp_material_at(int index) {
  return index >= 0 && index < asp_material_count() ? &presets[index] : NULL;
}

const char *asp_material_name(const asp_material *material) {
  return material->name;
}

asp_material *asp_material_create(const char *name, asp_error *error) {
  name = aspi_word_or_empty(name);
  size_t length = strlen(name) + 1;
  asp_material *material = malloc(sizeof *material + length);
  if (!material)
    return aspi_fail_null(error, ASP_ENOMEM, "out of memory for material '%s'", name);
  char *copy = (char *)(material + 1);
  memcpy(copy, name, length);
  *material = (asp_material){.name = copy, .title = "", .source = ""};
  return material;
}

void asp_material_free(asp_material *material) {
  free(material);
}

/* The number of that name; NULL if there is none. */
static double *number_of(asp_material *material, const char *name) {
  return strcmp(name, "youngs_modulus") == 0   ? &material->youngs_modulus
         : strcmp(name, "poissons_ratio") == 0 ? &material->poissons_ratio
         : strcmp(name, "density") == 0        ? &material->density
         : strcmp(name, "yield_stress") == 0   ? &material->yield_stress
                                               : NULL;
}

asp_code asp_material_set(asp_material *material, const char *name, double value,
                          asp_error *error) {
  name = aspi_word_or_empty(name);
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
  const double *number = number_of(&copy, aspi_word_or_empty(name));
  return number ? *number : NAN;
}

struct aspi_materials {
  int count;
  asp_material **list; /* as in the file */
};

enum { NAME, MODULUS, POISSON, DENSITY, YIELD, COLUMNS };

static asp_code read_row(aspi_materials *own, const aspi_table *table, const int at[COLUMNS],
                         asp_error *error) {
  size_t count = (size_t)own->count;
  const char *name = table->fields[at[NAME]];
  if (!*name || strpbrk(name, " \t,;"))
    return aspi_table_fail(table, error, "the name '%s'; it must be one word without commas", name);
  asp_material **grown = aspi_grow(own->list, count, sizeof *grown);
  if (!grown)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for over %zu materials", count);
  own->list = grown;
  asp_material *m = asp_material_create(name, error);
  if (!m)
    return ASP_ENOMEM;
  own->list[own->count++] = m;
  bool no_yield;
  asp_code code;
  if ((code =
           aspi_table_number(table, at[MODULUS], 1e-300, 1e300, &m->youngs_modulus, NULL, error)) ||
      (code = aspi_table_number(table, at[POISSON], -1, 0.5, &m->poissons_ratio, NULL, error)) ||
      (code = aspi_table_number(table, at[DENSITY], 1e-300, 1e300, &m->density, NULL, error)) ||
      (code = aspi_table_number(table, at[YIELD], 0, 1e300, &m->yield_stress, &no_yield, error)))
    return code;
  m->yield_stress = no_yield ? 0 : m->yield_stress;
  return ASP_OK;
}

static asp_code read_rows(aspi_materials *own, aspi_table *table, asp_error *error) {
  static const char *const names[COLUMNS] = {"name", "youngs_modulus_pa", "poissons_ratio",
                                             "density_kg_m3", "yield_stress_pa"};
  int at[COLUMNS] = {[YIELD] = aspi_table_find(table, names[YIELD])};
  for (int i = 0; i < YIELD; i++)
    if ((at[i] = aspi_table_need(table, names[i], error)) < 0)
      return ASP_EDATA;
  for (bool found;;) {
    asp_code code = aspi_table_row(table, &found, error);
    if (!code && found)
      code = read_row(own, table, at, error);
    if (code || !found)
      return code;
  }
}

aspi_materials *aspi_materials_read(const char *path, asp_error *error) {
  aspi_table *table = aspi_table_open(NULL, path, 0, error);
  if (!table)
    return NULL;
  aspi_materials *own = calloc(1, sizeof *own);
  asp_code code = own ? read_rows(own, table, error)
                      : aspi_fail(error, ASP_ENOMEM, "out of memory for materials");
  aspi_table_close(table);
  if (!code)
    return own;
  aspi_materials_free(own);
  return NULL;
}

void aspi_materials_free(aspi_materials *materials) {
  for (int i = 0; materials && i < materials->count; i++)
    free(materials->list[i]);
  if (materials)
    free(materials->list);
  free(materials);
}

const asp_material *aspi_materials_find(const aspi_materials *own, const char *name,
                                        asp_error *error) {
  const asp_material *found = NULL;
  char list[2000] = "";
  int mine = own ? own->count : 0;
  name = aspi_word_or_empty(name);
  for (int i = 0; i < mine + asp_material_count(); i++) {
    const asp_material *m = i < mine ? own->list[i] : &presets[i - mine];
    bool is_it = strcasecmp(m->name, name) == 0;
    if (is_it && found && i < mine)
      return aspi_fail_null(error, ASP_EDATA, "material '%.100s' is there twice in the file", name);
    found = is_it && !found ? m : found;
    if (!found && strlen(list) + strlen(m->name) + 2 < sizeof list)
      aspi_append(list, sizeof list, "%s%s", *list ? " " : "", m->name);
  }
  if (!found)
    aspi_fail_unknown(error, "material", name, list);
  return found;
}
