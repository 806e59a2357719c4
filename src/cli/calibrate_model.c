/* What a wall gives for values of the unknowns of `asperity calibrate`: moments of the measured
 * velocities, at the places of the data, by the same random numbers whatever the values; see
 * calibrate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/stream.h"
#include "cli/calibrate.h"
#include "impact/wall.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A wall by its sigma has so long a correlation length, in diameters, that size does not matter. */
#define LENGTHS 1000

/* Fewer rebounds than this have no second moments that count. */
enum { SPREAD_LEAST = 5 };

double calibrate_scaled(const calibrate_unknown *u, double value) {
  return u->bounded ? log((value - u->least) / (u->most - value)) : log(value);
}

double calibrate_value(const calibrate_unknown *u, double scaled) {
  return u->bounded ? u->least + (u->most - u->least) / (1 + exp(-scaled)) : exp(scaled);
}

double calibrate_slope(const calibrate_unknown *u, double scaled) {
  double share = 1 / (1 + exp(-scaled));
  return u->bounded ? (u->most - u->least) * share * (1 - share) : exp(scaled);
}

static bool set_surface(calibration *c) {
  if (c->smooth)
    return true;
  double r_q = c->r_q, lambda_c = c->lambda_c;
  if (c->sigma >= 0) {
    lambda_c = LENGTHS * c->d_p;
    r_q = lambda_c * tan(cli_radians(c->sigma)) / sqrt(2);
  }
  asp_surface *surface = asp_surface_create_lay(r_q, lambda_c, c->stretch * lambda_c, NULL);
  if (!surface)
    return false;
  asp_wall_set_surface(c->law.wall, surface);
  asp_surface_free(c->rough.surface);
  c->rough.surface = surface;
  return true;
}

bool calibrate_set(calibration *c, const gsl_vector *scaled) {
  for (size_t i = 0; i < c->n_unknown; i++) {
    const calibrate_unknown *u = &c->unknown[i];
    double value = calibrate_value(u, gsl_vector_get(scaled, i));
    switch (u->kind) {
    case OF_SIGMA:
      c->sigma = value;
      break;
    case OF_RQ:
      c->r_q = value * 1e-6;
      break;
    case OF_LAMBDA_C:
      c->lambda_c = value * 1e-6;
      break;
    case OF_PAIR:
      if (asp_pair_set(c->pair, u->name, value, NULL))
        return false;
      break;
    default:
      if (asp_wall_set(c->law.wall, u->name, value, NULL))
        return false;
    }
  }
  if (c->rough.profile || c->rough.map) /* prepared before the search */
    return aspi_wall_renew(c->law.wall, NULL) == ASP_OK;
  return set_surface(c) && asp_wall_prepare(c->law.wall, NULL) == ASP_OK;
}

/* One impact of the model as it would be measured: x and y; false: a deposit. */
static bool measure(const calibration *c, const measured_row *row, uint64_t tag, double *x,
                    double *y, double *alpha) {
  static const double n[3] = {0, 0, 1};
  aspi_stream noise = aspi_stream_begin(&(asp_key){c->seed, 1, tag, 2});
  double error[4] = {0, 0, 0, 0};
  for (int i = 0; i < 4 && (c->noise_angle > 0 || c->noise_speed > 0); i++)
    error[i] = aspi_stream_normal(&noise);
  double degrees = row->degrees + c->noise_angle * error[0];
  degrees = degrees > 90 ? 180 - degrees : fmax(fabs(degrees), 1e-3);
  double v = isnan(row->v1) ? c->speed : row->v1, a1 = cli_radians(degrees);
  double v1[3] = {degrees < 90 ? v * cos(a1) : 0, 0, -v * sin(a1)};
  asp_particle particle = {isnan(row->d_p) ? c->d_p : row->d_p,
                           asp_material_get(c->law.particle, "density"),
                           c->pair,
                           {0, 0, 0},
                           c->rough.lay.vector};
  asp_impact impact;
  asp_wall_impact(c->law.wall, &particle, v1, n, &(asp_key){c->seed, 1, tag, 1}, &impact);
  if (impact.outcome == ASP_DEPOSIT)
    return false;
  asp_coefficients cor = asp_impact_coefficients(v1, n, &impact);
  double a2 = cor.alpha2 + cli_radians(c->noise_angle) * error[1];
  double share = cor.cor_v * (1 + c->noise_speed * error[2]) / (1 + c->noise_speed * error[3]);
  double side = degrees < 90 ? impact.v2[1] / v : 0; /* out of the plane: no part of CoR_T */
  double in_plane = sqrt(fmax(0, cor.cor_v * cor.cor_v - side * side));
  share *= cor.cor_v > 0 ? in_plane / cor.cor_v : 0;
  *x = share * sin(a2);
  *y = share * cos(a2);
  *alpha = cli_radians(row->degrees);
  return true;
}

/* The moments of what was collected, and the covariance of their terms. */
typedef struct collected {
  double (*xy)[2];
  size_t count, stuck;
} collected;

static void moments_of(const collected *s, double moment[MOMENTS],
                       double covariance[MOMENTS][MOMENTS]) {
  double n = (double)s->count, all = n + (double)s->stuck;
  memset(moment, 0, MOMENTS * sizeof *moment);
  for (size_t i = 0; i < s->count; i++) {
    moment[MEAN_X] += s->xy[i][0] / n;
    moment[MEAN_Y] += s->xy[i][1] / n;
  }
  moment[STUCK] = (double)s->stuck / all;
  double term[MOMENTS] = {0};
  for (int pass = 0; pass < 2; pass++) { /* second moments, then the covariance of all terms */
    if (pass && covariance)
      memset(covariance, 0, MOMENTS * sizeof *covariance);
    for (size_t i = 0; i < s->count; i++) {
      double x = s->xy[i][0] - moment[MEAN_X], y = s->xy[i][1] - moment[MEAN_Y];
      if (pass == 0) {
        moment[VAR_X] += x * x / (n - 1);
        moment[VAR_Y] += y * y / (n - 1);
        moment[COV_XY] += x * y / (n - 1);
        continue;
      }
      term[MEAN_X] = x;
      term[MEAN_Y] = y;
      term[VAR_X] = x * x - moment[VAR_X];
      term[VAR_Y] = y * y - moment[VAR_Y];
      term[COV_XY] = x * y - moment[COV_XY];
      for (int k = 0; k < STUCK; k++)
        for (int l = 0; l < STUCK; l++)
          covariance[k][l] += term[k] * term[l] / (n - 1);
    }
    if (!covariance)
      return;
  }
  /* Of one impact: moments of rebounds are of as many as rebound. */
  for (int k = 0; k < STUCK; k++)
    for (int l = 0; l < STUCK; l++)
      covariance[k][l] *= all / n;
  double share = ((double)s->stuck + 0.5) / (all + 1);
  covariance[STUCK][STUCK] = share * (1 - share);
}

void calibrate_moments(const calibration *c, double (*moment)[MOMENTS],
                       double (*covariance)[MOMENTS][MOMENTS]) {
  for (size_t b = 0; b < c->n_bins; b++) {
    const calibrate_bin *bin = &c->bins[b];
    collected s = {cli_allocate(c->samples, sizeof *s.xy), 0, 0};
    for (size_t i = 0; i < c->samples; i++) {
      const measured_row *row = &c->data.rows[bin->first + i % (bin->end - bin->first)];
      double alpha;
      if (measure(c, row, b * c->samples + i, &s.xy[s.count][0], &s.xy[s.count][1], &alpha))
        s.count++;
      else
        s.stuck++;
    }
    moments_of(&s, moment[b], covariance ? covariance[b] : NULL);
    free(s.xy);
  }
}

void calibrate_take_data(calibration *c, calibrate_bin *bin) {
  collected s = {cli_allocate(bin->end - bin->first, sizeof *s.xy), 0, 0};
  bool has_x = true, has_y = true;
  for (size_t i = bin->first; i < bin->end; i++) {
    const measured_row *row = &c->data.rows[i];
    double alpha = cli_radians(row->degrees);
    if (row->deposit) {
      s.stuck++;
      continue;
    }
    has_x = has_x && isfinite(row->cor[COR_N]);
    has_y = has_y && isfinite(row->cor[COR_T]);
    s.xy[s.count][0] = row->cor[COR_N] * sin(alpha);
    s.xy[s.count++][1] = row->cor[COR_T] * cos(alpha);
  }
  bool spread = s.count >= SPREAD_LEAST && !c->smooth;
  bin->n = (double)(s.count + s.stuck);
  bin->used[MEAN_X] = has_x && s.count > 0;
  bin->used[MEAN_Y] = has_y && s.count > 0;
  bin->used[VAR_X] = has_x && spread;
  bin->used[VAR_Y] = has_y && spread;
  bin->used[COV_XY] = has_x && has_y && spread;
  bin->used[STUCK] = c->data.has_outcome && c->sticks;
  moments_of(&s, bin->moment, s.count > 1 ? bin->covariance : NULL);
  free(s.xy);
}

void calibrate_coefficients(const calibration *c, size_t b, double mean[COR_BOTH],
                            double sd[COR_BOTH]) {
  const calibrate_bin *bin = &c->bins[b];
  double n = 0;
  for (int k = 0; k < COR_BOTH; k++)
    mean[k] = sd[k] = 0;
  for (size_t i = 0; i < c->samples; i++) {
    const measured_row *row = &c->data.rows[bin->first + i % (bin->end - bin->first)];
    double xy[2], alpha;
    if (!measure(c, row, b * c->samples + i, &xy[0], &xy[1], &alpha))
      continue;
    double cor[COR_BOTH] = {xy[0] / sin(alpha), row->degrees < 90 ? xy[1] / cos(alpha) : NAN};
    n++;
    for (int k = 0; k < COR_BOTH; k++) { /* Welford's running moments */
      double step = cor[k] - mean[k];
      mean[k] += step / n;
      sd[k] += step * (cor[k] - mean[k]);
    }
  }
  for (int k = 0; k < COR_BOTH; k++) {
    sd[k] = n > 1 ? sqrt(sd[k] / (n - 1)) : NAN;
    mean[k] = n > 0 ? mean[k] : NAN;
  }
}
