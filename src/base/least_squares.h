/* Linear least squares of a few terms over any number of points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { ASP_TERMS_MOST = 55 };

/* The normal equations a c = b; solving turns b into the coefficients c. Initialize with {.terms =
 * n}.
 */
typedef struct aspi_least_squares {
  size_t terms;
  double a[ASP_TERMS_MOST * ASP_TERMS_MOST], b[ASP_TERMS_MOST];
} aspi_least_squares;

/* Adds a point of value z, where the terms have the values t. */
void aspi_least_squares_add(aspi_least_squares *fit, const double *t, double z);

/* False if the points do not fix the coefficients. */
bool aspi_least_squares_solve(aspi_least_squares *fit);

/* The fitted value where the terms have the values t. */
double aspi_least_squares_value(const aspi_least_squares *fit, const double *t);
