/* A wall of a description: its heights, its surface, and the tables of its model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "description/description.h"
#include "surface/describe.h"

#include <math.h>
#include <string.h>

/* How many size classes a measured wall has without dp_bins. */
enum { PROFILE_BINS = 16, MAP_BINS = 6 };

/* A map whose lambda_2/lambda_1 is larger has a lay, whose direction must be given. */
#define STRETCH_MOST 1.5

asp_code aspi_heights_read(const asp_description *d, asp_heights **heights, asp_error *doubt,
                           asp_error *error) {
  *heights = NULL;
  *doubt = (asp_error){.code = ASP_OK};
  if (!d->file || d->choice.heights)
    return ASP_OK;
  asp_error wrong;
  const char *kind = asp_description_word(d, "surface");
  if (!(d->units.meter > 0))
    return aspi_fail(error, ASP_EARG, "a %s is in SI units, which cannot be converted to %s", kind,
                     d->units.name);
  *heights = asp_heights_read(d->file, d->kind == ASPI_MAP, d->units.meter, NULL, 0, doubt, &wrong);
  return *heights ? ASP_OK : aspi_fail(error, wrong.code, "%s", wrong.text);
}

asp_code asp_description_set_heights(asp_description *d, const asp_heights *heights,
                                     asp_error *error) {
  const char *kind = heights ? aspi_kind_of_rows(heights->rows) : "profile or map";
  if (!d->file || (heights && d->kind != (heights->rows > 1 ? ASPI_MAP : ASPI_PROFILE)))
    return aspi_fail(error, ASP_EARG, "surface is '%s'; for a %s it must be '%s FILE'",
                     asp_description_word(d, "surface"), kind, kind);
  d->choice.heights = heights;
  return ASP_OK;
}

static asp_surface *make_from_map(const asp_description *d, double d_least, double *lambda,
                                  asp_error *error) {
  bool has_lay = d->lay != ASP_LAY_NONE;
  asp_heights_numbers n;
  if (aspi_heights_judge(d->choice.heights, d_least, &n, error))
    return NULL;
  *lambda = n.lambda_2;
  if (has_lay || !(n.lambda_2 > STRETCH_MOST * n.lambda_1))
    return aspi_surface_create_map(&n, has_lay, error);
  aspi_fail(error, ASP_EARG,
            "the wall has a lay, lambda_c %.4g across and %.4g along it; say which way it lies: "
            "'lay X Y Z', axial, circumferential, or an angle",
            n.lambda_1, n.lambda_2);
  return NULL;
}

static asp_surface *make_from_profile(const asp_description *d, const aspi_sizes *sizes,
                                      double *lambda, asp_error *error) {
  asp_surface *made =
      asp_surface_create_profile(d->choice.heights, sizes->least, sizes->most, sizes->bins, error);
  if (made)
    *lambda = asp_surface_lambda_c(made);
  return made;
}

static asp_surface *make_surface(const asp_description *d, const aspi_sizes *sizes,
                                 aspi_wall_heights *heights, asp_error *error) {
  if (d->kind == ASPI_SIGMA || d->kind == ASPI_GAUSSIAN)
    return aspi_description_surface(d, error);
  const asp_heights *h = d->choice.heights;
  asp_error wrong = {.code = ASP_OK};
  asp_surface *made = h->rows > 1 ? make_from_map(d, sizes->least, &heights->lambda, &wrong)
                                  : make_from_profile(d, sizes, &heights->lambda, &wrong);
  heights->spacing = aspi_heights_extent(h).spacing;
  heights->length = aspi_heights_extent(h).length;
  if (!made)
    aspi_fail(error, wrong.code, "surface %s %s: %s", asp_description_word(d, "surface"), d->file,
              wrong.text);
  return made;
}

aspi_wall_choice aspi_description_choice(const asp_description *d) {
  aspi_wall_choice choice = d->choice;
  choice.spread = aspi_description_spread(d);
  choice.deposit = d->deposit != ASPI_DEPOSIT_OFF;
  choice.seed = (uint32_t)d->seed;
  const asp_lay lay = asp_description_lay(d);
  const double by_angle[3] = {cos(lay.angle), sin(lay.angle), 0};
  choice.has_lay = lay.kind != ASP_LAY_NONE;
  memcpy(choice.lay, lay.kind == ASP_LAY_ANGLE ? by_angle : lay.vector, sizeof choice.lay);
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
  asp_heights *own;
  asp_error doubt;
  if (!d)
    aspi_fail(error, ASP_EARG, "description is NULL");
  if (!d || asp_description_check(d, error) ||
      (!d->pairs_come && asp_description_check_pair(d, error)) ||
      aspi_heights_read(d, &own, &doubt, error))
    return NULL;
  asp_description complete = *d; /* with the heights, for as long as the wall is made */
  if (own)
    complete.choice.heights = own;
  asp_wall *wall = make(&complete, d_least, d_most, error);
  if (wall)
    wall->heights.doubt = doubt;
  asp_heights_free(own);
  return wall;
}

asp_wall *asp_wall_from_text(const char *text, double d_least, double d_most, asp_error *error) {
  asp_description *d = asp_description_parse(text, NULL, error);
  asp_wall *wall = d ? asp_wall_create(d, d_least, d_most, error) : NULL;
  asp_description_free(d);
  return wall;
}
