/* The constants of a wall and of a law from moments of measured impacts. The model simulates
 * impacts with the same random numbers whatever the values of its unknowns, so that the differences
 * of moments are smooth in them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "analysis/impacts.h"
#include "asperity_internal.h"

#include <stdint.h>

enum { FIT_UNKNOWNS_MOST = 8 };

typedef struct aspi_unknown {
  const char *name;
  char unit[20]; /* of SI, as the description has it, or degrees */
  enum { OF_SURFACE, OF_PAIR, OF_LAW } kind;
  double default_value; /* the design of the search is around it, whatever the start */
  double start, least, most;
  bool bounded; /* bounds at most 10 apart: logistic scale; otherwise logarithm */
  /* On that scale, on which 1 is a big change: the start, the bounds, the box of the design. */
  double scaled_start, low, high, from, to;
} aspi_unknown;

/* Means of rebounds, x = v_N2/v1 and y = v_T2/v1, which are bounded where CoR_N and CoR_T are not;
 * their variances; and the share of deposits. */
enum { MOMENT_X, MOMENT_Y, MOMENT_XX, MOMENT_YY, MOMENT_STUCK, MOMENTS };

typedef struct aspi_bin_moments {
  double rebounds, all; /* impacts */
  double of[MOMENTS];   /* NAN without rebounds, but for the share of deposits */
  /* Covariances of one rebound's x, y, and their squares about the means. */
  double covariance[MOMENT_STUCK][MOMENT_STUCK];
} aspi_bin_moments;

/* Rows of the data at one place or at several close ones, and their moments. */
typedef struct aspi_calibration_bin {
  size_t first, end; /* rows of the data */
  double degrees;
  aspi_bin_moments moments;
  bool used[MOMENTS];
  bool data_weighted; /* the data state the errors of the means */
} aspi_calibration_bin;

typedef struct aspi_calibration {
  aspi_scatter data;
  aspi_calibration_bin *bins;
  size_t n_bins;
  aspi_unknown unknown[FIT_UNKNOWNS_MOST];
  size_t n_unknown;
  asp_description *words;
  asp_wall *wall; /* made of `words`, at the values that were tried last */
  asp_pair *pair; /* NULL: the law needs none */
  double density, d_p, speed;
  /* Measurement noise: sd of impact and rebound angle (degrees), relative sd of the speeds. */
  double noise[COR_BOTH], noise_speed;
  size_t samples;
  uint32_t seed;
  bool smooth, sticks,
      has_errors; /* has_errors: the errors of the data are stated and need no scale */
  bool moves;     /* the surface is unknown */
  void (*progress)(void *context, double share); /* may be NULL */
  void *progress_context;
} aspi_calibration;

typedef struct aspi_fit {
  double at[FIT_UNKNOWNS_MOST], error[FIT_UNKNOWNS_MOST]; /* on the scale */
  double correlation[FIT_UNKNOWNS_MOST][FIT_UNKNOWNS_MOST];
  double low[FIT_UNKNOWNS_MOST], high[FIT_UNKNOWNS_MOST]; /* -INFINITY, INFINITY: at the bound */
  double chi2, dof;
  double model_chi2; /* by the weights of the model, where it does not describe the data */
  size_t starts, agreed;
  bool described, converged;
} aspi_fit;

/* The value of a scaled unknown, and d value/d scaled. */
double aspi_unknown_value(const aspi_unknown *u, double scaled);
double aspi_unknown_slope(const aspi_unknown *u, double scaled);

/* Makes the wall of some values of the unknowns; false: there is none. */
bool aspi_calibration_set(const aspi_calibration *c, const double *scaled);

/* Moments of impacts of the model at the places of a bin; xy is scratch for `samples` of them.
 * Draws depend on the bin and the number of the impact; the data's own are others. */
aspi_bin_moments aspi_calibration_simulate(const aspi_calibration *c, size_t bin, size_t samples,
                                           double (*xy)[COR_BOTH]);

/* Moments of rebounds and deposits. */
aspi_bin_moments aspi_calibration_moments(double (*xy)[COR_BOTH], size_t rebounds, size_t deposits);

/* Puts the data into bins of that width (degrees) and finds their moments. ASP_EARG: fewer moments
 * than unknowns. */
asp_code aspi_calibration_take_data(aspi_calibration *c, double width, asp_error *error);

/* Finds the unknowns and sets the wall to them. ASP_ENOMEM, or ASP_EDATA: no values make a wall.
 * Least squares of simulated moments (McFadden 1989), by GSL's nonlinear fit from the caller's
 * start and from points in a box around the default values, with weights of the data. If the number
 * of impacts is known, a second fit uses the model's covariance as weights, which few impacts
 * cannot give (quasi-likelihood, Wedderburn 1974); it counts if the model then describes the data.
 * An unknown whose end of the search the data do not exclude is held there. */
asp_code aspi_calibration_find(aspi_calibration *c, aspi_fit *fit, asp_error *error);

/* Means and standard deviations of the model's CoR_N and CoR_T at the mean angle of a bin. False:
 * out of memory. */
bool aspi_calibration_coefficients(const aspi_calibration *c, size_t bin, double mean[COR_BOTH],
                                   double sd[COR_BOTH]);
