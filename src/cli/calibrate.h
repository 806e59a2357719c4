/* What `asperity calibrate` is made of: the unknowns, the measurements, and the model's
 * impacts for given unknowns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_CALIBRATE_H
#define ASP_CLI_CALIBRATE_H

#include "analysis/fit.h"
#include "cli/description.h"
#include "cli/measured.h"

/* The options of the command. */
enum {
  DP,
  SPEED,
  NOISE,
  HUBER,
  MEASURED,
  BIN = MEASURED + MEASURED_OPTION_COUNT,
  SAMPLES,
  OUTPUT,
  PLOT,
  N = PLOT + PLOT_OPTIONS
};

typedef struct calibrate_unknown {
  const char *name;
  char unit[20]; /* of SI, as the description has it, or degrees */
  enum { OF_SURFACE, OF_PAIR, OF_LAW } kind;
  double standard; /* the design of the search is around it, whatever the start */
  double start, least, most;
  bool bounded; /* between least and most, both finite and near: a logistic scale, else its log */
} calibrate_unknown;

/* Measurements at one place, or at some close ones; what they are is in the group of that number.
 */
typedef struct calibrate_bin {
  size_t first, end; /* rows of the data */
  double degrees;
} calibrate_bin;

typedef struct calibration {
  const cli_option *options;
  measured data;
  calibrate_bin *bins;
  aspi_group *groups; /* of each bin: x = v_N2/v1 and y = v_T2/v1 of rebounds, which are bounded */
  size_t n_bins;      /* where CoR_N and CoR_T are not */
  calibrate_unknown unknown[FIT_UNKNOWNS_MOST];
  size_t n_unknown;
  cli_description wall;
  double vector[3];
  const double *lay; /* that vector; NULL: none */
  double d_p, speed;
  double noise[COR_BOTH], noise_speed; /* of both angles, degrees; of both speeds, a share */
  double huber;                        /* in robust standard deviations; INFINITY: none */
  size_t samples;
  uint32_t seed;
  bool smooth, sticks, known; /* known: the errors of the data are, and need no scale */
  bool moves;                 /* the surface is unknown */
  cli_progress progress;
} calibration;

/* Between an unknown's value and the scale that it is looked for on. */
double calibrate_scaled(const calibrate_unknown *u, double value);
double calibrate_value(const calibrate_unknown *u, double scaled);
double calibrate_slope(const calibrate_unknown *u, double scaled); /* d value/d scaled */

/* The functions of aspi_fit_problem; the context is the calibration. */
bool calibrate_set(void *context, const double *scaled);
void calibrate_draw(void *context, size_t bin, size_t samples, uint32_t stream, aspi_cloud *to);

/* The impacts of a bin's rows, and which of their moments there are. */
void calibrate_take_impacts(const calibration *c, size_t bin);

/* A sample of one bin as coefficients: means and standard deviations of CoR_N and CoR_T. */
void calibrate_coefficients(const calibration *c, size_t bin, double mean[COR_BOTH],
                            double sd[COR_BOTH]);

void cli_calibrate_plot(const cli_option *option, const calibration *c, const char *data,
                        const char *title);

#endif
