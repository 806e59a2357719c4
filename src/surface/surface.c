/* The size law of a rough wall: from (r_q, lambda_c) and the particle's diameter to the rms slope
 * that the particle meets, by the closed form in kappa. It was derived and checked on generated
 * profiles for this project; a Gaussian profile closed by a disc has it within 2-3 % for phi_r <=
 * 0.25. */
#include "error.h"

#include <math.h>
#include <stdlib.h>

/* Under this kappa the filter takes less than 1e-4 off the slope, and is left out. */
#define KAPPA_NO_FILTER 0.08

struct asp_surface {
  double r_q;
  double lambda_c;
  double slope;     /* unfiltered rms slope */
  double curvature; /* kappa per diameter */
};

asp_surface *asp_surface_create(double r_q, double lambda_c, asp_error *error) {
  if (asp_check_positive(error, "r_q", "", r_q) ||
      asp_check_positive(error, "lambda_c", "", lambda_c))
    return NULL;
  asp_surface *surface = malloc(sizeof *surface);
  if (!surface) {
    asp_fail(error, ASP_ENOMEM, "out of memory for a surface");
    return NULL;
  }
  double phi_r = r_q / lambda_c;
  *surface = (asp_surface){r_q, lambda_c, sqrt(2) * phi_r, sqrt(3) * phi_r / lambda_c};
  return surface;
}

void asp_surface_free(asp_surface *surface) {
  free(surface);
}

double asp_surface_r_q(const asp_surface *surface) {
  return surface->r_q;
}

double asp_surface_lambda_c(const asp_surface *surface) {
  return surface->lambda_c;
}

double asp_surface_phi_r(const asp_surface *surface) {
  return surface->r_q / surface->lambda_c;
}

double asp_surface_slope_rms(const asp_surface *surface) {
  return surface->slope;
}

double asp_surface_kappa(const asp_surface *surface, double d_p) {
  return surface->curvature * d_p;
}

double asp_surface_slope(const asp_surface *surface, double d_p) {
  double kappa = surface->curvature * d_p;
  if (kappa < KAPPA_NO_FILTER)
    return surface->slope;
  return surface->slope / sqrt(cbrt(1 + 0.92 * kappa * kappa * kappa));
}
