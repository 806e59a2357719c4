/* The model of a calibration: impacts simulated for given values of the unknowns, at the places of
 * the data, with the same random numbers for all values; see calibrate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/calibrate.h"
#include "analysis/angles.h"
#include "base/running.h"
#include "base/stream.h"
#include "description/description.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Draws of a group have numbers of their own. */
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
  if (!c->moves)
    return aspi_wall_take_law(c->wall, &words->choice, NULL) == ASP_OK;
  return !asp_description_complete(words, NULL) && !aspi_wall_remake(c->wall, &words->choice, NULL);
}

/* Adds noise to what was measured of a rebound: x and y are in shares of v1. */
static void add_noise(const aspi_calibration *c, const double *normal, double *x, double *y) {
  double angle = atan2(*x, *y) + aspi_radians(c->noise[1]) * normal[1];
  double speed =
      hypot(*x, *y) * (1 + c->noise_speed * normal[2]) / (1 + c->noise_speed * normal[3]);
  *x = speed * sin(angle);
  *y = speed * cos(angle);
}

/* One impact of the model as it would be measured: x and y; false: no rebound is seen. */
static bool see_rebound(const aspi_calibration *c, const aspi_measured_row *row, uint64_t tag,
                        double xy[COR_BOTH]) {
  static const double n[3] = {0, 0, 1};
  double normal[4] = {0, 0, 0, 0};
  bool noisy = c->noise[0] > 0 || c->noise[1] > 0 || c->noise_speed > 0;
  aspi_stream noise = aspi_stream_begin(&(asp_key){c->seed, 1, tag, 2});
  for (int i = 0; i < 4 && noisy; i++)
    normal[i] = aspi_stream_normal(&noise);
  double degrees = row->degrees + c->noise[0] * normal[0];
  degrees = degrees > 90 ? 180 - degrees : fmax(fabs(degrees), 1e-3);
  double v = isnan(row->v1) ? c->speed : row->v1, a1 = aspi_radians(degrees);
  double v1[3] = {degrees < 90 ? v * cos(a1) : 0, 0, -v * sin(a1)};
  asp_particle particle = {
      isnan(row->d_p) ? c->d_p : row->d_p, c->density, c->pair, {0, 0, 0}, c->lay, 0, 0, NULL};
  asp_impact impact;
  asp_wall_impact(c->wall, &particle, v1, n, &(asp_key){c->seed, 1, tag, 1}, &impact);
  if (impact.outcome == ASP_DEPOSIT)
    return false;
  /* With v1 along the normal there is no plane of incidence: what is off the normal is all along.
   */
  bool all = c->data.view == ASPI_MEASURED_SPACE || !(v1[0] > 0);
  xy[COR_N] = impact.v2[2] / v;
  xy[COR_T] = (all ? hypot(impact.v2[0], impact.v2[1]) : impact.v2[0]) / v;
  if (!noisy)
    return true;
  add_noise(c, normal, &xy[COR_N], &xy[COR_T]);
  xy[COR_N] = fabs(xy[COR_N]);
  return true;
}

/* The row of impact i of some at the places of a bin. All rows come equally often, or spread over
 * the bin where there are fewer impacts: rows are in order of their angle. */
static const aspi_measured_row *row_of(const aspi_calibration *c, const aspi_calibration_bin *bin,
                                       size_t i, size_t samples) {
  double share = ((double)i + 0.5) / (double)samples;
  return &c->data.rows[bin->first + (size_t)(share * (double)(bin->end - bin->first))];
}

void aspi_calibration_draw(const aspi_calibration *c, size_t b, size_t samples, aspi_cloud *to) {
  const aspi_calibration_bin *bin = &c->bins[b];
  for (size_t i = 0; i < samples; i++) {
    const aspi_measured_row *row = row_of(c, bin, i, samples);
    if (see_rebound(c, row, b * TAGS_OF_A_BIN + i, to->xy[to->rebounds]))
      to->rebounds++;
    else
      to->deposits++;
  }
}

bool aspi_calibration_take_impacts(const aspi_calibration *c, size_t b) {
  const aspi_calibration_bin *bin = &c->bins[b];
  aspi_group *g = &c->groups[b];
  bool has[COR_BOTH] = {true, true};
  aspi_cloud *to = &g->impacts;
  if (!(to->xy = calloc(bin->end - bin->first, sizeof *to->xy)))
    return false;
  aspi_running both[COR_BOTH] = {{0, 0, 0}, {0, 0, 0}};
  for (size_t i = bin->first; i < bin->end; i++) {
    const aspi_measured_row *row = &c->data.rows[i];
    double alpha = aspi_radians(row->degrees), by[COR_BOTH] = {sin(alpha), cos(alpha)};
    to->deposits += row->deposit;
    for (int k = 0; k < COR_BOTH && !row->deposit; k++) {
      has[k] = has[k] && isfinite(row->cor[k]);
      to->xy[to->rebounds][k] = isfinite(row->cor[k]) ? row->cor[k] * by[k] : 0;
      aspi_running_add(&both[k], to->xy[to->rebounds][k]);
    }
    to->rebounds += !row->deposit;
  }
  bool any = to->rebounds > 0, spread = any && !c->smooth;
  g->n = (double)(to->rebounds + to->deposits);
  for (int k = 0; k < COR_BOTH; k++) {
    g->mean[k] = any && has[k] ? both[k].mean : NAN;
    g->sd[k] = any && has[k] ? aspi_running_sd(&both[k]) : NAN;
    g->used[MOMENT_X + k] = has[k] && any;
    g->used[MOMENT_XX + k] = has[k] && spread;
  }
  g->used[MOMENT_XY] = has[COR_N] && has[COR_T] && spread;
  g->used[MOMENT_STUCK] = c->data.has_outcome && c->sticks;
  return true;
}

bool aspi_calibration_coefficients(const aspi_calibration *c, size_t b, double mean[COR_BOTH],
                                   double sd[COR_BOTH]) {
  static const double center[COR_BOTH] = {0, 0};
  double alpha = aspi_radians(c->bins[b].degrees), by[COR_BOTH] = {sin(alpha), cos(alpha)};
  aspi_cloud cloud = {calloc(c->samples, sizeof *cloud.xy), 0, 0};
  if (!cloud.xy)
    return false;
  aspi_calibration_draw(c, b, c->samples, &cloud);
  aspi_cloud_moments m = aspi_cloud_moments_of(&cloud, center);
  for (int k = 0; k < COR_BOTH; k++) {
    mean[k] = m.of[MOMENT_X + k] / by[k];
    sd[k] = sqrt(m.covariance[MOMENT_X + k][MOMENT_X + k]) / by[k];
  }
  free(cloud.xy);
  return true;
}
