/* Samples of a coefficient, whose values may count with different weights, and their comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_SAMPLE_H
#define ASP_ANALYSIS_SAMPLE_H

#include <stdbool.h>
#include <stddef.h>

typedef struct aspi_weighted {
  double value, weight;
} aspi_weighted;

/* A sample; NAN where it is too small for a number. size: effective sample size (Kish). low and
 * high are the quantiles 0.05 and 0.95. */
typedef struct aspi_sample {
  aspi_weighted *values; /* in order; NULL where they are not kept */
  size_t count;
  bool equal; /* all weights are */
  double size, mean, sd, median, low, high;
} aspi_sample;

/* Puts the values in order, and works out the rest. */
void aspi_sample_describe(aspi_sample *s);

/* The share of the first within two bounds. */
double aspi_sample_within(const aspi_sample *s, double low, double high);

/* The two-sample distance of Kolmogorov and Smirnov, and the probability of as much or more when
 * both come from one law: exact for small samples of equal weights, else by the limit. NAN: out
 * of memory. */
double aspi_sample_distance(const aspi_sample *a, const aspi_sample *b);
double aspi_sample_p_value(const aspi_sample *a, const aspi_sample *b, double distance);

/* The probability of two shares k of n that are farther apart than these, with half of that of as
 * far (Fisher's exact test, mid-p). */
double aspi_shares_p_value(size_t k1, size_t n1, size_t k2, size_t n2);

/* The p-values of independent tests as one (Fisher), and of dependent ones (Cauchy combination, Liu
 * & Xie 2020). NAN of none. */
double aspi_combine_independent(const double *p, size_t count);
double aspi_combine_dependent(const double *p, size_t count);

#endif
