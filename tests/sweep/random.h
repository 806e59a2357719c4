/* Random inputs of the sweeps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"
#include "base/stream.h"
#include "rebound/laws.h"

#include <math.h>
#include <stdlib.h>

static inline double between(aspi_stream *s, double low, double high) {
  return low + (high - low) * aspi_stream_uniform(s);
}

static inline double power_of_ten(aspi_stream *s, double low, double high) {
  return pow(10, between(s, low, high));
}

/* One in ten is 0, the others lie between powers of ten. */
static inline double or_zero(aspi_stream *s, double low, double high) {
  return aspi_stream_uniform(s) < 0.1 ? 0 : power_of_ten(s, low, high);
}

/* Of any two materials; the surface energy and the friction are still to come. */
static inline asp_pair random_pair(aspi_stream *s) {
  asp_material particle = {.youngs_modulus = power_of_ten(s, 0, 15),
                           .poissons_ratio = between(s, -0.99, 0.49)};
  asp_material wall = {.youngs_modulus = power_of_ten(s, 0, 15),
                       .poissons_ratio = between(s, -0.99, 0.49)};
  particle.yield_stress = or_zero(s, -3, 13);
  asp_pair *made = asp_pair_create(&particle, &wall, NULL);
  if (!made)
    abort();
  asp_pair pair = *made;
  asp_pair_free(made);
  return pair;
}
