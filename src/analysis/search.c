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

/* Least second derivative of the sum of squares; keeps the matrix invertible. */
#define LEAST_CURVATURE 1e-8

/* Offset per moment that keeps the sum of log-variances positive. */
#define LEAST_LOG 80.0

/* Impacts for the weights, and for the derivatives, as multiples of those of a fit: noise in the
 * weights makes errors too small. */
enum { WEIGHING = 4 };

/* The values have settled if new weights and one more step move them by less than this share of
 * their errors. A step is small if it is below the second share. */
#define SETTLED 0.02
#define SMALL 0.5

/* Values also count as settled if they still vary by less than this share of their errors when the
 * rounds end: single impacts cause that. */
#define WANDERING 0.25

/* From this round on, values move only half of the step: weights and values could alternate
 * forever. */
enum { HALF_WAY_FROM = 4 };

/* ---- the data ---------------------------------------------------------------------------------
 */

static aspi_cloud_frame frame_of(const aspi_group *g) {
  double x = isfinite(g->mean[0]) ? g->mean[0] : 0, y = isfinite(g->mean[1]) ? g->mean[1] : 0;
  return aspi_cloud_frame_at(x, y);
}

/* Pooled covariance of impacts about the means of their groups. */
static void pool(aspi_search *s) {
  double freedom = 0;
  for (size_t g = 0; g < s->problem->n_bins; g++) {
    aspi_cloud_moments m = s->weights[g].data;
    if (!s->groups[g].impacts.xy || m.rebounds < 2)
      continue;
    freedom += m.rebounds - 1;
    for (int k = 0; k < MOMENTS; k++)
      for (int l = 0; l < MOMENTS; l++)
        s->pooled[k][l] += (m.rebounds - 1) * m.covariance[k][l];
  }
  for (int k = 0; k < MOMENTS; k++)
    for (int l = 0; l < MOMENTS; l++)
      s->pooled[k][l] = freedom > 0 ? s->pooled[k][l] / freedom : k == l ? 1e-4 : 0;
}

bool aspi_search_begin(aspi_search *s, const aspi_calibration *p) {
  size_t most = WEIGHING * p->samples;
  for (size_t g = 0; g < p->n_bins; g++)
    most = p->groups[g].impacts.rebounds > most ? p->groups[g].impacts.rebounds : most;
  *s = (aspi_search){.problem = p,
                     .groups = p->groups,
                     .weights = calloc(p->n_bins, sizeof *s->weights),
                     .xy = calloc(p->n_bins * most, sizeof *s->xy),
                     .room = calloc(2 * most * p->n_bins, sizeof *s->room),
                     .most = most,
                     .samples = p->samples,
                     .held = -1};
  if (!s->weights || !s->xy || !s->room)
    return false;
  for (size_t g = 0; g < p->n_bins; g++) {
    aspi_weights *w = &s->weights[g];
    w->frame = frame_of(&p->groups[g]);
    if (!p->scatters)
      aspi_cloud_frame_cut(&w->frame, &p->groups[g].impacts, p->huber, s->room);
    w->data = aspi_group_moments(&p->groups[g], &w->frame);
    for (int k = 0; k < MOMENTS; k++)
      s->n_moments += p->groups[g].used[k];
  }
  pool(s);
  return true;
}

void aspi_search_end(aspi_search *s) {
  free(s->weights);
  free(s->xy);
  free(s->room);
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

static aspi_cloud draw(const aspi_search *s, size_t group, size_t samples) {
  aspi_cloud cloud = {s->xy + group * s->most, 0, 0};
  aspi_calibration_draw(s->problem, group, samples, 0, &cloud);
  return cloud;
}

/* Simulates the moments of a group, and computes its weights from the data and the model. */
static bool weigh_group(aspi_search *s, size_t g, size_t samples, double *model) {
  const aspi_calibration *p = s->problem;
  aspi_weights *w = &s->weights[g];
  aspi_cloud cloud = draw(s, g, samples);
  if (cloud.rebounds < 2 && s->groups[g].n > (double)s->groups[g].impacts.deposits)
    return false;
  if (p->scatters && isfinite(p->huber)) {
    aspi_cloud_frame_cut(&w->frame, &cloud, p->huber, s->room + 2 * g * s->most);
    w->data = aspi_group_moments(&s->groups[g], &w->frame);
  }
  aspi_cloud_moments m = aspi_cloud_moments_of(&cloud, &w->frame);
  aspi_weights_set(w, &s->groups[g], &m, s->pooled, s->kind);
  memcpy(model, m.of, sizeof m.of);
  return true;
}

/* The whitened differences of all groups; false if the model rejects these values. */
static bool differences(aspi_search *s, const double *at, size_t samples, bool weigh,
                        gsl_vector *out) {
  size_t groups = s->problem->n_bins;
  bool fine = set_model(s, at);
  double log_determinant = 0;
  double(*off)[MOMENTS] = malloc(groups * sizeof *off);
  fine = fine && off;
  if (fine) {
    for (size_t g = 0; g < groups; g++) {
      double model[MOMENTS];
      if (weigh) {
        fine = weigh_group(s, g, samples, model) && fine;
      } else {
        aspi_cloud cloud = draw(s, g, samples);
        aspi_cloud_moments m = aspi_cloud_moments_of(&cloud, &s->weights[g].frame);
        memcpy(model, m.of, sizeof model);
      }
      if (fine)
        aspi_weights_apply(&s->weights[g], model, off[g]);
    }
  }
  size_t at_moment = 0;
  for (size_t g = 0; g < groups && fine && out; g++)
    for (int k = 0; k < s->weights[g].n; k++) {
      fine = fine && isfinite(off[g][k]);
      gsl_vector_set(out, at_moment++, off[g][k]);
    }
  for (size_t g = 0; g < groups; g++)
    log_determinant += s->weights[g].log_determinant;
  if (fine && out && !s->fixed)
    gsl_vector_set(out, at_moment,
                   sqrt(fmax(0, LEAST_LOG * (double)s->n_moments + log_determinant)));
  free(off);
  return fine;
}

/* Takes frames, data and weights for these values; false: no such model. */
static bool find_weights(aspi_search *s, const double *at) {
  return differences(s, at, s->samples * (s->kind == WEIGHTS_DATA ? 1 : WEIGHING), true, NULL);
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
  aspi_search *s = data;
  double at[FIT_UNKNOWNS_MOST];
  spread_out(s, x, at);
  if (!differences(s, at, s->samples, !s->fixed, out))
    gsl_vector_set_all(out, NOT_A_MODEL);
  return GSL_SUCCESS;
}

/* Derivatives by central differences; one-sided ones in a rough search. */
static int slopes(const gsl_vector *x, void *data, gsl_matrix *out) {
  const aspi_search *s = data;
  double back = s->fixed ? -TURN : 0;
  gsl_vector *at = gsl_vector_alloc(x->size), *up = gsl_vector_alloc(out->size1),
             *down = gsl_vector_alloc(out->size1);
  int status = at && up && down ? GSL_SUCCESS : GSL_ENOMEM;
  if (!status && !s->fixed)
    residuals(x, data, down);
  for (size_t j = 0; j < x->size && !status; j++) {
    gsl_vector_memcpy(at, x);
    gsl_vector_set(at, j, gsl_vector_get(x, j) + TURN);
    residuals(at, data, up);
    if (s->fixed) {
      gsl_vector_set(at, j, gsl_vector_get(x, j) + back);
      residuals(at, data, down);
    }
    gsl_vector_sub(up, down);
    gsl_vector_scale(up, 1 / (TURN - back));
    gsl_matrix_set_col(out, j, up);
  }
  gsl_vector_free(at);
  gsl_vector_free(up);
  gsl_vector_free(down);
  return status;
}

static size_t rows_of(const aspi_search *s) {
  return s->n_moments + !s->fixed;
}

double aspi_search_squares(aspi_search *s, const double *at) {
  gsl_vector *r = gsl_vector_alloc(rows_of(s));
  double squares = INFINITY;
  if (r && differences(s, at, s->samples, !s->fixed, r))
    gsl_blas_ddot(r, r, &squares);
  gsl_vector_free(r);
  return squares;
}

double aspi_search_descend(aspi_search *s, double *at, int steps, double close,
                           gsl_matrix *derivatives, gsl_vector *gradient) {
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
    gsl_vector *r = gsl_multifit_nlinear_residual(solver);
    gsl_blas_ddot(r, r, &squares);
    if (derivatives) {
      gsl_matrix_memcpy(derivatives, gsl_multifit_nlinear_jac(solver));
      gsl_blas_dgemv(CblasTrans, 1, derivatives, r, 0, gradient);
    }
  }
  for (size_t j = 0; j < p->n_unknown; j++)
    at[j] = fmin(fmax(at[j], p->unknown[j].low), p->unknown[j].high);
  if (solver)
    gsl_multifit_nlinear_free(solver);
  gsl_vector_free(x);
  return squares;
}

/* ---- weights and least squares in turn --------------------------------------------------------
 */

/* Covariance of the unknowns, A^-1 B A^-1 with A = J'J and B = J'SJ: the whitening has a ridge, and
 * S is the covariance of the whitened moments. A direction without influence has a large variance.
 * Also returns the expected chi^2 per degree of freedom, below 1 because of the ridge (Satorra &
 * Bentler 1994), and the next Gauss-Newton step. */
static bool covariance_of(const aspi_search *s, const gsl_matrix *derivatives,
                          const gsl_vector *gradient, gsl_matrix *out, gsl_vector *step,
                          double *mean_chi2) {
  size_t n = derivatives->size1, p = derivatives->size2, row = 0;
  gsl_matrix *inverse = gsl_matrix_alloc(p, p), *middle = gsl_matrix_alloc(p, p),
             *turned = gsl_matrix_calloc(n, p);
  bool fine = inverse && middle && turned;
  double trace = 0;
  for (size_t g = 0; fine && g < s->problem->n_bins; g++) {
    const aspi_weights *w = &s->weights[g];
    for (int i = 0; i < w->n; i++)
      trace += w->whitened[i][i];
    for (int i = 0; i < w->n; i++)
      for (int j = 0; j < w->n; j++)
        for (size_t k = 0; k < p; k++)
          *gsl_matrix_ptr(turned, row + (size_t)i, k) +=
              w->whitened[i][j] * gsl_matrix_get(derivatives, row + (size_t)j, k);
    row += (size_t)w->n;
  }
  if (fine) {
    gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, derivatives, derivatives, 0, inverse);
    for (size_t k = 0; k < p; k++)
      *gsl_matrix_ptr(inverse, k, k) += LEAST_CURVATURE;
    fine = !gsl_linalg_cholesky_decomp1(inverse) && !gsl_linalg_cholesky_invert(inverse);
  }
  if (fine) {
    gsl_blas_dgemv(CblasNoTrans, -1, inverse, gradient, 0, step);
    gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, derivatives, turned, 0, middle);
    gsl_matrix_view top = gsl_matrix_submatrix(turned, 0, 0, p, p); /* scratch from here on */
    gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, inverse, middle, 0, &top.matrix);
    for (size_t k = 0; k < p; k++)
      trace -= gsl_matrix_get(&top.matrix, k, k);
    *mean_chi2 = n > p ? trace / (double)(n - p) : 1;
    gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, &top.matrix, inverse, 0, out);
    for (size_t k = 0; k < p; k++) /* at a bound the fit does not depend on the unknown */
      if (!(gsl_matrix_get(out, k, k) > 0))
        gsl_matrix_set(out, k, k, 1 / LEAST_CURVATURE);
  }
  gsl_matrix_free(inverse);
  gsl_matrix_free(middle);
  gsl_matrix_free(turned);
  return fine;
}

/* Takes the Gauss-Newton step if it is small: single impacts make the sum of squares too rough for
 * a descent to end where its derivatives vanish. True if the step is so small that the values have
 * settled. */
static bool go_on(const aspi_search *s, double *at, const gsl_vector *step,
                  const gsl_matrix *covariance) {
  double most = 0;
  for (size_t j = 0; j < step->size; j++)
    most = fmax(most, fabs(gsl_vector_get(step, j)) / sqrt(gsl_matrix_get(covariance, j, j)));
  for (size_t j = 0; j < step->size && most < SMALL && most > SETTLED; j++)
    at[j] = fmin(fmax(at[j] + gsl_vector_get(step, j), s->problem->unknown[j].low),
                 s->problem->unknown[j].high);
  return most <= SETTLED;
}

bool aspi_search_settle(aspi_search *s, double *at, int rounds, double *chi2,
                        gsl_matrix *covariance) {
  size_t p = s->problem->n_unknown;
  gsl_matrix *derivatives = gsl_matrix_alloc(s->n_moments, p);
  gsl_vector *gradient = gsl_vector_alloc(p), *step = gsl_vector_alloc(p);
  bool fine = derivatives && gradient && step, settled = false;
  double moved = INFINITY; /* in the last round, in errors */
  s->fixed = true;
  *chi2 = INFINITY;
  for (int round = 0; fine && round < rounds && !settled; round++) {
    double mean_chi2, before[FIT_UNKNOWNS_MOST];
    memcpy(before, at, sizeof before);
    if (!find_weights(s, at))
      break;
    *chi2 = aspi_search_descend(s, at, round ? 1 : 3, 1e-4, derivatives, gradient);
    fine = isfinite(*chi2) && covariance_of(s, derivatives, gradient, covariance, step, &mean_chi2);
    if (!fine)
      break;
    *chi2 /= mean_chi2;
    settled = go_on(s, at, step, covariance);
    for (size_t j = 0; j < p && round >= HALF_WAY_FROM; j++)
      at[j] = (at[j] + before[j]) / 2;
    moved = 0;
    for (size_t j = 0; j < p; j++) {
      double by = fabs(at[j] - before[j]), error = sqrt(gsl_matrix_get(covariance, j, j));
      settled = settled && by < SETTLED * error + 1e-5;
      moved = fmax(moved, by / error);
    }
  }
  gsl_matrix_free(derivatives);
  gsl_vector_free(gradient);
  gsl_vector_free(step);
  return settled || (fine && moved < WANDERING);
}
