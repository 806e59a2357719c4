/* What `asperity calibrate` is made of: the unknowns, the measurements as moments, and the model's
 * moments for given unknowns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_CALIBRATE_H
#define ASP_CLI_CALIBRATE_H

#include "cli/law.h"
#include "cli/measured.h"
#include "cli/walls.h"

#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>

/* The options of the command. */
enum {
  FIT,
  ROUGH,
  MODEL = ROUGH + ROUGH_OPTIONS,
  TILT,
  COLLISIONS,
  DP,
  SPEED,
  NOISE,
  BIN,
  SAMPLES,
  SEED,
  OUTPUT,
  PLOT,
  LAW,
  N = LAW + LAW_OPTIONS
};

enum { UNKNOWNS_MOST = 8 };

/* Moments of a bin: of x = v_N2/v1 and y = v_T2/v1 of rebounds, which are bounded where CoR_N and
 * CoR_T are not, and the share of deposits. */
enum { MEAN_X, MEAN_Y, VAR_X, VAR_Y, COV_XY, STUCK, MOMENTS };

typedef struct calibrate_unknown {
  char name[40];
  const char *unit;
  enum { OF_SIGMA, OF_RQ, OF_LAMBDA_C, OF_PAIR, OF_LAW } kind;
  double start, least, most;
  bool bounded; /* between least and most, both finite and near: a logistic scale, else its log */
} calibrate_unknown;

/* Measurements at one place, or at some close ones. */
typedef struct calibrate_bin {
  size_t first, end; /* rows of the data */
  double n;          /* impacts; 1 where it is not known */
  double degrees;
  double moment[MOMENTS];
  double covariance[MOMENTS][MOMENTS]; /* of the moments, from the data; where the wall is smooth */
  bool used[MOMENTS];
} calibrate_bin;

typedef struct calibration {
  const cli_option *options;
  measured data;
  calibrate_bin *bins;
  size_t n_bins, n_moments; /* moments that are used, of all bins */
  calibrate_unknown unknown[UNKNOWNS_MOST];
  size_t n_unknown;
  cli_law law;
  asp_pair *pair;
  cli_rough rough; /* no surface: smooth; no profile or map: made of what follows */
  double sigma, r_q, lambda_c, stretch; /* of the lay; sigma < 0: by r_q */
  double d_p, speed, noise_angle, noise_speed;
  size_t samples;
  uint32_t seed;
  bool smooth, sticks, known; /* known: the errors of the data are, and need no scale */
} calibration;

/* Between an unknown's value and the scale that it is looked for on. */
double calibrate_scaled(const calibrate_unknown *u, double value);
double calibrate_value(const calibrate_unknown *u, double scaled);
double calibrate_slope(const calibrate_unknown *u, double scaled); /* d value/d scaled */

/* Puts values into the wall; false where no such wall can be. */
bool calibrate_set(calibration *c, const gsl_vector *scaled);

/* The moments of a bin's rows, which are impacts, and which of them there are. */
void calibrate_take_data(calibration *c, calibrate_bin *bin);

/* The moments of all bins, one after the other, and, where wanted, the covariance of the moments of
 * one impact, in blocks of MOMENTS x MOMENTS. The same draws for all values of the unknowns. */
void calibrate_moments(const calibration *c, double (*moment)[MOMENTS],
                       double (*covariance)[MOMENTS][MOMENTS]);

/* A sample of one bin as coefficients: means and standard deviations of CoR_N and CoR_T. */
void calibrate_coefficients(const calibration *c, size_t bin, double mean[COR_BOTH],
                            double sd[COR_BOTH]);

/* The unknowns on their scale and the covariance of those, both to be freed; the sum of squares and
 * the degrees of freedom; and whether the model describes the data. */
typedef struct calibrate_fit {
  gsl_vector *scaled;
  gsl_matrix *covariance;
  double chi2, dof;
  bool described;
} calibrate_fit;

/* Finds the values of the unknowns, and puts them into the wall. */
calibrate_fit calibrate_run(calibration *c);

void cli_calibrate_plot(const cli_option *option, const calibration *c, const char *data,
                        const char *title);

#endif
