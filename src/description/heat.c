/* The clauses that depend on the temperature of a particle: curves of viscosity and of modulus.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/units.h"
#include "description/words.h"

static bool is_modulus(const aspi_keyword *k) {
  return strcmp(k->name, "soften_modulus") == 0;
}

static const aspi_curve *curve_of(const asp_description *d, const aspi_keyword *k) {
  return is_modulus(k) ? &d->choice.heat.modulus : &d->choice.heat.viscosity;
}

static asp_code read_curve(aspi_words *r, const aspi_keyword *k, aspi_curve *curve) {
  const aspi_curve_form *form = curve->form;
  asp_code code = ASP_OK;
  curve->unit = aspi_quantity_factor(is_modulus(k) ? "stress" : "viscosity", &r->d->units);
  for (int i = 0; i < form->n_parameters && !code; i++)
    code = aspi_words_number(r, &form->parameters[i], &curve->parameters[i]);
  if (!code && form->begin)
    code = form->begin(curve, r->error);
  if (form->n_parameters > 0)
    return code;
  code = aspi_words_file(r, k->name, &curve->file);
  return code ? code
              : aspi_curve_read(curve, is_modulus(k) ? "youngs_modulus_pa" : "viscosity_pa_s",
                                r->error);
}

bool aspi_curve_take(aspi_words *r, const aspi_keyword *k, asp_code *code) {
  aspi_heat *heat = &r->d->choice.heat;
  aspi_curve *curve = is_modulus(k) ? &heat->modulus : &heat->viscosity;
  const aspi_curve_form *form = aspi_curve_forms;
  while (form->name &&
         !(aspi_words_in_list(k->name, form->keywords) && aspi_words_accept(r, form->name)))
    form++;
  if (!form->name)
    return false;
  if (curve->form)
    *code = aspi_fail(r->error, ASP_EARG, "'%s' has '%s' and '%s'; it must be one", k->name,
                      curve->form->name, form->name);
  curve->form = form;
  if (!*code)
    *code = read_curve(r, k, curve);
  return true;
}

void aspi_curve_write(aspi_line *to, const asp_description *d, const aspi_keyword *k) {
  const aspi_curve *curve = curve_of(d, k);
  const aspi_curve_form *form = curve->form;
  if (!form)
    return;
  aspi_line_word(to, form->name);
  for (int i = 0; i < form->n_parameters; i++)
    aspi_line_value(to, d, form->parameters[i].name, form->parameters[i].unit,
                    curve->parameters[i]);
  if (curve->file)
    aspi_line_name(to, curve->file);
}

asp_code aspi_description_check_curves(const asp_description *d, asp_error *error) {
  const aspi_heat *heat = &d->choice.heat;
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    if (aspi_words_in_list(k->name, "viscosity soften_modulus") && aspi_is_given(d, k->name) &&
        !curve_of(d, k)->form)
      return aspi_fail(error, ASP_EARG, "'%s' lacks its curve; it must be '%s %s'", k->name,
                       k->name, k->values);
  return heat->temperature > 0 && aspi_heat_counts(heat)
             ? aspi_heat_check(heat, heat->temperature, error)
             : ASP_OK;
}
