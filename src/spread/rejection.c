/* The paper's baseline, routines 1 to 3: the normal distribution, drawn again until the face
 * neither is in the shadow (delta > -alpha1) nor sends a specular rebound into the wall (delta >
 * -alpha1/2, the stricter of the two). That is the law of `truncated`, which is drawn in one step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/models.h"

const asp_spread_model aspi_spread_rejection = {
    .name = "rejection",
    .summary = "the law of truncated, by the name of the routines that draw again until it holds",
    .source = "Sommerfeld & Huber 1999; Altmeppen et al. 2020, routines 1 to 3",
    .density = aspi_truncated_density,
    .distribution = aspi_truncated_distribution,
    .quantile = aspi_truncated_quantile,
};
