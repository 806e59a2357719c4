/* Samples of a coefficient, whose values may count with different weights, and their comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SAMPLE_H
#define ASP_CLI_SAMPLE_H

#include <stdbool.h>
#include <stddef.h>

typedef struct sample_value {
  double value, weight;
} sample_value;

/* A sample; NAN where it is too small for a number. size: how many equal weights would know as
 * much (Kish). low and high are the quantiles 0.05 and 0.95. */
typedef struct sample {
  sample_value *values; /* in order; NULL where they are not kept */
  size_t count;
  bool equal; /* all weights are */
  double size, mean, sd, median, low, high;
} sample;

/* Puts the values in order, and works out the rest. */
void sample_describe(sample *s);

/* The share of the first within two bounds. */
double sample_within(const sample *s, double low, double high);

/* The two-sample distance of Kolmogorov and Smirnov, and the probability of as much or more when
 * both come from one law: exact for small samples of equal weights, else by the limit. */
double sample_distance(const sample *a, const sample *b);
double sample_p_value(const sample *a, const sample *b, double distance);

/* The probability of two shares k of n that are farther apart than these, with half of that of as
 * far (Fisher's exact test, mid-p). */
double shares_p_value(size_t k1, size_t n1, size_t k2, size_t n2);

/* The p-values of independent tests as one (Fisher), and of dependent ones (Cauchy combination, Liu
 * & Xie 2020). NAN of none. */
double combine_independent(const double *p, size_t count);
double combine_dependent(const double *p, size_t count);

#endif
