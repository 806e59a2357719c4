/* Samples of impacts, and one score of a model against measurements: the reduced chi-square of the
 * differences of means, standard deviations and shares of deposits, near 1 for the true model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "analysis/angles.h"
#include "analysis/near.h"

/* Fewer single impacts than this give no usable standard error. */
enum { ASPI_SCORED_LEAST = 10 };

/* The quantities of an impact: its numbers that are compared, and 1 for a deposit, 0 for a rebound.
 */
enum { ASPI_DEPOSITS = ASPI_COMPARED, ASPI_QUANTITIES };

/* A sample; NAN if it is too small for a number. size: effective sample size (Kish). _se are
 * standard errors. */
typedef struct aspi_sample {
  size_t count;
  double size, mean, sd, mean_se, sd_se;
} aspi_sample;

extern const aspi_sample aspi_sample_none;

/* Samples of all quantities on one side, of the model or of the data. */
typedef struct aspi_side {
  aspi_weighted *impacts; /* NULL if there are only numbers */
  size_t count;
  aspi_sample of[ASPI_QUANTITIES];
  double correlation; /* of both coefficients; 0 where not known */
} aspi_side;

/* Describes all quantities of the side's impacts. */
void aspi_side_describe(aspi_side *side);

/* Sums over differences z in their standard errors: of z^2; of the squares of their correlations,
 * and of z_i z_j times those. Begins with zeros. */
typedef struct aspi_score {
  double terms, square, scatter, shift;
} aspi_score;

/* Adds the differences of a bin. */
void aspi_score_add(aspi_score *score, const aspi_side *model, const aspi_side *data);

/* NAN if no difference has a known standard error. The standard error is that of a quadratic
 * form of normal differences. */
aspi_mean_error aspi_score_end(const aspi_score *score);
