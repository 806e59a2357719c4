/* The options that describe a wall and its particles, shared by the commands that make impacts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_WALLS_H
#define ASP_CLI_WALLS_H

#include "cli/cli.h"

/* Reads `plane` or `isotropic`, `single` or `multiple`, `on` or `off`. */
const char *cli_tilt(const cli_option *option);
bool cli_is_multiple(const cli_option *option);
bool cli_switch(const cli_option *option);

/* The correlation lengths of a wall, and its lay. */
typedef struct cli_lay {
  double lambda[2]; /* across the lay and along it; equal where there is none */
  double direction; /* of the lay, rad, from the direction of flight towards n x t */
  double vector[3]; /* the same where the particle flies along x and the wall is z = 0 */
  double part;      /* lambda[0]^2 over the square of the correlation length along the flight */
} cli_lay;

/* Reads --lambda-c, one length or two, and --lay, in degrees, which goes with two. */
cli_lay cli_lay_of(const cli_option *lambda_c, const cli_option *lay);
#define CLI_LAY_OPTION                                                                             \
  {                                                                                                \
    "lay", "DEGREES",                                                                              \
        "of two --lambda-c, or of a --map: from the flight to the lay [90: across it]", NULL       \
  }
#define CLI_LAMBDA_HELP "correlation length: autocorrelation 1/e; with a lay two: across,along"

/* The surface of --rq and those. */
asp_surface *cli_surface_of(const cli_option *rq, const cli_lay *lay);

/* The options by which a rough wall is given, in a row in a command's table: --sigma (of particles
 * of any size), or --rq and --lambda-c (and --lay), or a measured --profile or --map, as
 * `asperity surface --save` writes them. */
enum { ROUGH_SIGMA, ROUGH_RQ, ROUGH_LAMBDA_C, ROUGH_LAY, ROUGH_PROFILE, ROUGH_MAP, ROUGH_OPTIONS };

#define CLI_ROUGH_OPTIONS(first)                                                                   \
  [(first) +                                                                                       \
      ROUGH_SIGMA] = {"sigma", "DEGREES",                                                          \
                      "the wall as sigma = atan(s_eff), for particles of any size; or ...", NULL}, \
      [(first) + ROUGH_RQ] = {"rq", "LENGTH", "... its rms height,", NULL},                        \
      [(first) + ROUGH_LAMBDA_C] = {"lambda-c", "LENGTHS", CLI_LAMBDA_HELP, NULL},                 \
      [(first) + ROUGH_LAY] = CLI_LAY_OPTION,                                                      \
      [(first) + ROUGH_PROFILE] = {"profile", "FILE",                                              \
                                   "a measured profile instead; see 'asperity surface --save'",    \
                                   NULL},                                                          \
      [(first) +                                                                                   \
          ROUGH_MAP] = {"map", "FILE", "a measured map instead: SDF, matrix, or x, y, z", NULL}

/* A rough wall as a command is told of it. */
typedef struct cli_rough {
  asp_surface *surface;
  asp_profile *profile; /* or NULL */
  asp_map *map;         /* or NULL */
  cli_lay lay;
} cli_rough;

/* Whether any of them is there, of which the first is given; and one of a measured wall, whose
 * spread model is `profile` where none is named. */
bool cli_rough_given(const cli_option *first);
bool cli_rough_measured(const cli_option *first);

/* The spread model: that of --model where it is given, `profile` of a measured wall, else
 * `visible`.
 */
const char *cli_rough_model(const cli_option *first, const cli_option *model);

/* Chooses a wall's tilt, collisions and spread model; exits where there are no such. */
void cli_rough_choose(asp_wall *wall, const cli_option *tilt, const cli_option *collisions,
                      const char *model);

/* The diameter of --dp; where --sigma gives the wall, any that is not given. */
double cli_rough_size(const cli_option *first, const cli_option *dp);

/* Exits where the wall is given in two ways. */
void cli_rough_check(const cli_option *first);

/* Reads the wall for diameters from d_least to d_most; exits where none is given, or two are. */
cli_rough cli_rough_read(const cli_option *first, double d_least, double d_most);
void cli_rough_free(cli_rough *rough);

/* Puts the surface, the profile and the map into a wall that is to be prepared for those diameters;
 * they must outlive that. */
void cli_rough_put(const cli_rough *rough, asp_wall *wall, double d_least, double d_most);

/* Exits when the surface's size law does not reach to the diameter. */
void cli_check_size(const asp_surface *surface, double d_p);

#endif
