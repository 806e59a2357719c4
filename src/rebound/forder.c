/* Forder, Thew & Harrison 1998: mean coefficients as polynomials in the impact angle beta (rad) at
 * the face that is hit:
 *
 *   e_n = 0.988 - 0.78 beta + 0.19 beta^2 - 0.024 beta^3 + 0.027 beta^4
 *   e_t = 1 - 0.78 beta + 0.84 beta^2 - 0.21 beta^3 + 0.028 beta^4 - 0.022 beta^5
 *
 * From one secondary source, which names neither target nor grain; the sign of the last term is
 * inferred there. The law knows neither speed nor material, and nothing sticks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/laws.h"

#include <math.h>

static aspi_bounce rebound(const double *p, const aspi_hit *hit) {
  (void)p;
  double b = atan2(hit->v_n1, hit->v_t1);
  double e_n = 0.988 + b * (-0.78 + b * (0.19 + b * (-0.024 + b * 0.027)));
  double e_t = 1 + b * (-0.78 + b * (0.84 + b * (-0.21 + b * (0.028 - b * 0.022))));
  return aspi_bounce_capped(hit, e_n, e_t);
}

const asp_rebound_law aspi_rebound_forder = {
    .name = "forder",
    .summary = "measured means over impact angle, of a target and a grain that are not named",
    .source = "Forder, Thew & Harrison 1998 (by one secondary source, original not seen)",
    .measured = true,
    .rebound = rebound,
};
