/* A Gaussian wall from the numbers that instruments print.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

/* R_q of R_a. */
double aspi_r_q_of_r_a(double r_a);

/* lambda_c of R_q and the rms slope of a profile R_dq, or of S_q and that of a surface S_dq; and of
 * S_al, the length at which the autocorrelation is 0.2. */
double aspi_lambda_of_r_dq(double r_q, double r_dq);
double aspi_lambda_of_s_dq(double s_q, double s_dq);
double aspi_lambda_of_s_al(double s_al);

/* R_dq of the wall by numbers with this R_q on which a sphere of diameter d_p meets an rms slope;
 * NAN: it meets none as steep on any. */
double aspi_r_dq_met(double r_q, double d_p, double slope);

/* R_Sm/lambda_c of ISO 4287 at a sampling length of ASPI_RSM_LEAST to ASPI_RSM_MOST lambda_c. */
#define ASPI_RSM_LEAST 4
#define ASPI_RSM_MOST 64
double aspi_r_sm_factor(double sampling);

/* lambda_c of R_Sm measured with that sampling length; NAN if it is not within that range. */
double aspi_lambda_of_r_sm(double r_sm, double sampling);

/* R_Sm over the sampling length, where that is this many lambda_c: it falls with it. */
static inline double aspi_r_sm_share(double sampling) {
  return aspi_r_sm_factor(sampling) / sampling;
}
