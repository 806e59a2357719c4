/* A measured wall in numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "surface/heights.h"

/* Standard error of the mean tilt of first hits at 2 degrees, as a part of sigma: 0.11 for a
 * profile of 100 correlation lengths, proportional to 1/sqrt(length) (from ensembles of generated
 * profiles). */
#define ASP_LENGTH_ERROR(lengths) (1.1 / sqrt(lengths))

/* The numbers of a rough wall. ASP_EDATA and a message if the heights cannot be one: uncorrelated
 * neighbors, as in noise, or phi_r over 1. Depths that no particle reaches do not count: where
 * phi_r is over 1, the numbers are those of the center of a particle of diameter d_least (0:
 * unknown) that rolls over the heights. */
asp_code aspi_heights_judge(const asp_heights *heights, double d_least,
                            asp_heights_numbers *numbers, asp_error *error);

/* The Gaussian wall with the numbers of a map: s_q, lambda_1, and with `lay` lambda_2 along it;
 * without, it is met across its lay everywhere. */
asp_surface *aspi_surface_create_map(const asp_heights_numbers *numbers, bool lay,
                                     asp_error *error);

/* The rms and the skewness of n gradients p, q to the right of the lay and along it. */
void aspi_gradient_describe(const float *p, const float *q, size_t n, double lay, double rms[2],
                            double skewness[2]);
