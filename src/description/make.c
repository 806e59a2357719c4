/* A wall of a description: reads the file of a measured one, and makes the surface of a profile.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"
#include "base/error.h"
#include "description/description.h"
#include "readers/read.h"

#include <math.h>
#include <string.h>

/* Diameters that a measured wall is prepared for, where the description has no number. */
enum { PROFILE_BINS = 16, MAP_BINS = 6 };

/* Reads the file of a measured wall that the caller has not read himself. */
static asp_code read_file(asp_description *d, asp_error *error) {
  bool is_profile = d->kind == ASPI_PROFILE && !d->choice.profile,
       is_map = d->kind == ASPI_MAP && !d->choice.map;
  if (!is_profile && !is_map)
    return ASP_OK;
  if (!(d->units.meter > 0))
    return aspi_fail(error, ASP_EARG, "a %s is in SI units, which cannot be converted to %s",
                     is_map ? "map" : "profile", d->units.name);
  asp_error wrong = {ASP_OK, ""};
  asp_reader *reader = asp_reader_create(&wrong);
  if (reader && !asp_reader_set(reader, "meter", d->units.meter, &wrong)) {
    if (is_profile)
      d->profile = asp_reader_read(reader, d->file, &wrong);
    else
      d->map = asp_reader_read_map(reader, d->file, &wrong);
  }
  if (reader)
    asp_reader_check(reader, &d->doubt);
  asp_reader_free(reader);
  if (!d->profile && !d->map)
    return aspi_fail(error, wrong.code, "%s%s", wrong.text, asp_reader_advice(wrong.text));
  return is_map ? asp_description_set_map(d, d->map, error)
                : asp_description_set_profile(d, d->profile, error);
}

/* The surface of a profile is one for the diameters of a wall. */
static asp_surface *make_from_profile(const asp_description *d, const aspi_sizes *sizes,
                                      asp_error *error) {
  asp_error wrong;
  asp_surface *made =
      asp_surface_create_profile(d->choice.profile, sizes->least, sizes->most, sizes->bins, &wrong);
  if (!made) {
    aspi_fail(error, wrong.code, "surface profile %s: %s", d->file, wrong.text);
  } else if (asp_surface_phi_r(made) > 1) {
    aspi_fail(error, ASP_EDATA,
              "surface profile %s: phi_r = R_q/lambda_c is %g; over 1 is no roughness: are the "
              "units of positions and heights right (reader: unit_x, unit_z)?",
              d->file, asp_surface_phi_r(made));
    asp_surface_free(made);
    made = NULL;
  }
  return made;
}

/* The wall of a choice with the pair of its first two materials, where the law needs one. */
static asp_wall *make(const asp_description *d, aspi_wall_choice *choice, asp_error *error) {
  asp_pair *pair = NULL;
  if (choice->law->needs_pair && d->n_materials > 1) {
    pair = asp_description_pair(d, d->materials[0], d->materials[1], error);
    if (!pair)
      return NULL;
  }
  choice->pair = pair;
  asp_wall *wall = aspi_wall_create(choice, error);
  asp_pair_free(pair);
  return wall;
}

asp_wall *asp_wall_create(asp_description *d, double d_least, double d_most, asp_error *error) {
  if (!d) {
    aspi_fail(error, ASP_EARG, "a wall is to be made of no description");
    return NULL;
  }
  if (read_file(d, error) || asp_description_complete(d, error))
    return NULL;
  bool is_profile = d->kind == ASPI_PROFILE;
  aspi_wall_choice choice = d->choice;
  choice.sizes.bins = aspi_is_given(d, "dp_bins") ? (int)d->bins
                      : d->kind == ASPI_MAP       ? MAP_BINS
                                                  : PROFILE_BINS;
  if (asp_description_needs_sizes(d)) {
    choice.sizes.least = d_least;
    choice.sizes.most = d_most;
  }
  asp_surface *own = is_profile ? make_from_profile(d, &choice.sizes, error) : NULL;
  if (is_profile && !own)
    return NULL;
  choice.surface = own ? own : choice.surface;
  asp_wall *wall = make(d, &choice, error);
  asp_surface_free(own);
  return wall;
}

asp_wall *asp_wall_from_text(const char *text, double d_least, double d_most, asp_error *error) {
  asp_description *d = asp_description_parse(text, NULL, error);
  asp_wall *wall = d ? asp_wall_create(d, d_least, d_most, error) : NULL;
  asp_description_free(d);
  return wall;
}

asp_code aspi_description_check_sampling(const asp_description *d, const asp_wall *wall, double d_p,
                                         asp_error *error) {
  const asp_profile *profile = d->choice.profile;
  const asp_map *map = d->choice.map;
  const asp_surface *surface = asp_wall_surface(wall);
  asp_error doubt = {ASP_OK, ""};
  if (profile && surface) {
    double spacing = asp_profile_spacing(profile);
    aspi_sampling_check(d_p, spacing, (double)asp_profile_points(profile) * spacing,
                        asp_surface_lambda_c(surface), &doubt);
  } else if (map) {
    double x = asp_map_step_x(map), y = asp_map_step_y(map);
    aspi_sampling_check(d_p, fmax(x, y),
                        fmin((double)asp_map_columns(map) * x, (double)asp_map_rows(map) * y),
                        d->measured.lambda_2, &doubt);
  }
  return doubt.code ? aspi_fail(error, doubt.code, "surface %s %s: %s",
                                asp_description_word(d, "surface"), d->file, doubt.text)
                    : ASP_OK;
}
