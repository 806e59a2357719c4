/* What the menders of profiles and of maps have in common: least squares, and points far off the
 * median of their neighbours.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/mend.h"
#include "base/error.h"

#include <gsl/gsl_linalg.h>
#include <gsl/gsl_rstat.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

/* From the median absolute deviation to the sd of a normal law. */
#define MAD_TO_SD 1.4826

/* Equations whose triangle has a diagonal of this range fix no polynomial. */
#define SINGULAR 1e-13

/* The terms are nearly orthogonal on the grid, so that nothing is lost by normal equations. */
void aspi_fit_add(aspi_fit *fit, const double *t, double z) {
  for (size_t j = 0; j < fit->terms; j++) {
    fit->b[j] += t[j] * z;
    for (size_t k = 0; k < fit->terms; k++)
      fit->a[j * fit->terms + k] += t[j] * t[k];
  }
}

/* By QR, which GSL does without memory of its own and without calling its error handler. */
bool aspi_fit_solve(aspi_fit *fit) {
  double tau_of[ASP_FORM_TERMS], most = 0, least = INFINITY;
  gsl_matrix_view a = gsl_matrix_view_array(fit->a, fit->terms, fit->terms);
  gsl_vector_view b = gsl_vector_view_array(fit->b, fit->terms);
  gsl_vector_view tau = gsl_vector_view_array(tau_of, fit->terms);
  gsl_linalg_QR_decomp(&a.matrix, &tau.vector);
  for (size_t j = 0; j < fit->terms; j++) {
    double diagonal = fabs(fit->a[j * (fit->terms + 1)]);
    most = fmax(most, diagonal);
    least = fmin(least, diagonal);
  }
  if (!(least > SINGULAR * most))
    return false;
  gsl_linalg_QR_svx(&a.matrix, &tau.vector, &b.vector);
  return true;
}

double aspi_fit_value(const aspi_fit *fit, const double *t) {
  double value = 0;
  for (size_t j = 0; j < fit->terms; j++)
    value += fit->b[j] * t[j];
  return value;
}

double aspi_off_median(double z, double *window, size_t count) {
  if (count == 0)
    return 0;
  gsl_sort(window, 1, count);
  return fabs(z - gsl_stats_median_from_sorted_data(window, 1, count));
}

/* In two passes: the usual distance, then what is far beyond it. */
bool *aspi_spikes(const void *raw, const aspi_steps *steps, size_t points, aspi_off_neighbours *off,
                  double times, asp_error *error) {
  bool *is_spike = calloc(points, sizeof *is_spike);
  if (!is_spike) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for the spikes of %zu points", points);
    return NULL;
  }
  gsl_rstat_quantile_workspace median = {.p = 0.5};
  gsl_rstat_quantile_reset(&median);
  for (size_t i = 0; i < points; i++) {
    double distance = off(raw, i);
    if (!isnan(distance))
      gsl_rstat_quantile_add(distance, &median);
  }
  double sd = MAD_TO_SD * gsl_rstat_quantile_get(&median);
  double most = times * fmax(sd, isfinite(steps->quantum) ? steps->quantum / 2 : 0);
  for (size_t i = 0; i < points; i++)
    is_spike[i] = off(raw, i) > most;
  return is_spike;
}

asp_code aspi_count_spikes(const void *raw, const aspi_steps *steps, size_t points,
                           aspi_off_neighbours *off, double times, size_t *count,
                           asp_error *error) {
  bool *is_spike = aspi_spikes(raw, steps, points, off, times, error);
  if (!is_spike)
    return ASP_ENOMEM;
  *count = 0;
  for (size_t i = 0; i < points; i++)
    *count += is_spike[i];
  free(is_spike);
  return ASP_OK;
}
