/* Carbon steel worn by sand (Erosion/Corrosion Research Center of Tulsa; Zhang et al. 2007): E = C
 * B^-0.59 F_s v^n F(alpha), mass of the wall per mass of sand, with
 *
 *   F = 5.4 alpha - 10.11 alpha^2 + 10.93 alpha^3 - 6.33 alpha^4 + 1.42 alpha^5
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "erosion/laws.h"

#include <math.h>

enum { BRINELL, GRAINS, C, N, N_PARAMETERS };

static const aspi_keyword parameters[N_PARAMETERS] = {
    [BRINELL] = {"brinell", "", 0, 0, INFINITY, "hardness of the wall", .word = "", .above = true},
    [GRAINS] = {"grains", "", 0, 0, 2, "their form: F_s 1, 0.53 and 0.2",
                .values = "sharp | semi_rounded | round"},
    [C] = {"c", "", 2.17e-7, 0, INFINITY, "factor at 1 m/s", .above = true},
    [N] = {"n", "", 2.41, 0, 10, "exponent of the speed", .above = true},
};

static double rate(const double *p, double v, double sine, double cosine, double d_p) {
  static const double sharpness[] = {1, 0.53, 0.2};
  (void)d_p;
  double a = atan2(sine, cosine);
  double f = a * (5.4 + a * (-10.11 + a * (10.93 + a * (-6.33 + a * 1.42))));
  return p[C] * pow(p[BRINELL], -0.59) * sharpness[(int)p[GRAINS]] * pow(v, p[N]) * f;
}

const aspi_erosion_law aspi_erosion_ecrc = {
    .name = "ecrc",
    .summary = "carbon steel worn by sand of sharp, semi_rounded or round grains",
    .source =
        "Zhang, Reuterfors, McLaury, Shirazi & Rybicki 2007; C, n and F_s 0.2 as COMSOL's "
        "manual has them (the polynomial, B^-0.59 and the other F_s are recalled; the original "
        "was not seen)",
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rate = rate,
};
