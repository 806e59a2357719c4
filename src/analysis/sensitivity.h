/* Sensitivity of a run's results to the roughness of its wall by the likelihood-ratio method.
 *
 * On another wall, a result of an impact has as weight the product of the likelihood ratios of the
 * particle's draws up to it (asp_wall_weights). The derivative of that product is the sum of the
 * scores, the derivatives of the log likelihoods. Later draws have mean ratio 1 and mean score 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* Results of an impact: three are summed, coefficients (NAN for deposits) are averaged. */
enum { ASPI_STUCK, ASPI_DEPOSITED, ASPI_ERODED, ASPI_COR, ASPI_RESULTS = ASPI_COR + 2 };

/* Estimates: of the run, derivatives by two parameters, on another wall. */
enum { ASPI_RUN, ASPI_DERIVATIVE, ASPI_OTHER = ASPI_DERIVATIVE + 2, ASPI_PARTS };

typedef struct aspi_drawn {
  double tag, row;         /* which particle; the row of the ledger, which is in order of time */
  double self[ASPI_PARTS]; /* of its draws: 1, two scores, likelihood ratio */
  double result[ASPI_RESULTS];
  int mesh, triangle;
  double alpha1;            /* degrees */
  double place;             /* set by the caller before aspi_drawn_place */
  size_t grain;             /* from 0; this and the next are set by aspi_drawn_order */
  double prior[ASPI_PARTS]; /* of the particle's earlier draws: 1, sums, product */
} aspi_drawn;

/* Sorts impacts by particle and row; returns how many particles there are. *effective: the
 * effective sample size (sum w)^2 / sum w^2 for the other wall. */
size_t aspi_drawn_order(aspi_drawn *drawn, size_t n, double *effective);

/* Sorts them by place, and at a place by particle. */
void aspi_drawn_place(aspi_drawn *drawn, size_t n);

/* A result of the impacts at a place with standard errors over the particles, of which the run has
 * `grains`: the sum, of coefficients the mean. */
typedef struct aspi_derivative {
  double value, se;
} aspi_derivative;
void aspi_sensitivity(const aspi_drawn *drawn, size_t n, int result, size_t grains,
                      aspi_derivative found[ASPI_PARTS]);
