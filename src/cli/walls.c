/* Options that describe a wall; see walls.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/walls.h"

#include <math.h>
#include <stdlib.h>

/* Diameters for which a measured wall is prepared, where there is more than one. */
enum { CLI_ROUGH_BINS = 16 };

const char *cli_tilt(const cli_option *option) {
  cli_choice(option, "plane", "isotropic");
  return option->value;
}

bool cli_is_multiple(const cli_option *option) {
  return cli_choice(option, "single", "multiple");
}

bool cli_switch(const cli_option *option) {
  return cli_choice(option, "off", "on");
}

/* In degrees from the flight. */
static void turn_lay(cli_lay *lay, double degrees) {
  lay->direction = cli_radians(degrees);
  lay->vector[0] = cos(lay->direction);
  lay->vector[1] = sin(lay->direction);
  double ratio = lay->lambda[0] / lay->lambda[1];
  lay->part = 1 + (ratio * ratio - 1) * lay->vector[0] * lay->vector[0];
}

static double lay_degrees(const cli_option *lay) {
  return lay->value ? cli_number(lay, -360, 360) : 90;
}

cli_lay cli_lay_of(const cli_option *lambda_c, const cli_option *lay) {
  cli_list lengths = cli_lengths(lambda_c);
  if (lengths.count > 2)
    cli_bad_usage("--%s is '%s'; it must be one length, or two, across the lay and along it",
                  lambda_c->name, lambda_c->value);
  if (lay->value && lengths.count < 2)
    cli_bad_usage("--lay is '%s'; it needs two --lambda-c, across the lay and along it",
                  lay->value);
  cli_lay made = {.vector = {0, 0, 0}};
  for (size_t i = 0; i < 2; i++)
    made.lambda[i] = lengths.values[i < lengths.count ? i : 0];
  turn_lay(&made, lay_degrees(lay));
  free(lengths.values);
  return made;
}

asp_surface *cli_surface_of(const cli_option *rq, const cli_lay *lay) {
  asp_error error;
  asp_surface *surface =
      asp_surface_create_lay(cli_length(rq), lay->lambda[0], lay->lambda[1], &error);
  if (!surface)
    cli_bad_usage("%s", error.text);
  return surface;
}

void cli_check_size(const asp_surface *surface, double d_p) {
  asp_error error;
  if (asp_surface_check(surface, d_p, &error))
    cli_bad_usage("--dp: %s", error.text);
}

/* With sigma alone the correlation length is beyond all particles, so that none is too large. */
enum { SIGMA_MOST = 54 };
#define SIGMA_LAMBDA 1e6
#define ANY_SIZE 1e-5

static void read_numbers(const cli_option *o, cli_rough *rough, double d_most) {
  asp_error error;
  if (o[ROUGH_SIGMA].value) {
    double slope = tan(cli_radians(cli_number(&o[ROUGH_SIGMA], 0.001, SIGMA_MOST)));
    rough->lay = (cli_lay){.lambda = {SIGMA_LAMBDA, SIGMA_LAMBDA}, .vector = {1, 0, 0}, .part = 1};
    rough->surface = asp_surface_create(slope / sqrt(2) * SIGMA_LAMBDA, SIGMA_LAMBDA, &error);
    if (!rough->surface)
      cli_bad_usage("--sigma: %s", error.text);
    return;
  }
  rough->lay = cli_lay_of(&o[ROUGH_LAMBDA_C], &o[ROUGH_LAY]);
  rough->surface = cli_surface_of(&o[ROUGH_RQ], &rough->lay);
  cli_check_size(rough->surface, d_most);
}

static asp_code check_sampling(const cli_rough *rough, double d_p, asp_error *doubt) {
  const asp_profile *profile = rough->profile;
  const asp_map *map = rough->map;
  if (profile)
    return asp_sampling_check(d_p, asp_profile_spacing(profile),
                              (double)asp_profile_points(profile) * asp_profile_spacing(profile),
                              asp_surface_lambda_c(rough->surface), doubt);
  double step[2] = {asp_map_step_x(map), asp_map_step_y(map)};
  return asp_sampling_check(
      d_p, fmax(step[0], step[1]),
      fmin((double)asp_map_columns(map) * step[0], (double)asp_map_rows(map) * step[1]),
      asp_map_get(map, "lambda_2", NULL), doubt);
}

static void read_measured(const cli_option *o, cli_rough *rough, double d_least, double d_most) {
  asp_error error;
  asp_reader *reader = asp_reader_create(&error);
  const cli_option *file = o[ROUGH_PROFILE].value ? &o[ROUGH_PROFILE] : &o[ROUGH_MAP];
  if (reader && o[ROUGH_PROFILE].value)
    rough->profile = asp_reader_read(reader, file->value, &error);
  else if (reader)
    rough->map = asp_reader_read_map(reader, file->value, &error);
  if (!rough->profile && !rough->map)
    cli_bad_file(file, &error);
  if (asp_reader_check(reader, &error))
    cli_warn("--%s %s: %s", file->name, file->value, error.text);
  asp_reader_free(reader);
  rough->surface =
      rough->profile
          ? asp_surface_create_profile(rough->profile, d_least, d_most, CLI_ROUGH_BINS, &error)
          : asp_surface_create_map(rough->map, o[ROUGH_LAY].value != NULL, &error);
  if (!rough->surface)
    cli_bad_usage("--%s %s: %s", file->name, file->value, error.text);
  rough->lay.lambda[0] = asp_surface_lambda_c(rough->surface);
  rough->lay.lambda[1] = asp_surface_lambda_along(rough->surface);
  if (check_sampling(rough, d_least, &error))
    cli_warn("--%s %s: %s", file->name, file->value, error.text);
  turn_lay(&rough->lay, lay_degrees(&o[ROUGH_LAY]));
}

bool cli_rough_measured(const cli_option *o) {
  return o[ROUGH_PROFILE].value || o[ROUGH_MAP].value;
}

bool cli_rough_given(const cli_option *o) {
  return o[ROUGH_SIGMA].value || o[ROUGH_RQ].value || o[ROUGH_LAMBDA_C].value ||
         cli_rough_measured(o);
}

const char *cli_rough_model(const cli_option *o, const cli_option *model) {
  if (model->value)
    return model->value;
  return cli_rough_measured(o) ? "profile" : "visible";
}

void cli_rough_choose(asp_wall *wall, const cli_option *tilt, const cli_option *collisions,
                      const char *model) {
  asp_error error;
  asp_wall_choose(wall, "tilt", cli_tilt(tilt), NULL);
  asp_wall_choose(wall, "collisions", cli_is_multiple(collisions) ? "multiple" : "single", NULL);
  if (asp_wall_choose(wall, "spread", model, &error))
    cli_bad_usage("%s", error.text);
}

double cli_rough_size(const cli_option *o, const cli_option *dp) {
  bool any = o[ROUGH_SIGMA].value || !cli_rough_given(o); /* which is told when it is read */
  return any && !dp->value ? ANY_SIZE : cli_length(dp);
}

void cli_rough_check(const cli_option *o) {
  bool numbers = o[ROUGH_RQ].value || o[ROUGH_LAMBDA_C].value;
  int ways = (o[ROUGH_SIGMA].value != NULL) + numbers + (o[ROUGH_PROFILE].value != NULL) +
             (o[ROUGH_MAP].value != NULL);
  if (ways > 1 || (o[ROUGH_LAY].value && !numbers && !o[ROUGH_MAP].value))
    cli_bad_usage("a wall is given by one of --sigma, --rq with --lambda-c (and --lay), --profile, "
                  "--map (and --lay); not by two");
}

cli_rough cli_rough_read(const cli_option *o, double d_least, double d_most) {
  cli_rough_check(o);
  if (!cli_rough_given(o))
    cli_bad_usage("--rq LENGTH is missing, and --lambda-c; a wall is that, or --sigma, --profile "
                  "or --map");
  cli_rough rough = {.lay = {{0, 0}, 0, {1, 0, 0}, 1}};
  if (cli_rough_measured(o))
    read_measured(o, &rough, d_least, d_most);
  else
    read_numbers(o, &rough, d_most);
  return rough;
}

void cli_rough_put(const cli_rough *rough, asp_wall *wall, double d_least, double d_most) {
  asp_wall_set_surface(wall, rough->surface);
  asp_wall_set_profile(wall, rough->profile);
  asp_wall_set_map(wall, rough->map);
  asp_wall_set(wall, "d_p_least", d_least, NULL);
  asp_wall_set(wall, "d_p_most", d_most, NULL);
  asp_wall_set(wall, "d_p_bins", CLI_ROUGH_BINS, NULL);
}

void cli_rough_free(cli_rough *rough) {
  asp_surface_free(rough->surface);
  asp_profile_free(rough->profile);
  asp_map_free(rough->map);
}
