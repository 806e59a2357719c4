/* Least squares of whitened moments by GSL's nonlinear fit (Levenberg-Marquardt); see search.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/search.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Step of the unknowns for a derivative, wide enough to pass over the jumps that single impacts
 * make. */
#define TURN 0.04

/* Residual of each moment if the model rejects the values of the unknowns. */
#define NOT_A_MODEL 1e5

/* Least second derivative of the sum of squares, which keeps the matrix invertible; and the share
 * of the curvature in an unknown from which it counts as that alone. */
#define LEAST_CURVATURE 1e-8
#define BLIND 0.1

/* Offset per moment that keeps the sum of log-variances positive. */
#define LEAST_LOG 80.0

/* Impacts for the weights as a multiple of those of a fit: noise in the weights makes errors too
 * small. */
enum { WEIGHING = 4 };

/* Rounds of weights and a step, at most. From HALF_WAY_FROM on, values move only half of the step:
 * weights and values could alternate forever. */
enum { ROUNDS = 16, HALF_WAY_FROM = 4 };

/* The values have settled if a step is below this share of their errors; and if it is below the
 * second share when the rounds end, as single impacts make the derivatives rough. */
#define SETTLED 0.02
#define WANDERING 0.25

/* The longest step on the scale of an unknown. */
#define STEP_MOST 1.0

/* ---- the data ---------------------------------------------------------------------------------
 */

/* Pooled covariance of impacts about the means of their groups. */
static void pool(aspi_search *s) {
  double freedom = 0;
  for (size_t g = 0; g < s->problem->n_bins; g++) {
    const aspi_cloud_moments *m = &s->weights[g].data;
    if (!s->problem->groups[g].impacts.xy || m->rebounds < 2)
      continue;
    freedom += m->rebounds - 1;
    for (int k = 0; k < MOMENTS; k++)
      for (int l = 0; l < MOMENTS; l++)
        s->pooled[k][l] += (m->rebounds - 1) * m->covariance[k][l];
  }
  for (int k = 0; k < MOMENTS; k++)
    for (int l = 0; l < MOMENTS; l++)
      s->pooled[k][l] = freedom > 0 ? s->pooled[k][l] / freedom : k == l ? 1e-4 : 0;
}

void aspi_search_weigh_by_data(aspi_search *s) {
  s->by_model = false;
  for (size_t g = 0; g < s->problem->n_bins; g++)
    aspi_weights_set(&s->weights[g], &s->problem->groups[g], NULL, s->pooled);
}

bool aspi_search_begin(aspi_search *s, const aspi_calibration *p) {
  *s = (aspi_search){.problem = p,
                     .weights = calloc(p->n_bins, sizeof *s->weights),
                     .xy = calloc(WEIGHING * p->samples, sizeof *s->xy),
                     .samples = p->samples,
                     .by_model = p->known && (!p->smooth || p->noise[0] > 0 || p->noise[1] > 0 ||
                                              p->noise_speed > 0),
                     .held = -1};
  s->follows = s->by_model;
  if (!s->weights || !s->xy)
    return false;
  for (size_t g = 0; g < p->n_bins; g++) {
    const aspi_group *of = &p->groups[g];
    for (int k = 0; k < 2; k++)
      s->weights[g].center[k] = isfinite(of->mean[k]) ? of->mean[k] : 0;
    s->weights[g].data = aspi_group_moments(of, s->weights[g].center);
    for (int k = 0; k < MOMENTS; k++)
      s->n_moments += of->used[k];
  }
  pool(s);
  bool by_model = s->by_model;
  aspi_search_weigh_by_data(s);
  s->by_model = by_model;
  return true;
}

void aspi_search_end(aspi_search *s) {
  free(s->weights);
  free(s->xy);
}

/* ---- a point ----------------------------------------------------------------------------------
 */

static bool set_model(const aspi_search *s, const double *at) {
  const aspi_calibration *p = s->problem;
  double within[FIT_UNKNOWNS_MOST];
  for (size_t j = 0; j < p->n_unknown; j++)
    within[j] = fmin(fmax(at[j], p->unknown[j].low), p->unknown[j].high);
  return aspi_calibration_set(p, within);
}

static aspi_cloud_moments simulate(const aspi_search *s, size_t group, size_t samples) {
  aspi_cloud cloud = {s->xy, 0, 0};
  aspi_calibration_draw(s->problem, group, samples, &cloud);
  return aspi_cloud_moments_of(&cloud, s->weights[group].center);
}

static bool has_too_few(const aspi_group *g, const aspi_cloud_moments *model) {
  return model->rebounds < 2 && g->n > (double)g->impacts.deposits;
}

/* Takes the model's weights at these values; false: no such model. */
static bool weigh(aspi_search *s, const double *at) {
  const aspi_calibration *p = s->problem;
  if (!set_model(s, at))
    return false;
  for (size_t g = 0; g < p->n_bins; g++) {
    aspi_cloud_moments m = simulate(s, g, WEIGHING * s->samples);
    if (has_too_few(&p->groups[g], &m))
      return false;
    aspi_weights_set(&s->weights[g], &p->groups[g], &m, s->pooled);
  }
  return true;
}

/* The whitened differences of all moments, and the root of the logarithm of the determinant; false:
 * no such model. */
static bool differences(aspi_search *s, const double *at, gsl_vector *out) {
  const aspi_calibration *p = s->problem;
  bool fine = set_model(s, at);
  size_t place = 0;
  double log_determinant = LEAST_LOG * (double)s->n_moments;
  for (size_t g = 0; g < p->n_bins && fine; g++) {
    aspi_weights *w = &s->weights[g];
    aspi_cloud_moments m = simulate(s, g, s->samples);
    if (s->follows)
      aspi_weights_set(w, &p->groups[g], &m, s->pooled);
    fine = !has_too_few(&p->groups[g], &m);
    double off[MOMENTS];
    aspi_weights_apply(w, m.of, off);
    for (int k = 0; k < w->n; k++) {
      fine = fine && isfinite(off[k]);
      gsl_vector_set(out, place++, off[k]);
    }
    log_determinant += w->log_determinant;
  }
  if (!fine)
    gsl_vector_set_all(out, NOT_A_MODEL);
  else if (s->follows)
    gsl_vector_set(out, place, sqrt(fmax(0, log_determinant)));
  return fine;
}

static size_t rows_of(const aspi_search *s) {
  return s->n_moments + s->follows;
}

double aspi_search_squares(aspi_search *s, const double *at) {
  gsl_vector *r = gsl_vector_alloc(rows_of(s));
  double squares = INFINITY;
  if (r && differences(s, at, r))
    gsl_blas_ddot(r, r, &squares);
  gsl_vector_free(r);
  return squares;
}

/* ---- descent ----------------------------------------------------------------------------------
 */

/* Copies the free unknowns into the vector of all unknowns. */
static void spread_out(const aspi_search *s, const gsl_vector *x, double *at) {
  size_t k = 0;
  for (size_t j = 0; j < s->problem->n_unknown; j++)
    at[j] = (int)j == s->held ? s->held_at : gsl_vector_get(x, k++);
}

static int residuals(const gsl_vector *x, void *data, gsl_vector *out) {
  double at[FIT_UNKNOWNS_MOST];
  spread_out(data, x, at);
  differences(data, at, out);
  return GSL_SUCCESS;
}

/* Derivatives by central differences. */
static int slopes(const gsl_vector *x, void *data, gsl_matrix *out) {
  gsl_vector *at = gsl_vector_alloc(x->size), *down = gsl_vector_alloc(out->size1);
  int status = at && down ? GSL_SUCCESS : GSL_ENOMEM;
  for (size_t j = 0; j < x->size && !status; j++) {
    gsl_vector_view up = gsl_matrix_column(out, j);
    gsl_vector_memcpy(at, x);
    gsl_vector_set(at, j, gsl_vector_get(x, j) + TURN);
    residuals(at, data, &up.vector);
    gsl_vector_set(at, j, gsl_vector_get(x, j) - TURN);
    residuals(at, data, down);
    gsl_vector_sub(&up.vector, down);
    gsl_vector_scale(&up.vector, 1 / (2 * TURN));
  }
  gsl_vector_free(at);
  gsl_vector_free(down);
  return status;
}

/* Moves values back to where the search may go. */
static void limit(const aspi_calibration *p, double *at) {
  for (size_t j = 0; j < p->n_unknown; j++)
    at[j] = fmin(fmax(at[j], p->unknown[j].low), p->unknown[j].high);
}

double aspi_search_descend(aspi_search *s, double *at, int steps, double close) {
  const aspi_calibration *p = s->problem;
  size_t unknowns = p->n_unknown - (s->held >= 0), k = 0;
  if (unknowns == 0)
    return aspi_search_squares(s, at);
  gsl_multifit_nlinear_parameters how = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf fdf = {
      .f = residuals, .df = slopes, .n = rows_of(s), .p = unknowns, .params = s};
  gsl_multifit_nlinear_workspace *solver =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &how, fdf.n, fdf.p);
  gsl_vector *x = gsl_vector_alloc(unknowns);
  double squares = INFINITY;
  for (size_t j = 0; x && j < p->n_unknown; j++)
    if ((int)j != s->held)
      gsl_vector_set(x, k++, at[j]);
  if (solver && x && !gsl_multifit_nlinear_init(x, &fdf, solver)) {
    int info;
    gsl_multifit_nlinear_driver((size_t)steps, close, 1e-8, 1e-10, NULL, NULL, &info, solver);
    spread_out(s, gsl_multifit_nlinear_position(solver), at);
    const gsl_vector *r = gsl_multifit_nlinear_residual(solver);
    gsl_blas_ddot(r, r, &squares);
  }
  limit(p, at);
  if (solver)
    gsl_multifit_nlinear_free(solver);
  gsl_vector_free(x);
  return squares;
}

/* ---- steps to the end -------------------------------------------------------------------------
 */

/* Errors from the covariance of the unknowns, A^-1 B A^-1 with A = J'J and B = J'SJ, where J are
 * the derivatives of the whitened moments and S is their covariance. Takes A^-1 and scratch like J.
 */
static void find_errors(const aspi_search *s, const gsl_matrix *derivatives,
                        const gsl_matrix *inverse, gsl_matrix *turned, aspi_fit *fit) {
  size_t row = 0, p = derivatives->size2;
  double of_all[FIT_UNKNOWNS_MOST * FIT_UNKNOWNS_MOST];
  gsl_matrix_view all = gsl_matrix_view_array(of_all, p, p);
  gsl_matrix_view product = gsl_matrix_submatrix(turned, 0, 0, p, p);
  double expected =
      0; /* chi^2, below its degrees of freedom by the ridge (Satorra & Bentler 1994) */
  for (size_t g = 0; g < s->problem->n_bins; g++) {
    aspi_weights *w = &s->weights[g];
    size_t n = (size_t)w->n;
    if (n == 0)
      continue;
    gsl_matrix_view of = gsl_matrix_view_array_with_tda(w->whitened[0], n, n, MOMENTS);
    gsl_matrix_const_view from = gsl_matrix_const_submatrix(derivatives, row, 0, n, p);
    gsl_matrix_view to = gsl_matrix_submatrix(turned, row, 0, n, p);
    gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, &of.matrix, &from.matrix, 0, &to.matrix);
    for (size_t k = 0; k < n; k++)
      expected += w->whitened[k][k];
    row += n;
  }
  gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, derivatives, turned, 0, &all.matrix);
  gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, inverse, &all.matrix, 0, &product.matrix);
  for (size_t j = 0; j < p; j++)
    expected -= gsl_matrix_get(&product.matrix, j, j);
  fit->dof = (double)s->n_moments - (double)p;
  fit->chi2 *= fit->dof > 0 ? fit->dof / expected : 1;
  gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, &product.matrix, inverse, 0, &all.matrix);
  for (size_t j = 0; j < p; j++) {
    double naive = gsl_matrix_get(inverse, j, j);
    bool blind = naive > BLIND / LEAST_CURVATURE; /* chi^2 does not depend on it, at a bound */
    double variance = blind ? naive : gsl_matrix_get(&all.matrix, j, j);
    fit->error[j] = sqrt(variance);
    fit->rise[j] = variance / naive;
    for (size_t k = 0; k < p; k++)
      fit->correlation[j][k] = gsl_matrix_get(&all.matrix, j, k);
  }
  for (size_t j = 0; j < p; j++)
    for (size_t k = 0; k < p; k++)
      fit->correlation[j][k] /= fit->error[j] * fit->error[k];
}

/* The step to the minimum from fit->at, and all of `fit` that belongs to the values there, as if
 * the moments were linear in the unknowns. A direction without influence has a large error. */
static bool solve(aspi_search *s, aspi_fit *fit, double step[FIT_UNKNOWNS_MOST]) {
  size_t p = s->problem->n_unknown, n = s->n_moments;
  gsl_vector_view at = gsl_vector_view_array(fit->at, p), to = gsl_vector_view_array(step, p);
  gsl_matrix *derivatives = gsl_matrix_alloc(n, p), *turned = gsl_matrix_alloc(n, p),
             *inverse = gsl_matrix_alloc(p, p);
  gsl_vector *r = gsl_vector_alloc(n), *gradient = gsl_vector_alloc(p);
  s->follows = false;
  bool fine = derivatives && turned && inverse && r && gradient &&
              (!s->by_model || weigh(s, fit->at)) && differences(s, fit->at, r) &&
              !slopes(&at.vector, s, derivatives);
  if (fine) {
    gsl_blas_ddot(r, r, &fit->chi2);
    gsl_blas_dgemv(CblasTrans, 1, derivatives, r, 0, gradient);
    gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, derivatives, derivatives, 0, inverse);
    for (size_t k = 0; k < p; k++)
      *gsl_matrix_ptr(inverse, k, k) += LEAST_CURVATURE;
    fine = !gsl_linalg_cholesky_decomp1(inverse) && !gsl_linalg_cholesky_invert(inverse);
  }
  if (fine) {
    gsl_blas_dgemv(CblasNoTrans, -1, inverse, gradient, 0, &to.vector);
    find_errors(s, derivatives, inverse, turned, fit);
  }
  gsl_matrix_free(derivatives);
  gsl_matrix_free(turned);
  gsl_matrix_free(inverse);
  gsl_vector_free(r);
  gsl_vector_free(gradient);
  return fine;
}

bool aspi_search_settle(aspi_search *s, aspi_fit *fit) {
  const aspi_calibration *p = s->problem;
  double moved = INFINITY; /* in the last round, in errors */
  for (int round = 0; round < ROUNDS && moved > SETTLED; round++) {
    double step[FIT_UNKNOWNS_MOST], before[FIT_UNKNOWNS_MOST];
    if (!solve(s, fit, step))
      return false;
    memcpy(before, fit->at, sizeof before);
    for (size_t j = 0; j < p->n_unknown; j++)
      fit->at[j] += fmin(fmax(step[j], -STEP_MOST), STEP_MOST) / (round < HALF_WAY_FROM ? 1 : 2);
    limit(p, fit->at);
    moved = 0;
    for (size_t j = 0; j < p->n_unknown; j++)
      moved = fmax(moved, fabs(fit->at[j] - before[j]) / fit->error[j]);
  }
  fit->converged = moved < WANDERING;
  return true;
}
