/* The materials of a description.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/quantity.h"
#include "wall/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A name that is no material may be a keyword with a slip. */
static asp_code fail_material(aspi_words *r, const char *name) {
  char keywords[ASPI_LIST_MOST], all[2 * ASPI_LIST_MOST], meant[64];
  aspi_keyword_names("", keywords, sizeof keywords);
  size_t used = strlen(keywords);
  snprintf(keywords + used, sizeof keywords - used, " file %s", r->others);
  snprintf(all, sizeof all, "%s", keywords);
  for (int i = 0; i < asp_material_count(); i++) {
    used = strlen(all);
    snprintf(all + used, sizeof all - used, " %s", asp_material_name(asp_material_at(i)));
  }
  if (aspi_nearest_name(name, all, meant) && aspi_words_in_list(meant, keywords))
    return aspi_fail(r->error, ASP_ENAME,
                     "'%.100s' is neither a material nor a keyword; did you mean '%s'?", name,
                     meant);
  aspi_materials_find(r->said->own, name, r->error);
  return ASP_ENAME;
}

/* A material with the numbers of another one, in the caller's units. */
static asp_material *converted(const asp_material *m, const asp_units *units, asp_error *error) {
  double pascal = aspi_quantity_factor("stress", units);
  asp_material *made = asp_material_create(m->name, error);
  if (!made)
    return NULL;
  made->youngs_modulus = m->youngs_modulus * pascal;
  made->poissons_ratio = m->poissons_ratio;
  made->density = m->density * aspi_quantity_factor("density", units);
  made->yield_stress = m->yield_stress * pascal;
  return made;
}

/* Names end where the file or another keyword begins. */
static asp_code read_names(aspi_words *r) {
  aspi_description *said = r->said;
  char keywords[ASPI_LIST_MOST];
  aspi_keyword_names("", keywords, sizeof keywords);
  while (r->next < r->count && !aspi_words_next_is(r, "file") &&
         !aspi_words_in_list(r->words[r->next], keywords) &&
         !aspi_words_in_list(r->words[r->next], r->others)) {
    char **grown = realloc(said->names, (size_t)(said->n_materials + 1) * sizeof *grown);
    char *name = grown ? aspi_words_copy(r->words[r->next++], r->error) : NULL;
    said->names = grown ? grown : said->names;
    if (!name)
      return aspi_fail(r->error, ASP_ENOMEM, "out of memory for a description");
    said->names[said->n_materials++] = name;
  }
  return ASP_OK;
}

asp_code aspi_words_materials(aspi_words *r) {
  aspi_description *said = r->said;
  asp_code code = read_names(r);
  if (!code && aspi_words_take(r, "file")) {
    code = aspi_words_file(r, "the file of 'materials'", &said->materials_file);
    asp_error wrong;
    said->own = code ? NULL : aspi_materials_read(said->materials_file, &wrong);
    if (!code && !said->own)
      code = aspi_fail(r->error, wrong.code, "materials: %s", wrong.text);
  }
  if (!code)
    code = aspi_words_check_units(r, "materials are");
  if (code)
    return code;
  said->materials = calloc((size_t)said->n_materials + 1, sizeof *said->materials);
  if (!said->materials)
    return aspi_fail(r->error, ASP_ENOMEM, "out of memory for a description");
  for (int i = 0; i < said->n_materials; i++) {
    const asp_material *m = aspi_materials_find(said->own, said->names[i], NULL);
    if (!m)
      return fail_material(r, said->names[i]);
    said->materials[i] = converted(m, &said->units, r->error);
    if (!said->materials[i])
      return ASP_ENOMEM;
  }
  return ASP_OK;
}

int asp_wall_materials(const asp_wall *wall) {
  return wall->said ? wall->said->n_materials : 0;
}

const asp_material *asp_wall_material(const asp_wall *wall, int index) {
  return wall->said->materials[index];
}

asp_pair *asp_wall_pair(const asp_wall *wall, const asp_material *particle,
                        const asp_material *target, asp_error *error) {
  const aspi_description *said = wall->said;
  asp_pair *pair = asp_pair_create(particle, target, error);
  if (!pair)
    return NULL;
  double standard = ASP_SURFACE_ENERGY * aspi_quantity_factor("energy/area", &said->units);
  asp_pair_set(pair, "surface_energy", said->surface_energy >= 0 ? said->surface_energy : standard,
               NULL);
  if (said->friction >= 0)
    asp_pair_set(pair, "friction", said->friction, NULL);
  if (said->yield_stress >= 0)
    asp_pair_set(pair, "yield_stress", said->yield_stress, NULL);
  return pair;
}
