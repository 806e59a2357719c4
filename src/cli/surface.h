/* Data that `asperity surface` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SURFACE_H
#define ASP_CLI_SURFACE_H

#include "cli/slopes.h"
#include "surface/slopes.h"

/* One wall as the picture shows it. */
typedef struct cli_wall {
  asp_profile *profile;
  asp_profile *generated; /* of the same r_q and lambda_c, for a measured profile; or NULL */
  double r_q, lambda_c;
  const char *name; /* of the measured file, or NULL */
} cli_wall;

/* The curve on which discs roll: through the points if the profile is measured, else the points. */
aspi_contact cli_contact(const cli_wall *wall);

/* D_KL of the measured angles' density against the generated one's, for a particle of size d_p. */
double cli_generated_kl(const cli_wall *wall, double d_p);

/* The profile, the particle on it, and the density of the angles with its normal fit, beside that
 * of the generated profile where there is one. */
void cli_surface_plot(const cli_option *option, const cli_wall *wall, const cli_slopes *row);

#endif
