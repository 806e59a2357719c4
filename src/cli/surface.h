/* Functions shared by the files of `asperity surface`: generated and measured profiles (surface.c),
 * their picture (surface_plot.c), measured maps (surface_map.c), and warnings of both
 * (surface_check.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SURFACE_H
#define ASP_CLI_SURFACE_H

#include "cli/description.h"
#include "readers/read.h"
#include "surface/slopes.h"

/* One wall by its profile. */
typedef struct cli_wall {
  asp_profile *profile;
  double r_q, lambda_c;
  const char *name; /* of the measured file, or NULL */
} cli_wall;

/* The row of one particle size on one profile. */
typedef struct cli_slopes {
  double d_p, r_q, lambda_c;
  aspi_slopes slopes;
} cli_slopes;

double cli_kappa(const cli_slopes *row);

/* The curve on which discs roll: through the points if the profile is measured, else the points. */
aspi_contact cli_contact(const cli_wall *wall);

/* The profile, the particle on it, and the density of the angles with its normal fit. */
void cli_surface_plot(const cli_call *call, const cli_wall *wall, const cli_slopes *row);

/* Warns of the reader's doubts, and of a sampling that is too coarse for the smallest size; exits
 * if the points do not resolve a particle. */
void cli_surface_check(const char *name, const char *what, const aspi_profile_report *report,
                       double spacing, double length, double lambda, const cli_list *sizes);

/* All of `asperity surface` of a map: what it is, and which slopes a sphere of each size finds. */
void cli_surface_map(const cli_call *call, const cli_description *wall,
                     const aspi_profile_options *options, const cli_list *sizes);

#endif
