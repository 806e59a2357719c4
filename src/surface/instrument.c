/* A Gaussian wall from the numbers that instruments print, by its distribution of heights and its
 * autocorrelation exp(-x^2/lambda_c^2); see instrument.h. R_Sm of ISO 4287 has no closed form: the
 * height that an element must have grows with R_z, and so with the sampling length.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/instrument.h"
#include "base/tolerances.h"
#include "surface/size_law.h"
#include "surface/rsm_table.inc"

#include <math.h>

enum { ROWS = sizeof rsm_table / sizeof *rsm_table, HALVINGS = 60 };

double aspi_r_q_of_r_a(double r_a) {
  return sqrt(ASP_PI / 2) * r_a;
}

double aspi_lambda_of_r_dq(double r_q, double r_dq) {
  return sqrt(2) * r_q / r_dq;
}

double aspi_lambda_of_s_dq(double s_q, double s_dq) {
  return 2 * s_q / s_dq;
}

double aspi_lambda_of_s_al(double s_al) {
  return s_al / sqrt(log(5));
}

double aspi_r_sm_factor(double sampling) {
  double at = fmin(fmax(2 * log2(sampling / RSM_FIRST), 0), ROWS - 1);
  int row = at < ROWS - 1 ? (int)at : ROWS - 2;
  return rsm_table[row] + (at - row) * (rsm_table[row + 1] - rsm_table[row]);
}

double aspi_lambda_of_r_sm(double r_sm, double sampling) {
  double low = ASPI_RSM_LEAST, high = ASPI_RSM_MOST, share = r_sm / sampling;
  if (!(share <= aspi_r_sm_share(low) && share >= aspi_r_sm_share(high)))
    return NAN;
  for (int i = 0; i < HALVINGS; i++) {
    double middle = 0.5 * (low + high);
    *(aspi_r_sm_share(middle) > share ? &low : &high) = middle;
  }
  return sampling / (0.5 * (low + high));
}

/* By bisection up to phi_r 1. */
double aspi_r_dq_met(double r_q, double d_p, double slope) {
  double low = slope, high = sqrt(2), met[2] = {0, 0};
  for (int i = 0; i < HALVINGS && low < high; i++) {
    double middle = 0.5 * (low + high);
    asp_surface *wall = asp_surface_create(r_q, aspi_lambda_of_r_dq(r_q, middle), NULL);
    if (!wall)
      return NAN;
    aspi_surface_sphere_slopes(wall, d_p, met);
    asp_surface_free(wall);
    *(met[0] < slope ? &low : &high) = middle;
  }
  return fabs(met[0] - slope) <= ASPI_ROUNDING_TEXT * slope ? low : NAN;
}
