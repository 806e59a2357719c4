/* Impacts of a model, of a simulation or of a measurement, and means of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/tolerances.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* Both coefficients, or for data without them the angle of the rebound, degrees. */
enum { COR_N, COR_T, COR_BOTH, REBOUND_ANGLE = COR_BOTH, ASPI_COMPARED };

/* NAN: no number. Row of an impact: cor are its coefficients, se their measurement errors. Row of
 * means: cor are means, sd standard deviations, se standard errors, n the number of impacts.
 *
 * A row may stand for `rows` impacts with the same key. Its place is then their mean, power[k][p]
 * the sum of (x - cor[k])^(p + 1), and product the sum of the products of both differences. */
typedef struct aspi_scatter_row {
  double degrees, v1, d_p; /* SI */
  double cor[ASPI_COMPARED], sd[ASPI_COMPARED], se[ASPI_COMPARED], n;
  bool deposit;             /* it has no coefficients */
  double rows, least, most; /* angles in degrees */
  double key[3], power[ASPI_COMPARED][4], product;
} aspi_scatter_row;

/* The number of the interval, `width` degrees wide, that holds the angle; 90 is in the last one. */
static inline double aspi_scatter_interval(const aspi_scatter_row *row, double width) {
  return floor(fmin(row->degrees, 90 - 1e-6) / width + ASPI_ROUNDING_TEXT);
}

/* The velocity that a rebound is measured by: in the plane of incidence, as by one camera from the
 * side, where CoR_T has a sign; or in space, where CoR_T uses the whole speed along the wall. */
typedef enum aspi_projection { ASPI_IN_PLANE, ASPI_IN_SPACE, ASPI_PROJECTIONS } aspi_projection;

/* How impacts are grouped, where they are not kept one by one. */
typedef struct aspi_grouping {
  double *border[3]; /* limits of the bins of angle, speed, size; NULL: equal numbers */
  size_t count[3];   /* of the limits */
  double width;      /* bins of the angle alone, used above `places` groups; 0: never */
  size_t places;
} aspi_grouping;

typedef struct aspi_scatter {
  aspi_scatter_row *rows;
  size_t count;                  /* rows */
  size_t merge_at;               /* rows are merged when there are more */
  double impacts, deposits;      /* in all rows; deposits: that are one */
  bool means;                    /* rows are means, not impacts */
  bool has_speed, has_size;      /* of some rows they are known */
  bool has_outcome;              /* there is such a column */
  bool has_angle;                /* of rebounds, and no coefficients */
  bool by_interval;              /* rows are of intervals */
  const aspi_grouping *grouping; /* NULL: there is a row for each impact */
  aspi_projection projection;
} aspi_scatter;

/* True if a row (not the first) joins the bin of the row before it; rows are in order of their
 * angle. Bins are intervals or clusters. A cluster is narrower than `width` and at least width/2
 * from the next; fixed borders could cut it. */
bool aspi_scatter_joins(const aspi_scatter *scatter, size_t row, double width, bool clusters);
bool aspi_scatter_is_clustered(const aspi_scatter *scatter, double width);

/* Sets the key of a row. */
void aspi_scatter_key(const aspi_scatter *s, aspi_scatter_row *row);

/* Merges two rows with the same key; false if the keys differ. */
bool aspi_scatter_merge(aspi_scatter_row *to, const aspi_scatter_row *more);

/* Merges all rows with the same key. */
void aspi_scatter_gather(aspi_scatter *s);

/* Sums over a row of (x - center)^p, p from 1 to 4. */
void aspi_scatter_about(const aspi_scatter_row *row, int k, double center, double sums[4]);

/* Sorts by `compare` and merges equal items; returns how many are left. */
size_t aspi_merge_equal(void *items, size_t count, size_t size,
                        int (*compare)(const void *, const void *),
                        void (*add)(void *to, const void *more));
