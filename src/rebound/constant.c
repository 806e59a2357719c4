/* Two constant coefficients of restitution, about the face that is hit. For comparison, for walls
 * whose coefficients are known, and for tests: (1, 1) is the specular rebound.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/laws.h"

enum { COR_N, COR_T, N_PARAMETERS };

static const aspi_keyword parameters[N_PARAMETERS] = {
    [COR_N] = {"cor_n", "", 1, 0, 1, "normal coefficient of restitution of the face", .word = ""},
    [COR_T] = {"cor_t", "", 1, 0, 1, "tangential coefficient of restitution of the face",
               .word = ""},
};

static aspi_bounce rebound(const double *p, const aspi_hit *hit) {
  double n2 = p[COR_N] * hit->v_n1, t2 = p[COR_T] * hit->v_t1;
  return (aspi_bounce){n2, t2, 0, aspi_bounce_friction(hit, n2, t2)};
}

const asp_rebound_law aspi_rebound_constant = {
    .name = "constant",
    .summary = "constant coefficients of restitution",
    .source = "definition",
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rebound = rebound,
};
