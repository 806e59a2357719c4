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

/* ---- what has no effect ---- */

/* Refuses the first given word without an effect. */
static asp_code check_effects(const asp_description *d, asp_error *error) {
  static const char no_pair[] = ", which takes no materials";
  const asp_rebound_law *law = d->choice.law;
  const double from = asp_description_get(d, "soften_from");
  const bool is_hot = aspi_is_fit(d, "temperature") || aspi_is_fit(d, "soften_from") ||
                      asp_description_get(d, "temperature") > from;
  char degrees[40] = "";
  aspi_append(degrees, sizeof degrees, "%g K only", from);
  const struct {
    const char *name;
    bool idle;
    const char *with, *which, *why;
  } rules[] = {
      {"spread", d->kind == ASPI_SMOOTH, "surface smooth", "", ""},
      {"dp_bins", !asp_description_needs_sizes(d), "spread ", aspi_description_spread(d)->name, ""},
      {"materials", !law->needs_pair, "rebound ", law->name, no_pair},
      {"friction", asp_description_get(d, "mu") >= 0, "rebound ", law->name, ", whose MU is one"},
      {"surface_energy", !law->needs_pair, "rebound ", law->name, no_pair},
      {"surface_energy", d->deposit == ASPI_DEPOSIT_OFF, "deposit off", "", ""},
      {"temperature", !is_hot, "soften: the yield stress falls above ", degrees, ""},
      {"yield_stress", !law->needs_pair, "rebound ", law->name, no_pair},
      {"yield_stress", asp_description_get(d, "yield_rate") > 0, "yield_rate", "", ""},
      {"scatter", asp_description_get(d, "yield_rate") <= 0 && !aspi_is_given(d, "yield_stress"),
       "yield_rate 0", "", ""},
      {"adhesion", !law->needs_pair, "rebound ", law->name, no_pair},
      {"adhesion", d->deposit == ASPI_DEPOSIT_OFF, "deposit off", "", ""},
      {"remove", d->deposit != ASPI_FREEZE, "deposit ", asp_description_word(d, "deposit"), ""},
      {"remove", !law->needs_pair, "rebound ", law->name, no_pair}};
  for (size_t i = 0; i < sizeof rules / sizeof *rules; i++)
    if (rules[i].idle && aspi_is_given(d, rules[i].name))
      return aspi_fail(error, ASP_EARG, "'%s' has no effect with %s%s%s", rules[i].name,
                       rules[i].with, rules[i].which, rules[i].why);
  return ASP_OK;
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
  if (d->n_materials != 2)
    return aspi_fail(error, ASP_EARG,
                     "materials has %d names; it must be two, of particle and wall, as 'materials "
                     "quartz hastelloy-x', or 'rebound' a law without materials, as walton",
                     d->n_materials);
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
  if (!have_own && aspi_is_given(d, "soften") && !aspi_is_given(d, "temperature"))
    return aspi_fail(error, ASP_EARG,
                     "'soften' has no effect without 'temperature T', that of the particles");
  return ASP_OK;
}

double asp_description_softening(const asp_description *d) {
  const asp_rebound_law *law = d->choice.law;
  return law->softening ? law->softening(d->choice.parameters) : 1;
}

/* ---- the surface of numbers ---- */

asp_surface *aspi_description_surface(const asp_description *d, asp_error *error) {
  asp_error wrong = {ASP_OK, ""};
  asp_surface *made = d->kind == ASPI_SIGMA ? aspi_surface_create_slope(tan(aspi_radians(d->sigma)),
                                                                        d->lambda_c, &wrong)
                      : d->lay != ASP_LAY_NONE
                          ? asp_surface_create_lay(d->r_q, d->lambda_c, d->lambda_along, &wrong)
                          : asp_surface_create(d->r_q, d->lambda_c, &wrong);
  if (!made)
    aspi_fail(error, wrong.code, "surface: %s", wrong.text);
  return made;
}

/* ---- all together ---- */

asp_code asp_description_check(const asp_description *d, asp_error *error) {
  if (d->broken.code)
    return aspi_fail(error, d->broken.code, "%s", d->broken.text);
  asp_error wrong = {ASP_OK, ""};
  asp_code code = check_effects(d, error);
  if (!code)
    code = check_spread(d, error);
  if (!code)
    code = check_erosion(d, error);
  if (!code && d->choice.lever > 0)
    code = asp_description_check_bodies(d, error);
  if (code || (d->kind != ASPI_SIGMA && d->kind != ASPI_GAUSSIAN))
    return code;
  asp_surface_free(aspi_description_surface(d, &wrong));
  return wrong.code ? aspi_fail(error, wrong.code, "%s", wrong.text) : ASP_OK;
}
