/* Warnings about measured heights: dust, heights in a few steps, clipped heights.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_WARNINGS_H
#define ASP_READERS_WARNINGS_H

#include "readers/raw.h"

/* Robust standard deviations off its neighbors at which a point is dust, not roughness. */
#define ASP_SPIKES_CLEAR 20.0

/* Heights as a file has them, before the form is taken out. */
typedef struct aspi_steps {
  size_t points, levels; /* levels: 0 if there are too many to count */
  double quantum;        /* the least distance between neighbors of different height */
  double end[2];         /* the lowest and the highest one */
  size_t cut[2];         /* points that lie there side by side, where they are many; else 0 */
} aspi_steps;

aspi_steps aspi_steps_find(const aspi_raw *raw);

/* The sentences, "" where there is no doubt; heights in m. `outliers`: points that lie
 * ASP_SPIKES_CLEAR off their neighbors. */
void aspi_warnings_write(const aspi_steps *steps, size_t outliers, char *text, size_t size);

/* ASP_ERANGE and a message where a measured wall tells little about spheres of diameter d_p: where
 * they cover under 10 points, or it is under 20 correlation lengths lambda long; all lengths in one
 * unit. Of a map, the larger step, the shorter side and lambda_2. */
asp_code aspi_sampling_check(double d_p, double spacing, double length, double lambda,
                             asp_error *error);

#endif
