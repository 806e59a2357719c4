/* Groups the measurements of a calibration; see calibrate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/calibrate.h"
#include "analysis/angles.h"
#include "base/error.h"

#include <math.h>
#include <stdlib.h>

/* Simulated impacts for each measured one, unless --samples is given. */
enum { TIMES = 10, SAMPLES_LEAST = 2000, SAMPLES_MOST = 20000 };

/* Assumed error of a mean whose error is unknown, until the fit estimates it. */
#define ERROR_UNKNOWN 0.01

/* And for the number of impacts where only their scatter is known: that of means and that of
 * standard deviations then count alike. */
#define IMPACTS_UNKNOWN 20

/* A row of means; sd and n where they are known. */
static void take_means(aspi_calibration *c, size_t b) {
  const aspi_measured_row *row = &c->data.rows[c->bins[b].first];
  aspi_group *g = &c->groups[b];
  double alpha = aspi_radians(row->degrees), by[COR_BOTH] = {sin(alpha), cos(alpha)};
  bool scatter = row->sd[COR_N] > 0 || row->sd[COR_T] > 0, counted = row->n > 0;
  g->n = counted ? row->n : scatter && !c->smooth ? IMPACTS_UNKNOWN : 1;
  for (int k = 0; k < COR_BOTH && !(row->n > 0); k++)
    if (row->se[k] > 0 && row->sd[k] > 0 && (counted = true))
      g->n = fmax(1, row->sd[k] * row->sd[k] / (row->se[k] * row->se[k]));
  for (int k = 0; k < COR_BOTH; k++) {
    g->used[MOMENT_X + k] = isfinite(row->cor[k]) && (k == COR_N || row->degrees < 90);
    g->used[MOMENT_XX + k] = g->used[MOMENT_X + k] && row->sd[k] > 0 && !c->smooth;
    g->mean[k] = row->cor[k] * by[k];
    g->sd[k] = (row->sd[k] > 0 ? row->sd[k] : 0) * by[k];
    g->se[k] = (row->se[k] > 0 ? row->se[k] : NAN) * by[k];
    if (!(row->sd[k] > 0) && !(row->se[k] > 0))
      g->se[k] = ERROR_UNKNOWN * by[k];
    c->known = c->known && (counted || row->se[k] > 0 || !g->used[MOMENT_X + k]);
    g->by_data = g->by_data || (g->used[MOMENT_X + k] && g->n <= 1);
  }
}

static void make_bins(aspi_calibration *c, double width) {
  const aspi_measured_row *rows = c->data.rows;
  for (size_t i = 0; i < c->data.count; i++) {
    aspi_calibration_bin *last = c->n_bins ? &c->bins[c->n_bins - 1] : NULL;
    bool joins = last && !c->data.means &&
                 aspi_measured_interval(&rows[i], width) <=
                     aspi_measured_interval(&rows[last->first], width);
    if (!joins)
      c->bins[c->n_bins++] = (aspi_calibration_bin){.first = i};
    c->bins[c->n_bins - 1].end = i + 1;
  }
}

asp_code aspi_calibration_take_data(aspi_calibration *c, double width, asp_error *error) {
  c->known = true;
  c->bins = calloc(c->data.count, sizeof *c->bins);
  c->groups = calloc(c->data.count, sizeof *c->groups);
  bool fine = c->bins && c->groups;
  if (fine)
    make_bins(c, width);
  double most = 0;
  size_t n_moments = 0;
  for (size_t b = 0; b < c->n_bins && fine; b++) {
    aspi_calibration_bin *on = &c->bins[b];
    for (size_t i = on->first; i < on->end; i++)
      on->degrees += c->data.rows[i].degrees / (double)(on->end - on->first);
    if (c->data.means)
      take_means(c, b);
    else
      fine = aspi_calibration_take_impacts(c, b);
    for (int k = 0; k < MOMENTS; k++)
      n_moments += c->groups[b].used[k];
    most = fmax(most, c->groups[b].n);
  }
  if (!fine)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu rows of data", c->data.count);
  if (c->samples == 0)
    c->samples = (size_t)fmin(fmax(TIMES * most, SAMPLES_LEAST), SAMPLES_MOST);
  if (n_moments < c->n_unknown)
    return aspi_fail(error, ASP_EARG,
                     "the data have %zu moments for %zu unknowns; fewer numbers must be 'fit'",
                     n_moments, c->n_unknown);
  return ASP_OK;
}
