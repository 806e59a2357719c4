/* The constants of a wall and of a law from measured impacts: the unknowns, the measurements, and
 * the model's impacts for given unknowns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_CALIBRATE_H
#define ASP_ANALYSIS_CALIBRATE_H

#include "analysis/fit.h"
#include "analysis/impacts.h"

typedef struct aspi_unknown {
  const char *name;
  char unit[20]; /* of SI, as the description has it, or degrees */
  enum { OF_SURFACE, OF_PAIR, OF_LAW } kind;
  double standard; /* the design of the search is around it, whatever the start */
  double start, least, most;
  bool bounded; /* between least and most, both finite and near: a logistic scale, else its log */
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
  asp_wall *wall;
  asp_pair *pair;                        /* NULL: the law needs none */
  const asp_material *particle, *target; /* alike */
  const double *lay;                     /* NULL: none */
  double density, d_p, speed;
  double noise[COR_BOTH], noise_speed; /* of both angles, degrees; of both speeds, a share */
  double huber;                        /* in robust standard deviations; INFINITY: none */
  size_t samples;
  uint32_t seed;
  bool smooth, sticks, known; /* known: the errors of the data are, and need no scale */
  bool moves;                 /* the surface is unknown */
  void (*progress)(void *context, double share); /* may be NULL */
  void *progress_context;
} aspi_calibration;

/* Between an unknown's value and the scale that it is looked for on. */
double aspi_unknown_scaled(const aspi_unknown *u, double value);
double aspi_unknown_value(const aspi_unknown *u, double scaled);
double aspi_unknown_slope(const aspi_unknown *u, double scaled); /* d value/d scaled */

/* The functions of aspi_fit_problem; the context is the calibration. */
bool aspi_calibration_set(void *context, const double *scaled);
void aspi_calibration_draw(void *context, size_t bin, size_t samples, uint32_t stream,
                           aspi_cloud *to);

/* The impacts of a bin's rows, and which of their moments there are. False: out of memory. */
bool aspi_calibration_take_impacts(const aspi_calibration *c, size_t bin);

/* Puts the data into bins of that width (degrees), and those into groups of moments. ASP_EARG:
 * fewer moments than unknowns. */
asp_code aspi_calibration_take_data(aspi_calibration *c, double width, asp_error *error);

/* Finds the unknowns; see aspi_fit_run. */
asp_code aspi_calibration_find(aspi_calibration *c, aspi_fit *fit, asp_error *error);

/* Frees bins and groups. */
void aspi_calibration_free(aspi_calibration *c);

/* A sample of one bin as coefficients: means and standard deviations of CoR_N and CoR_T. */
void aspi_calibration_coefficients(const aspi_calibration *c, size_t bin, double mean[COR_BOTH],
                                   double sd[COR_BOTH]);

#endif
