/* A description, and access to its numbers and words by name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "description/description.h"
#include "base/units.h"
#include "base/error.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

asp_description *aspi_description_create(const asp_units *units, asp_error *error) {
  asp_description *d = calloc(1, sizeof *d);
  if (!d)
    return aspi_fail_null(error, ASP_ENOMEM, "out of memory for a description");
  d->units = units ? *units : aspi_si;
  d->units.name = d->units.name ? d->units.name : "the caller's units";
  d->last = "";
  d->sigma = d->r_q = d->lambda_c = NAN;
  d->friction = d->surface_energy = d->yield_stress = NAN;
  d->seed = aspi_keyword_find("seed")->default_value;
  d->choice = aspi_wall_choice_smooth();
  d->choice.isotropic = d->choice.multiple = true;
  d->choice.flow.micron = 1e-6 * aspi_quantity_factor("length", &d->units);
  return d;
}

void asp_description_free(asp_description *d) {
  if (!d)
    return;
  for (int i = 0; i < d->n_materials; i++) {
    free(d->names[i]);
    if (d->materials)
      asp_material_free(d->materials[i]);
  }
  free(d->names);
  free(d->materials);
  free(d->file);
  free(d->table);
  free(d->choice.heat.viscosity.file);
  free(d->choice.heat.modulus.file);
  free(d->materials_file);
  aspi_materials_free(d->own);
  aspi_cor_table_free(d->cor_table);
  free(d);
}

uint64_t aspi_keyword_bit(const aspi_keyword *k) {
  return (uint64_t)1 << (k - aspi_keywords);
}

bool aspi_is_given(const asp_description *d, const char *name) {
  const asp_rebound_law *law = d->choice.law;
  for (int i = 0; i < law->n_parameters; i++)
    if (d->of_law >> i & 1 && strcmp(aspi_keyword_word(&law->parameters[i]), name) == 0)
      return true;
  return aspi_given_of(d, name, 0);
}

const char *aspi_given_of(const asp_description *d, const char *list, int nth) {
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    if (d->given & aspi_keyword_bit(k) &&
        aspi_word_index(list, k->name, strlen(k->name), true) >= 0 && nth-- == 0)
      return k->name;
  return NULL;
}

bool asp_description_is_given(const asp_description *d, const char *keyword) {
  return keyword && aspi_is_given(d, keyword);
}

void aspi_set_given(asp_description *d, const char *name) {
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    if (strcmp(k->name, name) == 0 && !aspi_is_given(d, name))
      d->given |= aspi_keyword_bit(k);
}

void asp_description_default_plane(asp_description *d) {
  d->choice.isotropic = false;
}

void asp_description_expect_pairs(asp_description *d) {
  d->pairs_come = true;
}

const aspi_keyword *aspi_number_find(const asp_description *d, const char *name, size_t *place) {
  int i = name ? aspi_rebound_parameter_find(d->choice.law, name) : -1;
  *place = offsetof(asp_description, choice.parameters) + (size_t)(i < 0 ? 0 : i) * sizeof(double);
  if (i >= 0)
    return &d->choice.law->parameters[i];
  for (const aspi_keyword *k = aspi_keywords; k->name && name; k++)
    if (k->number && k->printed != ASPI_PRINT_NEVER && strcmp(k->name, name) == 0) {
      *place = k->number;
      return k;
    }
  return NULL;
}

double asp_description_get(const asp_description *d, const char *name) {
  size_t place;
  double value = NAN;
  const aspi_keyword *k = aspi_number_find(d, name, &place);
  if (k)
    memcpy(&value, (const char *)d + place, sizeof value);
  return k && k->within && !(value > 0) && !aspi_is_given(d, name) ? NAN : value;
}

/* Lists the numbers of the law, and of the keywords that are given or begin a clause. */
static asp_code fail_name(const asp_description *d, const char *name, asp_error *error) {
  const asp_rebound_law *law = d->choice.law;
  char list[420] = "", what[100];
  for (int i = 0; i < law->n_parameters; i++)
    aspi_append(list, sizeof list, " %s", law->parameters[i].name);
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    if (k->number && k->printed != ASPI_PRINT_NEVER && (!*k->within || aspi_is_given(d, k->name)))
      aspi_append(list, sizeof list, " %s", k->name);
  snprintf(what, sizeof what, "of a wall with rebound law '%s', number", law->name);
  return aspi_fail_unknown(error, what, name ? name : "", list + 1);
}

asp_code asp_description_set(asp_description *d, const char *name, double value, asp_error *error) {
  size_t place;
  char given[32] = "";
  const aspi_keyword *k = aspi_number_find(d, name, &place);
  if (!k || (k->within && *k->within && !aspi_is_given(d, name)))
    return fail_name(d, name, error);
  aspi_append(given, sizeof given, "%g", value);
  asp_code code = aspi_keyword_check(k, given, value, error);
  if (code)
    return code;
  memcpy((char *)d + place, &value, sizeof value);
  if (k->within)
    aspi_set_given(d, name);
  int kept = 0;
  for (int i = 0; i < d->n_fitted; i++)
    if (strcmp(d->fitted[i], name) != 0)
      d->fitted[kept++] = d->fitted[i];
  d->n_fitted = kept;
  return ASP_OK;
}

bool aspi_is_fit(const asp_description *d, const char *name) {
  for (int i = 0; i < d->n_fitted; i++)
    if (strcmp(d->fitted[i], name) == 0)
      return true;
  return false;
}

const char *asp_description_word(const asp_description *d, const char *name) {
  static const char *const kinds[] = {"smooth", "sigma", "rq", "profile", "map"};
  static const char *const deposits[] = {"freeze", "delete", "off"};
  const struct {
    const char *name, *value;
  } words[] = {{"surface", kinds[d->kind]},
               {"file", d->file},
               {"spread", aspi_description_spread(d)->name},
               {"tilt", d->choice.isotropic ? "isotropic" : "plane"},
               {"collisions", d->choice.multiple ? "multiple" : "single"},
               {"rebound", d->choice.law->name},
               {"deposit", deposits[d->deposit]}};
  for (size_t i = 0; name && i < sizeof words / sizeof *words; i++)
    if (strcmp(words[i].name, name) == 0)
      return words[i].value;
  return NULL;
}

const asp_spread_model *aspi_description_spread(const asp_description *d) {
  bool is_measured = d->kind == ASPI_PROFILE || d->kind == ASPI_MAP;
  const char *default_model = d->kind == ASPI_SMOOTH ? "none" : is_measured ? "traced" : "visible";
  return d->spread ? d->spread : asp_spread_find(default_model, NULL);
}

const asp_rebound_law *asp_description_rebound(const asp_description *d) {
  return d->choice.law;
}

asp_lay asp_description_lay(const asp_description *d) {
  asp_lay lay = {.kind = d->lay};
  if (lay.kind == ASP_LAY_ANGLE && d->lay_word)
    lay.angle = strcmp(d->lay_word, "axial") == 0 ? 0 : 0.5 * ASP_PI;
  else if (lay.kind == ASP_LAY_ANGLE)
    lay.angle = aspi_radians(d->lay_numbers[0]);
  if (lay.kind == ASP_LAY_VECTOR) {
    const double *v = d->lay_numbers;
    double per_length = 1 / sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; i++)
      lay.vector[i] = v[i] * per_length;
  }
  return lay;
}

int asp_description_materials(const asp_description *d) {
  return d->n_materials;
}

const asp_material *asp_description_material(const asp_description *d, int index) {
  return d->materials && index >= 0 && index < d->n_materials ? d->materials[index] : NULL;
}

asp_pair *asp_description_pair(const asp_description *d, const asp_material *particle,
                               const asp_material *target, asp_error *error) {
  asp_pair *pair = asp_pair_create(particle, target, error);
  if (!pair)
    return NULL;
  double default_energy = ASP_SURFACE_ENERGY * aspi_quantity_factor("energy/area", &d->units);
  asp_pair_set(pair, "surface_energy", d->surface_energy >= 0 ? d->surface_energy : default_energy,
               NULL);
  if (d->friction >= 0)
    asp_pair_set(pair, "friction", d->friction, NULL);
  if (d->yield_stress >= 0)
    asp_pair_set(pair, "yield_stress", d->yield_stress, NULL);
  return pair;
}
