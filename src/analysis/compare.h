/* Impacts of a model or a simulation at the places (angle, speed, size) of measurements, and how
 * far apart both are: means, standard deviations, shares of deposits, and one score of them all.
 *
 * Each measured impact is compared with model impacts at the same angle (and speed, and size), or
 * with the nearest ones, which together get the weight of one impact. A bin of measurements at
 * different angles therefore has a model sample of the same angles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "analysis/near.h"
#include "analysis/score.h"
#include "asperity_internal.h"

/* The measurements at one angle, speed and size, or those of some such places together; and the
 * impacts there. */
typedef struct aspi_compare_bin {
  size_t first, end;       /* rows of the data */
  double degrees, v1, d_p; /* their mean place; NAN if unknown */
  double from, to;         /* the angles that impacts were taken from */
  aspi_side model, data;
} aspi_compare_bin;

typedef struct aspi_comparison {
  const char *names[2]; /* of the files: impacts, data; no second one: the impacts alone */
  aspi_scatter impacts;
  aspi_scatter data; /* the impacts themselves if there are no data */
  aspi_compare_bin *bins;
  size_t count;
  aspi_mean_error score;
} aspi_comparison;

/* The borders of all measured places and of their surroundings: model impacts between the same
 * borders are equivalent. With very many places, none: then those of equal numbers are. To be
 * freed.
 */
asp_code aspi_compare_grouping(const aspi_scatter *data, const aspi_compare_reach *far,
                               aspi_grouping *grouping, asp_error *error);
void aspi_compare_grouping_free(aspi_grouping *grouping);

/* A bin for each row of means, or for each interval of angles of that width in degrees. If many
 * impacts were measured at each place, each place is a bin, unless the width is `given` by the
 * user. */
asp_code aspi_compare_make_bins(aspi_comparison *c, double width, bool given, asp_error *error);

/* Fills the bins; the impacts are in order of their angle. If far is NULL, the measured impacts are
 * also the model's sample. */
asp_code aspi_compare_fill(aspi_comparison *c, const aspi_compare_reach *far, asp_error *error);
