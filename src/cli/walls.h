/* The options that describe a wall and its particles, shared by the commands that make impacts. */
#ifndef ASP_CLI_WALLS_H
#define ASP_CLI_WALLS_H

#include "cli/cli.h"

/* Reads `plane` or `isotropic`, `single` or `multiple`, `on` or `off`. */
const char *cli_tilt(const cli_option *option);
bool cli_is_multiple(const cli_option *option);
bool cli_switch(const cli_option *option);

/* The surface of --rq and --lambda-c. */
asp_surface *cli_surface_of(const cli_option *rq, const cli_option *lambda_c);

/* Exits when the surface's size law does not reach to the diameter. */
void cli_check_size(const asp_surface *surface, double d_p);

#endif
