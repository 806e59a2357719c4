/* Measured coefficients of restitution as people have them: a table, a row for each impact or for
 * the mean of some, in any of several forms.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_MEASURED_H
#define ASP_CLI_MEASURED_H

#include <stdbool.h>
#include <stddef.h>

#include "cli/scatter.h"

/* NAN where there is nothing. Of an impact, cor are its coefficients and se their measurement
 * errors; of a mean, cor are means, sd standard deviations, se standard errors and n the number of
 * impacts. */
typedef struct measured_row {
  double degrees, v1, d_p; /* SI */
  double cor[COR_BOTH], sd[COR_BOTH], se[COR_BOTH], n;
  bool deposit;
} measured_row;

typedef struct measured {
  measured_row *rows;
  size_t count;
  bool means;                            /* rows are means, not impacts */
  bool has_speed, has_size, has_outcome; /* there are such columns */
} measured;

/* Reads such a table, in order of angle, speed, size; exits on a file that is none. Names and units
 * of its columns: see `asperity compare --help`. */
measured measured_read(const char *path);
void measured_free(measured *data);

/* The part of a help text that says which columns there may be. */
#define MEASURED_FORMS                                                                             \
  "DATA is CSV (- is standard input); a name's unit stands behind it: alpha1_deg or alpha1_rad,\n" \
  "v1_m_s, dp_um (or _mm, _m), also in brackets, or in a line of its own below the names. "        \
  "An\nangle without one is in degrees, with a warning, a speed in m/s; a length must have one.\n" \
  "Titles may stand above the names, and `sep=;`; e_n and e_t are cor_n and cor_t. Columns, of\n"  \
  "which those that are there are taken:\n"                                                        \
  "  impacts  alpha1, v1, alpha2, v2 | v1_n, v1_t, v2_n, v2_t | alpha1, cor_v, cor_alpha |\n"      \
  "           alpha1, cor_n, cor_t; with outcome (rebound or deposit), cor_n_se, cor_t_se\n"       \
  "  means    alpha1, cor_n_mean, cor_t_mean; with cor_n_sd, cor_t_sd, cor_n_se, cor_t_se, n\n"    \
  "and v1, dp with either. A polynomial is given by its points, as means.\n"

#endif
