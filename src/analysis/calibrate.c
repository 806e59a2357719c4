/* Groups the measurements of a calibration; see calibrate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/calibrate.h"
#include "base/units.h"
#include "base/error.h"

#include <math.h>
#include <stdlib.h>

/* Simulated impacts for each measured one, unless --samples is given. */
enum { TIMES = 10, SAMPLES_LEAST = 2000, SAMPLES_MOST = 20000 };

/* Assumed error of a mean whose error is unknown, until the fit estimates it. */
#define ERROR_UNKNOWN 0.01

/* Assumed number of impacts if only the scatter is known: means and standard deviations then have
 * equal weight. */
#define IMPACTS_UNKNOWN 20

/* With fewer impacts than this, a bin's own scatter counts less than that of all bins. */
#define FEW 20.0

/* A row of means; sd and n where they are known. */
static void take_means(aspi_calibration *c, aspi_calibration_bin *bin) {
  const aspi_scatter_row *row = &c->data.rows[bin->first];
  double alpha = aspi_radians(row->degrees), by[COR_BOTH] = {sin(alpha), cos(alpha)};
  bool scatter = row->sd[COR_N] > 0 || row->sd[COR_T] > 0, counted = row->n > 0;
  aspi_bin_moments *m = &bin->moments;
  m->all = counted ? row->n : scatter && !c->smooth ? IMPACTS_UNKNOWN : 1;
  for (int k = 0; k < COR_BOTH && !(row->n > 0); k++)
    if (row->se[k] > 0 && row->sd[k] > 0 && (counted = true))
      m->all = fmax(1, row->sd[k] * row->sd[k] / (row->se[k] * row->se[k]));
  m->rebounds = m->all;
  for (int k = 0; k < COR_BOTH; k++) {
    bin->used[MOMENT_X + k] = isfinite(row->cor[k]) && (k == COR_N || row->degrees < 90);
    bin->used[MOMENT_XX + k] =
        bin->used[MOMENT_X + k] && row->sd[k] > 0 && m->all > 1 && !c->smooth;
    double sd = row->se[k] > 0   ? row->se[k] * sqrt(m->all)
                : row->sd[k] > 0 ? row->sd[k]
                                 : ERROR_UNKNOWN * sqrt(m->all);
    m->of[MOMENT_X + k] = row->cor[k] * by[k];
    m->of[MOMENT_XX + k] = pow(row->sd[k] * by[k], 2);
    m->covariance[k][k] = pow(sd * by[k], 2);
    m->covariance[MOMENT_XX + k][MOMENT_XX + k] = 2 * pow(m->covariance[k][k], 2); /* if normal */
    c->has_errors = c->has_errors && (counted || row->se[k] > 0 || !bin->used[MOMENT_X + k]);
    bin->data_weighted = bin->data_weighted || (bin->used[MOMENT_X + k] && m->all <= 1);
  }
}

/* Reads the impacts of a bin, and notes which moments exist. False: out of memory. */
static bool take_impacts(const aspi_calibration *c, aspi_calibration_bin *bin) {
  size_t rebounds = 0, deposits = 0;
  bool has[COR_BOTH] = {true, true};
  double(*xy)[COR_BOTH] = calloc(bin->end - bin->first, sizeof *xy);
  for (size_t i = bin->first; xy && i < bin->end; i++) {
    const aspi_scatter_row *row = &c->data.rows[i];
    double alpha = aspi_radians(row->degrees), by[COR_BOTH] = {sin(alpha), cos(alpha)};
    for (int k = 0; k < COR_BOTH && !row->deposit; k++) {
      has[k] = has[k] && isfinite(row->cor[k]);
      xy[rebounds][k] = isfinite(row->cor[k]) ? row->cor[k] * by[k] : 0;
    }
    *(row->deposit ? &deposits : &rebounds) += 1;
  }
  if (xy)
    bin->moments = aspi_calibration_moments(xy, rebounds, deposits);
  for (int k = 0; k < COR_BOTH; k++) {
    bin->used[MOMENT_X + k] = has[k] && rebounds > 0;
    bin->used[MOMENT_XX + k] = has[k] && rebounds > 1 && !c->smooth;
  }
  bin->used[MOMENT_STUCK] = c->data.has_outcome && c->sticks;
  free(xy);
  return xy != NULL;
}

/* Blends each bin's covariances with those pooled over all bins. */
static void pool_covariances(aspi_calibration *c) {
  double pooled[MOMENT_STUCK][MOMENT_STUCK] = {{0}}, freedom = 0;
  for (int pass = 0; pass < 2; pass++)
    for (size_t b = 0; b < c->n_bins; b++) {
      aspi_bin_moments *m = &c->bins[b].moments;
      double rest = m->rebounds > 1 ? m->rebounds - 1 : 0, own = m->rebounds / (m->rebounds + FEW);
      freedom += pass == 0 ? rest : 0;
      for (int k = 0; k < MOMENT_STUCK; k++)
        for (int l = 0; l < MOMENT_STUCK; l++) {
          if (pass == 0 && rest > 0)
            pooled[k][l] += rest * m->covariance[k][l];
          if (pass == 1 && m->rebounds > 0)
            m->covariance[k][l] =
                own * m->covariance[k][l] + (1 - own) * pooled[k][l] / fmax(1, freedom);
        }
    }
}

static void make_bins(aspi_calibration *c, double width) {
  const bool clusters = aspi_scatter_is_clustered(&c->data, width);
  for (size_t i = 0; i < c->data.count; i++) {
    if (i == 0 || c->data.means || !aspi_scatter_joins(&c->data, i, width, clusters))
      c->bins[c->n_bins++] = (aspi_calibration_bin){.first = i};
    c->bins[c->n_bins - 1].end = i + 1;
  }
}

asp_code aspi_calibration_take_data(aspi_calibration *c, double width, asp_error *error) {
  double most = 0;
  size_t n_moments = 0;
  bool fine = (c->bins = calloc(c->data.count, sizeof *c->bins));
  c->has_errors = true;
  if (fine)
    make_bins(c, width);
  for (size_t b = 0; b < c->n_bins && fine; b++) {
    aspi_calibration_bin *bin = &c->bins[b];
    for (size_t i = bin->first; i < bin->end; i++)
      bin->degrees += c->data.rows[i].degrees / (double)(bin->end - bin->first);
    if (c->data.means)
      take_means(c, bin);
    else
      fine = take_impacts(c, bin);
    for (int k = 0; k < MOMENTS; k++)
      n_moments += bin->used[k];
    most = fmax(most, bin->moments.all);
  }
  if (!fine)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu rows of data", c->data.count);
  if (!c->data.means)
    pool_covariances(c);
  if (c->samples == 0)
    c->samples = (size_t)fmin(fmax(TIMES * most, SAMPLES_LEAST), SAMPLES_MOST);
  if (n_moments < c->n_unknown)
    return aspi_fail(error, ASP_EARG,
                     "the data have %zu moments for %zu unknowns; fewer numbers must be 'fit'",
                     n_moments, c->n_unknown);
  return ASP_OK;
}
