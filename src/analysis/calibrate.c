/* Groups measurements and searches for the unknowns; see calibrate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/calibrate.h"
#include "analysis/angles.h"
#include "base/error.h"

#include <math.h>
#include <stdlib.h>

/* Simulated impacts for each measured one, unless --samples is given. */
enum { TIMES = 10, SAMPLES_LEAST = 2000, SAMPLES_MOST = 20000 };

/* The box in which the search looks for starts, and bounds of the search, of an unknown without
 * bounds of its own: as logarithms of shares of its standard value; and on the logistic scale of
 * one with bounds. */
#define LOG_AROUND 2.5
#define LOG_DOWN 6.9
#define LOG_UP 3.4
#define LOGISTIC_AROUND 3.5
#define LOGISTIC 6.0

/* Assumed error of a mean whose error is unknown, until the fit estimates it. */
#define ERROR_UNKNOWN 0.01

/* And for the number of impacts where only their scatter is known: that of means and that of
 * standard deviations then count alike. */
#define IMPACTS_UNKNOWN 20

double aspi_unknown_scaled(const aspi_unknown *u, double value) {
  return u->bounded ? log((value - u->least) / (u->most - value)) : log(value);
}

double aspi_unknown_value(const aspi_unknown *u, double scaled) {
  return u->bounded ? u->least + (u->most - u->least) / (1 + exp(-scaled)) : exp(scaled);
}

double aspi_unknown_slope(const aspi_unknown *u, double scaled) {
  double share = 1 / (1 + exp(-scaled));
  return u->bounded ? (u->most - u->least) * share * (1 - share) : exp(scaled);
}

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

static double interval_of(const aspi_measured_row *row, double width) {
  return floor(fmin(row->degrees, 90 - 1e-6) / width + 1e-9);
}

static void make_bins(aspi_calibration *c, double width) {
  const aspi_measured_row *rows = c->data.rows;
  for (size_t i = 0; i < c->data.count; i++) {
    aspi_calibration_bin *last = c->n_bins ? &c->bins[c->n_bins - 1] : NULL;
    bool joins = last && !c->data.means &&
                 interval_of(&rows[i], width) <= interval_of(&rows[last->first], width);
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

static void show_progress(void *context, double share) {
  const aspi_calibration *c = context;
  if (c->progress)
    c->progress(c->progress_context, share);
}

/* Sets the search range of number j: around its standard value, or around a start far from that. */
static void bound_search(const aspi_unknown *u, size_t j, aspi_fit_problem *p) {
  double start = aspi_unknown_scaled(u, u->start),
         around = u->bounded ? LOGISTIC_AROUND : LOG_AROUND;
  double center = u->bounded ? 0 : log(u->standard);
  if (!(fabs(start - center) < around) && !u->bounded)
    center = start;
  p->low[j] = u->bounded ? -LOGISTIC : fmax(center - LOG_DOWN, log(u->least));
  p->high[j] = u->bounded ? LOGISTIC : fmin(center + LOG_UP, log(u->most));
  p->from[j] = fmax(center - around, p->low[j]);
  p->to[j] = fmin(center + around, p->high[j]);
  p->start[j] = fmin(fmax(start, p->low[j]), p->high[j]);
}

asp_code aspi_calibration_find(aspi_calibration *c, aspi_fit *fit, asp_error *error) {
  aspi_fit_problem p = {.context = c,
                        .set = aspi_calibration_set,
                        .draw = aspi_calibration_draw,
                        .groups = c->groups,
                        .n_groups = c->n_bins,
                        .n_unknowns = c->n_unknown,
                        .samples = c->samples,
                        .huber = c->huber,
                        .scatters =
                            !c->smooth || c->noise[0] > 0 || c->noise[1] > 0 || c->noise_speed > 0,
                        .known = c->known,
                        .progress = show_progress};
  for (size_t j = 0; j < c->n_unknown; j++)
    bound_search(&c->unknown[j], j, &p);
  return aspi_fit_run(&p, fit, error);
}

void aspi_calibration_free(aspi_calibration *c) {
  for (size_t b = 0; b < c->n_bins; b++)
    free(c->groups[b].impacts.xy);
  free(c->groups);
  free(c->bins);
}
