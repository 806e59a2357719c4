/* A wall: surface, spread model and rebound law looked up once and checked, so that a contact reads
 * numbers and follows pointers only. */
#include "base/error.h"
#include "impact/wall.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The profile that stands for a wall given by r_q and lambda_c: 1024 lambda_c long, and so fine
 * that a disc of many lambda_c does not feel the points. */
#define ASP_WALL_RESOLUTION 128
#define ASP_WALL_POINTS 131072
#define ASP_WALL_SEED 1

asp_wall_spec asp_wall_spec_default(void) {
  asp_wall_spec spec = {.spread = "none", .deposit = true};
  asp_wall_spec_rebound(&spec, "bons", NULL);
  return spec;
}

asp_code asp_wall_spec_rebound(asp_wall_spec *spec, const char *name, asp_error *error) {
  const asp_rebound_law *law = asp_rebound_find(name, error);
  if (!law)
    return ASP_ENAME;
  spec->rebound = law->name;
  for (int i = 0; i < law->n_parameters; i++)
    spec->parameters[i] = law->parameters[i].fallback;
  return ASP_OK;
}

static asp_code check_parameter(const asp_parameter *parameter, double value, asp_error *error) {
  return asp_check_range(error, parameter->name, parameter->unit, value, parameter->least,
                         parameter->most);
}

asp_code asp_wall_spec_set(asp_wall_spec *spec, const char *parameter, double value,
                           asp_error *error) {
  const asp_rebound_law *law = asp_rebound_find(spec->rebound, error);
  if (!law)
    return ASP_ENAME;
  int index = asp_rebound_parameter(law, parameter, error);
  if (index < 0)
    return ASP_ENAME;
  asp_code code = check_parameter(&law->parameters[index], value, error);
  if (code == ASP_OK)
    spec->parameters[index] = value;
  return code;
}

static asp_code check(const asp_wall_spec *spec, const asp_rebound_law *law, asp_error *error) {
  asp_code code = ASP_OK;
  for (int i = 0; i < law->n_parameters && code == ASP_OK; i++)
    code = check_parameter(&law->parameters[i], spec->parameters[i], error);
  if (code)
    return code;
  if (law->needs_table && !spec->table)
    return asp_fail(error, ASP_EARG, "rebound law '%s' needs a table of coefficients", law->name);
  bool rough = spec->surface && strcmp(spec->spread, "none") != 0;
  if (rough && law->scatters && law->scatters(spec->parameters) && !spec->scatter_twice)
    return asp_fail(error, ASP_EARG,
                    "rebound law '%s' draws a measured scatter, which holds the roughness of the "
                    "measured wall already; on a rough wall it would count twice. Take its means, "
                    "or a smooth wall, or ask for both (scatter_twice)",
                    law->name);
  return ASP_OK;
}

/* A profile of the surface's two numbers, for models that need one where the spec has none. */
static asp_profile *generate(const asp_surface *surface, asp_error *error) {
  double lambda_c = asp_surface_lambda_c(surface);
  return asp_profile_create(asp_surface_r_q(surface), lambda_c, lambda_c / ASP_WALL_RESOLUTION,
                            ASP_WALL_POINTS, ASP_WALL_SEED, error);
}

/* What the model keeps of the profile. */
static asp_code prepare(const asp_wall_spec *spec, const asp_spread_model *model, void **data,
                        asp_error *error) {
  *data = NULL;
  if (!model->prepare || !spec->surface)
    return ASP_OK;
  asp_profile *own = spec->profile ? NULL : generate(spec->surface, error);
  const asp_profile *profile = spec->profile ? spec->profile : own;
  if (profile)
    *data = model->prepare(profile, &spec->sizes, error);
  asp_profile_free(own);
  return *data ? ASP_OK : ASP_EARG;
}

asp_wall *asp_wall_create(const asp_wall_spec *spec, asp_error *error) {
  const asp_spread_model *spread = asp_spread_find(spec->spread, error);
  const asp_rebound_law *law = spread ? asp_rebound_find(spec->rebound, error) : NULL;
  void *data;
  if (!law || check(spec, law, error) || prepare(spec, spread, &data, error))
    return NULL;
  asp_wall *wall = malloc(sizeof *wall);
  if (!wall) {
    if (data)
      spread->release(data);
    asp_fail(error, ASP_ENOMEM, "out of memory for a wall");
    return NULL;
  }
  *wall = (asp_wall){.surface = spec->surface,
                     .spread = spread,
                     .upward = asp_spread_find("visible", NULL),
                     .data = data,
                     .law = law,
                     .table = spec->table,
                     .rough = spec->surface && spread != asp_spread_find("none", NULL),
                     .isotropic = spec->tilt == ASP_TILT_ISOTROPIC,
                     .multiple = spec->collisions != ASP_COLLISIONS_SINGLE || spread->escape ||
                                 spread->follow,
                     .forgets = spec->collisions == ASP_COLLISIONS_SMITH,
                     .deposit = spec->deposit};
  for (int i = 0; i < ASP_PARAMETERS_MAX; i++)
    wall->parameters[i] = spec->parameters[i];
  return wall;
}

void asp_wall_free(asp_wall *wall) {
  if (wall && wall->data)
    wall->spread->release(wall->data);
  free(wall);
}

const void *asp_wall_data(const asp_wall *wall) {
  return wall->data;
}
