/* Measured coefficients of restitution as people have them: a table, a row for each impact or for
 * the mean of some, in any of several forms.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_MEASURED_H
#define ASP_CLI_MEASURED_H

#include "analysis/impacts.h"
#include "cli/cli.h"

/* The option of commands that read such a table. */
#define MEASURED_OPTION                                                                            \
  {                                                                                                \
    "view", "plane|space",                                                                         \
        "velocity of v2, alpha2, cor_v, cor_alpha in the data, if their names do not say it", NULL \
  }

/* Reads such a table, in order of angle, speed, size; exits on a file that is none. Names and units
 * of its columns: see `asperity compare --help`. */
aspi_measured cli_measured_read(const char *path, const cli_option *view);

/* Puts rows in order of angle, speed, size. */
void cli_measured_sort(aspi_measured *data);

/* Exits where the data do not say how they look at rebounds, and `matters`: it makes a difference.
 */
void cli_measured_need_view(const char *path, aspi_measured *data, bool matters);

/* The part of a help text about the possible columns. */
#define MEASURED_FORMS                                                                             \
  "DATA is CSV (- is standard input). A name may carry its unit: alpha1_deg or alpha1_rad,\n"      \
  "v1_m_s, dp_um (or _mm, _m), also in brackets, or in a line of its own below the names. An\n"    \
  "angle without a unit is in degrees, with a warning, a speed in m/s; a length must have one.\n"  \
  "Titles and `sep=;` may precede the names; e_n and e_t are cor_n and cor_t, _std and _sem are\n" \
  "_sd and _se, radius is half of dp. The command takes these columns, where they are there:\n"    \
  "  impacts  alpha1, v1, alpha2, v2 | v1_n, v1_t, v2_n, v2_t | alpha1, cor_v, cor_alpha |\n"      \
  "           alpha1, cor_n, cor_t; with outcome (rebound or deposit), cor_n_se, cor_t_se\n"       \
  "  means    alpha1, cor_n_mean, cor_t_mean; with cor_n_sd, cor_t_sd, cor_n_se, cor_t_se, n\n"    \
  "and v1, dp with either. Give a polynomial by points on it, as means. If the wall throws\n"      \
  "particles to the side, alpha2, v2, cor_v and cor_alpha must say which velocity they belong\n"   \
  "to: alpha2_plane, v2_plane and so on to that in the plane of incidence, as one camera sees\n"   \
  "it; alpha2_space (0 to 90 degrees from the wall), v2_space and so on to that in space.\n"       \
  "Rebounds that noise put below the wall are mirrored at it.\n"

#endif
