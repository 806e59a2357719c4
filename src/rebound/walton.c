/* A hard sphere with Coulomb friction and spin (Walton 1993; Foerster, Louge, Chang & Allia 1994;
 * derived anew here): three constants, no adhesion, no material. With the approach v_n1 and the
 * speed u_t of the particle's surface along the face
 *
 *   v_n2 = e v_n1
 *   J_t/m = min(mu (1 + e) v_n1, (2/7) (1 + beta0) u_t)      against u_t: it slides, or it sticks
 *
 * so that u_t becomes -beta0 u_t where it sticks: beta0 = 0 is rolling, 1 a perfect grip. While it
 * slides, CoR_T = 1 - mu (1 + e) tan alpha' without spin before.
 *
 * beta0 is constant in that law, and measured contacts are not that simple between sliding and
 * normal impact, where the contact gives way along the face before it slides. `compliance K` works
 * that out instead of beta0: the contact is a Hertz spring whose unloading is weakened by e^2, with
 * a spring along the face of K times its stiffness (K = 2 (1 - nu)/(2 - nu) for like solids,
 * Mindlin 1949, recalled), which Coulomb's friction cuts and which weakens with the contact's
 * radius on unloading. The result depends on u_t/v_n1, mu, e and K only; it is integrated at each
 * contact, at some 2.6 us more a contact than the plain law. Partial slip is left out, and so a K
 * that is fitted to measurements is less than Mindlin's.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/laws.h"

#include <math.h>

enum { E, MU, BETA0, COMPLIANCE, N_PARAMETERS };

/* Steps over the time that the contact lasts without loss, which is 3.218 in the units below. */
enum { STEPS = 200 };
#define DURATION 3.218

static const aspi_keyword parameters[N_PARAMETERS] = {
    [E] = {"e", "", 0.9, 0, 1, "normal coefficient of restitution of the face", .word = ""},
    [MU] = {"mu", "", ASP_FRICTION, 0, 1e3, "coefficient of friction, Coulomb's", .word = ""},
    [BETA0] = {"beta0", "", 0, 0, 1,
               "rotational restitution of a contact that sticks: its surface leaves with "
               "-beta0 times its speed; 0: it rolls",
               .word = ""},
    [COMPLIANCE] = {"compliance", "", 0, 0, 10,
                    "tangential over normal stiffness of the contact, which then counts in "
                    "place of beta0; 0: rigid (2(1-nu)/(2-nu) for like solids, Mindlin "
                    "1949, recalled; 0.70 fits Kharaz et al. 2001)"},
};

/* The impulse along the face per mass and v_n1, of a contact that gives way there, at the speed u
 * of the surface per v_n1. In units where mass, approach and the Hertz constant are 1: the force
 * along the normal is x^(3/2). */
static double rub_of_springs(double e, double mu, double stiffness, double u) {
  double x = 0, v = 1, root = 0, force = 0, rub = 0, dt = DURATION / STEPS;
  for (int i = 0; i < 2 * STEPS; i++) {
    v -= (v < 0 ? e * e : 1) * x * root * dt;
    x += v * dt;
    if (!(x > 0))
      break;
    double now = sqrt(x), most = mu * (v < 0 ? e * e : 1) * x * now;
    if (now < root)
      force *= now / root;
    root = now;
    force = fmax(-most, fmin(most, force + stiffness * 1.5 * root * u * dt));
    u -= force * dt / ASPI_ROLLING;
    rub += force * dt;
  }
  return rub;
}

static aspi_bounce rebound(const double *p, const aspi_hit *hit) {
  double n1 = hit->v_n1, u = hit->u_t1, slides = p[MU] * (1 + p[E]) * n1;
  double rub = fmin(slides, ASPI_ROLLING * (1 + p[BETA0]) * u);
  /* A surface that is so fast that it slides throughout needs no springs. */
  if (p[COMPLIANCE] > 0 && u > 0 && slides > 0.01 * u && u < 20 * (1 + p[MU]) * n1)
    rub = fmin(n1 * rub_of_springs(p[E], p[MU], p[COMPLIANCE], u / n1), 2 * ASPI_ROLLING * u);
  else if (p[COMPLIANCE] > 0)
    rub = fmin(slides, ASPI_ROLLING * u);
  return (aspi_bounce){p[E] * n1, 0, fmax(0, rub), p[MU]};
}

static bool is_compliant(const double *p) {
  return p[BETA0] > 0 || p[COMPLIANCE] > 0;
}

const asp_rebound_law aspi_rebound_walton = {
    .name = "walton",
    .summary = "hard sphere with Coulomb friction: it slides, or sticks or rolls, and spins",
    .source = "Walton 1993; Foerster, Louge, Chang & Allia 1994 (by secondary sources)",
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rebound = rebound,
    .spins = aspi_rebound_always,
    .is_compliant = is_compliant,
};
