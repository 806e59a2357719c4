/* Angles of specular rebounds as histograms, and how far those of a model are from those of a
 * reference: the Kullback-Leibler divergence, with its standard error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"

enum { ASPI_ANGLE_BINS = 180 }; /* of one degree */

/* Rebounds of one group: alpha2 from 0 to 180 degrees, the lateral angle asin(v2.b/v2) and the tilt
 * of the first hit from -90 to 90. */
typedef struct aspi_angles {
  double n;
  double rebound[ASPI_ANGLE_BINS], lateral[ASPI_ANGLE_BINS], tilt[ASPI_ANGLE_BINS];
  double rebound_sum, lateral_sum, lateral_square; /* degrees */
  double later;                                    /* rebounds with more than one hit */
} aspi_angles;

/* Adds a rebound: v2 in (t, b, n), of any length. */
void aspi_angles_add(aspi_angles *angles, const double v2[3], double tilt, int hits);
void aspi_angles_merge(aspi_angles *to, const aspi_angles *from);

/* A number with its standard error. */
typedef struct aspi_mean_error {
  double value, se;
} aspi_mean_error;

/* Groups of rebounds at one impact angle: group g is at[g * stride]. */
typedef struct aspi_angle_groups {
  const aspi_angles *at;
  size_t n, stride;
} aspi_angle_groups;

/* D_KL(reference || model) of a histogram (its offset in aspi_angles), by the jackknife over the
 * reference's groups, which takes out the bias of histograms (Quenouille 1956). For a model with
 * the same number of groups, its groups are left out too; for a model in one group the bias is
 * (bins - 1)/2n. A bin that the model never fills counts as half an impact there. */
aspi_mean_error aspi_angles_divergence(aspi_angle_groups reference, aspi_angle_groups model,
                                       size_t histogram);

/* The mean over the groups of one of the sums, per rebound. */
aspi_mean_error aspi_angles_mean(aspi_angle_groups groups, size_t sum);
