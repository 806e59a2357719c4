/* The row of one particle size on one profile, as `asperity surface` has it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SLOPES_H
#define ASP_CLI_SLOPES_H

#include "cli/cli.h"
#include "surface/slopes.h"

/* Points per correlation length of a generated profile: fine enough that a particle smaller than
 * the spacing finds the unfiltered slope. */
#define CLI_POINTS_PER_LAMBDA 128.0

#define CLI_SLOPES_HEADER                                                                          \
  "dp_um,rq_um,lambda_c_um,phi_r,kappa,slope_rms,sigma_deg,angle_mean_deg,angle_sd_deg,angle_"     \
  "kurtosis,"                                                                                      \
  "kl_normal"

typedef struct cli_slopes {
  double d_p, r_q, lambda_c;
  aspi_slopes slopes;
} cli_slopes;

double cli_kappa(const cli_slopes *row);

/* The columns of CLI_SLOPES_HEADER, without the end of the line. */
void cli_slopes_print(FILE *out, const cli_slopes *row);

/* The slopes that discs of every size meet on a profile, in order, on all cores; the progress goes
 * on from `done` in steps of one. Exits on an error. */
void cli_slopes_measure(const asp_profile *profile, aspi_contact contact, double r_q,
                        double lambda_c, const cli_list *sizes, cli_progress *progress, double done,
                        cli_slopes *rows);

#endif
