/* The least squares of a calibration, by GSL's nonlinear fit (Levenberg-Marquardt); see
 * calibrate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/calibrate.h"
#include "base/error.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Searches at most, and their simulated impacts per bin. */
enum { STARTS_MOST = 2 * FIT_UNKNOWNS_MOST + 2, SEARCH_SAMPLES = 200 };

/* Searches that end within this of the best sum of squares agree. */
#define AGREED 1.0

/* A model describes the data if chi^2 per degree of freedom is below DESCRIBED, or so large a chi^2
 * has a probability above CHANCE. */
#define DESCRIBED 3.0
#define CHANCE 1e-4

/* Step of the unknowns for a derivative, wide enough to pass over the jumps that single impacts
 * make. */
#define DIFFERENCE 0.04

/* Steps of a fit, at most, and their relative size at its end. */
enum { STEPS = 20 };
#define CLOSE 1e-4

/* Rounds of weights and a fit, at most. Values have settled if a round moves them by less than this
 * share of their errors, and are in doubt if the last one moves them by more than the second. */
enum { ROUNDS = 12 };
#define SETTLED 0.02
#define WANDERING 0.25

/* Halvings to an end of an interval next to a bound, and the steps of the fit in each. */
enum { HALVINGS = 10, HALVING_STEPS = 2 };

/* Residual of each moment if the values of the unknowns make no wall. */
#define NOT_A_MODEL 1e5

/* Share of each variance that is added to it, as a simulation does not resolve combinations of
 * moments that vary less; and the least variance. */
#define RIDGE 1e-3
#define FLOOR 1e-14

/* The box of the starts, and the bounds of the search. Unknown without bounds: as logarithms of
 * shares of its default value; with bounds: on the logistic scale. */
#define LOG_AROUND 2.5
#define LOG_FAR 9.2
#define LOGISTIC_AROUND 3.5
#define LOGISTIC_FAR 6.0

typedef struct search {
  const aspi_calibration *problem;
  double (*lower)[MOMENTS][MOMENTS]; /* Cholesky factor of the covariance of each bin's moments */
  double (*xy)[COR_BOTH];            /* scratch of a bin */
  size_t samples;                    /* simulated impacts of a bin */
  size_t n_moments;
  double low[FIT_UNKNOWNS_MOST], high[FIT_UNKNOWNS_MOST]; /* equal: the unknown is held */
} search;

/* ---- bounds ---- */

static double scale_of(const aspi_unknown *u, double value) {
  return u->bounded ? log((value - u->least) / (u->most - value)) : log(value);
}

/* Sets the search range: around the default value, or around a start far from that. */
static void bound_search(aspi_unknown *u) {
  double start = scale_of(u, u->start), around = u->bounded ? LOGISTIC_AROUND : LOG_AROUND;
  double center = u->bounded ? 0 : log(u->default_value);
  if (!(fabs(start - center) < around) && !u->bounded)
    center = start;
  u->low = u->bounded ? -LOGISTIC_FAR : fmax(center - LOG_FAR, log(u->least));
  u->high = u->bounded ? LOGISTIC_FAR : fmin(center + LOG_FAR, log(u->most));
  u->from = fmax(center - around, u->low);
  u->to = fmin(center + around, u->high);
  u->scaled_start = fmin(fmax(start, u->low), u->high);
}

static void limit(const search *s, double *at) {
  for (size_t j = 0; j < s->problem->n_unknown; j++)
    at[j] = fmin(fmax(at[j], s->low[j]), s->high[j]);
}

/* ---- residuals ---- */

/* Covariance of two moments, measured minus simulated; model NULL: by the data's scatter. The
 * second term is that of variances of few impacts. */
static double covariance(const aspi_calibration_bin *bin, const aspi_bin_moments *model, int k,
                         int l) {
  const aspi_bin_moments *data = &bin->moments,
                         *scatter = model && !bin->data_weighted ? model : data;
  double n = data->rebounds;
  if (k == MOMENT_STUCK || l == MOMENT_STUCK) {
    double share = (data->all * (model ? model : data)->of[MOMENT_STUCK] + 0.5) / (data->all + 1);
    return k == l ? share * (1 - share) * (1 / data->all + (model ? 1 / model->all : 0)) : 0;
  }
  double sum = scatter->covariance[k][l] * (1 / n + (model ? 1 / model->rebounds : 0));
  if (k >= MOMENT_XX && l >= MOMENT_XX)
    sum += 2 * pow(scatter->covariance[k - MOMENT_XX][l - MOMENT_XX], 2) / (n * (n - 1));
  return sum;
}

/* Cholesky factor of the covariance of the used moments and a ridge. */
static void factor(const aspi_calibration_bin *bin, const aspi_bin_moments *model,
                   double (*a)[MOMENTS]) {
  for (int k = 0; k < MOMENTS; k++)
    for (int l = 0; l <= k && bin->used[k]; l++) {
      double sum = bin->used[l] ? covariance(bin, model, k, l) : 0;
      double floor = k == l ? RIDGE * sum + FLOOR : 0;
      for (int i = 0; i < l; i++)
        sum -= a[k][i] * a[l][i];
      a[k][l] = !bin->used[l] ? 0 : l < k ? sum / a[l][l] : sqrt(fmax(sum, 0) + floor);
    }
}

/* The moments of a bin; false: the model has no rebounds where the data have some. */
static bool simulate(const search *s, size_t b, aspi_bin_moments *m) {
  const aspi_calibration_bin *bin = &s->problem->bins[b];
  *m = aspi_calibration_simulate(s->problem, b, s->samples, s->xy);
  return m->rebounds >= 2 || !(bin->moments.rebounds > 0);
}

static bool set_model(const search *s, const double *at) {
  double within[FIT_UNKNOWNS_MOST];
  memcpy(within, at, s->problem->n_unknown * sizeof *within);
  limit(s, within);
  return aspi_calibration_set(s->problem, within);
}

/* Takes the weights of the model at these values; NULL: of the data. False: no such model. */
static bool weigh(search *s, const double *at) {
  bool fine = !at || set_model(s, at);
  for (size_t b = 0; b < s->problem->n_bins && fine; b++) {
    aspi_bin_moments m;
    fine = !at || simulate(s, b, &m);
    if (fine)
      factor(&s->problem->bins[b], at ? &m : NULL, s->lower[b]);
  }
  return fine;
}

/* Differences of all moments, independent and of variance 1. */
static int residuals(const gsl_vector *x, void *data, gsl_vector *out) {
  const search *s = data;
  bool fine = set_model(s, x->data);
  size_t place = 0;
  for (size_t b = 0; b < s->problem->n_bins && fine; b++) {
    const aspi_calibration_bin *bin = &s->problem->bins[b];
    double off[MOMENTS];
    aspi_bin_moments m;
    fine = simulate(s, b, &m);
    for (int k = 0; k < MOMENTS && fine; k++) {
      off[k] = 0;
      if (!bin->used[k])
        continue;
      off[k] = m.of[k] - bin->moments.of[k];
      for (int i = 0; i < k; i++)
        off[k] -= s->lower[b][k][i] * off[i];
      off[k] /= s->lower[b][k][k];
      gsl_vector_set(out, place++, off[k]);
    }
  }
  if (!fine)
    gsl_vector_set_all(out, NOT_A_MODEL);
  return GSL_SUCCESS;
}

/* Derivatives by central differences. */
static int slopes(const gsl_vector *x, void *data, gsl_matrix *out) {
  double of_at[FIT_UNKNOWNS_MOST];
  gsl_vector_view at = gsl_vector_view_array(of_at, x->size);
  gsl_vector *down = gsl_vector_alloc(out->size1);
  for (size_t j = 0; j < x->size && down; j++) {
    gsl_vector_view up = gsl_matrix_column(out, j);
    gsl_vector_memcpy(&at.vector, x);
    of_at[j] += DIFFERENCE;
    residuals(&at.vector, data, &up.vector);
    of_at[j] -= 2 * DIFFERENCE;
    residuals(&at.vector, data, down);
    gsl_vector_sub(&up.vector, down);
    gsl_vector_scale(&up.vector, 1 / (2 * DIFFERENCE));
  }
  gsl_vector_free(down);
  return down ? GSL_SUCCESS : GSL_ENOMEM;
}

/* ---- least squares ---- */

/* Errors and correlations; an unknown without influence has an infinite error. */
static void find_errors(gsl_multifit_nlinear_workspace *solver, size_t p, aspi_fit *fit) {
  double of_all[FIT_UNKNOWNS_MOST * FIT_UNKNOWNS_MOST];
  gsl_matrix_view all = gsl_matrix_view_array(of_all, p, p);
  gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(solver), 1e-12, &all.matrix);
  for (size_t j = 0; j < p; j++)
    fit->error[j] = of_all[j * p + j] > 0 ? sqrt(of_all[j * p + j]) : INFINITY;
  for (size_t j = 0; j < p; j++)
    for (size_t k = 0; k < p; k++)
      fit->correlation[j][k] = of_all[j * p + k] / (fit->error[j] * fit->error[k]);
}

/* Least squares from `at`; returns the sum, INFINITY if no values make a wall. fit NULL: no errors
 * are needed. */
static double descend(search *s, double *at, int steps, double close, aspi_fit *fit) {
  size_t p = s->problem->n_unknown;
  gsl_multifit_nlinear_parameters how = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf fdf = {
      .f = residuals, .df = slopes, .n = s->n_moments, .p = p, .params = s};
  gsl_multifit_nlinear_workspace *solver =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &how, fdf.n, p);
  gsl_vector_view x = gsl_vector_view_array(at, p);
  double squares = INFINITY;
  int info;
  if (solver && !gsl_multifit_nlinear_init(&x.vector, &fdf, solver)) {
    gsl_multifit_nlinear_driver((size_t)steps, close, 1e-8, 1e-10, NULL, NULL, &info, solver);
    gsl_vector_memcpy(&x.vector, gsl_multifit_nlinear_position(solver));
    const gsl_vector *r = gsl_multifit_nlinear_residual(solver);
    gsl_blas_ddot(r, r, &squares);
    if (fit)
      find_errors(solver, p, fit);
  }
  if (solver)
    gsl_multifit_nlinear_free(solver);
  limit(s, at);
  return squares < NOT_A_MODEL * NOT_A_MODEL ? squares : INFINITY;
}

/* ---- the best start ---- */

static void progress(const search *s, double share) {
  if (s->problem->progress)
    s->problem->progress(s->problem->progress_context, share);
}

/* Finds the best end of a few searches. They begin at the caller's start, in the middle of the box,
 * and halfway to each of its sides. */
static asp_code look_around(search *s, aspi_fit *fit) {
  const aspi_calibration *p = s->problem;
  double best = INFINITY, squares[STARTS_MOST];
  const size_t starts = 2 * p->n_unknown + 2;
  for (size_t i = 0; i < starts; i++) {
    double at[FIT_UNKNOWNS_MOST];
    for (size_t j = 0; j < p->n_unknown; j++) {
      const aspi_unknown *u = &p->unknown[j];
      double side = i / 2 == j + 1 ? (i % 2 ? 0.25 : -0.25) : 0;
      at[j] = i == 0 ? u->scaled_start : (u->from + u->to) / 2 + side * (u->to - u->from);
    }
    squares[i] = descend(s, at, STEPS, 5e-3, NULL);
    if (squares[i] < best) {
      best = squares[i];
      memcpy(fit->at, at, sizeof fit->at);
    }
    progress(s, 0.6 * (double)i / (double)starts);
  }
  fit->starts = starts;
  for (size_t i = 0; i < starts; i++)
    fit->agreed += squares[i] <= best + AGREED;
  return isfinite(best) ? ASP_OK : ASP_EDATA;
}

/* ---- the result ---- */

static bool describes(double chi2, double dof) {
  return dof <= 0 || chi2 < DESCRIBED * dof || gsl_cdf_chisq_Q(chi2, dof) > CHANCE;
}

/* Fits with new weights of the model until the values stay; false: no such model. */
static bool settle(search *s, aspi_fit *fit) {
  double moved = INFINITY; /* in the last round, in errors */
  for (int round = 0; round < ROUNDS && moved > SETTLED; round++) {
    double before[FIT_UNKNOWNS_MOST];
    memcpy(before, fit->at, sizeof before);
    if (!weigh(s, fit->at))
      return false;
    fit->chi2 = descend(s, fit->at, STEPS, CLOSE, fit);
    moved = 0;
    for (size_t j = 0; j < s->problem->n_unknown; j++)
      moved = fmax(moved, fabs(fit->at[j] - before[j]) / fit->error[j]);
    progress(s, 0.6 + 0.3 * round / ROUNDS);
  }
  fit->converged = moved < WANDERING;
  return isfinite(fit->chi2);
}

/* The fit with weights of the data, then one with weights of the model if it describes the data. A
 * model with too little scatter would give its own misfit too much weight. */
static asp_code fit_all(search *s, aspi_fit *fit, bool by_model) {
  fit->chi2 = descend(s, fit->at, STEPS, CLOSE, fit);
  fit->dof = (double)(s->n_moments - s->problem->n_unknown);
  fit->described = describes(fit->chi2, fit->dof);
  fit->model_chi2 = fit->chi2;
  fit->converged = true;
  aspi_fit better = *fit;
  if (!by_model || !isfinite(fit->chi2))
    return isfinite(fit->chi2) ? ASP_OK : ASP_EDATA;
  bool fine = settle(s, &better);
  fit->described = better.described = fine && describes(better.chi2, better.dof);
  fit->model_chi2 = better.model_chi2 = better.chi2;
  if (fit->described)
    *fit = better;
  else
    weigh(s, NULL);
  return ASP_OK;
}

/* True if chi^2 with an unknown held there, the others at their best, is higher by that rise. */
static bool is_above(search *s, const aspi_fit *fit, double rise, size_t j, double held) {
  double others[FIT_UNKNOWNS_MOST], low = s->low[j], high = s->high[j];
  memcpy(others, fit->at, sizeof others);
  others[j] = s->low[j] = s->high[j] = held;
  bool above = descend(s, others, HALVING_STEPS, 1e-3, NULL) > fit->chi2 + rise;
  s->low[j] = low;
  s->high[j] = high;
  return above;
}

/* The value of an unknown, on the side of a bound, where chi^2 is higher by that rise. */
static double interval_end(search *s, const aspi_fit *fit, double rise, size_t j, double bound) {
  double inner = fit->at[j], outer = bound;
  for (int i = 0; i < HALVINGS; i++) {
    double middle = (inner + outer) / 2;
    *(is_above(s, fit, rise, j, middle) ? &outer : &inner) = middle;
  }
  return (inner + outer) / 2;
}

/* Where the data do not exclude an end of an unknown's search, all values up to there describe them
 * alike, and the start would decide between these. The unknown is then held at that end, or at its
 * default value if neither end is excluded, and the others are fitted there. Their intervals cover
 * those at the best fit, too. */
static void hold_open(search *s, aspi_fit *fit, double both) {
  const aspi_calibration *p = s->problem;
  search held = *s;
  bool open[FIT_UNKNOWNS_MOST], any = false;
  for (size_t j = 0; j < p->n_unknown; j++) {
    bool low = isinf(fit->low[j]), high = isinf(fit->high[j]);
    open[j] = low || high;
    any = any || open[j];
    if (open[j])
      held.low[j] = held.high[j] = low && high ? (p->unknown[j].from + p->unknown[j].to) / 2
                                   : low       ? s->low[j]
                                               : s->high[j];
  }
  if (!any)
    return;
  aspi_fit there = *fit;
  there.chi2 = descend(&held, there.at, STEPS, CLOSE, &there);
  fit->model_chi2 += there.chi2 - fit->chi2;
  fit->chi2 = there.chi2;
  for (size_t j = 0; j < p->n_unknown; j++) {
    fit->at[j] = there.at[j];
    fit->error[j] = there.error[j];
    if (!open[j]) {
      fit->low[j] = fmin(fit->low[j], there.at[j] - both * there.error[j]);
      fit->high[j] = fmax(fit->high[j], there.at[j] + both * there.error[j]);
    }
  }
}

/* 95 % of an unknown by its error; if the data do not exclude a bound, where chi^2 may be far from
 * a parabola, by the rise of chi^2 on the other side alone. */
static void find_intervals(search *s, aspi_fit *fit) {
  const aspi_calibration *p = s->problem;
  double n = 0;
  for (size_t b = 0; b < p->n_bins; b++)
    n += p->bins[b].moments.all;
  bool scaled = (!p->has_errors || !fit->described) && fit->dof > 0;
  double wide = scaled ? sqrt(fit->chi2 / fit->dof) : 1;
  double freedom = fmax(1, (p->has_errors ? n : (double)s->n_moments) - (double)p->n_unknown);
  double both = gsl_cdf_tdist_Pinv(0.975, freedom) * wide;
  double one = gsl_cdf_tdist_Pinv(0.95, freedom) * wide;
  for (size_t j = 0; j < p->n_unknown; j++) {
    double *low = &fit->low[j], *high = &fit->high[j];
    *low = fit->at[j] - both * fit->error[j];
    *high = fit->at[j] + both * fit->error[j];
    bool has_low = is_above(s, fit, both * both, j, s->low[j]);
    bool has_high = is_above(s, fit, both * both, j, s->high[j]);
    if (!has_low || !has_high) {
      *low = has_low ? interval_end(s, fit, one * one, j, s->low[j]) : -INFINITY;
      *high = has_high ? interval_end(s, fit, one * one, j, s->high[j]) : INFINITY;
    }
  }
  hold_open(s, fit, both);
  for (size_t j = 0; j < p->n_unknown; j++)
    fit->error[j] *= wide;
}

static asp_code find(search *s, aspi_fit *fit) {
  const aspi_calibration *p = s->problem;
  bool noisy = p->noise[0] > 0 || p->noise[1] > 0 || p->noise_speed > 0;
  for (size_t b = 0; b < p->n_bins; b++)
    for (int k = 0; k < MOMENTS; k++)
      s->n_moments += p->bins[b].used[k];
  weigh(s, NULL);
  s->samples = p->samples < SEARCH_SAMPLES ? p->samples : SEARCH_SAMPLES;
  asp_code code = look_around(s, fit);
  s->samples = p->samples;
  if (!code)
    code = fit_all(s, fit, p->has_errors && (!p->smooth || noisy));
  if (!code)
    find_intervals(s, fit);
  return !code && !set_model(s, fit->at) ? ASP_EDATA : code;
}

/* Says why the search fails, at its first start. */
static asp_code explain(search *s, asp_error *error) {
  const aspi_calibration *p = s->problem;
  double at[FIT_UNKNOWNS_MOST];
  aspi_bin_moments m;
  for (size_t j = 0; j < p->n_unknown; j++)
    at[j] = p->unknown[j].scaled_start;
  if (!set_model(s, at))
    return aspi_fail(error, ASP_EDATA,
                     "there is no such wall or law where the search begins (%s %g); give another "
                     "start with fit=VALUE",
                     p->unknown[0].name, aspi_unknown_value(&p->unknown[0], at[0]));
  for (size_t b = 0; b < p->n_bins; b++) {
    const aspi_calibration_bin *bin = &p->bins[b];
    for (int k = 0; k < MOMENTS; k++)
      if (bin->used[k] && k < MOMENT_STUCK && !(bin->moments.covariance[k][k] > 1e-20))
        return aspi_fail(error, ASP_EDATA,
                         "the %zu rows near %.3g degrees do not scatter, so they have no weight; "
                         "state them as means, with their errors where these are known",
                         bin->end - bin->first, bin->degrees);
    if (!simulate(s, b, &m) || !(m.rebounds > 0))
      return aspi_fail(error, ASP_EDATA,
                       "at %.3g degrees all particles stick to the model's wall, and those of the "
                       "data rebound; state a lower surface_energy, 'deposit off', or fit=VALUE",
                       bin->degrees);
  }
  return aspi_fail(error, ASP_EDATA,
                   "no start of the search gives a finite chi^2; give one with fit=VALUE");
}

asp_code aspi_calibration_find(aspi_calibration *p, aspi_fit *fit, asp_error *error) {
  search s = {.problem = p,
              .lower = calloc(p->n_bins, sizeof *s.lower),
              .xy = calloc(p->samples, sizeof *s.xy)};
  *fit = (aspi_fit){.starts = 0};
  for (size_t j = 0; j < p->n_unknown; j++) {
    bound_search(&p->unknown[j]);
    s.low[j] = p->unknown[j].low;
    s.high[j] = p->unknown[j].high;
  }
  asp_code code = s.lower && s.xy ? find(&s, fit) : ASP_ENOMEM;
  if (code == ASP_ENOMEM)
    aspi_fail(error, code, "out of memory for a fit");
  else if (code)
    code = explain(&s, error);
  free(s.lower);
  free(s.xy);
  return code;
}
