/* The constants of a wall and of a law from moments of measured impacts. The model simulates
 * impacts with the same random numbers whatever the values of its unknowns, so that the differences
 * of moments are smooth in them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_CALIBRATE_H
#define ASP_ANALYSIS_CALIBRATE_H

#include "analysis/impacts.h"
#include "analysis/weights.h"
#include "asperity.h"

#include <stdint.h>

enum { FIT_UNKNOWNS_MOST = 8 };

typedef struct aspi_unknown {
  const char *name;
  char unit[20]; /* of SI, as the description has it, or degrees */
  enum { OF_SURFACE, OF_PAIR, OF_LAW } kind;
  double standard; /* the design of the search is around it, whatever the start */
  double start, least, most;
  bool bounded; /* between least and most, both finite and near: a logistic scale, else its log */
  /* On that scale, on which 1 is a big change: the start, the bounds, the box of the design. */
  double scaled_start, low, high, from, to;
} aspi_unknown;

/* Measurements at one place, or at some close ones; what they are is in the group of that number.
 */
typedef struct aspi_calibration_bin {
  size_t first, end; /* rows of the data */
  double degrees;
} aspi_calibration_bin;

typedef struct aspi_calibration {
  aspi_measured data;
  aspi_calibration_bin *bins;
  aspi_group *groups; /* of each bin: x = v_N2/v1 and y = v_T2/v1 of rebounds, which are bounded */
  size_t n_bins;      /* where CoR_N and CoR_T are not */
  aspi_unknown unknown[FIT_UNKNOWNS_MOST];
  size_t n_unknown;
  asp_description *words;
  asp_wall *wall;                        /* of them, for the values looked at last */
  asp_pair *pair;                        /* NULL: the law needs none */
  const asp_material *particle, *target; /* alike */
  const double *lay;                     /* NULL: none */
  double density, d_p, speed;
  double noise[COR_BOTH], noise_speed; /* of both angles, degrees; of both speeds, a share */
  double huber;                        /* in robust standard deviations; INFINITY: none */
  size_t samples;
  uint32_t seed;
  bool smooth, sticks, known; /* known: the errors of the data are, and need no scale */
  bool scatters;              /* the model's impacts at one place differ */
  bool moves;                 /* the surface is unknown */
  void (*progress)(void *context, double share); /* may be NULL */
  void *progress_context;
} aspi_calibration;

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

/* The value on the scale on which an unknown is looked for, and d value/d scaled. */
double aspi_unknown_value(const aspi_unknown *u, double scaled);
double aspi_unknown_slope(const aspi_unknown *u, double scaled);

/* Makes the wall of some values of the unknowns; false: there is none. */
bool aspi_calibration_set(const aspi_calibration *c, const double *scaled);

/* Impacts of the model at the places of a bin; xy has room for them. Draws depend on the bin, the
 * stream and the number of the impact; the data's own are none of stream 0. */
void aspi_calibration_draw(const aspi_calibration *c, size_t bin, size_t samples, uint32_t stream,
                           aspi_cloud *to);

/* The impacts of a bin's rows, and which of their moments there are. False: out of memory. */
bool aspi_calibration_take_impacts(const aspi_calibration *c, size_t bin);

/* Puts the data into bins of that width (degrees), and those into groups of moments. ASP_EARG:
 * fewer moments than unknowns. */
asp_code aspi_calibration_take_data(aspi_calibration *c, double width, asp_error *error);

/* Finds the unknowns and leaves the wall at them. ASP_ENOMEM, or ASP_EDATA: no values make a wall.
 * The minimum is looked for from the best points of a design that does not depend on the caller's
 * start, by the likelihood that the moments would have if they were normal with the covariance of
 * data and model together. The start is one more point; its end counts only where it is better by
 * more than noise, so that all starts have the same result. At the best end, weights are taken from
 * the model, and least squares and weights take turns until neither changes (quasi-likelihood,
 * Wedderburn 1974). */
asp_code aspi_calibration_find(aspi_calibration *c, aspi_fit *fit, asp_error *error);

/* A sample of one bin as coefficients: means and standard deviations of CoR_N and CoR_T. */
void aspi_calibration_coefficients(const aspi_calibration *c, size_t bin, double mean[COR_BOTH],
                                   double sd[COR_BOTH]);

#endif
