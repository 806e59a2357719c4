/* The Gaussian wall that has the numbers of a map.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "surface/map_describe.h"

/* Under this ratio of the two lengths the wall has no lay to speak of. */
#define STRETCH_LEAST 1.05

/* Beyond this heights and positions are in different units. */
#define PHI_R_MOST 100.0

asp_surface *asp_surface_create_map(const asp_map *map, bool lay, asp_error *error) {
  aspi_map_description d;
  if (aspi_map_describe(map, &d, error) || aspi_map_check(map, &d, PHI_R_MOST, error))
    return NULL;
  if (lay && d.lambda_2 > STRETCH_LEAST * d.lambda_1)
    return asp_surface_create_lay(d.s_q, d.lambda_1, d.lambda_2, error);
  return asp_surface_create(d.s_q, d.lambda_1, error);
}
