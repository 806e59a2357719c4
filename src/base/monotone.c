/* Monotone interpolation; see monotone.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/monotone.h"

#include <gsl/gsl_interp.h>
#include <math.h>

/* Steffen's tangent between two chords (his eq. 11): that of the parabola through the three points,
 * no more than twice the flatter chord, and none at an extremum. */
static double tangent_between(double before, double h_before, double after, double h_after) {
  double parabola = (before * h_after + after * h_before) / (h_before + h_after);
  return (copysign(1, before) + copysign(1, after)) *
         fmin(fabs(before), fmin(fabs(after), 0.5 * fabs(parabola)));
}

void aspi_monotone_tangents(const double *x, const double *y, size_t count, double *tangent) {
  double h = x ? x[1] - x[0] : 1, chord = (y[1] - y[0]) / h;
  tangent[0] = chord;
  for (size_t i = 1; i + 1 < count; i++) {
    double h_after = x ? x[i + 1] - x[i] : 1, after = (y[i + 1] - y[i]) / h_after;
    tangent[i] = tangent_between(chord, h, after, h_after);
    h = h_after;
    chord = after;
  }
  tangent[count - 1] = chord;
}

double aspi_monotone_at(const double *x, const double *y, const double *tangent, size_t count,
                        double at) {
  size_t i = gsl_interp_bsearch(x, at, 0, count - 1);
  return aspi_cubic_piece(x[i + 1] - x[i], at - x[i], &y[i], &tangent[i]);
}
