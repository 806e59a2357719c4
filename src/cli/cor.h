/* What `asperity cor` hands to its picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_COR_H
#define ASP_CLI_COR_H

#include "cli/law.h"
#include "cli/walls.h"

/* The options of the command. */
enum {
  ROUGH,
  DP = ROUGH + ROUGH_OPTIONS,
  SPEED,
  ANGLES,
  MODEL,
  SAMPLES,
  SEED,
  TILT,
  COLLISIONS,
  COLUMNS,
  OUTPUT,
  PLOT,
  LAW,
  N = LAW + LAW_OPTIONS
};

/* Diameters or speeds: a list, or where that is empty a log-normal whose ln has the sd
 * ln(most/least)/5, cut at both ends. least and most are also those of a list. */
typedef struct cor_values {
  cli_list list;
  double least, most, median;
} cor_values;

typedef struct cor_scene {
  cli_rough rough; /* its surface is NULL where the wall is smooth */
  cli_law law;
  asp_pair *pair;
  cor_values speeds, sizes;
} cor_scene;

typedef struct cor_row {
  double d_p, alpha1;
  asp_impact impact;
  asp_coefficients cor;
} cor_row;

/* Reads the wall from the options, and takes it away. */
void cli_cor_read_wall(const cli_option *options, cor_scene *scene);
void cli_cor_free_wall(cor_scene *scene);

/* One impact at an angle in degrees. */
cor_row cli_cor_impact(const cor_scene *scene, double angle, size_t sample, uint64_t tag,
                       uint32_t seed);

void cli_cor_plot(const cli_option *options, const cor_scene *scene, const cor_row *rows,
                  size_t count);

#endif
