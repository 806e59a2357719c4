/* Impacts of a model or a simulation, and measured coefficients of restitution.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_IMPACTS_H
#define ASP_ANALYSIS_IMPACTS_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum { COR_N, COR_T, COR_BOTH };

typedef struct aspi_scatter_point {
  double degrees;       /* impact angle */
  float v1, d_p;        /* SI; NAN where there is none */
  bool deposit;         /* it has no coefficients */
  float cor_t_space;    /* of the whole speed along the wall, without a sign; NAN alike */
  double cor[COR_BOTH]; /* NAN where there is none */
} aspi_scatter_point;

typedef struct aspi_scatter_impacts {
  aspi_scatter_point *points;
  size_t count, deposits; /* deposits: of those */
  bool rough;             /* some local wall was tilted */
  bool sideways;          /* some went out of the plane of incidence */
  char comment[1024];     /* the file's first comment */
} aspi_scatter_impacts;

/* NAN where there is nothing. Of an impact, cor are its coefficients and se their measurement
 * errors; of a mean, cor are means, sd standard deviations, se standard errors and n the number of
 * impacts. */
typedef struct aspi_measured_row {
  double degrees, v1, d_p; /* SI */
  double cor[COR_BOTH], sd[COR_BOTH], se[COR_BOTH], n;
  bool deposit;
} aspi_measured_row;

/* Which interval of that width an angle is in; the last one ends with 90 degrees. */
static inline double aspi_measured_interval(const aspi_measured_row *row, double width) {
  return floor(fmin(row->degrees, 90 - 1e-6) / width + 1e-9);
}

/* How rebounds were looked at: in the plane of incidence, as by one camera from the side, so that
 * CoR_T has a sign; in space, where it is of the whole speed along the wall; or by columns that
 * mean either. */
typedef enum aspi_measured_view {
  ASPI_MEASURED_PLANE,
  ASPI_MEASURED_SPACE,
  ASPI_MEASURED_EITHER
} aspi_measured_view;

typedef struct aspi_measured {
  aspi_measured_row *rows;
  size_t count;
  bool means;                            /* rows are means, not impacts */
  bool has_speed, has_size, has_outcome; /* there are such columns */
  aspi_measured_view view;
} aspi_measured;

#endif
