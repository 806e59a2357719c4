/* How results of a run would change with the roughness of its wall, from the draws of its impacts.
 *
 * What a particle does after a draw counts with the product of the weights of all its draws so far
 * (asp_wall_weights); the derivative of that product is the sum of the scores, which are the
 * derivatives of the logarithms. Later draws have the mean weight 1 and the mean score 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_SENSITIVITY_H
#define ASP_ANALYSIS_SENSITIVITY_H

#include <stdbool.h>
#include <stddef.h>

/* What an impact adds to the sums of a run; and its coefficients, NAN where there are none. */
enum { ASPI_STUCK, ASPI_DEPOSITED, ASPI_ERODED, ASPI_COR, ASPI_RESULTS = ASPI_COR + 2 };

/* The run itself, its derivatives by two parameters, and another wall. */
enum { ASPI_RUN, ASPI_DERIVATIVE, ASPI_OTHER = ASPI_DERIVATIVE + 2, ASPI_PARTS };

typedef struct aspi_drawn {
  double tag, row;        /* which particle; the row of the ledger, which is in order of time */
  double own[ASPI_PARTS]; /* of its draws: 1, two scores, the weight on another wall */
  double result[ASPI_RESULTS];
  int mesh, triangle;
  double alpha1;             /* degrees */
  double place;              /* by which the caller sorts them */
  size_t grain;              /* from 0; this and the next are set by aspi_drawn_order */
  double before[ASPI_PARTS]; /* of the particle's earlier draws: 1, sums, product */
} aspi_drawn;

/* Sorts impacts by particle and row; returns how many particles there are. *effective: how many
 * would tell as much about the other wall if their weights were equal. */
size_t aspi_drawn_order(aspi_drawn *drawn, size_t n, double *effective);

/* Sorts them by place, and at a place by particle. */
void aspi_drawn_place(aspi_drawn *drawn, size_t n);

/* A result of the impacts at a place with standard errors over the particles, of which the run has
 * `grains`: the sum, of coefficients the mean. */
typedef struct aspi_estimate {
  double value, se;
} aspi_estimate;
void aspi_sensitivity(const aspi_drawn *drawn, size_t n, int result, size_t grains,
                      aspi_estimate found[ASPI_PARTS]);

#endif
