/* Samples of a quantity of impacts, whose values may count with different weights.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_SAMPLE_H
#define ASP_ANALYSIS_SAMPLE_H

#include "analysis/impacts.h"

/* The quantities of an impact: both coefficients, and 1 for a deposit, 0 for a rebound. */
enum { ASPI_DEPOSITS = COR_BOTH, ASPI_QUANTITIES };

/* A coefficient is NAN where there is none. */
typedef struct aspi_impact {
  double of[ASPI_QUANTITIES], weight;
} aspi_impact;

/* A sample; NAN where it is too small for a number. size: effective sample size
 * (Kish). low and high are the quantiles 0.05 and 0.95; _se are standard errors. */
typedef struct aspi_sample {
  size_t count;
  double size, mean, sd, median, low, high, mean_se, sd_se;
} aspi_sample;

extern const aspi_sample aspi_sample_none;

/* What is known of all quantities on one side, of the model or of the data. */
typedef struct aspi_side {
  aspi_impact *impacts; /* NULL where there are only numbers */
  size_t count;
  aspi_sample of[ASPI_QUANTITIES];
} aspi_side;

/* Describes a quantity of the side's impacts, which puts them in its order. */
void aspi_sample_describe(aspi_side *side, int quantity);

/* The two-sample distance of Kolmogorov and Smirnov; both sides are in order of the quantity. */
double aspi_sample_distance(const aspi_side *a, const aspi_side *b, int quantity);

#endif
