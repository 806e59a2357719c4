/* Steel worn by sand (DNV RP-O501): E = K v^n F(alpha), mass of the wall per mass of sand, with
 *
 *   F = 0.6 (sin alpha + 7.2 (sin alpha - sin^2 alpha))^0.6 (1 - exp(-20 alpha))
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "erosion/laws.h"

#include <math.h>

enum { K, N, N_PARAMETERS };

static const aspi_keyword parameters[N_PARAMETERS] = {
    [K] = {"k", "", 2e-9, 0, INFINITY, "factor at 1 m/s; steel 2e-9", .above = true},
    [N] = {"n", "", 2.6, 0, 10, "exponent of the speed; steel 2.6", .above = true},
};

static double rate(const double *p, double v, double sine, double cosine, double d_p) {
  (void)d_p;
  double f = 0.6 * pow(sine + 7.2 * (sine - sine * sine), 0.6) * -expm1(-20 * atan2(sine, cosine));
  return p[K] * pow(v, p[N]) * f;
}

const aspi_erosion_law aspi_erosion_dnv = {
    .name = "dnv",
    .summary = "steel and other ductile walls, worn by sand",
    .source =
        "DNV RP-O501, August 2015, eq. 3.3, as equinor's pysand has it (its code was seen, the "
        "original was not)",
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rate = rate,
};
