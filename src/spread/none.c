/* No spread: the particle meets the mean wall.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/models.h"

static double quantile(const aspi_spread_input *input, double u) {
  (void)input;
  (void)u;
  return 0;
}

const asp_spread_model aspi_spread_none = {
    .name = "none",
    .summary = "no tilt: the smooth wall",
    .source = "definition",
    .quantile = quantile,
};
