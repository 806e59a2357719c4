/* The rough wall multi-collision model of Konan, Kannengieser & Simonin 2009, as recalled (the
 * original was not at hand): the first face follows `effective` (eq. 4); a rebound at theta >
 * 0 over the mean wall is the last one with probability tanh(1.5 theta/sigma), otherwise the next
 * face is drawn for the direction that the particle now has. Against ray tracing that is too low
 * for theta under sigma.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/models.h"

#include <math.h>

static double escape(const aspi_spread_input *view, double theta) {
  return view->sigma < ASP_SIGMA_ZERO ? 1 : tanh(1.5 * theta / view->sigma);
}

const asp_spread_model aspi_spread_multicollision = {
    .name = "multicollision",
    .summary = "as effective, then further faces until the particle leaves",
    .source = "Konan, Kannengieser & Simonin 2009 (recalled, original not seen)",
    .covers_rising = true,
    .escape = escape,
    .density = aspi_effective_density,
    .distribution = aspi_effective_distribution,
    .quantile = aspi_effective_quantile,
};
