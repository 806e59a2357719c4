/* Heights as a file has them; see read.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/read.h"
#include "base/error.h"
#include "base/grow.h"

#include <math.h>

asp_code aspi_raw_add(aspi_raw *raw, double height, asp_error *error) {
  double *grown = aspi_grow(raw->z, raw->points, sizeof *grown);
  if (!grown)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a %s of over %zu points",
                     raw->is_map ? "map" : "profile", raw->points);
  raw->z = grown;
  raw->z[raw->points++] = height;
  return ASP_OK;
}

size_t aspi_raw_count_bad(const aspi_raw *raw) {
  size_t count = 0;
  for (size_t i = 0; i < raw->points; i++)
    count += isnan(raw->z[i]);
  return count;
}

void aspi_raw_range(const aspi_raw *raw, double *least, double *most) {
  *least = INFINITY;
  *most = -INFINITY;
  for (size_t i = 0; i < raw->points; i++) {
    *least = fmin(*least, raw->z[i]);
    *most = fmax(*most, raw->z[i]);
  }
}
