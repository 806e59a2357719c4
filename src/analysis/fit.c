/* Starting points and results of a fit; see calibrate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/search.h"
#include "base/error.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_qrng.h>
#include <math.h>
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

/* Rounds of weights and least squares, and those of the first, rough ones. */
enum { ROUNDS = 16, FIRST_ROUNDS = 3 };

/* The interval of an unknown comes from the rise of chi^2 if its error is above VAGUE on its scale,
 * or a bound is nearer than NEAR errors. */
#define VAGUE 0.4
#define NEAR 3.0

/* With fewer impacts, intervals come from refits. */
enum { FEW = 20 };

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

static size_t search_samples(const aspi_calibration *p) {
  return p->samples < SEARCH_SAMPLES ? p->samples : SEARCH_SAMPLES;
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
  at->squares = aspi_search_descend(s, at->at, 20, 5e-3, NULL, NULL);
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
  s->samples = search_samples(p);
  s->kind = p->scatters && p->known ? WEIGHTS_BOTH : WEIGHTS_DATA;
  s->fixed = false;
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

static void find_intervals(aspi_search *s, aspi_fit *fit, double scale) {
  const aspi_calibration *p = s->problem;
  double n = p->known ? impacts_of(p) : (double)s->n_moments;
  double freedom = fmax(1, n / (double)p->n_unknown - 1); /* few: second moments have long tails */
  double widths = gsl_cdf_tdist_Pinv(0.975, freedom);
  for (size_t j = 0; j < p->n_unknown; j++) {
    double error = fit->error[j], room = NEAR * error;
    fit->low[j] = fit->at[j] - widths * error;
    fit->high[j] = fit->at[j] + widths * error;
    fit->interval[j] = BY_ERROR;
    if (error < VAGUE && fit->at[j] - room > p->unknown[j].low &&
        fit->at[j] + room < p->unknown[j].high)
      continue;
    fit->interval[j] = BY_RISE;
    aspi_interval_by_rise(s, fit->at, scale, j, &fit->low[j], &fit->high[j]);
  }
}

/* Fits with weights of the model if it describes the data, else with weights of both. */
static bool settle(aspi_search *s, aspi_fit *fit, gsl_matrix *covariance) {
  const aspi_calibration *p = s->problem;
  fit->dof = (double)s->n_moments - (double)p->n_unknown;
  if (p->scatters && p->known) {
    double at[FIT_UNKNOWNS_MOST], chi2;
    memcpy(at, fit->at, sizeof at);
    s->samples = search_samples(p);
    aspi_search_settle(s, at, FIRST_ROUNDS, &chi2, covariance);
    s->samples = p->samples;
    if (describes(chi2, fit->dof)) {
      memcpy(fit->at, at, sizeof at);
      s->kind = WEIGHTS_MODEL;
    }
  }
  fit->converged = aspi_search_settle(s, fit->at, ROUNDS, &fit->chi2, covariance);
  fit->described = describes(fit->chi2, fit->dof);
  if (s->kind == WEIGHTS_BOTH && fit->described) { /* the model fits: use its weights alone */
    s->kind = WEIGHTS_MODEL;
    fit->converged = aspi_search_settle(s, fit->at, ROUNDS, &fit->chi2, covariance);
    fit->described = describes(fit->chi2, fit->dof);
  }
  return isfinite(fit->chi2);
}

/* Errors and correlations from the covariance, and intervals. */
static asp_code find_errors(aspi_search *s, aspi_fit *fit, const gsl_matrix *covariance) {
  const aspi_calibration *p = s->problem;
  bool scaled = (!p->known || !fit->described) && fit->dof > 0;
  double scale = scaled ? fit->chi2 / fit->dof : 1;
  for (size_t i = 0; i < p->n_unknown; i++) {
    double variance = gsl_matrix_get(covariance, i, i);
    fit->error[i] = sqrt(scale * variance);
    for (size_t j = 0; j < p->n_unknown; j++)
      fit->correlation[i][j] =
          gsl_matrix_get(covariance, i, j) / sqrt(variance * gsl_matrix_get(covariance, j, j));
  }
  find_intervals(s, fit, scale);
  bool few = p->known && p->scatters && impacts_of(p) < FEW && p->groups[0].impacts.xy;
  return !few || aspi_interval_by_bootstrap(p, fit) ? ASP_OK : ASP_ENOMEM;
}

asp_code aspi_calibration_find(aspi_calibration *p, aspi_fit *fit, asp_error *error) {
  aspi_search s;
  gsl_matrix *covariance = gsl_matrix_alloc(p->n_unknown, p->n_unknown);
  *fit = (aspi_fit){.starts = 0};
  p->scatters = !p->smooth || p->noise[0] > 0 || p->noise[1] > 0 || p->noise_speed > 0;
  for (size_t j = 0; j < p->n_unknown; j++)
    bound_search(&p->unknown[j]);
  asp_code code = aspi_search_begin(&s, p) && covariance ? look_around(&s, fit) : ASP_ENOMEM;
  if (!code && !settle(&s, fit, covariance))
    code = ASP_EDATA;
  if (!code)
    code = find_errors(&s, fit, covariance);
  if (!code && !aspi_calibration_set(p, fit->at))
    code = ASP_EDATA;
  aspi_search_end(&s);
  gsl_matrix_free(covariance);
  if (code)
    aspi_fail(error, code,
              code == ASP_ENOMEM ? "out of memory for a fit"
                                 : "no wall or law has moments like those of the data; say by "
                                   "fit=VALUE where the search begins");
  return code;
}
