/* First hits of the geometry of a Gaussian wall, from the table of an ensemble (ensemble.h).
 * Particles that fly up follow `visible`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/ensemble.h"

static double quantile(const aspi_view *view, double u) {
  return view->alpha1 < 0 ? aspi_spread_visible.quantile(view, u) : aspi_ensemble_quantile(view, u);
}

static double distribution(const aspi_view *view, double delta) {
  return view->alpha1 < 0 ? aspi_spread_visible.distribution(view, delta)
                          : aspi_ensemble_distribution(view, delta);
}

static double density(const aspi_view *view, double delta) {
  return view->alpha1 < 0 ? aspi_spread_visible.density(view, delta)
                          : aspi_ensemble_density(view, delta);
}

const asp_spread_model aspi_spread_profile = {
    .name = "profile",
    .summary = "first hits from a table of generated Gaussian walls",
    .source = "geometry, derived for this project",
    .geometry = true,
    .upward = true,
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
};
