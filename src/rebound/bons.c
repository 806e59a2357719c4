/* The rebound law of Bons, Prenter & Whitaker 2017, with the rate-dependent yield stress of
 * Whitaker & Bons 2018. The particle is a cylinder of the sphere's volume (area A = pi d^2/4,
 * length 2d/3) that the wall compresses like a spring of modulus E_c:
 *
 *   v_y   = sigma_y / sqrt(rho E_c)                      approach speed at which it yields
 *   v_n2  = sqrt(max(0, min(v_n1, v_y)^2 - 2 W_A / m))   what the spring returns, less adhesion
 *   W_A   = 2 gamma A f,  2 W_A / m = 6 gamma f / (rho d),  f = a + b min(1, v_n1/v_y)^c
 *   v_t2  = max(0, v_t1 - mu (v_n1 + v_n2) cos^2 alpha')
 *
 * The form is from secondary sources; gamma, a, b and c are recalled from the literature without
 * the original at hand, and so all four are the user's to set. Shear removal is not modelled here.
 */
#include "rebound/laws.h"

#include <math.h>

enum { YIELD_RATE, AREA_A, AREA_B, AREA_C, N_PARAMETERS };

static const asp_parameter parameters[N_PARAMETERS] = {
    [YIELD_RATE] = {"yield_rate", "stress/speed", 0, 0, INFINITY,
                    "yield stress per impact speed, sigma_y = yield_rate |v1|; 0: the material's "
                    "constant yield stress (form: Whitaker & Bons 2018, secondary source; no value "
                    "found)"},
    [AREA_A] = {"a", "", 0.1, 0, 1e3,
                "contact area share f = a + b min(1, v_n1/v_y)^c (recalled, original not seen)"},
    [AREA_B] = {"b", "", 1.0 / 7, 0, 1e3, "see a (recalled, original not seen)"},
    [AREA_C] = {"c", "", 0.5, 0, 10, "see a (recalled, original not seen)"},
};

/* 2 W_A / m, the square of the speed that adhesion takes. Where v_y is 0 everything yields, and the
 * ratio is 1. */
static double adhesion(const double *p, const asp_hit *hit, double v_y) {
  double ratio = hit->v_n1 < v_y ? hit->v_n1 / v_y : 1;
  double share = p[AREA_A] + p[AREA_B] * pow(ratio, p[AREA_C]);
  return 6 * hit->pair->surface_energy * share / (hit->density * hit->d_p);
}

static asp_bounce rebound(const double *p, const asp_hit *hit) {
  const asp_pair *pair = hit->pair;
  double n1 = hit->v_n1, t1 = hit->v_t1, speed2 = n1 * n1 + t1 * t1;
  double yield = p[YIELD_RATE] > 0 ? p[YIELD_RATE] * sqrt(speed2) : pair->yield_stress;
  double v_y = yield / sqrt(hit->density * pair->modulus);
  double n2 = fmin(n1, v_y);
  if (hit->adhesion && pair->surface_energy > 0)
    n2 = sqrt(fmax(0, n2 * n2 - adhesion(p, hit, v_y)));
  double cos2 = t1 > 0 ? t1 * t1 / speed2 : 0;
  return (asp_bounce){n2, fmax(0, t1 - pair->friction * (n1 + n2) * cos2)};
}

const asp_rebound_law asp_rebound_bons = {
    .name = "bons",
    .summary = "elastic, plastic or stuck: a yielding spring with adhesion, and friction",
    .source = "Bons, Prenter & Whitaker 2017; Whitaker & Bons 2018 (both by secondary sources)",
    .needs_material = true,
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rebound = rebound,
};
