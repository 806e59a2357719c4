/* Generated Gaussian maps, for tests.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "surface/heights.h"

/* A Gaussian wall with a lay: autocovariance r_q^2 exp(-r' M r), where M has the eigenvalues
 * 1/lambda_1^2 and 1/lambda_2^2; `axis` is the angle from x to the first of its axes (rad). */
typedef struct gauss_wall {
  double r_q, lambda_1, lambda_2, axis;
} gauss_wall;

/* A periodic map of such a wall; both sides are powers of two. r_q is that of the ensemble. The
 * same seed gives the same map. NULL: out of memory. */
asp_heights *gauss_map_create(const gauss_wall *wall, const double step[2], size_t columns,
                              size_t rows, uint32_t seed, asp_error *error);
