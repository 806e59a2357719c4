/* Checks the clauses of a description together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/units.h"
#include "description/description.h"
#include "surface/size_law.h"

#include <math.h>

bool asp_description_needs_sizes(const asp_description *d) {
  return d->kind == ASPI_PROFILE || (d->kind != ASPI_SMOOTH && aspi_description_spread(d)->prepare);
}

/* Why a word with this need has no effect; "": it has one. */
static void find_lack(const asp_description *d, aspi_need need, char *why, size_t size) {
  const double rate = asp_description_get(d, "yield_rate"), heat = d->choice.heat.temperature,
               from = asp_description_get(d, "soften_from");
  const bool is_cold = !aspi_is_fit(d, "temperature") && !aspi_is_fit(d, "soften_from") &&
                       heat <= from && !aspi_heat_counts(&d->choice.heat);
  const char *law = d->choice.law->name;
  *why = '\0';
  if (need == ASPI_ROUGH && d->kind == ASPI_SMOOTH)
    aspi_append(why, size, "with surface smooth");
  else if (need == ASPI_SIZES && !asp_description_needs_sizes(d))
    aspi_append(why, size, "with spread %s", aspi_description_spread(d)->name);
  else if (need == ASPI_PAIR && !d->choice.law->needs_pair)
    aspi_append(why, size, "with rebound %s, which takes no materials", law);
  else if (need == ASPI_NO_MU && asp_description_get(d, "mu") >= 0)
    aspi_append(why, size, "with rebound %s, whose MU is one", law);
  else if ((need == ASPI_STICKS && d->deposit == ASPI_DEPOSIT_OFF) ||
           (need == ASPI_FREEZES && d->deposit != ASPI_FREEZE))
    aspi_append(why, size, "with deposit %s", asp_description_word(d, "deposit"));
  else if (need == ASPI_NO_RATE && rate > 0)
    aspi_append(why, size, "with yield_rate");
  else if (need == ASPI_HAS_YIELD && rate <= 0 && !aspi_is_given(d, "yield_stress"))
    aspi_append(why, size, "with yield_rate 0");
  else if (need == ASPI_IS_HOT && !d->choice.law->softening && !aspi_heat_counts(&d->choice.heat))
    aspi_append(why, size, "with rebound %s, without 'viscosity' and 'soften_modulus'", law);
  else if (need == ASPI_IS_HOT && is_cold)
    aspi_append(why, size, "at %g K: softening starts at %g K (soften FROM RATE)", heat, from);
}

static asp_code check_effect(const asp_description *d, const aspi_keyword *k, asp_error *error) {
  char why[160];
  for (unsigned need = 1; need <= k->needs; need *= 2) {
    find_lack(d, (aspi_need)(k->needs & need), why, sizeof why);
    if (*why)
      return aspi_fail(error, ASP_EARG, "'%s' has no effect %s", k->name, why);
  }
  return ASP_OK;
}

/* Refuses the first given word without an effect. */
static asp_code check_effects(const asp_description *d, asp_error *error) {
  asp_code code = ASP_OK;
  for (const aspi_keyword *k = aspi_keywords; k->name && !code; k++)
    if (d->given & aspi_keyword_bit(k))
      code = check_effect(d, k, error);
  for (int i = 0; i < d->choice.law->n_parameters && !code; i++)
    if (d->of_law >> i & 1)
      code = check_effect(d, &d->choice.law->parameters[i], error);
  return code;
}

static asp_code check_spread(const asp_description *d, asp_error *error) {
  if (d->spread != &aspi_spread_profile || !d->file)
    return ASP_OK;
  return aspi_fail(
      error, ASP_EARG,
      "spread is 'profile', a law of Gaussian walls; over a measured one particles are "
      "followed hit by hit: 'spread traced', the default");
}

static asp_code check_erosion(const asp_description *d, asp_error *error) {
  const aspi_erosion *erosion = &d->choice.erosion;
  if (!erosion->law || !erosion->law->is_volume || erosion->density > 0 ||
      (d->n_materials > 0 && d->choice.law->needs_pair))
    return ASP_OK;
  return aspi_fail(error, ASP_EARG,
                   "erosion needs the density of the wall: by 'materials', or 'density RHO' in its "
                   "own words");
}

asp_code asp_description_check_bodies(const asp_description *d, asp_error *error) {
  return aspi_rebound_check_bodies(d->choice.law, d->choice.parameters, error);
}

asp_code asp_description_check_pair(const asp_description *d, asp_error *error) {
  if (!d->choice.law->needs_pair)
    return ASP_OK;
  char laws[200] = "";
  for (int i = 0; i < asp_rebound_count(); i++)
    if (!asp_rebound_at(i)->needs_pair)
      aspi_append(laws, sizeof laws, " %s", asp_rebound_at(i)->name);
  if (d->n_materials != 2)
    return aspi_fail(error, ASP_EARG,
                     "materials needs two names (particle, wall), got %d, as 'materials quartz "
                     "hastelloy-x'; laws without materials:%s",
                     d->n_materials, laws);
  const asp_material *m = d->materials[0];
  if (asp_description_get(d, "yield_rate") > 0 || aspi_is_given(d, "yield_stress") ||
      m->yield_stress > 0)
    return ASP_OK;
  return aspi_fail(error, ASP_EARG,
                   "material '%s' has no yield stress; say 'yield_stress Y', or 'yield_rate R' of "
                   "'rebound bons', or 'rebound walton E MU 0 deposit off', which needs none",
                   m->name);
}

asp_code asp_description_check_heat(const asp_description *d, bool have_own, asp_error *error) {
  if (have_own && aspi_is_given(d, "temperature"))
    return aspi_fail(error, ASP_EARG,
                     "'temperature' has no effect: the particles have one of their own");
  const char *hot =
      aspi_is_given(d, "soften") ? "soften" : aspi_given_of(d, "viscosity soften_modulus", 0);
  if (!have_own && hot && !aspi_is_given(d, "temperature"))
    return aspi_fail(error, ASP_EARG,
                     "'%s' has no effect without 'temperature T', that of the particles, behind "
                     "'rebound %s'",
                     hot, d->choice.law->name);
  return ASP_OK;
}

double asp_description_softening(const asp_description *d) {
  const asp_rebound_law *law = d->choice.law;
  return law->softening ? law->softening(d->choice.parameters, d->choice.heat.temperature) : 1;
}

asp_surface *aspi_description_surface(const asp_description *d, asp_error *error) {
  asp_error wrong = {.code = ASP_OK};
  asp_surface *made = d->kind == ASPI_SIGMA ? aspi_surface_create_slope(tan(aspi_radians(d->sigma)),
                                                                        d->lambda_c, &wrong)
                      : d->lay != ASP_LAY_NONE
                          ? asp_surface_create_lay(d->r_q, d->lambda_c, d->lambda_along, &wrong)
                          : asp_surface_create(d->r_q, d->lambda_c, &wrong);
  if (!made)
    aspi_fail(error, wrong.code, "surface: %s", wrong.text);
  return made;
}

asp_code asp_description_check(const asp_description *d, asp_error *error) {
  if (d->broken.code)
    return aspi_fail(error, d->broken.code, "%s", d->broken.text);
  asp_error wrong = {.code = ASP_OK};
  asp_code code = check_effects(d, error);
  if (!code)
    code = check_spread(d, error);
  if (!code)
    code = check_erosion(d, error);
  if (!code)
    code = aspi_description_check_curves(d, error);
  if (!code && d->choice.lever > 0)
    code = asp_description_check_bodies(d, error);
  if (code || (d->kind != ASPI_SIGMA && d->kind != ASPI_GAUSSIAN))
    return code;
  asp_surface_free(aspi_description_surface(d, &wrong));
  return wrong.code ? aspi_fail(error, wrong.code, "%s", wrong.text) : ASP_OK;
}
