/* A wall: surface, spread model and rebound law looked up once and checked, so that a contact reads
 * numbers and follows pointers only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/wall.h"
#include "base/error.h"
#include "surface/heights.h"
#include "surface/size_law.h"

#include <stdlib.h>
#include <string.h>

void aspi_wall_choose_law(aspi_wall_choice *choice, const asp_rebound_law *law) {
  choice->law = law;
  for (int i = 0; i < law->n_parameters; i++)
    choice->parameters[i] = law->parameters[i].default_value;
}

aspi_wall_choice aspi_wall_choice_smooth(void) {
  aspi_wall_choice choice = {
      .spread = asp_spread_find("none", NULL), .sizes = {0, 0, 1}, .deposit = true};
  aspi_wall_choose_law(&choice, asp_rebound_find("bons", NULL));
  return choice;
}

static bool is_rough(const aspi_wall_choice *choice) {
  return choice->surface && strcmp(choice->spread->name, "none") != 0;
}

static asp_code check(const aspi_wall_choice *choice, asp_error *error) {
  const asp_rebound_law *law = choice->law;
  bool scatters = law->scatters && law->scatters(choice->parameters);
  if (is_rough(choice) && scatters)
    return aspi_fail(error, ASP_EARG,
                     "rebound law '%s' draws a measured scatter, which holds the roughness of the "
                     "measured wall already; on a rough wall it would count twice. Take its means, "
                     "or a smooth wall",
                     law->name);
  return ASP_OK;
}

static asp_code make_data(asp_wall *wall, const aspi_wall_choice *choice, asp_error *error) {
  if (!choice->surface || !choice->spread->prepare)
    return ASP_OK;
  const aspi_height_field of = {choice->surface, choice->heights, choice->isotropic};
  aspi_sizes sizes = choice->sizes;
  sizes.bins = sizes.least >= sizes.most ? 1 : sizes.bins;
  asp_error wrong = {.code = ASP_OK};
  wall->data = choice->spread->prepare(&of, &sizes, &wrong);
  if (wall->data && choice->heights && choice->spread->field)
    wall->valleys = aspi_valleys_create(choice->spread, wall->data, &of, &sizes, &wrong);
  return wall->data && !wrong.code ? ASP_OK : aspi_fail(error, wrong.code, "%s", wrong.text);
}

void aspi_wall_take_law(asp_wall *wall, const aspi_wall_choice *choice) {
  wall->law = choice->law;
  memcpy(wall->parameters, choice->parameters, sizeof wall->parameters);
  wall->deposit = choice->deposit;
  wall->spins = choice->law->spins && choice->law->spins(choice->parameters);
  wall->flow = choice->flow;
  wall->erosion = choice->erosion;
  wall->lever = choice->lever;
  wall->scatter = choice->scatter;
  if (wall->heat)
    *wall->heat = choice->heat;
  wall->varies = (choice->law->needs_pair && (choice->scatter > 0 || choice->flow.adhesion > 0)) ||
                 aspi_heat_counts(&choice->heat);
}

static void release(asp_wall *wall) {
  if (wall->data)
    wall->spread->release(wall->data);
  aspi_valleys_free(wall->valleys);
  asp_surface_free(wall->surface);
  aspi_cor_table_free(wall->table);
  asp_pair_free(wall->pair);
  free(wall->heat);
}

void asp_wall_free(asp_wall *wall) {
  if (wall)
    release(wall);
  free(wall);
}

/* Copies of what the choice points to. */
static asp_code copy_parts(asp_wall *wall, const aspi_wall_choice *choice, asp_error *error) {
  wall->surface = choice->surface ? aspi_surface_copy(choice->surface) : NULL;
  wall->table = choice->table ? aspi_cor_table_copy(choice->table) : NULL;
  wall->heat = malloc(sizeof *wall->heat);
  wall->pair = choice->pair ? malloc(sizeof *wall->pair) : NULL;
  if (wall->pair)
    *wall->pair = *choice->pair;
  if ((choice->surface && !wall->surface) || (choice->table && !wall->table) ||
      (choice->pair && !wall->pair) || !wall->heat)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a wall");
  return ASP_OK;
}

static asp_code make(asp_wall *wall, const aspi_wall_choice *choice, asp_error *error) {
  const asp_spread_model *spread = choice->spread;
  wall->spread = spread;
  wall->rising = asp_spread_find("visible", NULL);
  asp_code code = check(choice, error);
  if (!code)
    code = copy_parts(wall, choice, error);
  if (!code)
    code = make_data(wall, choice, error);
  wall->rough = is_rough(choice);
  wall->follow = wall->data ? spread->follow : NULL;
  wall->has_cross_slope = wall->data && choice->heights && choice->heights->rows > 1;
  wall->isotropic = choice->isotropic || wall->has_cross_slope;
  wall->has_lay = choice->has_lay;
  memcpy(wall->lay, choice->lay, sizeof wall->lay);
  wall->seed = choice->seed;
  wall->multiple = choice->multiple || spread->follow;
  aspi_wall_take_law(wall, choice);
  return code;
}

asp_wall *aspi_wall_create(const aspi_wall_choice *choice, asp_error *error) {
  asp_wall *wall = calloc(1, sizeof *wall);
  if (!wall)
    aspi_fail(error, ASP_ENOMEM, "out of memory for a wall");
  if (!wall || !make(wall, choice, error))
    return wall;
  asp_wall_free(wall);
  return NULL;
}

void aspi_wall_replace(asp_wall *wall, asp_wall *by) {
  release(wall);
  *wall = *by;
  free(by);
}

uint32_t asp_wall_seed(const asp_wall *wall) {
  return wall->seed;
}

const asp_surface *asp_wall_surface(const asp_wall *wall) {
  return wall->surface;
}

const asp_spread_model *asp_wall_spread(const asp_wall *wall) {
  return wall->spread;
}

const asp_pair *asp_wall_pair(const asp_wall *wall) {
  return wall->pair;
}

asp_code asp_wall_sticking(const asp_wall *wall, double temperature, double *share,
                           asp_error *error) {
  const double kelvin = aspi_heat_of(wall->heat, temperature);
  asp_code code =
      aspi_heat_counts(wall->heat) ? aspi_heat_check(wall->heat, kelvin, error) : ASP_OK;
  if (share)
    *share = code ? 0 : aspi_heat_share(wall->heat, kelvin);
  return code;
}
