/* The slope of a wall over particle size and direction, for the core.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"

#include <math.h>

/* kappa of asp_surface_kappa, by phi_r = r_q/lambda_c. */
static inline double aspi_kappa(double d_p, double phi_r, double lambda_c) {
  return sqrt(3) * d_p * phi_r / lambda_c;
}

/* Length of a face over lambda_c (asp_surface_face_length). */
#define ASPI_FACE_LENGTH (ASP_PI / sqrt(2))

/* Below this kappa the filter reduces the slope by less than 1e-4 and is left out. */
#define ASPI_KAPPA_NO_FILTER 0.08

/* The rms slopes that a sphere of diameter d_p meets across the lay, and along it: with kappa_i =
 * sqrt(3) d_p r_q/lambda_i^2, s_i (1 + kappa_i^2 (0.92 kappa_i + 0.37 kappa_j))^(-1/6), which was
 * derived for this project and compared with dilations of surfaces: within 2 % for kappa up to 4,
 * 4 % high at 8, and lambda_2/lambda_1 from 1 to 10, for small slopes. Steep ones are filtered
 * less: at phi_r 0.25 the law is 5 % low at kappa 1 and 1.5 (s_eff/s is 0.91 and 0.79), 4 % at 2, 1
 * % at 4 (the test unit_ball prints it). Beyond phi_r = 0.25 it is corrected as the law of a disc;
 * on a wall by its profile it is the disc's own slope times aspi_sphere_over_disc. */
void aspi_surface_sphere_slopes(const asp_surface *surface, double d_p, double slope[2]);

/* s_eff of a disc on the profile along a direction in which the autocorrelation falls to 1/e at
 * lambda_c/sqrt(part), 0 < part <= 1 where the lay is the longer way. */
double aspi_surface_slope_along(const asp_surface *surface, double d_p, double part);

/* s_eff/s of a Gaussian profile closed by a disc, kappa >= 0: 1 when nothing is filtered,
 *   s_eff = s (1 + 0.92 kappa^3)^(-1/6).
 * Against generated profiles, kappa up to 16: within 3 % at phi_r 0.05, up to 5 % low at 0.25; 5 %
 * high at kappa 64. */
double aspi_closed_form(double kappa);

/* The slope that a sphere meets over that of a disc, on a wall without a lay: fitted to spheres and
 * discs on generated surfaces and profiles, which have 0.978, 0.950, 0.924, 0.908 and 0.897 at
 * kappa 1, 2, 4, 10 and 20, with phi_r 0.125. The ratio of both laws is 5 % high at the last. */
double aspi_sphere_over_disc(double kappa);

/* A Gaussian wall by its slope alone, which is that for all diameters; lambda_c, which gives the
 * length of its faces, may be NAN. */
asp_surface *aspi_surface_create_slope(double slope, double lambda_c, asp_error *error);

/* lambda_along/lambda_c. */
double aspi_surface_stretch(const asp_surface *surface);

/* The two numbers of a Gaussian wall that particles of up to d_p meet as they do this one: of a
 * wall by its slope alone in proportion to d_p. */
void aspi_surface_gaussian(const asp_surface *surface, double d_p, double *r_q, double *lambda_c);

/* A copy; NULL when out of memory. */
asp_surface *aspi_surface_copy(const asp_surface *surface);
