/* Lists that grow by doubling.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdbool.h>
#include <stdlib.h>

/* The list of `count` things with room for one more; NULL if out of memory, and the list stays.
 * Grow the list with this function only. */
static inline void *aspi_grow(void *list, size_t count, size_t size) {
  bool is_full = (count & (count - 1)) == 0; /* 0, 1, 2, 4, 8, ... */
  return is_full ? realloc(list, (count ? 2 * count : 1) * size) : list;
}
