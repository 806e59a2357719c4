/* A wall of a description: its heights, its surface, and the tables of its model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "description/description.h"
#include "readers/read.h"

#include <math.h>
#include <string.h>

/* Diameters that a measured wall is prepared for, where the description has no number. */
enum { PROFILE_BINS = 16, MAP_BINS = 6 };

/* A map whose lambda_2/lambda_1 is larger has a lay, whose direction must be given. */
#define STRETCH_MOST 1.5

/* ---- heights of a file ---- */

asp_code aspi_heights_read(const asp_description *d, aspi_heights *heights, asp_error *error) {
  bool is_profile = d->kind == ASPI_PROFILE && !d->choice.profile,
       is_map = d->kind == ASPI_MAP && !d->choice.map;
  *heights = (aspi_heights){NULL, NULL, {ASP_OK, ""}};
  if (!is_profile && !is_map)
    return ASP_OK;
  if (!(d->units.meter > 0))
    return aspi_fail(error, ASP_EARG, "a %s is in SI units, which cannot be converted to %s",
                     is_map ? "map" : "profile", d->units.name);
  asp_error wrong = {ASP_OK, ""};
  asp_reader *reader = asp_reader_create(&wrong);
  if (reader && !asp_reader_set(reader, "meter", d->units.meter, &wrong)) {
    if (is_profile)
      heights->profile = asp_reader_read(reader, d->file, &wrong);
    else
      heights->map = asp_reader_read_map(reader, d->file, &wrong);
  }
  if (reader)
    asp_reader_check(reader, &heights->doubt);
  asp_reader_free(reader);
  return heights->profile || heights->map
             ? ASP_OK
             : aspi_fail(error, wrong.code, "%s%s", wrong.text, asp_reader_advice(wrong.text));
}

void aspi_heights_free(aspi_heights *heights) {
  asp_profile_free(heights->profile);
  asp_map_free(heights->map);
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
  if (!code)
    d->choice.map = map;
  return code;
}

/* ---- surface ---- */

static asp_surface *make_from_map(const asp_description *d, aspi_wall_heights *heights,
                                  asp_error *error) {
  const asp_map *map = d->choice.map;
  const double x = asp_map_step_x(map), y = asp_map_step_y(map);
  asp_map_numbers numbers;
  if (asp_map_describe(map, &numbers, error))
    return NULL;
  const double across = numbers.lambda_1, along = numbers.lambda_2;
  heights->spacing = fmax(x, y);
  heights->length = fmin((double)asp_map_columns(map) * x, (double)asp_map_rows(map) * y);
  heights->lambda = along;
  if (d->lay != ASP_LAY_NONE || !(along > STRETCH_MOST * across))
    return aspi_surface_create_map(map, &numbers, d->lay != ASP_LAY_NONE, error);
  aspi_fail(error, ASP_EARG,
            "the wall has a lay, lambda_c %.4g across and %.4g along it; say which way it lies: "
            "'lay X Y Z', axial, circumferential, or an angle",
            across, along);
  return NULL;
}

static asp_surface *make_from_profile(const asp_description *d, const aspi_sizes *sizes,
                                      aspi_wall_heights *heights, asp_error *error) {
  const asp_profile *profile = d->choice.profile;
  asp_surface *made =
      asp_surface_create_profile(profile, sizes->least, sizes->most, sizes->bins, error);
  if (!made)
    return NULL;
  heights->spacing = asp_profile_spacing(profile);
  heights->length = (double)asp_profile_points(profile) * heights->spacing;
  heights->lambda = asp_surface_lambda_c(made);
  if (!(asp_surface_phi_r(made) > 1))
    return made;
  aspi_fail(error, ASP_EDATA,
            "phi_r = R_q/lambda_c is %g; over 1 is no roughness: are the units of positions and "
            "heights right (reader: unit_x, unit_z)?",
            asp_surface_phi_r(made));
  asp_surface_free(made);
  return NULL;
}

static asp_surface *make_surface(const asp_description *d, const aspi_sizes *sizes,
                                 aspi_wall_heights *heights, asp_error *error) {
  if (d->kind == ASPI_SIGMA || d->kind == ASPI_GAUSSIAN)
    return aspi_description_surface(d, error);
  asp_error wrong = {ASP_OK, ""};
  asp_surface *made = d->kind == ASPI_MAP ? make_from_map(d, heights, &wrong)
                                          : make_from_profile(d, sizes, heights, &wrong);
  if (!made)
    aspi_fail(error, wrong.code, "surface %s %s: %s", asp_description_word(d, "surface"), d->file,
              wrong.text);
  return made;
}

/* ---- wall ---- */

aspi_wall_choice aspi_description_choice(const asp_description *d) {
  aspi_wall_choice choice = d->choice;
  choice.spread = aspi_description_spread(d);
  choice.deposit = d->deposit != ASPI_DEPOSIT_OFF;
  choice.sizes.bins = d->bins > 0 ? (int)d->bins : d->kind == ASPI_MAP ? MAP_BINS : PROFILE_BINS;
  return choice;
}

/* The wall of a description whose heights, if it has a file, are set. */
static asp_wall *make(const asp_description *d, double d_least, double d_most, asp_error *error) {
  aspi_wall_choice choice = aspi_description_choice(d);
  aspi_wall_heights heights = {.spacing = 0};
  asp_surface *surface = NULL;
  asp_pair *pair = NULL;
  asp_wall *wall = NULL;
  if (asp_description_needs_sizes(d)) {
    choice.sizes.least = d_least;
    choice.sizes.most = d_most;
  }
  bool needs_pair = choice.law->needs_pair && d->n_materials > 1;
  if (d->kind != ASPI_SMOOTH)
    choice.surface = surface = make_surface(d, &choice.sizes, &heights, error);
  if (needs_pair && (surface || d->kind == ASPI_SMOOTH))
    choice.pair = pair = asp_description_pair(d, d->materials[0], d->materials[1], error);
  if ((surface || d->kind == ASPI_SMOOTH) && (pair || !needs_pair))
    wall = aspi_wall_create(&choice, error);
  if (wall)
    wall->heights = heights;
  asp_surface_free(surface);
  asp_pair_free(pair);
  return wall;
}

asp_wall *asp_wall_create(const asp_description *d, double d_least, double d_most,
                          asp_error *error) {
  aspi_heights own;
  if (!d)
    aspi_fail(error, ASP_EARG, "a wall is to be made of no description");
  if (!d || asp_description_check(d, error) || aspi_heights_read(d, &own, error))
    return NULL;
  asp_description complete = *d; /* with the heights, for as long as the wall is made */
  if (own.profile)
    complete.choice.profile = own.profile;
  if (own.map)
    complete.choice.map = own.map;
  asp_wall *wall = make(&complete, d_least, d_most, error);
  if (wall)
    wall->heights.doubt = own.doubt;
  aspi_heights_free(&own);
  return wall;
}

asp_wall *asp_wall_from_text(const char *text, double d_least, double d_most, asp_error *error) {
  asp_description *d = asp_description_parse(text, NULL, error);
  asp_wall *wall = d ? asp_wall_create(d, d_least, d_most, error) : NULL;
  asp_description_free(d);
  return wall;
}
