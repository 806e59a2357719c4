/* Options that describe a wall; see walls.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/walls.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

cli_lay cli_lay_of(const cli_option *lambda_c, const cli_option *lay) {
  cli_list lengths = cli_lengths(lambda_c);
  if (lengths.count > 2)
    cli_bad_usage("--%s is '%s'; it must be one length, or two, across the lay and along it",
                  lambda_c->name, lambda_c->value);
  if (lay->value && lengths.count < 2)
    cli_bad_usage("--lay is '%s'; it needs two --lambda-c, across the lay and along it",
                  lay->value);
  double degrees = lay->value ? cli_number(lay, -360, 360) : 90;
  cli_lay made = {.direction = cli_radians(degrees)};
  for (size_t i = 0; i < 2; i++)
    made.lambda[i] = lengths.values[i < lengths.count ? i : 0];
  made.vector[0] = cos(made.direction);
  made.vector[1] = sin(made.direction);
  double ratio = made.lambda[0] / made.lambda[1];
  made.part = 1 + (ratio * ratio - 1) * made.vector[0] * made.vector[0];
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

static void read_numbers(const cli_rough_options *o, cli_rough *rough, double d_most) {
  asp_error error;
  if (o->sigma->value) {
    double slope = tan(cli_radians(cli_number(o->sigma, 0.001, SIGMA_MOST)));
    rough->lay = (cli_lay){.lambda = {SIGMA_LAMBDA, SIGMA_LAMBDA}, .vector = {1, 0, 0}, .part = 1};
    rough->surface = asp_surface_create(slope / sqrt(2) * SIGMA_LAMBDA, SIGMA_LAMBDA, &error);
    if (!rough->surface)
      cli_bad_usage("--sigma: %s", error.text);
    return;
  }
  rough->lay = cli_lay_of(o->lambda_c, o->lay);
  rough->surface = cli_surface_of(o->rq, &rough->lay);
  cli_check_size(rough->surface, d_most);
}

static void read_measured(const cli_rough_options *o, cli_rough *rough, double d_least,
                          double d_most) {
  asp_error error;
  asp_reader *reader = asp_reader_create(&error);
  const cli_option *file = o->profile->value ? o->profile : o->map;
  if (reader && o->profile->value)
    rough->profile = asp_reader_read(reader, file->value, &error);
  else if (reader)
    rough->map = asp_reader_read_map(reader, file->value, &error);
  asp_reader_free(reader);
  if (!rough->profile && !rough->map)
    cli_bad_file(file, &error);
  rough->surface = rough->profile
                       ? asp_surface_create_profile(rough->profile, d_least, d_most,
                                                    d_most > d_least ? CLI_ROUGH_BINS : 1, &error)
                       : asp_surface_create_map(rough->map, false, &error);
  if (!rough->surface)
    cli_bad_usage("--%s %s: %s", file->name, file->value, error.text);
}

cli_rough cli_rough_read(const cli_rough_options *o, double d_least, double d_most) {
  bool numbers = o->rq->value || o->lambda_c->value;
  int ways =
      (o->sigma->value != NULL) + numbers + (o->profile->value != NULL) + (o->map->value != NULL);
  if (ways == 0)
    cli_bad_usage("--rq LENGTH is missing, and --lambda-c; a wall is that, or --sigma, --profile "
                  "or --map");
  if (ways > 1 || (!numbers && o->lay->value))
    cli_bad_usage("a wall is given by one of --sigma, --rq with --lambda-c (and --lay), --profile, "
                  "--map; not by two");
  cli_rough rough = {NULL, NULL, NULL, {{0, 0}, 0, {1, 0, 0}, 1}};
  if (o->profile->value || o->map->value)
    read_measured(o, &rough, d_least, d_most);
  else
    read_numbers(o, &rough, d_most);
  return rough;
}

void cli_rough_free(cli_rough *rough) {
  asp_surface_free(rough->surface);
  asp_profile_free(rough->profile);
  asp_map_free(rough->map);
}
