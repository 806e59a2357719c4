/* The model of a calibration: impacts simulated for given values of the unknowns, at the places of
 * the data, with the same random numbers for all values; see calibrate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/calibrate.h"
#include "base/units.h"
#include "base/stream.h"
#include "description/description.h"

#include <math.h>
#include <stdlib.h>

/* Each bin has its own range of tags. */
enum { TAGS_OF_A_BIN = 1 << 30 };

double aspi_unknown_value(const aspi_unknown *u, double scaled) {
  return u->bounded ? u->least + (u->most - u->least) / (1 + exp(-scaled)) : exp(scaled);
}

double aspi_unknown_slope(const aspi_unknown *u, double scaled) {
  double share = 1 / (1 + exp(-scaled));
  return u->bounded ? (u->most - u->least) * share * (1 - share) : exp(scaled);
}

bool aspi_calibration_set(const aspi_calibration *c, const double *scaled) {
  asp_description *words = c->words;
  for (size_t i = 0; i < c->n_unknown; i++) {
    const aspi_unknown *u = &c->unknown[i];
    double value = aspi_unknown_value(u, scaled[i]);
    if (asp_description_set(words, u->name, value, NULL) ||
        (u->kind == OF_PAIR && asp_pair_set(c->pair, u->name, value, NULL)))
      return false;
  }
  if (!c->moves) {
    const aspi_wall_choice choice = aspi_description_choice(words);
    aspi_wall_take_law(c->wall, &choice);
    return true;
  }
  asp_wall *made = asp_wall_create(words, 0, 0, NULL);
  if (made)
    aspi_wall_replace(c->wall, made);
  return made != NULL;
}

/* Adds measurement noise to a rebound: x and y are shares of v1. */
static void add_noise(const aspi_calibration *c, const double *normal, double *x, double *y) {
  double angle = atan2(*x, *y) + aspi_radians(c->noise[1]) * normal[1];
  double speed =
      hypot(*x, *y) * (1 + c->noise_speed * normal[2]) / (1 + c->noise_speed * normal[3]);
  *x = speed * sin(angle);
  *y = speed * cos(angle);
}

/* One impact of the model as it would be measured: x and y; false: no rebound is seen. */
static bool see_rebound(const aspi_calibration *c, const aspi_scatter_row *row, uint64_t tag,
                        double xy[COR_BOTH]) {
  static const double n[3] = {0, 0, 1};
  double normal[4] = {0, 0, 0, 0};
  bool noisy = c->noise[0] > 0 || c->noise[1] > 0 || c->noise_speed > 0;
  aspi_stream noise = aspi_stream_begin(&(asp_key){c->seed, 1, tag, 2, 0});
  for (int i = 0; i < 4 && noisy; i++)
    normal[i] = aspi_stream_normal(&noise);
  double degrees = row->degrees + c->noise[0] * normal[0];
  degrees = degrees > 90 ? 180 - degrees : fmax(fabs(degrees), 1e-3);
  double v = isnan(row->v1) ? c->speed : row->v1, a1 = aspi_radians(degrees);
  double v1[3] = {degrees < 90 ? v * cos(a1) : 0, 0, -v * sin(a1)};
  asp_particle particle = {
      .d_p = isnan(row->d_p) ? c->d_p : row->d_p, .density = c->density, .pair = c->pair};
  asp_impact impact;
  asp_wall_impact(c->wall, &particle, v1, n, &(asp_key){c->seed, 1, tag, 1, 0}, &impact);
  if (impact.outcome == ASP_DEPOSIT)
    return false;
  /* With v1 along the normal there is no plane of incidence: the whole tangential velocity counts.
   */
  bool all = c->data.projection == ASPI_IN_SPACE || !(v1[0] > 0);
  xy[COR_N] = impact.v2[2] / v;
  xy[COR_T] = (all ? hypot(impact.v2[0], impact.v2[1]) : impact.v2[0]) / v;
  if (!noisy)
    return true;
  add_noise(c, normal, &xy[COR_N], &xy[COR_T]);
  xy[COR_N] = fabs(xy[COR_N]);
  return true;
}

/* The row whose place impact i has. All rows come equally often; fewer impacts than rows are spread
 * over the bin, because rows are in order of their angle. */
static const aspi_scatter_row *row_of(const aspi_calibration *c, const aspi_calibration_bin *bin,
                                      size_t i, size_t samples) {
  double share = ((double)i + 0.5) / (double)samples;
  return &c->data.rows[bin->first + (size_t)(share * (double)(bin->end - bin->first))];
}

aspi_bin_moments aspi_calibration_simulate(const aspi_calibration *c, size_t b, size_t samples,
                                           double (*xy)[COR_BOTH]) {
  size_t rebounds = 0;
  for (size_t i = 0; i < samples; i++)
    rebounds +=
        see_rebound(c, row_of(c, &c->bins[b], i, samples), b * TAGS_OF_A_BIN + i, xy[rebounds]);
  return aspi_calibration_moments(xy, rebounds, samples - rebounds);
}

aspi_bin_moments aspi_calibration_moments(double (*xy)[COR_BOTH], size_t rebounds,
                                          size_t deposits) {
  double n = (double)rebounds, sum[COR_BOTH] = {0, 0};
  aspi_bin_moments m = {.rebounds = n, .all = n + (double)deposits};
  for (size_t i = 0; i < rebounds; i++)
    for (int k = 0; k < COR_BOTH; k++)
      sum[k] += xy[i][k];
  double mean[MOMENT_STUCK] = {sum[COR_N] / n, sum[COR_T] / n};
  double product[MOMENT_STUCK][MOMENT_STUCK] = {{0}};
  for (size_t i = 0; i < rebounds; i++) {
    double x = xy[i][COR_N] - mean[MOMENT_X], y = xy[i][COR_T] - mean[MOMENT_Y];
    double term[MOMENT_STUCK] = {x, y, x * x, y * y};
    for (int k = 0; k < MOMENT_STUCK; k++)
      for (int l = 0; l <= k; l++)
        product[k][l] += term[k] * term[l];
  }
  for (int k = 0; k < COR_BOTH; k++) {
    m.of[MOMENT_X + k] = mean[k];
    mean[MOMENT_XX + k] = product[k][k] / n;
    m.of[MOMENT_XX + k] = product[k][k] / fmax(1, n - 1);
  }
  for (int k = 0; k < MOMENT_STUCK; k++)
    for (int l = 0; l <= k; l++)
      m.covariance[k][l] = m.covariance[l][k] =
          (product[k][l] - (l >= MOMENT_XX ? n * mean[k] * mean[l] : 0)) / fmax(1, n - 1);
  m.of[MOMENT_STUCK] = (double)deposits / m.all;
  return m;
}

bool aspi_calibration_coefficients(const aspi_calibration *c, size_t b, double mean[COR_BOTH],
                                   double sd[COR_BOTH]) {
  double alpha = aspi_radians(c->bins[b].degrees), by[COR_BOTH] = {sin(alpha), cos(alpha)};
  double(*xy)[COR_BOTH] = calloc(c->samples, sizeof *xy);
  if (!xy)
    return false;
  aspi_bin_moments m = aspi_calibration_simulate(c, b, c->samples, xy);
  for (int k = 0; k < COR_BOTH; k++) {
    mean[k] = m.of[MOMENT_X + k] / by[k];
    sd[k] = sqrt(m.of[MOMENT_XX + k]) / by[k];
  }
  free(xy);
  return true;
}
