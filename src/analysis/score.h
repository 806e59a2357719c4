/* One score of a model against measurements: the reduced chi-square of the differences of means,
 * standard deviations and shares of deposits, near 1 for the true model, and its standard error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_SCORE_H
#define ASP_ANALYSIS_SCORE_H

#include "analysis/angles.h"
#include "analysis/sample.h"

#include <gsl/gsl_rng.h>

/* Replicates; and fewer single impacts than this tell no standard error to divide by. */
enum { ASPI_REPLICATES = 200, ASPI_SCORED_LEAST = 10 };

/* chi2 of a difference that is z in its standard errors, and of a replicate's difference from it,
 * e: the sums of z^2, z e and e^2 over all terms. */
typedef struct aspi_score {
  gsl_rng *rng;
  size_t terms;
  double square, cross[ASPI_REPLICATES], noise[ASPI_REPLICATES];
} aspi_score;

/* Both return false where memory is out. */
bool aspi_score_begin(aspi_score *score);

/* Adds the terms of a bin with single impacts on both sides: resamples them. */
bool aspi_score_add_impacts(aspi_score *score, const aspi_side *model, const aspi_side *data);

/* Adds the terms of measured means: the replicates are normal. */
void aspi_score_add_means(aspi_score *score, const aspi_side *model, const aspi_side *data);

/* NAN where no difference has a known standard error. Replicates scatter about the measured
 * differences less what noise alone adds to chi2, so that their scatter is that of the score over
 * repeated measurements. Frees what the score holds. */
aspi_estimate aspi_score_end(aspi_score *score);

#endif
