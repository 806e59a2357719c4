/* Random numbers that are the same everywhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdint.h>

static uint32_t random_state = 12345;
static inline double uniform(double lo, double hi) {
  random_state = static_cast<uint32_t>((static_cast<uint64_t>(random_state) * 48271) % 2147483647);
  return lo + (hi - lo) * random_state / 2147483647.0;
}

static inline void random_vector(double size, double v[3]) {
  for (int d = 0; d < 3; d++)
    v[d] = uniform(-size, size);
}
