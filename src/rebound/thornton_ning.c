/* Elastic, plastic and adhesive: Thornton & Ning 1998 (by secondary sources, derived anew here),
 * with E the composite modulus. A sphere of radius R is a contact of Johnson, Kendall & Roberts,
 * whose force P and approach x follow the contact's radius a:
 *
 *   P = 4 E a^3/(3R) - (8 pi Gamma E a^3)^(1/2)        x = a^2/R - (2 pi Gamma a/E)^(1/2)
 *
 * It yields where the pressure at its center reaches p_y (their eq. 65), and from there the force
 * grows with the pressure capped at p_y (eq. 69); it unloads by the first equation with the larger
 * radius R_p that gives the force at the largest a:
 *
 *   p_y = 2 E a_y/(pi R) - (2 Gamma E/(pi a_y))^(1/2)
 *   dP/da = 2 pi p_y a - a_y (2 pi Gamma E/a)^(1/2)
 *   v_s = 1.84 ((Gamma/R)^5/(rho^3 E^2))^(1/6)          sticks below, without yield
 *
 * Gamma = 2 gamma is the work of adhesion, gamma the pair's surface energy, as in `bons`. The work
 * starts at x = 0, where the surfaces jump into contact, and ends where a can shrink no further.
 * Their closed form (eq. 78) adds the losses of yield and of adhesion instead, and sticks less than
 * this contact, which their figures show.
 *
 * Lengths are in R, radii of contact a_y u^2, work in E R^3 a_y^5. Then all follows from
 * adhesion = (2 pi Gamma/E)^(1/2)/a_y^(3/2) from 0 to 2; from 1 on, it yields at once.
 *
 * The motion along the face is not part of their law; it is the hard sphere of `walton` with the
 * pair's Coulomb friction and beta0 = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/laws.h"

#include <math.h>

enum { PRESSURE, N_PARAMETERS };

/* Work against adhesion^(10/3): of the approach at x = 0, and at the end of a contact of radius R.
 */
#define JUMP (-0.3)
#define SNAP 0.031498026247371828 /* 0.2/4^(4/3) */

static const aspi_keyword parameters[N_PARAMETERS] = {
    [PRESSURE] = {"pressure_ratio", "", 1.6, 0.1, 10,
                  "contact pressure at yield over the yield stress, p_y/sigma_y (1.6 where "
                  "a Hertz contact first yields, up to 2.8 when it is fully plastic: "
                  "Johnson 1985, recalled)"},
};

/* The integral of P dx of a contact with the radius of curvature dent. */
static double elastic_work(double adhesion, double dent, double u) {
  double u2 = u * u, root = u2 * u2 * u / dent;
  return 8. / 15 * root * root - 4. / 3 * adhesion * u2 * root +
         0.5 * adhesion * adhesion * u2 * u2;
}

/* The same while it yields, and its slope; give = 2 - adhesion. */
static double plastic_work(double adhesion, double give, double u, double *slope) {
  double eighth = 0.5 * give, fifth = adhesion * (0.2 * adhesion - 2), fourth = adhesion - 2. / 3;
  double square = adhesion * adhesion, first = -adhesion * fourth, u3 = u * u * u;
  *slope = u3 * (8 * eighth * u3 * u + 5 * fifth * u + 4 * fourth) + 2 * square * u + first;
  return u * (u3 * (eighth * u3 * u + fifth * u + fourth) + square * u + first);
}

/* The radius at which the loading has done that work: Newton's method from above, on a convex
 * curve. */
static double stops_at(double adhesion, double give, double from, double work) {
  double u = 2 * from, last, slope;
  while (plastic_work(adhesion, give, u, &slope) < work)
    u *= 2;
  do {
    last = u;
    u -= (plastic_work(adhesion, give, u, &slope) - work) / slope;
  } while (u < last);
  return u;
}

/* The radius at which it yields, to the power 1/2: the root of 2 b^3 = pressure b + pull. */
static double yields_at(double pressure, double pull) {
  double b = sqrt(0.5 * pressure) + cbrt(0.5 * pull), last;
  do {
    last = b;
    b = (4 * b * b * b + pull) / (6 * b * b - pressure);
  } while (b < last);
  return b;
}

/* The speed after the approach speed n1. Pressure: pi p_y/E > 0; pull: (2 pi Gamma/(E R))^(1/2);
 * stiffness: E^(1/2)/rho^(1/2). */
static double leaves_with(double n1, double pressure, double pull, double stiffness) {
  double b = yields_at(pressure, pull), adhesion = pull / (b * b * b), give = pressure / (b * b);
  double unit = sqrt(1.5 / ASP_PI) * stiffness * b * b * b * b * b,
         work = (n1 / unit) * (n1 / unit);
  double root = cbrt(adhesion), scale = root * adhesion * adhesion * adhesion, slope;
  double to_yield = adhesion < 1 ? elastic_work(adhesion, 1, 1) - JUMP * scale : 0;
  if (work <= to_yield) {
    double pull_off = (SNAP - JUMP) * scale;
    return pull_off < work ? n1 * sqrt(1 - pull_off / work) : pull_off > 0 ? 0 : n1;
  }
  double from = fmax(1, root);
  work += plastic_work(adhesion, give, from, &slope) - to_yield;
  double u = stops_at(adhesion, give, from, work), u3 = u * u * u;
  double force = give * u3 * u - 2 * adhesion * u + adhesion - 2. / 3;
  double dent = 4. / 3 * u3 * u3 / (force + 2 * adhesion * u3);
  double back = elastic_work(adhesion, dent, u) - SNAP * scale * dent * cbrt(dent);
  return back > 0 ? fmin(n1, unit * sqrt(back)) : 0;
}

static aspi_bounce rebound(const double *p, const aspi_hit *hit) {
  const asp_pair *pair = hit->pair;
  double n1 = hit->v_n1, modulus = pair->modulus,
         pressure = ASP_PI * p[PRESSURE] * pair->yield_stress;
  double energy = hit->adhesion ? pair->surface_energy : 0;
  double pull = sqrt(8 * ASP_PI * energy / (modulus * hit->d_p));
  double n2 =
      pressure > 0 ? leaves_with(n1, pressure / modulus, pull, sqrt(modulus / hit->density)) : 0;
  double rub = fmin(pair->friction * (n1 + n2), ASPI_ROLLING * hit->u_t1);
  return (aspi_bounce){n2, 0, rub, pair->friction};
}

const asp_rebound_law aspi_rebound_thornton_ning = {
    .name = "thornton_ning",
    .summary = "elastic, plastic or stuck: a Hertz spring that yields and adheres, with Coulomb "
               "friction and spin",
    .source = "Thornton & Ning 1998 (by secondary sources)",
    .needs_pair = true,
    .d_most = ASPI_ADHESIVE_MOST,
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rebound = rebound,
    .spins = aspi_rebound_always,
};
