/* The user's own coefficients of restitution over impact angle and speed, about the face that is
 * hit; see aspi_cor_table. Nothing sticks unless the table has cor_n = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/laws.h"

#include <math.h>

static aspi_bounce rebound(const double *p, const aspi_hit *hit) {
  (void)p;
  double n1 = hit->v_n1, t1 = hit->v_t1, cor_n, cor_t;
  aspi_cor_table_at(hit->table, sqrt(n1 * n1 + t1 * t1), atan2(n1, t1), &cor_n, &cor_t);
  return aspi_bounce_capped(hit, cor_n, cor_t);
}

const asp_rebound_law aspi_rebound_table = {
    .name = "table",
    .summary = "your own coefficients over impact angle and speed, interpolated",
    .source = "your file",
    .needs_table = true,
    .measured = true,
    .rebound = rebound,
};
