/* A wall: surface, spread model and rebound law looked up once and checked, so that a contact reads
 * numbers and follows pointers only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "wall/description.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const asp_parameter numbers[ASP_WALL_NUMBERS] = {
    [ASP_WALL_DEPOSIT] = {.name = "deposit", .fallback = 1, .most = 1},
    [ASP_WALL_SCATTER_TWICE] = {.name = "scatter_twice", .most = 1},
    [ASP_WALL_REMOVE_U_TAU] = {.name = "remove_u_tau", .most = INFINITY},
    [ASP_WALL_REMOVE_GAS_DENSITY] = {.name = "remove_gas_density", .most = INFINITY},
    [ASP_WALL_REMOVE_MEAN_FREE_PATH] = {.name = "remove_mean_free_path", .most = INFINITY},
    [ASP_WALL_REMOVE_WORK] = {.name = "remove_work",
                              .fallback = ASPI_REMOVAL_WORK,
                              .most = INFINITY},
    [ASP_WALL_D_P_LEAST] = {.name = "d_p_least", .most = INFINITY},
    [ASP_WALL_D_P_MOST] = {.name = "d_p_most", .most = INFINITY},
    [ASP_WALL_D_P_BINS] = {.name = "d_p_bins", .fallback = 1, .least = 1, .most = ASP_BINS_MAX},
};

static void choose_law(aspi_wall_choice *choice, const asp_rebound_law *law) {
  choice->law = law;
  for (int i = 0; i < law->n_parameters; i++)
    choice->parameters[i] = law->parameters[i].fallback;
}

asp_wall *asp_wall_create(asp_error *error) {
  asp_wall *wall = calloc(1, sizeof *wall);
  if (!wall) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for a wall");
    return NULL;
  }
  wall->choice.spread = asp_spread_find("none", NULL);
  choose_law(&wall->choice, asp_rebound_find("bons", NULL));
  for (int i = 0; i < ASP_WALL_NUMBERS; i++)
    wall->choice.numbers[i] = numbers[i].fallback;
  asp_wall_prepare(wall, NULL); /* of this choice, nothing can be wrong */
  return wall;
}

static void release(asp_wall *wall) {
  if (wall->data)
    wall->spread->release(wall->data);
  wall->data = NULL;
}

void asp_wall_free(asp_wall *wall) {
  if (wall) {
    release(wall);
    aspi_description_free(wall->said);
  }
  free(wall);
}

/* *second is whether the word is the second of the two. */
static asp_code choose_one(const char *name, const char *word, const char *first,
                           const char *second, bool *is_second, asp_error *error) {
  bool one = word && strcmp(word, first) == 0, other = word && strcmp(word, second) == 0;
  if (!one && !other)
    return aspi_fail(error, ASP_EARG, "%s is '%s'; it must be %s or %s", name, word ? word : "",
                     first, second);
  *is_second = other;
  return ASP_OK;
}

asp_code asp_wall_choose(asp_wall *wall, const char *name, const char *word, asp_error *error) {
  aspi_wall_choice *choice = &wall->choice;
  if (strcmp(name, "tilt") == 0)
    return choose_one(name, word, "plane", "isotropic", &choice->isotropic, error);
  if (strcmp(name, "collisions") == 0)
    return choose_one(name, word, "single", "multiple", &choice->multiple, error);
  if (strcmp(name, "spread") == 0) {
    const asp_spread_model *model = asp_spread_find(word, error);
    choice->spread = model ? model : choice->spread;
    return model ? ASP_OK : ASP_ENAME;
  }
  if (strcmp(name, "rebound") == 0) {
    const asp_rebound_law *law = asp_rebound_find(word, error);
    if (law)
      choose_law(choice, law);
    return law ? ASP_OK : ASP_ENAME;
  }
  return aspi_fail(error, ASP_ENAME,
                   "choice '%s' is unknown to a wall; there are: spread rebound tilt collisions",
                   name);
}

/* A number that a wall has, and what may be set there. */
typedef struct place {
  double *value;
  const asp_parameter *of;
} place;

/* NULLs where there is none of that name. */
static place find(aspi_wall_choice *choice, const char *name) {
  for (int i = 0; i < choice->law->n_parameters; i++)
    if (strcmp(choice->law->parameters[i].name, name) == 0)
      return (place){&choice->parameters[i], &choice->law->parameters[i]};
  for (int i = 0; i < ASP_WALL_NUMBERS; i++)
    if (strcmp(numbers[i].name, name) == 0)
      return (place){&choice->numbers[i], &numbers[i]};
  return (place){NULL, NULL};
}

/* Those of the law, and of any wall. */
static asp_code fail_name(const aspi_wall_choice *choice, const char *name, asp_error *error) {
  char list[420] = "", what[100];
  for (int i = 0; i < choice->law->n_parameters + ASP_WALL_NUMBERS; i++) {
    int own = i - choice->law->n_parameters;
    size_t used = strlen(list);
    snprintf(list + used, sizeof list - used, "%s%s", used ? " " : "",
             own < 0 ? choice->law->parameters[i].name : numbers[own].name);
  }
  snprintf(what, sizeof what, "of a wall with rebound law '%s', number", choice->law->name);
  return aspi_fail_unknown(error, what, name, list);
}

asp_code asp_wall_set(asp_wall *wall, const char *name, double value, asp_error *error) {
  place at = find(&wall->choice, name);
  if (!at.of) {
    asp_code code = wall->said ? aspi_description_set(wall->said, name, value, error) : ASP_ENAME;
    if (!code)
      aspi_description_know(wall->said, name);
    return code == ASP_ENAME ? fail_name(&wall->choice, name, error) : code;
  }
  bool whole = at.of >= numbers && at.of < numbers + ASP_WALL_NUMBERS && isfinite(at.of->most);
  const char *unit = at.of->unit ? at.of->unit : "";
  asp_code code = aspi_check_range(error, name, unit, value, at.of->least, at.of->most);
  if (!code && whole && (value > floor(value)))
    code = aspi_fail(error, ASP_EARG, "%s is %g; it must be a whole number", name, value);
  if (code)
    return code;
  *at.value = value;
  if (wall->said)
    aspi_description_know(wall->said, name);
  return ASP_OK;
}

double asp_wall_get(const asp_wall *wall, const char *name) {
  aspi_wall_choice choice = wall->choice;
  place at = find(&choice, name);
  if (strcmp(name, "erosion_density") == 0)
    return choice.erosion.density;
  return at.of ? *at.value : wall->said ? aspi_description_get(wall->said, name) : NAN;
}

void asp_wall_set_surface(asp_wall *wall, const asp_surface *surface) {
  wall->choice.surface = surface;
}

void asp_wall_set_map(asp_wall *wall, const asp_map *map) {
  wall->choice.map = map;
}

void asp_wall_set_profile(asp_wall *wall, const asp_profile *profile) {
  wall->choice.profile = profile;
}

const asp_spread_model *asp_wall_spread(const asp_wall *wall) {
  return wall->choice.spread;
}

const asp_rebound_law *asp_wall_rebound(const asp_wall *wall) {
  return wall->choice.law;
}

static bool is_rough(const aspi_wall_choice *choice) {
  return choice->surface && strcmp(choice->spread->name, "none") != 0;
}

static asp_code check(const aspi_wall_choice *choice, asp_error *error) {
  const asp_rebound_law *law = choice->law;
  if (law->needs_table && !choice->table)
    return aspi_fail(error, ASP_EARG, "rebound law '%s' needs a table of coefficients", law->name);
  const double *numbers_of = choice->numbers;
  if (numbers_of[ASP_WALL_REMOVE_U_TAU] > 0 && !(numbers_of[ASP_WALL_REMOVE_GAS_DENSITY] > 0))
    return aspi_fail(error, ASP_EARG,
                     "remove_u_tau is %g without a gas; remove_gas_density must be more than 0",
                     numbers_of[ASP_WALL_REMOVE_U_TAU]);
  bool scatters = law->scatters && law->scatters(choice->parameters);
  if (is_rough(choice) && scatters && !(choice->numbers[ASP_WALL_SCATTER_TWICE] > 0))
    return aspi_fail(error, ASP_EARG,
                     "rebound law '%s' draws a measured scatter, which holds the roughness of the "
                     "measured wall already; on a rough wall it would count twice. Take its means, "
                     "or a smooth wall, or ask for both (scatter_twice)",
                     law->name);
  return ASP_OK;
}

/* Creates the model's data from the profile, or from one that the model generates. */
static asp_code make_data(const aspi_wall_choice *choice, void **data, asp_error *error) {
  const asp_spread_model *model = choice->spread;
  *data = NULL;
  bool from_map = choice->map && model->prepare_map;
  bool from_profile = !from_map && choice->profile && model->prepare;
  if (!choice->surface || !(from_map || from_profile || (!choice->profile && model->generate)))
    return ASP_OK;
  const double *n = choice->numbers;
  bool one = n[ASP_WALL_D_P_LEAST] >= n[ASP_WALL_D_P_MOST];
  aspi_sizes sizes = {n[ASP_WALL_D_P_LEAST], n[ASP_WALL_D_P_MOST],
                      one ? 1 : (int)n[ASP_WALL_D_P_BINS]};
  asp_error wrong = {ASP_OK, ""};
  *data = from_map       ? model->prepare_map(choice->map, &sizes, &wrong)
          : from_profile ? model->prepare(choice->profile, &sizes, &wrong)
                         : model->generate(choice->surface, &sizes, &wrong);
  return *data ? ASP_OK : aspi_fail(error, wrong.code, "%s", wrong.text);
}

static void take_law(asp_wall *wall) {
  const aspi_wall_choice *choice = &wall->choice;
  wall->law = choice->law;
  memcpy(wall->parameters, choice->parameters, sizeof wall->parameters);
  wall->table = choice->table;
  wall->deposit = choice->numbers[ASP_WALL_DEPOSIT] > 0;
  wall->spins = choice->law->spins && choice->law->spins(choice->parameters);
  wall->flow = (aspi_flow){
      choice->numbers[ASP_WALL_REMOVE_U_TAU], choice->numbers[ASP_WALL_REMOVE_GAS_DENSITY],
      choice->numbers[ASP_WALL_REMOVE_MEAN_FREE_PATH], choice->numbers[ASP_WALL_REMOVE_WORK]};
  wall->erosion = choice->erosion;
}

asp_code aspi_wall_renew(asp_wall *wall, asp_error *error) {
  asp_code code = check(&wall->choice, error);
  if (!code)
    take_law(wall);
  return code;
}

asp_code asp_wall_prepare(asp_wall *wall, asp_error *error) {
  const aspi_wall_choice *choice = &wall->choice;
  void *data;
  asp_code code = check(choice, error);
  if (!code)
    code = make_data(choice, &data, error);
  if (code)
    return code;
  release(wall);
  wall->surface = choice->surface;
  wall->spread = choice->spread;
  wall->upward = asp_spread_find("visible", NULL);
  wall->data = data;
  wall->rough = is_rough(choice);
  wall->follow = data ? choice->spread->follow : NULL;
  wall->draws_q = data && choice->map && choice->spread->prepare_map;
  wall->isotropic = choice->isotropic || wall->draws_q;
  wall->multiple = choice->multiple || choice->spread->escape || wall->draws_q ||
                   (choice->spread->follow && !choice->spread->quantile);
  take_law(wall);
  return ASP_OK;
}
