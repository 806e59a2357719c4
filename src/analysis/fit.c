/* Starting points and results of a fit; see calibrate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/search.h"
#include "base/error.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_qrng.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Searches for the start: the points of the design, the least distance of two starts on the scale,
 * the number of searches, the number that must agree, and the simulated impacts per group. */
#define APART 1.0
enum { PROBES = 256, STARTS = 10, AGREEING = 3, SEARCH_SAMPLES = 200 };

/* Searches that end within this of the best sum of squares agree. */
#define AGREED 1.0

/* A value within this distance of a bound, on the scale, counts as at the bound. */
#define AT_BOUND 0.01

/* A model describes the data if chi^2 per degree of freedom is below DESCRIBED, or so large a chi^2
 * has a probability above 1e-4. */
#define DESCRIBED 3.0
#define CHANCE 1e-4

/* An end of an interval: the places that are tried, and how many before wide steps out and halvings
 * take over; how near they come, as a share of the distance; the largest factor of a step out. */
enum { CORRECTIONS = 10, PATIENCE = 2 };
#define END_CLOSE 0.02
#define FARTHER_MOST 4.0

/* The box in which the search looks for starts, and bounds of the search, of an unknown without
 * bounds of its own: as logarithms of shares of its standard value; and on the logistic scale of
 * one with bounds. */
#define LOG_AROUND 2.5
#define LOG_DOWN 9.2
#define LOG_UP 9.2
#define LOGISTIC_AROUND 3.5
#define LOGISTIC 6.0

/* ---- the scales of the unknowns ---- */

static double scale_of(const aspi_unknown *u, double value) {
  return u->bounded ? log((value - u->least) / (u->most - value)) : log(value);
}

/* Sets the search range: around the standard value, or around a start far from that. */
static void bound_search(aspi_unknown *u) {
  double start = scale_of(u, u->start), around = u->bounded ? LOGISTIC_AROUND : LOG_AROUND;
  double center = u->bounded ? 0 : log(u->standard);
  if (!(fabs(start - center) < around) && !u->bounded)
    center = start;
  u->low = u->bounded ? -LOGISTIC : fmax(center - LOG_DOWN, log(u->least));
  u->high = u->bounded ? LOGISTIC : fmin(center + LOG_UP, log(u->most));
  u->from = fmax(center - around, u->low);
  u->to = fmin(center + around, u->high);
  u->scaled_start = fmin(fmax(start, u->low), u->high);
}

/* ---- the best start ---- */

typedef struct probe {
  double at[FIT_UNKNOWNS_MOST], squares;
} probe;

static int by_squares(const void *left, const void *right) {
  const probe *a = left, *b = right;
  return (a->squares > b->squares) - (a->squares < b->squares);
}

static bool describes(double chi2, double dof) {
  return dof <= 0 || chi2 < DESCRIBED * dof || gsl_cdf_chisq_Q(chi2, dof) > CHANCE;
}

/* Evaluates the points of a Sobol sequence and sorts them, the best first. */
static bool design(aspi_search *s, probe *probes) {
  const aspi_calibration *p = s->problem;
  gsl_qrng *sequence = gsl_qrng_alloc(gsl_qrng_sobol, (unsigned)p->n_unknown);
  if (!sequence)
    return false;
  for (int i = 0; i < PROBES; i++) {
    double share[FIT_UNKNOWNS_MOST];
    gsl_qrng_get(sequence, share);
    for (size_t j = 0; j < p->n_unknown; j++)
      probes[i].at[j] = p->unknown[j].from + share[j] * (p->unknown[j].to - p->unknown[j].from);
    probes[i].squares = aspi_search_squares(s, probes[i].at);
    if (p->progress)
      p->progress(p->progress_context, 0.1 * i / PROBES);
  }
  gsl_qrng_free(sequence);
  qsort(probes, PROBES, sizeof *probes, by_squares);
  return true;
}

static bool is_apart(const aspi_calibration *p, const probe *point, const probe *from, size_t n) {
  for (size_t i = 0; i < n; i++) {
    double square = 0;
    for (size_t j = 0; j < p->n_unknown; j++)
      square += gsl_pow_2(point->at[j] - from[i].at[j]);
    if (square < APART * APART)
      return false;
  }
  return true;
}

/* Chooses the best points that are not near each other. */
static size_t choose_starts(const aspi_calibration *p, const probe *probes, probe *starts) {
  size_t n = 0;
  for (int i = 0; i < PROBES && n < STARTS; i++)
    if (is_apart(p, &probes[i], starts, n))
      starts[n++] = probes[i];
  return n;
}

static void descend(aspi_search *s, probe *at) {
  at->squares = aspi_search_descend(s, at->at, 20, 5e-3);
}

/* True if a search ended at a bound. It may be lost on a plateau, so its agreement does not count.
 */
static bool is_at_bound(const aspi_calibration *p, const probe *end) {
  for (size_t j = 0; j < p->n_unknown; j++)
    if (end->at[j] < p->unknown[j].low + AT_BOUND || end->at[j] > p->unknown[j].high - AT_BOUND)
      return true;
  return false;
}

/* Finds the best end of many searches. The one from the caller's start comes last, and counts only
 * if it is better. */
static asp_code look_around(aspi_search *s, aspi_fit *fit) {
  const aspi_calibration *p = s->problem;
  probe probes[PROBES], ends[STARTS + 1];
  size_t best = 0;
  s->samples = p->samples < SEARCH_SAMPLES ? p->samples : SEARCH_SAMPLES;
  if (!design(s, probes))
    return ASP_ENOMEM;
  size_t most = choose_starts(p, probes, ends);
  while (fit->starts < most && (fit->agreed < AGREEING || is_at_bound(p, &ends[best]))) {
    size_t last = fit->starts++;
    descend(s, &ends[last]);
    best = ends[last].squares < ends[best].squares ? last : best;
    fit->agreed = 0;
    for (size_t i = 0; i <= last; i++)
      fit->agreed += ends[i].squares <= ends[best].squares + AGREED;
    if (p->progress)
      p->progress(p->progress_context, 0.1 + 0.4 * (double)fit->starts / (double)most);
  }
  probe *start = &ends[fit->starts++];
  for (size_t j = 0; j < p->n_unknown; j++)
    start->at[j] = p->unknown[j].scaled_start;
  descend(s, start);
  bool better = start->squares < ends[best].squares - AGREED;
  fit->agreed = better ? 1 : fit->agreed + (start->squares <= ends[best].squares + AGREED);
  start = better ? start : &ends[best];
  memcpy(fit->at, start->at, sizeof fit->at);
  s->samples = p->samples;
  return isfinite(start->squares) ? ASP_OK : ASP_EDATA;
}

static double impacts_of(const aspi_calibration *p) {
  double n = 0;
  for (size_t g = 0; g < p->n_bins; g++)
    n += p->groups[g].n;
  return n;
}

/* The value of an unknown, on the side of a bound, at which chi^2 has risen as it would over so
 * many errors if moments were linear in the unknowns; the others are at their best. Infinite if it
 * rises less up to the bound. The root of the rise is nearly linear. */
static double end_of(aspi_search *s, const aspi_fit *fit, double errors, size_t j, double bound) {
  double least = aspi_search_squares(s, fit->at), rise = errors * errors * fit->rise[j];
  double inner = 0, outer = INFINITY, room = fabs(bound - fit->at[j]);
  double side = bound < fit->at[j] ? -1 : 1, off = fmin(room, errors * fit->error[j]);
  for (int i = 0; i < CORRECTIONS; i++) {
    double others[FIT_UNKNOWNS_MOST];
    for (size_t k = 0; k < s->problem->n_unknown; k++) {
      double by = side * off * fit->correlation[k][j] * fit->error[k] / fit->error[j];
      others[k] = fit->at[k] + fmin(fmax(by, -APART), APART);
    }
    s->held = (int)j;
    s->held_at = fit->at[j] + side * off;
    double now = aspi_search_descend(s, others, 2, 1e-3) - least;
    double factor = sqrt(rise / fmax(now, rise * 1e-6));
    s->held = -1;
    if (fabs(factor - 1) < END_CLOSE)
      break;
    if (now < rise && off >= room)
      return side * INFINITY;
    *(now < rise ? &inner : &outer) = off;
    factor = i < PATIENCE ? factor : isinf(outer) ? FARTHER_MOST : 0;
    off = fmin(room, off * fmin(factor, FARTHER_MOST));
    if (off <= inner || off >= outer)
      off = (inner + outer) / 2;
  }
  return fit->at[j] + side * off;
}

/* 95 % of an unknown: between two values, or on one side of one if the other side has none. */
static void find_intervals(aspi_search *s, aspi_fit *fit) {
  const aspi_calibration *p = s->problem;
  double n = p->known ? impacts_of(p) : (double)s->n_moments;
  double scale = (!p->known || !fit->described) && fit->dof > 0 ? fit->chi2 / fit->dof : 1;
  double freedom = fmax(1, n - (double)p->n_unknown);
  double wide = sqrt(scale), both = gsl_cdf_tdist_Pinv(0.975, freedom) * wide;
  double one = gsl_cdf_tdist_Pinv(0.95, freedom) * wide;
  for (size_t j = 0; j < p->n_unknown; j++) {
    double low = p->unknown[j].low, high = p->unknown[j].high;
    fit->low[j] = end_of(s, fit, both, j, low);
    fit->high[j] = end_of(s, fit, both, j, high);
    if (isinf(fit->low[j]) && isfinite(fit->high[j]))
      fit->high[j] = end_of(s, fit, one, j, high);
    else if (isinf(fit->high[j]) && isfinite(fit->low[j]))
      fit->low[j] = end_of(s, fit, one, j, low);
  }
  for (size_t j = 0; j < p->n_unknown; j++)
    fit->error[j] *= wide;
}

/* Settles with the weights that belong to the data; with those of the data themselves if the model
 * does not describe them, as a model that scatters too little would take its misfit for certain. */
static bool settle(aspi_search *s, aspi_fit *fit) {
  bool fine = aspi_search_settle(s, fit);
  fit->described = fine && describes(fit->chi2, fit->dof);
  fit->first_chi2 = fit->chi2;
  if (fit->described || !s->by_model)
    return fine;
  aspi_search_weigh_by_data(s);
  return aspi_search_settle(s, fit);
}

asp_code aspi_calibration_find(aspi_calibration *p, aspi_fit *fit, asp_error *error) {
  aspi_search s;
  *fit = (aspi_fit){.starts = 0};
  for (size_t j = 0; j < p->n_unknown; j++)
    bound_search(&p->unknown[j]);
  asp_code code = aspi_search_begin(&s, p) ? look_around(&s, fit) : ASP_ENOMEM;
  if (!code && !settle(&s, fit))
    code = ASP_EDATA;
  if (!code)
    find_intervals(&s, fit);
  if (!code && !aspi_calibration_set(p, fit->at))
    code = ASP_EDATA;
  aspi_search_end(&s);
  if (code)
    aspi_fail(error, code,
              code == ASP_ENOMEM ? "out of memory for a fit"
                                 : "no wall or law has moments like those of the data; say by "
                                   "fit=VALUE where the search begins");
  return code;
}
