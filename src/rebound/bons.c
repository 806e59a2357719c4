/* The rebound law of Bons, Prenter & Whitaker 2017, with the rate-dependent yield stress of
 * Whitaker & Bons 2018. The particle is a cylinder of the sphere's volume (area A = pi d^2/4,
 * length 2d/3) that the wall compresses like a spring of modulus E_c:
 *
 *   v_y   = sigma_y / sqrt(rho E_c)                      approach speed at which it yields
 *   v_n2  = sqrt(max(0, min(v_n1, v_y)^2 - v_a^2))       what the spring returns, less adhesion
 *   v_a^2 = 2 W_A / m = 6 gamma f / (rho d),  W_A = 2 gamma A f,  f = a + b min(1, v_n1/v_y)^c
 *   v_t2  = max(0, v_t1 - mu (v_n1 + v_n2) cos^2 alpha')
 *   sigma_y = sigma_y0 (1 - s max(0, T - T_s)), not below 0, of the constant or the rate form
 *
 * The form is from secondary sources; gamma, a, b, c and the softening are recalled from the
 * literature without the original at hand, and so all of them are the user's to set. The recalled
 * softening is 200 MPa up to 1000 K and 0.225 MPa/K less above; it is kept as a share of the yield
 * stress, so that it holds in any units.
 *
 * mu is a constant fitted to this form, not Coulomb's: what was measured on oblique impacts of 5 mm
 * alumina on glass (Kharaz, Gorham & Salman 2001, mu 0.092) follows 1 - mu (1 + e_n) tan alpha'
 * within 0.008 up to 60 degrees and has its least CoR_T at 70 degrees; this form with that mu has
 * it at 45 degrees and lies up to 0.35 higher.
 *
 * The form has no spin. `spin on` lets the particle take part, as an extension of this project:
 * the impulse that the law takes from v_t1 is taken from the velocity of the particle's surface,
 * with its angle in place of alpha', and ends where the surface stops, at (2/7) of its speed.
 *
 * A grain whose yield stress is not its material's has its own share of the rate, too.
 *
 * The difference of squares is taken as (v - v_a)(v + v_a): v_n2^2 is right to some last bits of
 * v_n1^2, and v_t2 to some of v_t1 (tests/sweep/precision.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/laws.h"

#include <math.h>

enum { YIELD_RATE, AREA_A, AREA_B, AREA_C, SOFTEN_FROM, SOFTEN_RATE, SPIN, N_PARAMETERS };

static const aspi_keyword parameters[N_PARAMETERS] = {
    [YIELD_RATE] = {"yield_rate", "stress/speed", 0, 0, INFINITY,
                    "yield stress per impact speed, sigma_y = yield_rate |v1|; 0: the material's "
                    "constant yield stress (form: Whitaker & Bons 2018, secondary source; no value "
                    "found)"},
    [AREA_A] = {"a", "", 0.1, 0, 1e3,
                "contact area share f = a + b min(1, v_n1/v_y)^c (recalled, original not seen)",
                .word = "contact_area"},
    [AREA_B] = {"b", "", 1.0 / 7, 0, 1e3, "see a (recalled, original not seen)",
                .word = "contact_area"},
    [AREA_C] = {"c", "", 0.5, 0, 10, "see a (recalled, original not seen)", .word = "contact_area"},
    [SOFTEN_FROM] = {"soften_from", "K", 1000, 0, 1e5,
                     "temperature above which the yield stress falls (recalled, original not seen)",
                     .word = "soften"},
    [SOFTEN_RATE] = {"soften_rate", "1/K", 0.225 / 200, 0, 1,
                     "share of the yield stress lost per kelvin above it (recalled, original not "
                     "seen)",
                     .word = "soften"},
    [SPIN] = {"spin", "", 0, 0, 1,
              "off: the particle's spin is left as it is, as in the source; on: friction "
              "acts on its surface and turns it (an extension of this project)",
              .values = "off | on"},
};

/* least diameter, m (an estimate of this project) */
#define D_LEAST 0.5e-6

/* Yield stress at this temperature over the cold one. */
static double softening(const double *p, double temperature) {
  if (!(temperature > p[SOFTEN_FROM]))
    return 1;
  return fmax(0, fma(-p[SOFTEN_RATE], temperature - p[SOFTEN_FROM], 1));
}

/* With v_y = 0 nothing is elastic: v_n1/v_y is taken as 1 and nothing returns. */
static aspi_bounce rebound(const double *p, const aspi_hit *hit) {
  const asp_pair *pair = hit->pair;
  double n1 = hit->v_n1, t1 = hit->v_t1, speed = sqrt(n1 * n1 + t1 * t1), density = hit->density;
  double yield =
      p[YIELD_RATE] > 0 ? p[YIELD_RATE] * speed * (1 + pair->yield_excess) : pair->yield_stress;
  double v_y = yield * softening(p, hit->temperature) / sqrt(density * pair->modulus);
  double n2 = fmin(n1, v_y);
  if (hit->adhesion && pair->surface_energy > 0) {
    double share = p[AREA_A] + p[AREA_B] * (n1 < v_y ? pow(n1 / v_y, p[AREA_C]) : 1);
    double v_a = sqrt(6 * share * pair->surface_energy / (density * hit->d_p));
    n2 = n2 > v_a ? sqrt((n2 - v_a) * (n2 + v_a)) : 0;
  }
  double along = t1 > 0 ? t1 / speed : 0, friction = pair->friction * along * along;
  double u1 = hit->u_t1, pressed = pair->friction * (n1 + n2), rub = 0;
  if (p[SPIN] > 0 && u1 > 0) {
    double share = u1 / sqrt(n1 * n1 + u1 * u1);
    rub = fmin(pressed * share * share, ASPI_ROLLING * u1);
    friction = pair->friction * share * share;
  }
  return (aspi_bounce){n2, fmax(0, t1 - pressed * along * along), rub, friction};
}

static bool spins(const double *p) {
  return p[SPIN] > 0;
}

const asp_rebound_law aspi_rebound_bons = {
    .name = "bons",
    .summary = "elastic, plastic or stuck: a yielding spring with adhesion, and friction whose "
               "coefficient is fitted to this form, not Coulomb's",
    .source = "Bons, Prenter & Whitaker 2017; Whitaker & Bons 2018 (both by secondary sources)",
    .needs_pair = true,
    .d_least = D_LEAST,
    .d_most = ASPI_ADHESIVE_MOST,
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rebound = rebound,
    .softening = softening,
    .spins = spins,
};
