/* Checks the clauses of a description together, and makes the surface of its numbers or its map.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/units.h"
#include "description/description.h"
#include "surface/size_law.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Correlation length of a wall by its sigma alone, in meters: larger than all particles. */
#define SIGMA_LAMBDA 1e6

/* A map whose lambda_2/lambda_1 is larger has a lay, whose direction must be given. */
#define STRETCH_MOST 1.5

bool asp_description_needs_sizes(const asp_description *d) {
  if (d->kind == ASPI_SMOOTH)
    return false;
  return d->kind == ASPI_PROFILE || d->choice.spread->generate ||
         (d->kind == ASPI_MAP && d->choice.spread->prepare_map);
}

/* ---- what has no effect ---- */

typedef struct against {
  char text[120];
} against;

static bool without_pair(const asp_description *d, against *with) {
  snprintf(with->text, sizeof with->text, "rebound %s, which takes no materials",
           d->choice.law->name);
  return !d->choice.law->needs_pair;
}

static bool deposits_off(const asp_description *d, against *with) {
  snprintf(with->text, sizeof with->text, "deposit off");
  return d->deposit == ASPI_DEPOSIT_OFF;
}

static bool keeps_no_deposits(const asp_description *d, against *with) {
  snprintf(with->text, sizeof with->text, "deposit %s", asp_description_word(d, "deposit"));
  return d->deposit != ASPI_FREEZE;
}

static bool yields_by_rate(const asp_description *d, against *with) {
  snprintf(with->text, sizeof with->text, "yield_rate");
  return asp_description_get(d, "yield_rate") > 0;
}

static bool is_not_hot(const asp_description *d, against *with) {
  double from = asp_description_get(d, "soften_from");
  snprintf(with->text, sizeof with->text, "soften: the yield stress falls above %g K only", from);
  return !aspi_is_fit(d, "temperature") && !aspi_is_fit(d, "soften_from") &&
         !(asp_description_get(d, "temperature") > from);
}

static bool has_own_friction(const asp_description *d, against *with) {
  snprintf(with->text, sizeof with->text, "rebound %s, whose MU is one", d->choice.law->name);
  return asp_description_get(d, "mu") >= 0;
}

static bool is_smooth(const asp_description *d, against *with) {
  snprintf(with->text, sizeof with->text, "surface smooth");
  return d->kind == ASPI_SMOOTH;
}

static bool has_no_bins(const asp_description *d, against *with) {
  snprintf(with->text, sizeof with->text, "spread %s", d->choice.spread->name);
  return !asp_description_needs_sizes(d);
}

static const struct {
  const char *name;
  bool (*idle)(const asp_description *d, against *with);
} rules[] = {{"spread", is_smooth},
             {"dp_bins", has_no_bins},
             {"materials", without_pair},
             {"friction", has_own_friction},
             {"surface_energy", without_pair},
             {"surface_energy", deposits_off},
             {"temperature", is_not_hot},
             {"yield_stress", without_pair},
             {"yield_stress", yields_by_rate},
             {"remove", keeps_no_deposits},
             {"remove", without_pair}};

/* Refuses the first given word without an effect. */
static asp_code check_effects(const asp_description *d, asp_error *error) {
  against with;
  for (size_t i = 0; i < sizeof rules / sizeof *rules; i++)
    if (aspi_is_given(d, rules[i].name) && rules[i].idle(d, &with))
      return aspi_fail(error, ASP_EARG, "'%s' has no effect with %s", rules[i].name, with.text);
  return ASP_OK;
}

static asp_code check_erosion(const asp_description *d, asp_error *error) {
  const aspi_erosion *erosion = &d->choice.erosion;
  if (!erosion->law || erosion->density > 0 || (d->n_materials > 0 && d->choice.law->needs_pair))
    return ASP_OK;
  return aspi_fail(error, ASP_EARG,
                   "erosion needs the density of the wall: by 'materials', or 'density RHO' in its "
                   "own words");
}

/* ---- surface ---- */

static asp_surface *make_from_sigma(const asp_description *d, asp_error *error) {
  double meter = d->units.meter > 0 ? d->units.meter : 1, lambda = SIGMA_LAMBDA * meter;
  double slope = tan(aspi_radians(d->sigma));
  asp_surface *made = asp_surface_create(slope / sqrt(2) * lambda, lambda, error);
  if (made)
    aspi_surface_set_feature(made, d->lambda_c > 0 ? d->lambda_c : 0);
  return made;
}

static asp_surface *make_from_lengths(const asp_description *d, asp_error *error) {
  return d->lay != ASP_LAY_NONE
             ? asp_surface_create_lay(d->r_q, d->lambda_c, d->lambda_along, error)
             : asp_surface_create(d->r_q, d->lambda_c, error);
}

static asp_code check_lay(const asp_description *d, asp_error *error) {
  const double across = d->measured.lambda_1, along = d->measured.lambda_2;
  if (d->lay != ASP_LAY_NONE || !(along > STRETCH_MOST * across))
    return ASP_OK;
  return aspi_fail(error, ASP_EARG,
                   "surface map %s: the wall has a lay, lambda_c %.4g across and %.4g along it; "
                   "say which way it lies: 'lay X Y Z', axial, circumferential, or an angle",
                   d->file, across, along);
}

/* What may be wrong where lambda_c is too short. */
static const char *slip_of_lengths(const asp_description *d) {
  if (!(d->r_q > d->lambda_c))
    return "";
  if (aspi_is_given(d, "rdq") || aspi_is_given(d, "sdq"))
    return "; is the slope an angle? then it needs its unit, as in '10deg'";
  return aspi_is_given(d, "rsm") || aspi_is_given(d, "sal")
             ? "; are the height and the length swapped?"
             : "; are rq and lambda_c swapped?";
}

static asp_code make_surface(asp_description *d, asp_error *error) {
  asp_error wrong = {ASP_OK, ""};
  bool is_map = d->kind == ASPI_MAP;
  if (d->surface || d->kind == ASPI_SMOOTH || d->kind == ASPI_PROFILE || (is_map && !d->choice.map))
    return ASP_OK;
  if (is_map && !asp_map_describe(d->choice.map, &d->measured, &wrong)) {
    if (check_lay(d, error))
      return ASP_EARG;
    d->surface =
        aspi_surface_create_map(d->choice.map, &d->measured, d->lay != ASP_LAY_NONE, &wrong);
  } else if (!is_map)
    d->surface = d->kind == ASPI_SIGMA ? make_from_sigma(d, &wrong) : make_from_lengths(d, &wrong);
  if (d->surface)
    return ASP_OK;
  return is_map ? aspi_fail(error, wrong.code, "surface map %s: %s", d->file, wrong.text)
                : aspi_fail(error, wrong.code, "surface: %s%s", wrong.text, slip_of_lengths(d));
}

/* ---- all together ---- */

/* The model where none is given. */
static const char *standard_model(const asp_description *d) {
  return d->kind == ASPI_SMOOTH                           ? "none"
         : d->kind == ASPI_PROFILE || d->kind == ASPI_MAP ? "profile"
                                                          : "visible";
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

asp_code asp_description_complete(asp_description *d, asp_error *error) {
  if (d->broken.code)
    return aspi_fail(error, d->broken.code, "%s", d->broken.text);
  d->choice.spread = d->spread ? d->spread : asp_spread_find(standard_model(d), NULL);
  asp_code code = check_effects(d, error);
  if (!code)
    code = check_erosion(d, error);
  if (!code && d->choice.lever > 0)
    code = asp_description_check_bodies(d, error);
  if (!code)
    code = make_surface(d, error);
  d->choice.surface = d->surface;
  return code;
}

/* Takes heights of the caller's, of a description whose surface is of that kind. */
static asp_code check_kind(const asp_description *d, bool is_kind, const char *kind,
                           asp_error *error) {
  return is_kind ? ASP_OK
                 : aspi_fail(error, ASP_EARG, "surface is '%s'; for a %s it must be '%s FILE'",
                             asp_description_word(d, "surface"), kind, kind);
}

asp_code asp_description_set_profile(asp_description *d, const asp_profile *profile,
                                     asp_error *error) {
  asp_code code = check_kind(d, d->kind == ASPI_PROFILE, "profile", error);
  if (!code)
    d->choice.profile = profile;
  return code;
}

asp_code asp_description_set_map(asp_description *d, const asp_map *map, asp_error *error) {
  asp_code code = check_kind(d, d->kind == ASPI_MAP, "map", error);
  if (code)
    return code;
  asp_surface_free(d->surface);
  d->choice.surface = d->surface = NULL;
  d->choice.map = map;
  return asp_description_complete(d, error);
}
