/* The normal distribution cut at delta_alpha = -alpha1/2 (eq. 5 with mu = 0, b = -alpha1/2), by
 * inverse transform.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/models.h"

double aspi_truncated_density(const aspi_spread_input *input, double delta) {
  return aspi_cut_normal_density(input->sigma, -input->alpha1 / 2, ASP_DELTA_MOST, delta);
}

double aspi_truncated_distribution(const aspi_spread_input *input, double delta) {
  return aspi_cut_normal_distribution(input->sigma, -input->alpha1 / 2, ASP_DELTA_MOST, delta);
}

double aspi_truncated_quantile(const aspi_spread_input *input, double u) {
  if (input->sigma < ASP_SIGMA_ZERO)
    return 0;
  return aspi_cut_normal_quantile(input->sigma, -input->alpha1 / 2, ASP_DELTA_MOST, u);
}

const asp_spread_model aspi_spread_truncated = {
    .name = "truncated",
    .summary = "normal distribution cut at -alpha1/2, where the rebound would not leave the wall",
    .source = "Altmeppen et al. 2020, eq. 5",
    .density = aspi_truncated_density,
    .distribution = aspi_truncated_distribution,
    .quantile = aspi_truncated_quantile,
};
