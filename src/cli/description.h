/* A wall and its particles, from the words before the first option of a command line; the words are
 * those of a script, see asp_description_parse. Numbers are SI; lengths take a unit.
 *
 * These functions exit with status 2 on bad words, a bad file or an impossible wall, and warn of
 * suspicious input.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"
#include "cli/cli.h"

typedef struct cli_description {
  asp_description *words;
  asp_wall *wall;                        /* NULL until it is made */
  const asp_material *particle, *target; /* NULL if the law takes no materials and none are
                                            given */
  asp_pair *pair;                        /* NULL alike */
  bool has_default_materials;            /* none are given */
  bool has_own_heat;                     /* the particles have temperatures of their own */
  bool has_no_impact; /* the command takes no rebound law, so constants do not count */
  double density;     /* of the particles */
  char *text;         /* canonical; with the materials, also where they are the
                         default */
} cli_description;

/* Reads the words. `materials` names two, particle and wall (default: Arizona Road Dust on
 * hastelloy-x). fittable: numbers may be `fit`, see struct asp_description, and materials must be
 * given. Call cli_description_make next.
 */
cli_description cli_description_read(int count, char **words, bool fittable);

/* The words of a command line, with the materials of a ledger's heading behind them where they have
 * none and it has two. Returns their count. */
int cli_ledger_words(const char *heading, int count, char ***words);

/* The densities of those materials: of the particles where it is NAN, and of the wall. */
void cli_ledger_densities(const char *heading, double *particle, double *wall);

/* The canonical text. */
char *cli_description_text(const asp_description *words);

/* Refuses each keyword that is given and is none of `allowed`, which have blanks between; `why` is
 * a sentence about the command. */
void cli_description_allow(cli_description *description, const char *allowed, const char *why);

/* Warns of suspicious words, wall (if made), file and constants. Unknown diameters are 0. */
void cli_description_doubt(const cli_description *description, double d_least, double d_most);

/* Reads a measured wall and prepares for diameters from d_least to d_most, and warns of
 * doubts. */
void cli_description_make(cli_description *description, double d_least, double d_most);

/* Warns if the lowest of these angles (degrees) is steepened over a measured profile. */
void cli_description_doubt_angles(const cli_description *description, const cli_list *angles);

/* One impact, at an angle in degrees on the wall z = 0, of a particle that flies along x, at a
 * temperature of its own (0: it has none); cor_t is NAN if it is undefined. */
typedef struct cli_impact {
  asp_impact impact;
  asp_coefficients cor;
} cli_impact;
cli_impact cli_impact_at(const cli_description *description, double d_p, double speed,
                         double kelvin, double degrees, const asp_key *key);

/* The square of lambda_c across the lay over the correlation length along the flight; 1 without a
 * lay. */
double cli_description_shrink(const cli_description *description, const asp_surface *surface);
