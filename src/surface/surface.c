/* The rms slope of a rough wall over the particle's diameter. Three
 * kinds of wall share one form, a closed form times a correction over log2(d_p), made once:
 * - a Gaussian wall up to phi_r = 0.25: the closed form in kappa, which was derived for this
 *   project; no correction;
 * - a Gaussian wall beyond: corrected by the two-parameter table of size_table.inc;
 * - a measured profile: no closed form, its own slopes at the diameters of its bins.
 * A wall by its slope alone has that slope for all diameters, and no height.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/monotone.h"
#include "surface/describe.h"
#include "surface/heights.h"
#include "surface/size_law.h"
#include "surface/slopes.h"
#include "surface/size_table.inc"
#include "base/tolerances.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Under this ratio of the two lengths a map has no lay to speak of. */
#define STRETCH_LEAST 1.05

/* The closed form has been compared with generated profiles up to here, where it is 5 % high. */
#define KAPPA_MOST 64.0

/* Beyond this phi_r the closed form gives way to the table. */
#define PHI_R_CLOSED 0.25

/* A Gaussian wall of this lambda_c over d_p is met by points. */
#define POINTS 1e6

struct asp_surface {
  double r_q;          /* this and the next two NAN if they are not known */
  double lambda_c;     /* that of its faces, too */
  double lambda_along; /* along the lay; lambda_c without a lay */
  double stretch;      /* lambda_along/lambda_c */
  double phi_r;
  double slope;     /* unfiltered rms slope */
  double curvature; /* kappa per diameter */
  double d_p_most;
  bool closed_form;
  double uncertainty; /* of one by its profile */
  int bins;
  /* The correction: monotone cubic pieces between nodes at equal steps of log2(d_p), level at both
   * ends. */
  int nodes;
  double log_first, per_step;
  double *tangent; /* behind the values; per step */
  double value[];
};

/* ---- making ---- */

double aspi_closed_form(double kappa) {
  return kappa < ASPI_KAPPA_NO_FILTER ? 1 : 1 / sqrt(cbrt(1 + 0.92 * kappa * kappa * kappa));
}

static asp_surface *allocate(int nodes, asp_error *error) {
  asp_surface *surface = calloc(1, sizeof *surface + 2 * (size_t)nodes * sizeof *surface->value);
  if (!surface)
    return aspi_fail_null(error, ASP_ENOMEM, "out of memory for a surface");
  surface->nodes = nodes;
  surface->stretch = 1;
  surface->tangent = surface->value + nodes;
  return surface;
}

static void set_tangents(asp_surface *surface) {
  int last = surface->nodes - 1;
  if (last > 0)
    aspi_monotone_tangents(NULL, surface->value, (size_t)surface->nodes, surface->tangent);
  surface->tangent[0] = surface->tangent[last] = 0;
}

static void set_range(asp_surface *surface, double d_least, double d_most) {
  surface->log_first = log2(d_least);
  surface->per_step =
      surface->nodes > 1 ? (surface->nodes - 1) / (log2(d_most) - surface->log_first) : 0;
  surface->d_p_most = d_most;
}

/* Corrections for a phi_r between two rows of the table, linear between them. The row before the
 * first is the closed form, so the slope has no jump where the table begins. */
static void set_by_table(asp_surface *surface, double phi_r) {
  double at = (phi_r - PHI_R_CLOSED) / SIZE_TABLE_PHI_STEP;
  int below = (int)fmin(at, SIZE_TABLE_ROWS - 1);
  double part = at - below;
  for (int i = 0; i < SIZE_TABLE_COLUMNS; i++) {
    double size = SIZE_TABLE_SIZE_FIRST * pow(2, 0.5 * i), correction[2];
    for (int k = 0; k < 2; k++) {
      double phi = PHI_R_CLOSED + (below + k) * SIZE_TABLE_PHI_STEP;
      correction[k] = below + k == 0 ? 1
                                     : size_table[below + k - 1][i] /
                                           aspi_closed_form(aspi_kappa(size, phi, 1));
    }
    surface->value[i] = correction[0] + part * (correction[1] - correction[0]);
  }
  set_range(surface, SIZE_TABLE_SIZE_FIRST * surface->lambda_c,
            SIZE_TABLE_SIZE_FIRST * pow(2, 0.5 * (SIZE_TABLE_COLUMNS - 1)) * surface->lambda_c);
  set_tangents(surface);
}

static asp_code check_numbers(double r_q, double lambda_c, double phi_r_most, asp_error *error) {
  if (aspi_check_length(error, "r_q", r_q) || aspi_check_length(error, "lambda_c", lambda_c))
    return ASP_EARG;
  double phi_r = r_q / lambda_c;
  if (phi_r <= phi_r_most * (1 + ASPI_ROUNDING_DOUBLE))
    return ASP_OK;
  return aspi_fail(
      error, ASP_ERANGE,
      "r_q is %g and lambda_c %g: their ratio %g must be at most %g%s. Are the units right?", r_q,
      lambda_c, phi_r, phi_r_most, phi_r_most > PHI_R_CLOSED ? "" : " with a lay");
}

asp_surface *asp_surface_create(double r_q, double lambda_c, asp_error *error) {
  if (check_numbers(r_q, lambda_c, SIZE_TABLE_PHI_MOST, error))
    return NULL;
  double phi_r = r_q / lambda_c;
  bool table = phi_r > PHI_R_CLOSED;
  asp_surface *surface = allocate(table ? SIZE_TABLE_COLUMNS : 0, error);
  if (!surface)
    return NULL;
  surface->r_q = r_q;
  surface->lambda_c = surface->lambda_along = lambda_c;
  surface->phi_r = phi_r;
  surface->slope = sqrt(2) * phi_r;
  surface->curvature = aspi_kappa(1, phi_r, lambda_c);
  surface->closed_form = true;
  surface->d_p_most = KAPPA_MOST / surface->curvature;
  if (table)
    set_by_table(surface, phi_r);
  return surface;
}

asp_surface *aspi_surface_create_slope(double slope, double lambda_c, asp_error *error) {
  asp_surface *surface = allocate(0, error);
  if (!surface)
    return NULL;
  surface->r_q = NAN;
  surface->lambda_c = surface->lambda_along = lambda_c;
  surface->phi_r = slope / sqrt(2);
  surface->slope = slope;
  surface->closed_form = true;
  surface->d_p_most = INFINITY;
  return surface;
}

asp_surface *asp_surface_create_lay(double r_q, double lambda_c, double lambda_along,
                                    asp_error *error) {
  if (aspi_check_length(error, "lambda_c along the lay", lambda_along))
    return NULL;
  if (lambda_along <= lambda_c && lambda_along >= lambda_c)
    return asp_surface_create(r_q, lambda_c, error);
  if (check_numbers(r_q, lambda_c, PHI_R_CLOSED, error) ||
      check_numbers(r_q, lambda_along, PHI_R_CLOSED, error))
    return NULL;
  asp_surface *surface = asp_surface_create(r_q, lambda_c, error);
  if (surface) {
    surface->lambda_along = lambda_along;
    surface->stretch = lambda_along / lambda_c;
    surface->d_p_most *= fmin(1, lambda_along * lambda_along / (lambda_c * lambda_c));
  }
  return surface;
}

static asp_code check_bins(const asp_heights *profile, double d_min, double d_max, int bins,
                           asp_error *error) {
  aspi_extent extent = aspi_heights_extent(profile);
  if (!(d_min >= extent.spacing && d_min <= d_max && d_max <= extent.length))
    return aspi_fail(error, ASP_EARG,
                     "d_p is %g to %g; the profile's spacing and length allow %g to %g", d_min,
                     d_max, extent.spacing, extent.length);
  if (bins < 1 || bins > ASP_BINS_MAX)
    return aspi_fail(error, ASP_EARG, "bins are %d; they must be 1 to %d", bins, (int)ASP_BINS_MAX);
  return ASP_OK;
}

static asp_code set_by_profile(asp_surface *surface, const asp_heights *profile, double d_min,
                               double d_max, asp_error *error) {
  bool one = surface->nodes == 1;
  set_range(surface, one ? sqrt(d_min * d_max) : d_min, d_max);
  for (int i = 0; i < surface->nodes; i++) {
    aspi_slopes slopes;
    double d_p = fmin(fmax(asp_surface_bin_d_p(surface, i), d_min), d_max);
    asp_code code = aspi_profile_describe_slopes(profile, d_p, &slopes, error);
    if (code)
      return code;
    surface->value[i] = slopes.slope_rms;
  }
  set_tangents(surface);
  return ASP_OK;
}

asp_surface *asp_surface_create_profile(const asp_heights *profile, double d_min, double d_max,
                                        int bins, asp_error *error) {
  asp_heights_numbers d;
  if (check_bins(profile, d_min, d_max, bins, error) ||
      aspi_heights_judge(profile, d_min, &d, error))
    return NULL;
  if (d_min >= d_max)
    bins = 1;
  asp_surface *surface = allocate(bins, error);
  if (!surface)
    return NULL;
  surface->r_q = d.s_q;
  surface->lambda_c = surface->lambda_along = d.lambda_1;
  surface->phi_r = d.s_q / d.lambda_1;
  surface->slope = d.s_dq;
  surface->curvature = aspi_kappa(1, surface->phi_r, d.lambda_1);
  surface->bins = bins;
  surface->uncertainty = ASP_LENGTH_ERROR(aspi_heights_extent(profile).total / d.lambda_1);
  if (set_by_profile(surface, profile, d_min, d_max, error)) {
    free(surface);
    return NULL;
  }
  return surface;
}

asp_surface *aspi_surface_create_map(const asp_heights_numbers *d, bool lay, asp_error *error) {
  if (lay && d->lambda_2 > STRETCH_LEAST * d->lambda_1)
    return asp_surface_create_lay(d->s_q, d->lambda_1, d->lambda_2, error);
  return asp_surface_create(d->s_q, d->lambda_1, error);
}

asp_surface *aspi_surface_copy(const asp_surface *surface) {
  asp_surface *copy = allocate(surface->nodes, NULL);
  if (!copy)
    return NULL;
  double *tangent = copy->tangent;
  memcpy(copy, surface, sizeof *copy + 2 * (size_t)surface->nodes * sizeof *copy->value);
  copy->tangent = tangent;
  return copy;
}

void asp_surface_free(asp_surface *surface) {
  free(surface);
}

/* ---- reading ---- */

int asp_surface_bins(const asp_surface *surface) {
  return surface->bins;
}

double asp_surface_bin_d_p(const asp_surface *surface, int bin) {
  double step = surface->nodes > 1 ? 1 / surface->per_step : 0;
  return exp2(surface->log_first + bin * step);
}

double asp_surface_uncertainty(const asp_surface *surface) {
  return surface->uncertainty;
}

asp_code asp_surface_check(const asp_surface *surface, double d_p, asp_error *error) {
  if (d_p >= 0 && d_p <= surface->d_p_most * (1 + ASPI_ROUNDING_DOUBLE))
    return ASP_OK;
  return aspi_fail(error, ASP_ERANGE,
                   "d_p is %g; this wall's size law (r_q %g, lambda_c %g) is valid up to %g", d_p,
                   surface->r_q, surface->lambda_c, surface->d_p_most);
}

double asp_surface_r_q(const asp_surface *surface) {
  return surface->r_q;
}

double asp_surface_lambda_c(const asp_surface *surface) {
  return surface->lambda_c;
}

double asp_surface_lambda_along(const asp_surface *surface) {
  return surface->lambda_along;
}

/* Half of the mean distance of a profile's upward crossings of its mean line: 2 pi r_q/s for
 * Gaussian heights (Rice 1944), with s = sqrt(2) r_q/lambda_c. */
double asp_surface_face_length(const asp_surface *surface, double d_p) {
  return surface->lambda_c > 0 ? ASPI_FACE_LENGTH * surface->lambda_c : d_p;
}

double aspi_surface_stretch(const asp_surface *surface) {
  return surface->stretch;
}

void aspi_surface_gaussian(const asp_surface *surface, double d_p, double *r_q, double *lambda_c) {
  const bool known = surface->r_q > 0;
  *lambda_c = known ? surface->lambda_c : POINTS * d_p;
  *r_q = known ? surface->r_q : surface->phi_r * *lambda_c;
}

double asp_surface_phi_r(const asp_surface *surface) {
  return surface->phi_r;
}

double asp_surface_slope_rms(const asp_surface *surface) {
  return surface->slope;
}

double asp_surface_kappa(const asp_surface *surface, double d_p) {
  return surface->curvature * d_p;
}

/* The cubic piece that d_p is in; the first and last value beyond the nodes. */
static double correction(const asp_surface *surface, double d_p) {
  if (!(d_p > 0))
    return surface->value[0];
  double at = (log2(d_p) - surface->log_first) * surface->per_step;
  if (!(at > 0))
    return surface->value[0];
  if (at >= surface->nodes - 1)
    return surface->value[surface->nodes - 1];
  int i = (int)at;
  return aspi_cubic_piece(1, at - i, &surface->value[i], &surface->tangent[i]);
}

double asp_surface_slope(const asp_surface *surface, double d_p) {
  double slope = surface->slope;
  if (surface->closed_form)
    slope *= aspi_closed_form(surface->curvature * d_p);
  else
    slope = 1;
  return surface->nodes ? slope * correction(surface, d_p) : slope;
}

double aspi_surface_slope_along(const asp_surface *surface, double d_p, double part) {
  return surface->slope * sqrt(part) * aspi_closed_form(part * surface->curvature * d_p);
}

/* s_eff/s of a sphere along an axis. */
static double sphere_ratio(double kappa, double other) {
  return 1 / sqrt(cbrt(1 + kappa * kappa * (0.92 * kappa + 0.37 * other)));
}

double aspi_sphere_over_disc(double kappa) {
  return kappa >= ASPI_KAPPA_NO_FILTER ? 1 - 0.105 / (1 + pow(2.12 / kappa, 1.5)) : 1;
}

void aspi_surface_sphere_slopes(const asp_surface *surface, double d_p, double slope[2]) {
  double kappa = surface->curvature * d_p, short_way = 1 / surface->stretch;
  double other = kappa * short_way * short_way;
  if (surface->closed_form) {
    double steep = surface->nodes ? surface->slope * correction(surface, d_p) : surface->slope;
    bool filters = fmax(kappa, other) >= ASPI_KAPPA_NO_FILTER;
    slope[0] = steep * (filters ? sphere_ratio(kappa, other) : 1);
    slope[1] = steep * short_way * (filters ? sphere_ratio(other, kappa) : 1);
    return;
  }
  slope[0] = slope[1] = asp_surface_slope(surface, d_p) * aspi_sphere_over_disc(kappa);
}
