/* What weibull_fit hands to its pictures.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_WEIBULL_FIT_H
#define ASP_WEIBULL_FIT_H

#include "cli/cli.h"
#include "spread/models.h"

enum { FIT_BINS = 600, FIT_DEGREE = 4 };

/* Bins reach from -alpha1/2 up over this many sigma. */
#define FIT_REACH 12.0

/* tau of the paper's boundary angle e. */
#define FIT_TAU_END 6.48

/* One wall at one angle. */
typedef struct angle_fit {
  double sigma, alpha1;   /* rad */
  double count[FIT_BINS]; /* of all runs, by (delta + alpha1/2)/sigma */
  double n;
  double k, k_sd, lambda, lambda_sd; /* mean and sd over the runs; lambda over sigma */
} angle_fit;

/* The wall as a model looks at it. */
aspi_view cli_fit_view(const angle_fit *fit);

/* True if a model has its own density over delta, so that the baseline's samples can judge it. */
bool cli_fit_judges(const asp_spread_model *model);

/* D_KL of the samples against a model's law, less the samples' bias. A bin that the model does not
 * reach counts as 1e-9. */
double cli_fit_divergence(const angle_fit *fit, const asp_spread_model *model);

/* The figure that --figure names, of n fits, wall by wall; k and lambda are the polynomials. */
void cli_fit_plot(const cli_call *call, const angle_fit *fits, size_t n, const cli_list *sigmas,
                  const double *k, const double *lambda);

#endif
