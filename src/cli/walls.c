/* Options that describe a wall; see walls.h. */
#include "cli/walls.h"

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

asp_surface *cli_surface_of(const cli_option *rq, const cli_option *lambda_c) {
  asp_error error;
  asp_surface *surface = asp_surface_create(cli_length(rq), cli_length(lambda_c), &error);
  if (!surface)
    cli_bad_usage("%s", error.text);
  return surface;
}

void cli_check_size(const asp_surface *surface, double d_p) {
  asp_error error;
  if (asp_surface_check(surface, d_p, &error))
    cli_bad_usage("--dp: %s", error.text);
}
