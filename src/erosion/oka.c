/* Metals of any hardness (Oka, Okamura & Yoshida 2005; Oka & Yoshida 2005): the volume in mm^3 per
 * kg
 *
 *   E = K (a H)^(k1 b) (v/v')^k2 (d/d')^k3 (sin alpha)^n1 (1 + H (1 - sin alpha))^n2
 *
 * with the Vickers hardness H in GPa; a and b of the wall's material; K, k1, k3, v' and d' of the
 * particles' kind; and k2, n1, n2 of that kind and H. Manuals list W = (a H)^-b instead of a and b,
 * so that (a H)^(k1 b) = W^-k1.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "erosion/laws.h"

#include <math.h>

enum { HARDNESS, PARTICLES, WALL, A, B, K, K1, K2, K3, SPEED, DIAMETER, N1, N2, N_PARAMETERS };

#define OKA(NAME, UNIT, TEXT)                                                                      \
  { NAME, UNIT, NAN, -INFINITY, INFINITY, TEXT ", where it is not that of the particles' kind" }

static const aspi_keyword parameters[N_PARAMETERS] = {
    [HARDNESS] = {"hardness", "stress", 0, 0, INFINITY, "Vickers hardness of the wall", .word = "",
                  .above = true},
    [PARTICLES] = {"particles", "", 0, 0, 2, "what they are of", .values = "sio2 | sic | glass"},
    [WALL] = {"wall", "", 0, 0, 2, "what it is of: (a H)^-b 3, 10 and 1000",
              .values = "carbon_steel | stainless_steel | aluminum"},
    [A] = {"a", "", NAN, 0, INFINITY,
           "a of (a H)^(k1 b), in 1/GPa, where it is not that of the wall's kind", .above = true,
           .word = "a_b"},
    [B] = {"b", "", NAN, -INFINITY, INFINITY, "b of (a H)^(k1 b)", .word = "a_b"},
    [K] = OKA("k", "", "K"),
    [K1] = OKA("k1", "", "exponent of (a H)^b"),
    [K2] = OKA("k2", "", "exponent of the speed"),
    [K3] = OKA("k3", "", "exponent of the diameter"),
    [SPEED] = OKA("speed", "speed", "v'"),
    [DIAMETER] = OKA("diameter", "length", "d'"),
    [N1] = OKA("n1", "", "exponent of sin alpha"),
    [N2] = OKA("n2", "", "exponent of the hardness's part"),
};

static const struct {
  double k, k1, k2[2], k3, speed, diameter, n1[2], n2[2];
} kinds[] = {
    {65, -0.12, {2.3, 0.038}, 0.19, 104, 326e-6, {0.71, 0.14}, {2.4, -0.94}},
    {45, -0.05, {3, 0.085}, 0.19, 99, 326e-6, {0.71, 0.14}, {2.8, -1}},
    {27, -0.16, {2.1, 0}, 0.19, 100, 200e-6, {2.8, 0.41}, {2.6, -1.46}},
};

/* (a H)^-b of each material of the wall. */
static const double walls[] = {3, 10, 1000};

static double given_or(double given, double default_value) {
  return isnan(given) ? default_value : given;
}

static double rate(const double *p, double v, double sine, double cosine, double d_p) {
  (void)cosine;
  int kind = (int)p[PARTICLES];
  double h = p[HARDNESS] * 1e-9;
  const double *k2 = kinds[kind].k2, *n1 = kinds[kind].n1, *n2 = kinds[kind].n2;
  double wear = isnan(p[A]) ? walls[(int)p[WALL]] : pow(p[A] * h, -p[B]);
  double e90 =
      given_or(p[K], kinds[kind].k) * pow(wear, -given_or(p[K1], kinds[kind].k1)) *
      pow(v / given_or(p[SPEED], kinds[kind].speed), given_or(p[K2], k2[0] * pow(h, k2[1]))) *
      pow(d_p / given_or(p[DIAMETER], kinds[kind].diameter), given_or(p[K3], kinds[kind].k3));
  return 1e-9 * e90 * pow(sine, given_or(p[N1], n1[0] * pow(h, n1[1]))) *
         pow(1 + h * (1 - sine), given_or(p[N2], n2[0] * pow(h, n2[1])));
}

const aspi_erosion_law aspi_erosion_oka = {
    .name = "oka",
    .summary = "metals of any hardness, worn by sand, silicon carbide or glass",
    .source =
        "Oka, Okamura & Yoshida 2005; Oka & Yoshida 2005, as the manual of Altair EDEM has them "
        "for sio2 and the three walls (sic and glass are recalled; the originals were not seen)",
    .is_volume = true,
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rate = rate,
};
