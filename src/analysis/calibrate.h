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

/* Rows of the data at one place or at several close ones; the group of the same index has their
 * moments. */
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
  asp_wall *wall;                        /* made of `words`, at the values that were tried last */
  asp_pair *pair;                        /* NULL: the law needs none */
  const asp_material *particle, *target; /* alike */
  const double *lay;                     /* NULL: none */
  double density, d_p, speed;
  double noise[COR_BOTH], noise_speed; /* of both angles, degrees; of both speeds, a share */
  size_t samples;
  uint32_t seed;
  bool smooth, sticks, known; /* known: the errors of the data are stated and need no scale */
  bool moves;                 /* the surface is unknown */
  void (*progress)(void *context, double share); /* may be NULL */
  void *progress_context;
} aspi_calibration;

typedef struct aspi_fit {
  double at[FIT_UNKNOWNS_MOST], error[FIT_UNKNOWNS_MOST]; /* on the scale */
  double correlation[FIT_UNKNOWNS_MOST][FIT_UNKNOWNS_MOST];
  double rise[FIT_UNKNOWNS_MOST]; /* of chi2 at one error from its minimum */
  double low[FIT_UNKNOWNS_MOST], high[FIT_UNKNOWNS_MOST]; /* -INFINITY, INFINITY: at the bound */
  double chi2, dof;
  double first_chi2; /* before the weights were those of the data; chi2 if they need not be */
  size_t starts, agreed;
  bool described, converged;
} aspi_fit;

/* The value on the scale on which an unknown is looked for, and d value/d scaled. */
double aspi_unknown_value(const aspi_unknown *u, double scaled);
double aspi_unknown_slope(const aspi_unknown *u, double scaled);

/* Makes the wall of some values of the unknowns; false: there is none. */
bool aspi_calibration_set(const aspi_calibration *c, const double *scaled);

/* Impacts of the model at the places of a bin; xy has room for them. Draws depend on the bin and
 * the number of the impact; the data's own are others. */
void aspi_calibration_draw(const aspi_calibration *c, size_t bin, size_t samples, aspi_cloud *to);

/* The impacts of a bin's rows, and which of their moments there are. False: out of memory. */
bool aspi_calibration_take_impacts(const aspi_calibration *c, size_t bin);

/* Puts the data into bins of that width (degrees), and those into groups of moments. ASP_EARG:
 * fewer moments than unknowns. */
asp_code aspi_calibration_take_data(aspi_calibration *c, double width, asp_error *error);

/* Finds the unknowns and leaves the wall at them. ASP_ENOMEM, or ASP_EDATA: no values make a wall.
 * Simulated moments (McFadden 1989), weighed by the model's covariance where the errors of the data
 * are known and the model describes them. The minimum is looked for from the best points of a
 * design that does not depend on the caller's start, by the likelihood that the moments would have
 * if they were normal; the start is one more point, whose end counts only where it is better by
 * more than noise, so that all starts have the same result. From the best end, Gauss-Newton steps
 * with new weights at each go to the estimates (quasi-likelihood). With the last weights, the rise
 * of chi^2 makes the intervals. */
asp_code aspi_calibration_find(aspi_calibration *c, aspi_fit *fit, asp_error *error);

/* Means and standard deviations of the model's CoR_N and CoR_T at the mean angle of a bin. False:
 * out of memory. */
bool aspi_calibration_coefficients(const aspi_calibration *c, size_t bin, double mean[COR_BOTH],
                                   double sd[COR_BOTH]);

#endif
