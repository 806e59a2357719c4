/* Shared by the parts of a fit: the calibration with its weights, and scratch memory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_SEARCH_H
#define ASP_ANALYSIS_SEARCH_H

#include "analysis/calibrate.h"

#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>

typedef struct aspi_search {
  const aspi_calibration *problem;
  aspi_group *groups; /* the data: the problem's own, or synthetic ones */
  aspi_weights *weights;
  double pooled[MOMENTS][MOMENTS];
  double (*xy)[2], *room; /* of all groups, for `most` impacts each */
  size_t most, samples, n_moments;
  aspi_weights_kind kind;
  bool fixed; /* weights stay; else they follow the unknowns, and their determinant counts */
  int held;   /* an unknown that stays where it is; -1: none */
  double held_at;
} aspi_search;

bool aspi_search_begin(aspi_search *s, const aspi_calibration *problem);
void aspi_search_end(aspi_search *s);

/* Least squares from there on, to within `close` on the scale; the sum of squares, and where wanted
 * the derivatives in the end, and half the gradient of the sum. INFINITY: no such model. */
double aspi_search_descend(aspi_search *s, double *at, int steps, double close,
                           gsl_matrix *derivatives, gsl_vector *gradient);

/* The sum of squares at some values. */
double aspi_search_squares(aspi_search *s, const double *at);

/* Weights and least squares in turn, until neither changes, with the model or the data to weigh by;
 * covariance is that of the unknowns. */
bool aspi_search_settle(aspi_search *s, double *at, int rounds, double *chi2,
                        gsl_matrix *covariance);

/* The 95 % interval of an unknown by the rise of chi^2, with the weights as they are. */
void aspi_interval_by_rise(aspi_search *s, const double *at, double scale, size_t j, double *low,
                           double *high);

/* All of them by refits of synthetic data; false: there is no memory. */
bool aspi_interval_by_bootstrap(const aspi_calibration *problem, aspi_fit *fit);

#endif
