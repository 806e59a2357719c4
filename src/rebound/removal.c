/* The critical friction velocity of El-Batsh, as one published code has it (a user-defined function
 * of a flow solver; the original was not seen):
 *
 *   u_tau_c^2 = C_u W/(rho_g d) (W/(d K_c))^(1/3),  K_c = (4/3) E_c
 *   C_u = 1 + Kn (1.2 + 0.41 exp(-0.88/Kn)),        Kn = 2 l/d
 *
 * A particle that would stick is taken away at once where the flow's friction velocity is more.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/removal.h"

#include <math.h>

bool aspi_flow_removes(const aspi_flow *flow, const asp_particle *particle) {
  double u_tau = particle->u_tau > 0 ? particle->u_tau : flow->u_tau, d_p = particle->d_p;
  if (!(u_tau > 0) || !(flow->density > 0) || !particle->pair)
    return false;
  double kn = 2 * flow->mean_free_path / d_p;
  double slip = kn > 0 ? 1 + kn * (1.2 + 0.41 * exp(-0.88 / kn)) : 1;
  double per_area = cbrt(flow->work / (d_p * 4 / 3 * particle->pair->modulus));
  double critical2 = slip * flow->work / (flow->density * d_p) * per_area;
  return u_tau * u_tau > critical2;
}
