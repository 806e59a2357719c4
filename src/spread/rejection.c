/* The paper's baseline, routines 1 to 3: draw from the normal distribution until the face neither
 * is in the shadow (delta > -alpha1) nor sends a specular rebound into the wall (delta > -alpha1/2,
 * the stricter of the two). At least every second draw is taken, so the bound is never met in
 * practice.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/models.h"

static bool loop(const aspi_spread_input *view, aspi_stream *stream, double *delta) {
  *delta = 0;
  if (view->sigma < ASP_SIGMA_ZERO)
    return true;
  for (int i = 0; i < ASP_HITS_MAX; i++) {
    double drawn = view->sigma * aspi_stream_normal(stream);
    if (drawn > -view->alpha1 / 2 && drawn < ASP_DELTA_MOST) {
      *delta = drawn;
      return true;
    }
  }
  return false;
}

const asp_spread_model aspi_spread_rejection = {
    .name = "rejection",
    .summary = "normal distribution, drawn again until the rebound leaves the wall",
    .source = "Sommerfeld & Huber 1999; Altmeppen et al. 2020, routines 1 to 3",
    .density = aspi_truncated_density,
    .distribution = aspi_truncated_distribution,
    .loop = loop,
};
