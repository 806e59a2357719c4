/* Cutting wear of a ductile wall (Finnie 1960): the volume c m v^2/(p psi K) F(alpha), with
 *
 *   F = sin 2 alpha - (6/K) sin^2 alpha   where tan alpha < K/6
 *   F = (K/6) cos^2 alpha                 else
 *
 * and the share c of the grains that cut; the others plough. It wears nothing at normal impact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "erosion/laws.h"

#include <math.h>

enum { P, PSI, K, SHARE, N_PARAMETERS };

static const aspi_keyword parameters[N_PARAMETERS] = {
    [P] = {"flow_stress", "stress", 0, 0, INFINITY, "of the wall", .word = "", .above = true},
    [PSI] = {"psi", "", 2, 0, INFINITY, "length over depth of a cut", .above = true},
    [K] = {"k", "", 2, 0, INFINITY, "normal over tangential force on the grain", .above = true},
    [SHARE] = {"share", "", 1, 0, 1, "of the grains that cut; other codes take 0.1", .above = true},
};

static double rate(const double *p, double v, double sine, double cosine, double d_p) {
  (void)d_p;
  double f = sine < cosine * p[K] / 6 ? 2 * sine * cosine - 6 / p[K] * sine * sine
                                      : p[K] / 6 * cosine * cosine;
  return p[SHARE] * v * v / (p[P] * p[PSI] * p[K]) * f;
}

const aspi_erosion_law aspi_erosion_finnie = {
    .name = "finnie",
    .summary = "cutting of a ductile wall, most at small angles, none at normal impact",
    .source = "Finnie 1960, as OpenFOAM's ParticleErosion has it (its code was seen, the original "
              "was not); share as COMSOL's manual has it, 0.1 there",
    .is_volume = true,
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rate = rate,
};
