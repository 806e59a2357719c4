/* Impacts of a model, of a simulation or of a measurement, and means of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_IMPACTS_H
#define ASP_ANALYSIS_IMPACTS_H

#include "base/tolerances.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum { COR_N, COR_T, COR_BOTH };

/* NAN where there is no number. Of an impact, cor are its coefficients, se their measurement
 * errors, and cor_t_space is the ratio of the whole speeds along the wall, without a sign. Of a
 * mean, cor are means, sd standard deviations, se standard errors, n the number of impacts. */
typedef struct aspi_scatter_row {
  double degrees, v1, d_p; /* SI */
  double cor[COR_BOTH], cor_t_space, sd[COR_BOTH], se[COR_BOTH], n;
  bool deposit; /* it has no coefficients */
} aspi_scatter_row;

/* Which interval of that width an angle is in; the last one ends with 90 degrees. */
static inline double aspi_scatter_interval(const aspi_scatter_row *row, double width) {
  return floor(fmin(row->degrees, 90 - 1e-6) / width + ASPI_ROUNDING_TEXT);
}

/* How rebounds were seen: in the plane of incidence, as by one camera from the side, so that CoR_T
 * has a sign; or in space, where it is of the whole speed along the wall. */
typedef enum aspi_rebound_view { ASPI_IN_PLANE, ASPI_IN_SPACE, ASPI_VIEWS } aspi_rebound_view;

typedef struct aspi_scatter {
  aspi_scatter_row *rows;
  size_t count, deposits;   /* deposits: rows that are one */
  bool means;               /* rows are means, not impacts */
  bool has_speed, has_size; /* of some rows they are known */
  bool has_outcome;         /* there is such a column */
  aspi_rebound_view view;
} aspi_scatter;

#endif
