/* The slope angles of the wall as a particle at normal impact sees them: a normal distribution with
 * sd sigma (eq. 3), for every impact angle. It has no shadow; if it draws a face that the particle
 * cannot hit, the contact draws again.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/models.h"

static double density(const aspi_spread_input *input, double delta) {
  return aspi_cut_normal_density(input->sigma, -ASP_DELTA_MOST, ASP_DELTA_MOST, delta);
}

static double distribution(const aspi_spread_input *input, double delta) {
  return aspi_cut_normal_distribution(input->sigma, -ASP_DELTA_MOST, ASP_DELTA_MOST, delta);
}

static double quantile(const aspi_spread_input *input, double u) {
  if (input->sigma < ASP_SIGMA_ZERO)
    return 0;
  return aspi_cut_normal_quantile(input->sigma, -ASP_DELTA_MOST, ASP_DELTA_MOST, u);
}

const asp_spread_model aspi_spread_normal = {
    .name = "normal",
    .summary = "normal distribution with sd sigma, without shadowing",
    .source = "Sommerfeld & Huber 1999; Altmeppen et al. 2020, eq. 3",
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
};
