/* What a flow takes away: measured shares of deposits, and the force that holds them against the
 * speed at which they stick.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "choice.h"

/* The fastest normal impact that sticks by the law of Thornton & Ning. */
static double sticking_speed(double d_p, double density, const asp_pair *pair) {
  aspi_wall_choice choice = choice_of("thornton_ning");
  asp_wall *wall = wall_of(&choice);
  asp_particle particle = {.d_p = d_p, .density = density, .pair = pair};
  double sticks = 0;
  for (double speed = 1e-3; speed < 10; speed *= 1.02) {
    asp_impact impact;
    asp_wall_impact(wall, &particle, (const double[3]){0, 0, -speed}, (const double[3]){0, 0, 1},
                    &(asp_key){1, 1, 1, 1, 0}, &impact);
    sticks = impact.outcome == ASP_DEPOSIT ? speed : sticks;
  }
  asp_wall_free(wall);
  return sticks;
}

/* Shares of deposits that a flow leaves for 1 s, as measured (Reeks & Hall 2001, alumina on steel,
 * d 10 um, digitized), with surface energy 0.28: mean over adhesion of exp(-p t). And a rate that
 * is the rocking itself where the flow pulls more than the deposit holds. */
TEST(a_flow_takes_away) {
  static const asp_pair pair = {50e9, 2e9, 0.28, 0.3, 0, 0, 0};
  static const double measured[][2] = {
      {0.258, 0.996}, {0.381, 0.941}, {0.525, 0.886}, {1.497, 0.150}, {3.135, 0.061}};
  enum { N = 20000 };
  asp_particle particle = {.d_p = 10e-6, .density = 3950, .pair = &pair, .gas = ASP_GAS_FLOWS};
  aspi_wall_choice choice = choice_of("bons");
  choice.flow = (aspi_flow){.density = 1.2, .viscosity = 1.5e-5, .micron = 1e-6};
  asp_wall *wall = wall_of(&choice);
  for (size_t i = 0; i < sizeof measured / sizeof *measured; i++) {
    double stays = 0, by_draw = 0;
    particle.u_tau = measured[i][0];
    for (uint64_t tag = 1; tag <= N; tag++) {
      asp_removal its = asp_wall_removal(wall, &particle, &(asp_key){1, 1, tag, 1, 0});
      assert_true(its.rate >= 0 && its.rate <= 0.00658 * particle.u_tau * particle.u_tau / 1.5e-5);
      stays += exp(-its.rate) / N;
      by_draw += (double)!(its.rate > its.most) / N;
    }
    assert_near(stays, measured[i][1], 0.07);
    assert_near(by_draw, stays, 0.02);
  }
  particle.u_tau = 100;
  assert_near(asp_wall_removal(wall, &particle, &(asp_key){1, 1, 1, 1, 0}).rate, 0.00658e4 / 1.5e-5,
              1e-3);
  particle.gas = ASP_GAS_AT_REST; /* whatever the words say */
  asp_wall_free(wall);
  choice.flow.u_tau = 100;
  wall = wall_of(&choice);
  assert_near(asp_wall_removal(wall, &particle, &(asp_key){1, 1, 1, 1, 0}).rate, 0, 0);
  particle.gas = ASP_GAS_NONE;
  assert_true(asp_wall_removal(wall, &particle, &(asp_key){1, 1, 1, 1, 0}).rate > 0);
  asp_wall_free(wall);
}

/* One surface energy: a flow must pull as hard as JKR's (3/2) pi Gamma R, of the work of adhesion
 * Gamma by which Thornton & Ning's elastic sphere sticks (v_s = 1.84 (Gamma^5/(R^5 rho^3
 * E^2))^(1/6)), to take it away at the full rate. */
TEST(holds_by_what_it_sticks) {
  const asp_pair pair = {118e9, 1e12, 0.1, 0.3, 0, 0, 0};
  const double r = 10e-6, rho = 7850, nu = 1.5e-5, u = 0.5, full = 0.00658 * u * u / nu;
  const double sticks = sticking_speed(2 * r, rho, &pair), in_wall = r * u / nu;
  double work = r * pow(pow(sticks / 1.84, 6) * pow(rho, 3) * 118e9 * 118e9, 0.2);
  double pull = 10.45 * nu * nu * (pow(in_wall, 2.31) + 300 * in_wall * in_wall);
  asp_particle particle = {
      .d_p = 2 * r, .density = rho, .pair = &pair, .u_tau = u, .gas = ASP_GAS_FLOWS};
  for (int i = 0; i < 2; i++) { /* with 0.7 of that, and 1.1 of it */
    aspi_wall_choice choice = choice_of("thornton_ning");
    choice.flow = (aspi_flow){.density = (i ? 1.1 : 0.7) * 1.5 * M_PI * work * r / pull,
                              .viscosity = nu,
                              .adhesion = 1,
                              .spread = 1,
                              .micron = 1e-6};
    asp_wall *wall = wall_of(&choice);
    assert_int_equal(asp_wall_removal(wall, &particle, &(asp_key){1, 1, 1, 1, 0}).rate < full, !i);
    asp_wall_free(wall);
  }
}
