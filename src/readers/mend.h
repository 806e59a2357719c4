/* What the menders of profiles and of maps have in common.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SURFACE_MEND_H
#define ASP_SURFACE_MEND_H

#include "asperity.h"
#include "readers/read.h"

#include <stdbool.h>
#include <stddef.h>

/* Terms of the largest polynomial that is taken out as form, in two variables. */
enum { ASP_FORM_TERMS = (ASP_FORM_MAX + 1) * (ASP_FORM_MAX + 2) / 2 };

/* Heights and spacings beyond these (m) are no surface, and could overflow. */
#define ASP_LENGTH_MOST 1e9
#define ASP_SPACING_LEAST 1e-15

/* The coefficients b of a polynomial, and the normal equations a c = b of its fit. */
typedef struct aspi_fit {
  size_t terms;
  double a[ASP_FORM_TERMS * ASP_FORM_TERMS], b[ASP_FORM_TERMS];
} aspi_fit;

/* Adds a point of height z, where the terms have the values t, to the equations. */
void aspi_fit_add(aspi_fit *fit, const double *t, double z);

/* Turns b into the coefficients; false where the points do not fix them. */
bool aspi_fit_solve(aspi_fit *fit);

/* The polynomial where its terms have the values t. */
double aspi_fit_value(const aspi_fit *fit, const double *t);

/* How far z is from the median of a window of `count` heights, which it sorts; 0 where count is 0.
 */
double aspi_off_median(double z, double *window, size_t count);

/* How far a point is from its neighbours; NAN where it is bad itself. */
typedef double aspi_off_neighbours(const void *raw, size_t at);

/* Which of the points are spikes: over `times` robust standard deviations off their neighbours. The
 * deviation is at least half the step in which heights are given, since most points of heights in
 * steps are off by nothing. For the caller to free; NULL where there is no memory. */
bool *aspi_spikes(const void *raw, const aspi_steps *steps, size_t points, aspi_off_neighbours *off,
                  double times, asp_error *error);

/* How many they are. */
asp_code aspi_count_spikes(const void *raw, const aspi_steps *steps, size_t points,
                           aspi_off_neighbours *off, double times, size_t *count, asp_error *error);

#endif
