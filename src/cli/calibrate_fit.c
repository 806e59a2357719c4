/* The fit of `asperity calibrate`. At each place that was measured, the moments of what rebounds
 * (means, variances and covariance of v_N2/v1 and v_T2/v1) and the share that sticks are compared
 * with those of simulated impacts, which have the same random numbers for all values of the
 * unknowns, so that the sum of squares is smooth; GSL's nonlinear least squares (Levenberg &
 * Marquardt) finds its minimum. Each moment counts by its covariance in a sample of the data's
 * size: at first by that of the data themselves; then, where the model describes them, by that of
 * the model at the values found so far, with that of the simulation added, which small samples
 * need. Where it does not, the first stays, and the standard errors are scaled by the root of chi^2
 * per degree of freedom.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/calibrate.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <stdlib.h>

/* Rounds of new weights, steps of each, and how far the unknowns are moved on their scale
 * for a derivative. */
enum { ROUNDS = 3, STEPS_MOST = 12 };
#define TURN 0.04

/* The covariance is that of so many times the simulated impacts: what it is off makes an estimate
 * worse than its standard error says, for moments have long tails. */
enum { WEIGHING = 10 };

/* A model describes the data when chi^2 per degree of freedom is less, by the variances of the data
 * alone: where wall and law leave one freedom, moments hang together so closely that the covariance
 * of a sample is no guide. On a smooth wall it counts, in bins with no fewer impacts than FEW. */
#define DESCRIBED 3
enum { FEW = 20 };

/* Of the variances of a moment, so that one that does not vary can be weighed. */
#define FLOOR 1e-12

typedef struct work {
  calibration *c;
  double (*moment)[MOMENTS];
  double (*covariance)[MOMENTS][MOMENTS];
  double (*lower)[MOMENTS][MOMENTS]; /* Cholesky factors of the used moments of each bin */
  bool by_model;                     /* whether the covariance is the model's */
} work;

/* The covariance of a bin's moments, of a sample of the data's size and one of the simulation's. A
 * smooth wall without noise has none of its own, and takes the data's throughout. */
static void weigh_bin(const work *w, size_t b) {
  const calibration *c = w->c;
  const calibrate_bin *bin = &c->bins[b];
  bool scatters = !c->smooth || c->noise_angle > 0 || c->noise_speed > 0;
  bool own = w->by_model && scatters, alone = !own && (scatters || bin->n < FEW);
  double share = 1 / bin->n + (scatters ? 1 / (double)c->samples : 0);
  int map[MOMENTS], n = 0;
  double turn[MOMENTS]; /* d root/d variance */
  for (int k = 0; k < MOMENTS; k++)
    turn[k] = c->data.means && (k == VAR_X || k == VAR_Y)
                  ? 0.5 / sqrt(fmax((own ? w->moment[b] : bin->moment)[k], FLOOR))
                  : 1;
  for (int k = 0; k < MOMENTS; k++)
    if (bin->used[k])
      map[n++] = k;
  if (n == 0)
    return;
  double block[MOMENTS * MOMENTS];
  gsl_matrix_view m = gsl_matrix_view_array(block, (size_t)n, (size_t)n);
  for (int k = 0; k < n; k++)
    for (int l = 0; l < n; l++) {
      double of_model = w->covariance[b][map[k]][map[l]];
      double each = own || map[k] == STUCK ? of_model : bin->covariance[map[k]][map[l]];
      each = alone && k != l ? 0 : each * turn[map[k]] * turn[map[l]];
      if (c->data.means && own && map[k] == map[l] && map[k] <= MEAN_Y && !(bin->n > 1))
        each = fmax(each, bin->covariance[map[k]][map[k]]);
      gsl_matrix_set(&m.matrix, (size_t)k, (size_t)l, each * share + (k == l ? FLOOR : 0));
    }
  if (gsl_linalg_cholesky_decomp1(&m.matrix)) /* take them one by one */
    for (int k = 0; k < n; k++)
      for (int l = 0; l < n; l++)
        gsl_matrix_set(&m.matrix, (size_t)k, (size_t)l,
                       k == l ? sqrt(fmax(FLOOR, w->covariance[b][map[k]][map[k]] * share)) : 0);
  for (int k = 0; k < n; k++)
    for (int l = 0; l <= k; l++)
      w->lower[b][k][l] = gsl_matrix_get(&m.matrix, (size_t)k, (size_t)l);
}

/* A moment as it is compared: of means, the standard deviation that they come with; of impacts the
 * variance, since with the covariance it makes what hangs together do so in a straight line. */
static double compared(const calibration *c, int k, double value) {
  return c->data.means && (k == VAR_X || k == VAR_Y) ? sqrt(fmax(value, FLOOR)) : value;
}

/* Differences of the moments, made independent and of variance 1. */
static int residuals(const gsl_vector *scaled, void *data, gsl_vector *out) {
  work *w = data;
  calibration *c = w->c;
  if (!calibrate_set(c, scaled))
    return GSL_EDOM;
  calibrate_moments(c, w->moment, NULL);
  size_t at = 0;
  for (size_t b = 0; b < c->n_bins; b++) {
    double solved[MOMENTS];
    for (int k = 0, n = 0; k < MOMENTS; k++) {
      if (!c->bins[b].used[k])
        continue;
      double off = compared(c, k, w->moment[b][k]) - compared(c, k, c->bins[b].moment[k]);
      for (int l = 0; l < n; l++)
        off -= w->lower[b][n][l] * solved[l];
      solved[n] = off / w->lower[b][n][n];
      if (!isfinite(solved[n]))
        return GSL_EDOM;
      gsl_vector_set(out, at++, solved[n++]);
    }
  }
  return GSL_SUCCESS;
}

/* By central differences, wide enough to pass over the steps of single impacts. */
static int slopes(const gsl_vector *scaled, void *data, gsl_matrix *out) {
  work *w = data;
  size_t n = w->c->n_moments;
  gsl_vector *at = gsl_vector_alloc(scaled->size), *up = gsl_vector_alloc(n),
             *down = gsl_vector_alloc(n);
  int status = at && up && down ? GSL_SUCCESS : GSL_ENOMEM;
  for (size_t j = 0; j < scaled->size && !status; j++) {
    gsl_vector_memcpy(at, scaled);
    gsl_vector_set(at, j, gsl_vector_get(scaled, j) + TURN);
    status = residuals(at, w, up);
    gsl_vector_set(at, j, gsl_vector_get(scaled, j) - TURN);
    status = status ? status : residuals(at, w, down);
    for (size_t i = 0; i < n && !status; i++)
      gsl_matrix_set(out, i, j, (gsl_vector_get(up, i) - gsl_vector_get(down, i)) / (2 * TURN));
  }
  gsl_vector_free(at);
  gsl_vector_free(up);
  gsl_vector_free(down);
  return status;
}

static void weigh(work *w, const gsl_vector *scaled, bool by_model) {
  w->by_model = by_model;
  if (!calibrate_set(w->c, scaled))
    cli_fail("no wall can be made of the values that the fit has come to");
  size_t samples = w->c->samples;
  w->c->samples *= by_model ? WEIGHING : 1;
  calibrate_moments(w->c, w->moment, w->covariance);
  w->c->samples = samples;
  for (size_t b = 0; b < w->c->n_bins; b++)
    weigh_bin(w, b);
}

static double squares_at(work *w, const gsl_vector *scaled, gsl_vector *r) {
  double chi2;
  if (residuals(scaled, w, r))
    return INFINITY;
  gsl_blas_ddot(r, r, &chi2);
  return chi2;
}

/* Where to begin: the best of some values around those given, one unknown after the other. */
static void look_around(work *w, gsl_vector *scaled) {
  calibration *c = w->c;
  static const double turns[2][5] = {{-1, -0.5, 0, 0.5, 1}, {-0.25, 0, 0.25}};
  static const size_t counts[2] = {5, 3};
  gsl_vector *r = gsl_vector_alloc(c->n_moments), *at = gsl_vector_alloc(c->n_unknown);
  weigh(w, scaled, false);
  for (int pass = 0; pass < 2; pass++)
    for (size_t j = 0; j < c->n_unknown; j++) {
      double best = INFINITY, best_turn = 0;
      for (size_t k = 0; k < counts[pass]; k++) {
        gsl_vector_memcpy(at, scaled);
        gsl_vector_set(at, j, gsl_vector_get(at, j) + turns[pass][k]);
        double chi2 = squares_at(w, at, r);
        if (chi2 < best) {
          best = chi2;
          best_turn = turns[pass][k];
        }
      }
      gsl_vector_set(scaled, j, gsl_vector_get(scaled, j) + best_turn);
    }
  gsl_vector_free(r);
  gsl_vector_free(at);
}

calibrate_fit calibrate_run(calibration *c) {
  work w = {c, cli_allocate(c->n_bins, sizeof *w.moment),
            cli_allocate(c->n_bins, sizeof *w.covariance), cli_allocate(c->n_bins, sizeof *w.lower),
            false};
  gsl_multifit_nlinear_parameters how = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf fdf = {
      .f = residuals, .df = slopes, .n = c->n_moments, .p = c->n_unknown, .params = &w};
  gsl_multifit_nlinear_workspace *solver =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &how, fdf.n, fdf.p);
  calibrate_fit result = {.scaled = gsl_vector_alloc(fdf.p),
                          .covariance = gsl_matrix_alloc(fdf.p, fdf.p),
                          .dof = (double)(c->n_moments - c->n_unknown)};
  if (!solver || !result.scaled || !result.covariance)
    cli_fail("out of memory");
  for (size_t i = 0; i < c->n_unknown; i++)
    gsl_vector_set(result.scaled, i, calibrate_scaled(&c->unknown[i], c->unknown[i].start));
  look_around(&w, result.scaled);
  cli_progress progress = cli_progress_begin("fit", ROUNDS);
  for (int round = 0; round < ROUNDS; round++) {
    int info;
    weigh(&w, result.scaled, round > 0);
    if (gsl_multifit_nlinear_init(result.scaled, &fdf, solver))
      cli_fail("the model has no moments at the values that the fit has come to");
    gsl_multifit_nlinear_driver(STEPS_MOST, round + 1 < ROUNDS ? 1e-3 : 1e-5, 1e-8, 1e-8, NULL,
                                NULL, &info, solver);
    gsl_vector_memcpy(result.scaled, gsl_multifit_nlinear_position(solver));
    cli_progress_show(&progress, round + 1);
    gsl_vector *r = gsl_multifit_nlinear_residual(solver);
    gsl_blas_ddot(r, r, &result.chi2);
    result.described = result.chi2 <= DESCRIBED * fmax(1, result.dof);
    if (!c->known || !result.described)
      break;
  }
  cli_progress_end(&progress);
  gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(solver), 0, result.covariance);
  if ((!c->known || !result.described) && result.dof > 0)
    gsl_matrix_scale(result.covariance, result.chi2 / result.dof);
  calibrate_set(c, result.scaled);
  gsl_multifit_nlinear_free(solver);
  free(w.moment);
  free(w.covariance);
  free(w.lower);
  return result;
}
