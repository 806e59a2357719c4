/* A wall and its particles by the words that stand before the first option of a command line, the
 * same as in a script; see asp_description_parse. Numbers are SI, lengths take a unit behind them.
 *
 * Everything here exits on bad words, a bad file or a wall that cannot be made: status 2. What only
 * looks like a mistake is a warning.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_DESCRIPTION_H
#define ASP_CLI_DESCRIPTION_H

#include "asperity_internal.h"
#include "cli/cli.h"

typedef struct cli_description {
  asp_description *words;
  asp_wall *wall;                        /* NULL until it is made */
  const asp_material *particle, *target; /* NULL where the law takes no materials and none are
                                            given */
  asp_pair *pair;                        /* NULL alike */
  bool has_standard_materials;           /* none are given */
  bool has_no_impact; /* the command takes no rebound law, so constants do not count */
  double density;     /* of the particles */
  char *text;         /* canonical; with the materials, also where they are the
                         default */
} cli_description;

/* Reads the words, of which there may be none; `materials` are two, those of the particles and of
 * the wall: Arizona Road Dust on hastelloy-x where none are given. may_fit: numbers may be unknown,
 * see struct asp_description, and materials must be given. cli_description_make is still to come.
 */
cli_description cli_description_read(int count, char **words, bool may_fit);

/* The canonical text. */
char *cli_description_text(const asp_description *words);

/* Refuses each keyword that is given and is none of `allowed`, which have blanks between; `why` is
 * a sentence about the command. */
void cli_description_allow(cli_description *description, const char *allowed, const char *why);

/* Warns of what looks like a mistake in the words, the wall if it is made, its file, and its
 * constants; diameters that are not known are 0. */
void cli_description_doubt(const cli_description *description, double d_least, double d_most);

/* Reads a measured wall and prepares for diameters from d_least to d_most, and warns of
 * doubts. */
void cli_description_make(cli_description *description, double d_least, double d_most);

/* Warns where the lowest of these angles (degrees) is steepened over a measured profile. */
void cli_description_doubt_angles(const cli_description *description, const cli_list *angles);

/* One impact, at an angle in degrees on the wall z = 0, of a particle that flies along x; cor_t is
 * NAN where it is undefined. */
typedef struct cli_impact {
  asp_impact impact;
  asp_coefficients cor;
} cli_impact;
cli_impact cli_impact_at(const cli_description *description, double d_p, double speed,
                         double degrees, const asp_key *key);

/* The direction of the lay where particles fly along x over the wall z = 0; NULL where there is no
 * lay. An angle is from x toward y. `vector` holds it. */
const double *cli_description_lay(const cli_description *description, double vector[3]);

/* The square of lambda_c across the lay over the correlation length along the flight; 1 where there
 * is no lay. */
double cli_description_shrink(const cli_description *description, const asp_surface *surface);

#endif
