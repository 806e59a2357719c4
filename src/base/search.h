/* Binary search.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* How many of `count` items, which are in order, are below the value. */
static inline size_t aspi_count_below(const void *items, size_t count, double value,
                                      bool (*is_below)(const void *items, size_t i, double value)) {
  size_t low = 0, high = count;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (is_below(items, middle, value))
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}
