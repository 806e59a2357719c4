/* The wall that a description means: its numbers, its surface, and the choice of a model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/quantity.h"
#include "readers/read.h"
#include "surface/size_law.h"
#include "wall/description.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* Diameters that a measured wall is prepared for, where the description has no number. */
enum { PROFILE_BINS = 16, MAP_BINS = 6 };

/* Correlation length of a wall by its sigma alone, in meters: larger than all particles. */
#define SIGMA_LAMBDA 1e6

/* A map whose lambda_2/lambda_1 is larger has a lay, whose direction must be given. */
#define STRETCH_MOST 1.5

void aspi_description_free(aspi_description *said) {
  if (!said)
    return;
  for (int i = 0; i < said->n_materials; i++) {
    free(said->names[i]);
    if (said->materials)
      asp_material_free(said->materials[i]);
  }
  free(said->names);
  free(said->materials);
  free(said->file);
  free(said->table);
  free(said->materials_file);
  aspi_materials_free(said->own);
  asp_surface_free(said->surface);
  asp_profile_free(said->profile);
  asp_map_free(said->map);
  aspi_cor_table_free(said->cor_table);
  free(said);
}

/* ---- statements of the script ---- */

/* Its numbers that may be asked for by name, and set. */
static const struct {
  const char *within, *name;
  size_t at;
} numbers[] = {{"", "seed", offsetof(aspi_description, seed)},
               {"", "friction", offsetof(aspi_description, friction)},
               {"", "surface_energy", offsetof(aspi_description, surface_energy)},
               {"", "yield_stress", offsetof(aspi_description, yield_stress)},
               {"surface", "sigma", offsetof(aspi_description, sigma)},
               {"surface", "rq", offsetof(aspi_description, r_q)},
               {"surface", "lambda_c", offsetof(aspi_description, lambda_c)},
               {"spread", "tolerance", offsetof(aspi_description, tolerance)}};
enum { NUMBERS = sizeof numbers / sizeof *numbers };

static int number_find(const char *name) {
  int i = 0;
  while (i < NUMBERS && strcmp(numbers[i].name, name) != 0)
    i++;
  return i;
}

double *aspi_description_number(aspi_description *said, const char *name) {
  int i = number_find(name);
  return i < NUMBERS ? (double *)((char *)said + numbers[i].at) : NULL;
}

double aspi_description_get(const aspi_description *said, const char *name) {
  double value = NAN;
  int i = number_find(name);
  if (i < NUMBERS)
    memcpy(&value, (const char *)said + numbers[i].at, sizeof value);
  return value;
}

asp_code aspi_description_set(aspi_description *said, const char *name, double value,
                              asp_error *error) {
  int i = number_find(name);
  bool other_surface = i < NUMBERS && strcmp(numbers[i].within, "surface") == 0 &&
                       isnan(aspi_description_get(said, name));
  if (i == NUMBERS || other_surface)
    return ASP_ENAME;
  asp_code code = aspi_keyword_check(aspi_keyword_find(numbers[i].within, name), value, error);
  if (code)
    return code;
  *aspi_description_number(said, name) = value;
  if (!*numbers[i].within)
    aspi_set_given(said, name);
  return ASP_OK;
}

void aspi_description_know(aspi_description *said, const char *name) {
  int kept = 0;
  for (int i = 0; i < said->n_fits; i++)
    if (strcmp(said->fits[i], name) != 0)
      said->fits[kept++] = said->fits[i];
  said->n_fits = kept;
}

bool aspi_is_fit(const aspi_description *said, const char *name) {
  for (int i = 0; i < said->n_fits; i++)
    if (strcmp(said->fits[i], name) == 0)
      return true;
  return false;
}

const char *asp_wall_word(const asp_wall *wall, const char *name) {
  static const char *const kinds[] = {"smooth", "sigma", "rq", "profile", "map"};
  static const char *const deposits[] = {"freeze", "delete", "off"};
  const aspi_description *said = wall->said;
  if (strcmp(name, "tilt") == 0)
    return wall->choice.isotropic ? "isotropic" : "plane";
  if (strcmp(name, "collisions") == 0)
    return wall->choice.multiple ? "multiple" : "single";
  if (!said)
    return NULL;
  return strcmp(name, "surface") == 0   ? kinds[said->kind]
         : strcmp(name, "file") == 0    ? said->file
         : strcmp(name, "deposit") == 0 ? deposits[said->deposit]
         : strcmp(name, "choice") == 0  ? said->choice
         : strcmp(name, "doubt") == 0   ? said->doubt.text
                                        : NULL;
}

bool asp_wall_is_given(const asp_wall *wall, const char *keyword) {
  return wall->said && aspi_is_given(wall->said, keyword);
}

asp_lay asp_wall_lay(const asp_wall *wall) {
  const aspi_description *said = wall->said;
  asp_lay lay = {said ? said->lay : ASP_LAY_NONE, {0, 0, 0}, 0};
  if (lay.kind == ASP_LAY_ANGLE && said->lay_word)
    lay.angle = strcmp(said->lay_word, "axial") == 0 ? 0 : 0.5 * ASP_PI;
  else if (lay.kind == ASP_LAY_ANGLE)
    lay.angle = said->lay_numbers[0] * (ASP_PI / 180);
  if (lay.kind == ASP_LAY_VECTOR) {
    const double *v = said->lay_numbers;
    double per_length = 1 / sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int d = 0; d < 3; d++)
      lay.vector[d] = v[d] * per_length;
  }
  return lay;
}

const asp_surface *asp_wall_surface(const asp_wall *wall) {
  return wall->choice.surface;
}

/* ---- surface ---- */

bool asp_wall_needs_sizes(const asp_wall *wall) {
  const aspi_description *said = wall->said;
  if (said->kind == ASPI_SMOOTH)
    return false;
  return said->kind == ASPI_PROFILE || said->chooses || wall->choice.spread->generate ||
         (said->kind == ASPI_MAP && wall->choice.spread->prepare_map);
}

static asp_code take_surface(asp_wall *wall, asp_surface *made, const asp_error *wrong,
                             asp_error *error) {
  aspi_description *said = wall->said;
  if (!made && said->file)
    return aspi_fail(error, wrong->code, "surface %s %s: %s", asp_wall_word(wall, "surface"),
                     said->file, wrong->text);
  if (!made)
    return aspi_fail(error, wrong->code, "surface: %s", wrong->text);
  asp_surface_free(said->surface);
  said->surface = made;
  asp_wall_set_surface(wall, made);
  return ASP_OK;
}

static asp_code make_from_sigma(asp_wall *wall, asp_error *error) {
  const aspi_description *said = wall->said;
  asp_error wrong = {ASP_OK, ""};
  double metre = said->units.metre > 0 ? said->units.metre : 1, lambda = SIGMA_LAMBDA * metre;
  double slope = tan(said->sigma * (ASP_PI / 180));
  asp_surface *made = asp_surface_create(slope / sqrt(2) * lambda, lambda, &wrong);
  if (made)
    aspi_surface_set_feature(made, 0);
  return take_surface(wall, made, &wrong, error);
}

static asp_code make_from_lengths(asp_wall *wall, asp_error *error) {
  const aspi_description *said = wall->said;
  asp_error wrong = {ASP_OK, ""};
  asp_surface *made =
      said->lay != ASP_LAY_NONE
          ? asp_surface_create_lay(said->r_q, said->lambda_c, said->lambda_along, &wrong)
          : asp_surface_create(said->r_q, said->lambda_c, &wrong);
  return take_surface(wall, made, &wrong, error);
}

static asp_code make_from_map(asp_wall *wall, asp_error *error) {
  const aspi_description *said = wall->said;
  const asp_map *map = wall->choice.map;
  asp_error wrong = {ASP_OK, ""};
  double across = asp_map_get(map, "lambda_1", &wrong),
         along = asp_map_get(map, "lambda_2", &wrong);
  if (said->lay == ASP_LAY_NONE && along > STRETCH_MOST * across)
    return aspi_fail(error, ASP_EARG,
                     "surface map %s: the wall has a lay, lambda_c %.4g across and %.4g along it; "
                     "say which way it lies: 'lay X Y Z', axial, circumferential, or an angle",
                     said->file, across, along);
  return take_surface(wall, asp_surface_create_map(map, said->lay != ASP_LAY_NONE, &wrong), &wrong,
                      error);
}

asp_code aspi_make_surface(asp_wall *wall, asp_error *error) {
  switch (wall->said->kind) {
  case ASPI_SIGMA:
    return make_from_sigma(wall, error);
  case ASPI_GAUSSIAN:
    return make_from_lengths(wall, error);
  case ASPI_MAP:
    return wall->choice.map ? make_from_map(wall, error) : ASP_OK;
  default:
    return ASP_OK;
  }
}

static asp_code make_from_profile(asp_wall *wall, double d_least, double d_most, int bins,
                                  asp_error *error) {
  asp_error wrong = {ASP_OK, ""};
  asp_code code = take_surface(
      wall, asp_surface_create_profile(wall->choice.profile, d_least, d_most, bins, &wrong), &wrong,
      error);
  if (code || asp_surface_phi_r(wall->choice.surface) <= 1)
    return code;
  return aspi_fail(error, ASP_EDATA,
                   "surface profile %s: phi_r = R_q/lambda_c is %g; over 1 is no roughness: are "
                   "the units of positions and heights right (asperity surface --unit)?",
                   wall->said->file, asp_surface_phi_r(wall->choice.surface));
}

/* Reads the file of a measured wall that the caller has not read himself. */
static asp_code read_file(asp_wall *wall, asp_error *error) {
  aspi_description *said = wall->said;
  bool is_profile = said->kind == ASPI_PROFILE && !wall->choice.profile,
       is_map = said->kind == ASPI_MAP && !wall->choice.map;
  if (!is_profile && !is_map)
    return ASP_OK;
  if (!(said->units.metre > 0))
    return aspi_fail(error, ASP_EARG, "a %s is in SI units, which cannot be converted to %s",
                     is_map ? "map" : "profile", said->units.name);
  asp_error wrong = {ASP_OK, ""};
  asp_reader *reader = asp_reader_create(&wrong);
  if (reader && !asp_reader_set(reader, "metre", said->units.metre, &wrong)) {
    if (is_profile)
      said->profile = asp_reader_read(reader, said->file, &wrong);
    else
      said->map = asp_reader_read_map(reader, said->file, &wrong);
  }
  if (reader)
    asp_reader_check(reader, &said->doubt);
  asp_reader_free(reader);
  wall->choice.profile = is_profile ? said->profile : wall->choice.profile;
  wall->choice.map = is_map ? said->map : wall->choice.map;
  if (!said->profile && !said->map)
    return aspi_fail(error, wrong.code, "%s", wrong.text);
  return asp_wall_complete(wall, error);
}

static asp_code choose_model(asp_wall *wall, double d_least, double d_most, asp_error *error) {
  aspi_description *said = wall->said;
  asp_error wrong;
  double divergence;
  const asp_spread_model *model =
      aspi_spread_auto(wall->choice.surface, d_least, d_most, wall->choice.multiple,
                       said->tolerance, &divergence, said->choice, sizeof said->choice, &wrong);
  if (!model)
    return aspi_fail(error, wrong.code, "spread auto: %s", wrong.text);
  wall->choice.spread = model;
  return ASP_OK;
}

asp_code asp_wall_make(asp_wall *wall, double d_least, double d_most, asp_error *error) {
  aspi_description *said = wall->said;
  int bins = aspi_is_given(said, "dp_bins") ? (int)said->bins
             : said->kind == ASPI_MAP       ? MAP_BINS
                                            : PROFILE_BINS;
  asp_code code = read_file(wall, error);
  if (!code && said->kind == ASPI_PROFILE)
    code = make_from_profile(wall, d_least, d_most, bins, error);
  if (!code && said->chooses && said->kind != ASPI_SMOOTH)
    code = choose_model(wall, d_least, d_most, error);
  if (code)
    return code;
  if (asp_wall_needs_sizes(wall)) {
    wall->choice.numbers[ASP_WALL_D_P_LEAST] = d_least;
    wall->choice.numbers[ASP_WALL_D_P_MOST] = d_most;
  }
  wall->choice.numbers[ASP_WALL_D_P_BINS] = bins;
  return asp_wall_prepare(wall, error);
}

asp_code asp_wall_check_sampling(const asp_wall *wall, double d_p, asp_error *error) {
  const asp_profile *profile = wall->choice.profile;
  const asp_map *map = wall->choice.map;
  asp_error doubt = {ASP_OK, ""};
  if (profile) {
    double spacing = asp_profile_spacing(profile);
    aspi_sampling_check(d_p, spacing, (double)asp_profile_points(profile) * spacing,
                        asp_surface_lambda_c(wall->choice.surface), &doubt);
  } else if (map) {
    double x = asp_map_step_x(map), y = asp_map_step_y(map);
    aspi_sampling_check(d_p, fmax(x, y),
                        fmin((double)asp_map_columns(map) * x, (double)asp_map_rows(map) * y),
                        asp_map_get(map, "lambda_2", NULL), &doubt);
  }
  return doubt.code
             ? aspi_fail(error, doubt.code, "surface %s %s: %s", asp_wall_word(wall, "surface"),
                         asp_wall_word(wall, "file"), doubt.text)
             : ASP_OK;
}
