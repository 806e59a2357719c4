/* Intervals of a fit's unknowns where a standard error does not make them; see calibrate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/search.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Halvings of the place where chi^2 has risen. */
enum { HALVINGS = 6 };

/* Synthetic data sets, and rounds of weights and simulated impacts of a group in each refit. */
enum { REFITS = 200, REFIT_ROUNDS = 2, REFIT_SAMPLES = 100 };

/* chi^2 with one unknown held, and the others at their best from where they were. */
static double held_squares(aspi_search *s, double *others, size_t j, double at) {
  s->held = (int)j;
  s->held_at = others[j] = at;
  double squares = aspi_search_descend(s, others, 3, 1e-3, NULL, NULL);
  others[j] = at;
  s->held = -1;
  return squares;
}

/* The value at which chi^2 is `rise` above its minimum, on one side; infinite if it stays below
 * that up to the bound. */
static double risen(aspi_search *s, const double *at, double wanted, size_t j, double bound) {
  double others[FIT_UNKNOWNS_MOST], inner = at[j], outer = at[j], side = bound < at[j] ? -1 : 1;
  memcpy(others, at, sizeof others);
  for (double step = 0.25;; step *= 2) {
    outer = side < 0 ? fmax(inner - step, bound) : fmin(inner + step, bound);
    if (held_squares(s, others, j, outer) > wanted)
      break;
    if (fabs(outer - bound) < 1e-9)
      return side * INFINITY;
    inner = outer;
  }
  for (int i = 0; i < HALVINGS; i++) {
    double middle = (inner + outer) / 2;
    if (held_squares(s, others, j, middle) > wanted)
      outer = middle;
    else
      inner = middle;
  }
  return (inner + outer) / 2;
}

void aspi_interval_by_rise(aspi_search *s, const double *at, double scale, size_t j, double *low,
                           double *high) {
  const aspi_calibration *p = s->problem;
  double chi2 = aspi_search_squares(s, at);
  double both = scale * gsl_cdf_chisq_Pinv(0.95, 1), one = scale * gsl_cdf_chisq_Pinv(0.90, 1);
  *low = risen(s, at, chi2 + both, j, p->unknown[j].low);
  *high = risen(s, at, chi2 + both, j, p->unknown[j].high);
  if (isinf(*low) && isfinite(*high))
    *high = risen(s, at, chi2 + one, j, p->unknown[j].high);
  if (isinf(*high) && isfinite(*low))
    *low = risen(s, at, chi2 + one, j, p->unknown[j].low);
}

/* One data set of the fitted model, with the data's number of impacts. */
static void synthesize(const aspi_calibration *p, uint32_t stream, aspi_group *groups) {
  for (size_t g = 0; g < p->n_bins; g++) {
    aspi_cloud *to = &groups[g].impacts;
    to->rebounds = to->deposits = 0;
    aspi_calibration_draw(p, g, (size_t)p->groups[g].n, stream, to);
    for (int k = 0; k < 2; k++)
      groups[g].mean[k] = p->groups[g].mean[k];
    for (int k = 0; k < MOMENTS; k++)
      groups[g].used[k] = p->groups[g].used[k] && (k == MOMENT_STUCK || to->rebounds > 0);
  }
}

bool aspi_interval_by_bootstrap(const aspi_calibration *problem, aspi_fit *fit) {
  aspi_calibration p = *problem;
  size_t groups = p.n_bins, most = 0, done = 0;
  p.samples = p.samples < REFIT_SAMPLES ? p.samples : REFIT_SAMPLES;
  p.groups = malloc(groups * sizeof *p.groups);
  for (size_t g = 0; g < groups; g++)
    most += (size_t)problem->groups[g].n;
  double(*xy)[2] = calloc(most, sizeof *xy), *ends = calloc(REFITS * p.n_unknown, sizeof *ends);
  gsl_matrix *covariance = gsl_matrix_alloc(p.n_unknown, p.n_unknown);
  bool fine = p.groups && xy && ends && covariance;
  for (uint32_t i = 0; fine && i < REFITS; i++) {
    aspi_search s;
    double at[FIT_UNKNOWNS_MOST], chi2;
    memcpy(p.groups, problem->groups, groups * sizeof *p.groups);
    size_t next = 0;
    for (size_t g = 0; g < groups; g++) {
      p.groups[g].impacts.xy = xy + next;
      next += (size_t)p.groups[g].n;
    }
    aspi_calibration_set(&p, fit->at);
    synthesize(problem, i + 1, p.groups);
    memcpy(at, fit->at, sizeof at);
    fine = aspi_search_begin(&s, &p);
    s.kind = WEIGHTS_MODEL;
    if (fine)
      aspi_search_settle(&s, at, REFIT_ROUNDS, &chi2, covariance);
    if (fine && isfinite(chi2)) {
      for (size_t j = 0; j < p.n_unknown; j++)
        ends[j * REFITS + done] = at[j];
      done++;
    }
    aspi_search_end(&s);
  }
  for (size_t j = 0; fine && done > 1 && j < p.n_unknown; j++) {
    double *e = ends + j * REFITS;
    gsl_sort(e, 1, done);
    fit->low[j] = 2 * fit->at[j] - gsl_stats_quantile_from_sorted_data(e, 1, done, 0.975);
    fit->high[j] = 2 * fit->at[j] - gsl_stats_quantile_from_sorted_data(e, 1, done, 0.025);
    fit->error[j] = gsl_stats_sd(e, 1, done);
    fit->interval[j] = BY_BOOTSTRAP;
  }
  gsl_matrix_free(covariance);
  free(p.groups);
  free(xy);
  free(ends);
  return fine;
}
