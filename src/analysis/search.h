/* A search for the unknowns of a calibration: whitened differences of moments, and the minimum of
 * their squares. The weights are those of the model where it scatters and the errors of the data
 * are known and the model describes them, else those of the data.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_SEARCH_H
#define ASP_ANALYSIS_SEARCH_H

#include "analysis/calibrate.h"

typedef struct aspi_search {
  const aspi_calibration *problem;
  aspi_weights *weights;
  double pooled[MOMENTS][MOMENTS];
  double (*xy)[2]; /* scratch of a group */
  size_t samples;  /* simulated impacts of a group */
  size_t n_moments;
  bool by_model; /* weights of the model, else of the data */
  int held;      /* an unknown that stays where it is; -1: none */
  double held_at;
  bool follows; /* weights follow the unknowns, and their determinant counts; else they stay */
} aspi_search;

/* Begins with weights that follow the unknowns if they are the model's. False: out of memory. */
bool aspi_search_begin(aspi_search *s, const aspi_calibration *problem);
void aspi_search_end(aspi_search *s);

/* Takes the weights of the data from here on. */
void aspi_search_weigh_by_data(aspi_search *s);

/* The sum of squares at some values; INFINITY: no such model. */
double aspi_search_squares(aspi_search *s, const double *at);

/* Least squares from there on, in at most `steps` steps, to within `close` on the scale. Returns
 * the sum of squares. */
double aspi_search_descend(aspi_search *s, double *at, int steps, double close);

/* Gauss-Newton steps from fit->at until they are small against the errors; the model's weights are
 * those at the values where a step begins (quasi-likelihood, Wedderburn 1974), and stay in the end.
 * Fills in all but starts, intervals and `described`. False: there is no such model, or no memory.
 */
bool aspi_search_settle(aspi_search *s, aspi_fit *fit);

#endif
