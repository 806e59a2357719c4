/* Elastic, plastic and adhesive: Thornton & Ning 1998 (by secondary sources). A sphere of radius R
 * is a Hertz spring until the largest pressure reaches p_y, at the approach speed
 *
 *   v_y = (pi^2/sqrt(40)) (p_y^5/(E*^4 rho))^(1/2)
 *
 * beyond, its force grows linearly with the approach, dP = pi p_y R da, and it unloads as a Hertz
 * spring of the larger radius R_p that the dent has. With x the plastic approach per that at yield,
 *
 *   (v_n1/v_y)^2 = 1 + (5/2) (x + (3/4) x^2)            energy of the loading
 *   v_e  = v_y (1 + (3/2) x)/(1 + x)^(1/4)              what unloading returns; -> 1.185 v_y^(1/4)
 *   R_p  = R (1 + x)^(3/2)/(1 + (3/2) x)                                           v_n1^(3/4)
 *   v_n2 = sqrt(max(0, v_e^2 - v_s^2 (R_p/R)^(4/3)))    less what parting costs (Johnson, Kendall
 *   v_s  = 1.84 ((Gamma/R)^5/(rho^3 E*^2))^(1/6)        & Roberts), the speed under which it sticks
 *
 * Gamma = 2 gamma is the work of adhesion, gamma the pair's surface energy, as in `bons`. Their
 * adhesive and plastic parts are joined here by the radius R_p; adhesion is left out of the
 * loading. The motion along the face is not part of their law; it is the hard sphere of `walton`
 * with the pair's Coulomb friction and beta0 = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/laws.h"

#include <math.h>

enum { PRESSURE, N_PARAMETERS };

static const asp_parameter parameters[N_PARAMETERS] = {
    [PRESSURE] = {.name = "pressure_ratio",
                  .unit = "",
                  .fallback = 1.6,
                  .least = 0.1,
                  .most = 10,
                  .text = "contact pressure at yield over the yield stress, p_y/sigma_y (1.6 where "
                          "a Hertz contact first yields, up to 2.8 when it is fully plastic: "
                          "Johnson 1985, recalled)",
                  .keyword = "pressure_ratio"},
};

/* Speed after unloading for a given approach speed, and the dent's radius per R. */
static double unload(double n1, double v_y, double *radius) {
  *radius = 1;
  if (n1 <= v_y)
    return n1;
  if (!(v_y > 0))
    return 0;
  double ratio = n1 / v_y, over = 1.2 * (ratio - 1) * (ratio + 1);
  double x = over / (1.5 * (1 + sqrt(1 + over)));
  *radius = (1 + x) * sqrt(1 + x) / (1 + 1.5 * x);
  return v_y * (1 + 1.5 * x) / sqrt(sqrt(1 + x));
}

static aspi_bounce rebound(const double *p, const aspi_hit *hit) {
  const asp_pair *pair = hit->pair;
  double n1 = hit->v_n1, density = hit->density, modulus = pair->modulus;
  double p_y = p[PRESSURE] * pair->yield_stress, share = p_y / modulus, dent;
  double v_y = ASP_PI * ASP_PI / sqrt(40) * share * share * sqrt(p_y / density);
  double n2 = unload(n1, v_y, &dent);
  if (hit->adhesion && pair->surface_energy > 0) {
    double work = 4 * pair->surface_energy / hit->d_p, root = cbrt(work);
    double v_s = 1.84 * sqrt(work) * root / (sqrt(density) * cbrt(modulus)); /* work^(5/6) */
    double v_a = v_s * cbrt(dent * dent);
    n2 = n2 > v_a ? sqrt((n2 - v_a) * (n2 + v_a)) : 0;
  }
  double rub = fmin(pair->friction * (n1 + n2), ASPI_ROLLING * hit->u_t1);
  return (aspi_bounce){n2, 0, rub, pair->friction};
}

static bool spins(const double *p) {
  (void)p;
  return true;
}

const asp_rebound_law aspi_rebound_thornton_ning = {
    .name = "thornton_ning",
    .summary = "elastic, plastic or stuck: a Hertz spring that yields and adheres, with Coulomb "
               "friction and spin",
    .source = "Thornton & Ning 1998 (by secondary sources; joined as the page says)",
    .needs_pair = true,
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rebound = rebound,
    .spins = spins,
};
