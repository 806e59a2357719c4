/* Options that describe a wall; see walls.h. */
#include "cli/walls.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
