/* The size law beyond what asperity.h says of it. */
#ifndef ASP_SURFACE_SIZE_LAW_H
#define ASP_SURFACE_SIZE_LAW_H

#include "asperity.h"

/* What rolls over what. */
typedef enum aspi_filter {
  ASP_FILTER_DISC,  /* a disc on a profile (the paper) */
  ASP_FILTER_SPHERE /* a sphere on an isotropic surface: it finds a little less slope */
} aspi_filter;

/* asp_surface_create with the filter as chosen; a sphere up to phi_r = 0.25, by a table of small
 * slopes: its s_eff is within 3 % up to phi_r = 0.1, and up to 6 % low at 0.25. */
asp_surface *aspi_surface_create_filter(double r_q, double lambda_c, aspi_filter filter,
                                        asp_error *error);

/* The largest d_p that the size law has been checked for. */
double aspi_surface_d_p_most(const asp_surface *surface);

/* s_eff/s of a Gaussian profile closed by a disc, kappa >= 0: 1 when nothing is filtered,
 *   s_eff = s (1 + 0.92 kappa^3)^(-1/6).
 * Against generated profiles, kappa up to 16: within 3 % at phi_r 0.05, up to 5 % low at 0.25; 5 %
 * high at kappa 64. */
double aspi_closed_form(double kappa);

#endif
