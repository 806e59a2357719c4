/* Linear least squares; see least_squares.h. Terms that are nearly orthogonal, as Legendre
 * polynomials on a grid, lose nothing by normal equations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/least_squares.h"

#include <gsl/gsl_linalg.h>
#include <math.h>

/* If the triangle's diagonal has a larger range than this, the points do not fix the coefficients.
 */
#define SINGULAR 1e-13

void aspi_least_squares_add(aspi_least_squares *fit, const double *t, double z) {
  for (size_t j = 0; j < fit->terms; j++) {
    fit->b[j] += t[j] * z;
    for (size_t k = 0; k < fit->terms; k++)
      fit->a[j * fit->terms + k] += t[j] * t[k];
  }
}

/* By QR: GSL's QR allocates nothing and never calls its error handler. */
bool aspi_least_squares_solve(aspi_least_squares *fit) {
  double tau_of[ASP_TERMS_MOST], most = 0, least = INFINITY;
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

double aspi_least_squares_value(const aspi_least_squares *fit, const double *t) {
  double value = 0;
  for (size_t j = 0; j < fit->terms; j++)
    value += fit->b[j] * t[j];
  return value;
}
