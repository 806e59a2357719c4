/* The materials of a description.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/grow.h"
#include "base/number.h"
#include "base/units.h"
#include "description/words.h"

#include <stdio.h>
#include <stdlib.h>

static bool is_number(const char *word) {
  char *end;
  aspi_number(word, &end);
  return end > word && !*end;
}

/* An unknown name may be a misspelled keyword. */
static asp_code fail_material(aspi_words *r, const char *name) {
  if (aspi_words_misplaced(r, name))
    return ASP_ENAME;
  char keywords[ASPI_LIST_MOST] = "", all[2 * ASPI_LIST_MOST], meant[64];
  aspi_keyword_names("", keywords, sizeof keywords);
  aspi_append(keywords, sizeof keywords, " file %s", r->others);
  snprintf(all, sizeof all, "%s", keywords);
  for (int i = 0; i < asp_material_count(); i++)
    aspi_append(all, sizeof all, " %s", asp_material_name(asp_material_at(i)));
  if (aspi_nearest_name(name, all, meant) && aspi_words_in_list(meant, keywords))
    return aspi_fail(r->error, ASP_ENAME,
                     "'%.100s' is neither a material nor a keyword; did you mean '%s'?", name,
                     meant);
  aspi_materials_find(r->d->own, name, r->error);
  return ASP_ENAME;
}

/* A copy of a material in the caller's units. */
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

/* Names end where the file, another keyword or a number begins. */
asp_code aspi_names_read(aspi_words *r, const aspi_keyword *k) {
  (void)k;
  asp_description *d = r->d;
  char keywords[ASPI_LIST_MOST] = "";
  aspi_keyword_names("", keywords, sizeof keywords);
  while (r->next < r->count && !aspi_words_next_is(r, "file") && !is_number(r->words[r->next]) &&
         !aspi_words_in_list(r->words[r->next], keywords) &&
         !aspi_words_in_list(r->words[r->next], r->others)) {
    char **grown = aspi_grow(d->names, (size_t)d->n_materials, sizeof *grown);
    char *name = grown ? aspi_words_copy(r->words[r->next++], r->error) : NULL;
    d->names = grown ? grown : d->names;
    if (!name)
      return aspi_fail(r->error, ASP_ENOMEM, "out of memory for a description");
    d->names[d->n_materials++] = name;
  }
  for (int i = 0; i < asp_material_count(); i++)
    aspi_words_offer(r, asp_material_name(asp_material_at(i)));
  return ASP_OK;
}

asp_code aspi_names_finish(aspi_words *r) {
  asp_description *d = r->d;
  asp_error wrong;
  d->own = d->materials_file ? aspi_materials_read(d->materials_file, &wrong) : NULL;
  if (d->materials_file && !d->own)
    return aspi_fail(r->error, wrong.code, "materials: %s", wrong.text);
  d->materials = calloc((size_t)d->n_materials + 1, sizeof *d->materials);
  if (!d->materials)
    return aspi_fail(r->error, ASP_ENOMEM, "out of memory for a description");
  for (int i = 0; i < d->n_materials; i++) {
    const asp_material *m = aspi_materials_find(d->own, d->names[i], NULL);
    if (!m)
      return fail_material(r, d->names[i]);
    d->materials[i] = converted(m, &d->units, r->error);
    if (!d->materials[i])
      return ASP_ENOMEM;
  }
  return ASP_OK;
}

void aspi_names_write(aspi_line *l, const asp_description *d, const aspi_keyword *k) {
  (void)k;
  for (int i = 0; i < d->n_materials; i++)
    aspi_line_name(l, d->names[i]);
}
