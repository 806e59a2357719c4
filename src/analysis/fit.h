/* The unknowns of a model from moments of measured impacts. The model simulates impacts with the
 * same random numbers whatever the values of its unknowns, so that the differences of moments are
 * smooth in them.
 *
 * The minimum is looked for from the best points of a design that does not depend on the caller's
 * start, by the likelihood that the moments would have if they were normal with the covariance of
 * data and model together. The start is one more point; its end counts only where it is better by
 * more than noise, so that all starts have the same result. At the best end, weights are taken from
 * the model, and least squares and weights take turns until neither changes (quasi-likelihood,
 * Wedderburn 1974).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_FIT_H
#define ASP_ANALYSIS_FIT_H

#include "analysis/weights.h"
#include "asperity.h"

#include <stdint.h>

enum { FIT_UNKNOWNS_MOST = 8 };

typedef struct aspi_fit_problem {
  void *context;
  bool (*set)(void *context, const double *at); /* false: there is no such model */
  /* Impacts of the model at the places of a group; xy has room for them. Draws depend on the group,
   * the stream and the number of the impact; the data's own are none of stream 0. */
  void (*draw)(void *context, size_t group, size_t samples, uint32_t stream, aspi_cloud *to);
  aspi_group *groups;
  size_t n_groups, n_unknowns, samples;
  double start[FIT_UNKNOWNS_MOST];                        /* each on a scale of its own, on which */
  double low[FIT_UNKNOWNS_MOST], high[FIT_UNKNOWNS_MOST]; /* 1 is a big change; its bounds */
  double from[FIT_UNKNOWNS_MOST], to[FIT_UNKNOWNS_MOST];  /* the box of the design */
  double huber;  /* rebounds farther out than this many robust sd are pulled in; INFINITY: none */
  bool scatters; /* the model's impacts at one place differ */
  bool known;    /* the data state their errors */
  void (*progress)(void *context, double share); /* may be NULL */
} aspi_fit_problem;

/* Source of an unknown's 95 % interval: its standard error; the rise of chi^2 if the error is large
 * or a bound is near (an end may then lie at the bound); or refits of synthetic data if impacts are
 * few. */
typedef enum aspi_interval { BY_ERROR, BY_RISE, BY_BOOTSTRAP } aspi_interval;

typedef struct aspi_fit {
  double at[FIT_UNKNOWNS_MOST], error[FIT_UNKNOWNS_MOST]; /* on the scale */
  double correlation[FIT_UNKNOWNS_MOST][FIT_UNKNOWNS_MOST];
  double low[FIT_UNKNOWNS_MOST], high[FIT_UNKNOWNS_MOST]; /* -INFINITY, INFINITY: at the bound */
  aspi_interval interval[FIT_UNKNOWNS_MOST];
  double chi2, dof;
  size_t starts, agreed;
  bool described, converged;
} aspi_fit;

/* Leaves the model at the values found. ASP_ENOMEM, or ASP_EDATA: no values make a model. */
asp_code aspi_fit_run(const aspi_fit_problem *problem, aspi_fit *fit, asp_error *error);

#endif
