/* Positions of a profile's points as a file has them: whether they rise or fall, how far apart they
 * are, and heights at equal spacing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_POSITIONS_H
#define ASP_READERS_POSITIONS_H

#include "base/text.h"
#include "readers/read.h"

#include <gsl/gsl_rstat.h>

/* A point of the file: its position along the profile in the file's unit, its height in m. */
typedef struct aspi_point {
  double x, z;
  size_t line;
} aspi_point;

/* Points in X and Y: the first one, the last one from there, and their running covariance. */
typedef struct aspi_plane {
  double first[2], last[2], mean[2], c_xx, c_xy, c_yy;
} aspi_plane;

typedef struct aspi_positions {
  aspi_point *list; /* for the caller to free */
  size_t points, room;
  double ratio; /* of the units of Y and X, where positions are distances in both; else 0 */
  aspi_plane plane;
  double step_least, step_most, usual;     /* usual: mean of the steps that are not gaps */
  size_t usual_count, repeats;             /* repeats: positions that repeat the one before */
  double sign;                             /* -1: positions fall; 0: not known yet */
  double mean_i, mean_x, c_ii, c_ix, c_xx; /* running regression on the index */
  int decimals, digits;                    /* the most that any position is written with */
  double most;                             /* the largest coordinate that is written */
  gsl_rstat_quantile_workspace median;     /* of the steps */
} aspi_positions;

void aspi_positions_begin(aspi_positions *p);

/* Adds the point of a line; `y` counts where p->ratio is not 0. ASP_EDATA where positions neither
 * rise nor fall. */
asp_code aspi_positions_add(aspi_positions *p, const aspi_text *text, double x, double y, double z,
                            asp_error *error);

/* Takes in how finely a position is written. */
void aspi_positions_precision(aspi_positions *p, const char *written);

/* Completes `raw` with the heights at equal spacing from the least position on, and that spacing in
 * the file's unit: those of the file where they are equally spaced but for rounding, else between
 * them, which `resample` must allow. */
asp_code aspi_positions_space(aspi_positions *p, const aspi_text *text, bool resample,
                              aspi_raw *raw, asp_error *error);

#endif
