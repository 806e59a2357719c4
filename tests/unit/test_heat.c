/* Hot particles: the curves of viscosity against numbers worked out by hand, the share that sticks
 * against min(1, mu_c/mu), and the modulus at a temperature against the capture speed of an
 * adhesive contact that is integrated here, and that of El-Batsh's formula.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"

#include <stdlib.h>

static const double up[3] = {0, 0, 1};

static double share_of(const char *text, double kelvin) {
  asp_wall *wall = wall_from(text, 0);
  double share;
  assert_int_equal(asp_wall_sticking(wall, kelvin, &share, NULL), ASP_OK);
  asp_wall_free(wall);
  return share;
}

/* By hand: vft at 1300 K 10^(-4.5 + 9000/800) = 10^6.75 Pa s. Watt & Fereday for
 * 36, 20.8, 4.9, 13.3 and 25 %: m 0.316608, c -1.6786; at 1250 K 10^(4.6310 - 1.6786 - 1) Pa s. A
 * table in between. */
TEST(shares_by_hand) {
  const char *vft = "rebound walton 0.8 0.3 0 deposit freeze viscosity vft -4.5 9000 500 critical";
  const char *watt = "rebound walton 0.8 0.3 0 deposit freeze viscosity critical 10 watt";
  char text[200];
  snprintf(text, sizeof text, "%s 1e4", vft);
  assert_near(share_of(text, 1300), pow(10, 4 - 6.75), 1e-12);
  assert_near(share_of(text, 2000), 1, 0);
  snprintf(text, sizeof text, "%s 1e5P", vft);
  assert_near(share_of(text, 1300), pow(10, 4 - 6.75), 1e-12);
  snprintf(text, sizeof text, "%s 36 20.8 4.9 13.3 25", watt);
  assert_near(share_of(text, 1250), 10 / pow(10, 1e7 * 0.316608 / (826.85 * 826.85) - 2.6786),
              1e-9);
  snprintf(text, sizeof text, "%s 37.8 21.84 5.145 13.965 26.25", watt); /* 105 % of the same */
  assert_near(share_of(text, 1250), 10 / pow(10, 1e7 * 0.316608 / (826.85 * 826.85) - 2.6786),
              1e-9);
  FILE *table = fopen("viscosity.csv", "w");
  fputs("# measured\ntemperature_k,viscosity_pa_s\n1100,1e9\n1300,1e5\n1400,1e4\n", table);
  fclose(table);
  const char *words = "rebound walton 0.8 0.3 0 deposit freeze viscosity critical 10 table";
  snprintf(text, sizeof text, "%s viscosity.csv", words);
  assert_near(share_of(text, 1150), 1e-7, 1e-15);
  assert_near(share_of(text, 1400), 1e-3, 1e-12);
  asp_wall *wall = wall_from(text, 0);
  asp_error error;
  for (double kelvin = 1099; kelvin < 1500; kelvin += 302) {
    assert_int_equal(asp_wall_sticking(wall, kelvin, NULL, &error), ASP_ERANGE);
    assert_says(error.text, "from 1100 to 1400 K");
  }
  asp_wall_free(wall);
}

enum { IMPACTS = 8000 };

/* Impacts at a temperature: how many stick. Those that rebound do so as on `cold`, and those that
 * stick hit the same faces. */
static int count_stuck(const asp_wall *wall, const asp_wall *cold, double kelvin, double angle,
                       const asp_body *body) {
  const double v[3] = {20 * cos(angle), 0, -20 * sin(angle)};
  double tilt[2] = {0, 0}, square = 0;
  int stuck = 0;
  for (uint64_t i = 0; i < IMPACTS; i++) {
    asp_particle one = {.d_p = 1e-5, .density = 2650, .temperature = kelvin, .body = body};
    const asp_key key = {1, asp_key_wall("hot"), i, 1, 0};
    asp_impact impact, other;
    assert_int_equal(asp_wall_impact(wall, &one, v, up, &key, &impact), ASP_OK);
    assert_int_equal(asp_wall_impact(cold, &one, v, up, &key, &other), ASP_OK);
    stuck += impact.outcome == ASP_DEPOSIT;
    if (impact.outcome == ASP_DEPOSIT)
      assert_true(impact.hits == 1 && !(impact.v2[0] < 0 || impact.v2[0] > 0));
    else
      assert_memory_equal(impact.v2, other.v2, sizeof other.v2);
    assert_near(impact.delta_alpha, other.delta_alpha, 0);
    tilt[impact.outcome == ASP_DEPOSIT] += impact.delta_alpha;
    square += impact.delta_alpha * impact.delta_alpha;
  }
  const int free = IMPACTS - stuck;
  if (stuck > 0 && free > 0)
    assert_near(tilt[1] / stuck, tilt[0] / free,
                4 * sqrt(square / IMPACTS * (1. / stuck + 1. / free)));
  return stuck;
}

TEST(sticks_with_that_share) {
  static const char *const walls[] = {
      "rebound walton 0.8 0.3 0", "surface rq 5e-6 lambda_c 40e-6 rebound walton 0.8 0.3 0",
      "surface rq 5e-6 lambda_c 40e-6 rebound bons materials quartz hastelloy-x surface_energy 0"};
  const double mass = ASP_PI / 6 * 2650 * 1e-15, turn = 10 / (mass * 1e-10);
  const asp_body body = {1 / mass, {turn, turn, turn, 0, 0, 0}, {1e-6, 0, 2e-6}, {0}};
  char text[300];
  for (size_t w = 0; w < sizeof walls / sizeof *walls; w++)
    for (int k = 0; k < 4; k++) {
      snprintf(text, sizeof text, "%s deposit freeze viscosity critical 1e4 vft -4.5 9000 500",
               walls[w]);
      asp_wall *hot = wall_from(text, 0), *cold = wall_from(walls[w], 0);
      const double kelvin = 1350 + 50 * k, p = fmin(1, pow(10, 8.5 - 9000 / (kelvin - 500)));
      const int stuck = count_stuck(hot, cold, kelvin, k % 2 ? 0.1 : 1.5, k == 1 ? &body : NULL);
      assert_near(stuck, IMPACTS * p, 4 * sqrt(IMPACTS * p * (1 - p)) + 0.5);
      asp_wall_free(hot);
      asp_wall_free(cold);
    }
}

/* The particle keeps its velocity, and the code says why. */
TEST(unknown_is_an_error) {
  asp_wall *wall =
      wall_from("rebound walton 0.8 0.3 0 deposit freeze viscosity critical 1e4 vft -4.5 "
                "9000 500",
                0);
  const asp_key key = {1, 2, 3, 4, 0};
  const double v[3] = {1, 0, -1}, none[] = {0, 400};
  asp_impact impact;
  asp_error error;
  for (int i = 0; i < 2; i++) {
    const asp_particle one = {.d_p = 1e-5, .density = 2650, .temperature = none[i]};
    assert_int_equal(asp_wall_impacts(wall, 1, &one, v, up, &key, &impact, &error), ASP_ERANGE);
    assert_says(error.text, i ? "more than 500 K" : "must be more than 0");
    assert_memory_equal(impact.v2, v, sizeof v);
  }
  asp_wall_free(wall);
}

/* What a contact of Johnson, Kendall & Roberts takes from x = 0, where it begins, to where it can
 * shrink no further, with R = E = 1: the integral of P dx, by Simpson's rule, in gamma = 2 pi
 * Gamma. */
static double force_dx(double a, double gamma) {
  const double p = 4 * a * a * a / 3 - 2 * sqrt(gamma * a * a * a);
  return p * (2 * a - 0.5 * sqrt(gamma / a));
}

static double work_of_adhesion(double gamma) {
  const double first = cbrt(gamma), last = cbrt(gamma / 16);
  enum { STEPS = 2000 };
  double sum = 0;
  for (int i = 0; i <= STEPS; i++)
    sum += force_dx(first + (last - first) * i / STEPS, gamma) * (i == 0 || i == STEPS ? 1
                                                                  : i % 2              ? 4
                                                                                       : 2);
  return fabs(sum * (last - first) / STEPS / 3);
}

/* El-Batsh's speed v = (2 E/d)^(10/7), with E_p = E_s = 3e20 exp(-0.02365 T), is the elastic
 * contact of Hertz that adheres by its largest area with the energy 0.34 v^0.5 (SI): (1/2) m v^2 =
 * 0.34 v^0.5 A(v). With that energy the contact above has the same speed but for the area's path:
 * 0.83 of it. */
TEST(modulus_of_el_batsh) {
  static const double kelvin[] = {1000, 1100, 1200, 1300, 1400, 1500};
  const double d = 1e-5, rho = 2650, nu = 0.27, r = d / 2, mass = rho * ASP_PI / 6 * d * d * d;
  for (int i = 0; i < 6; i++) {
    const double young = 3e20 * exp(-0.02365 * kelvin[i]), k = (1 - nu * nu) / (ASP_PI * young);
    const double part = 0.51 * pow(5 * ASP_PI * ASP_PI * 2 * k / (4 * pow(rho, 1.5)), 0.4);
    const double v = pow(2 * part / d, 10 / 7.), gamma = 0.17 * sqrt(v);
    char text[400];
    FILE *file = fopen("ash.csv", "w");
    fprintf(file,
            "name,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa\n"
            "ash,7e10,%g,%g,1e16\nlayer,7e10,%g,%g,\n",
            nu, rho, nu, rho);
    fclose(file);
    snprintf(text, sizeof text,
             "rebound thornton_ning temperature %g soften_modulus exp 3e20 0.02365 "
             "wall_temperature %g materials ash layer file ash.csv surface_energy %.17g",
             kelvin[i] + 20, kelvin[i] - 20, gamma);
    asp_error error;
    asp_description *words = asp_description_parse(text, NULL, &error);
    if (!words)
      fail_msg("%s", error.text);
    asp_wall *wall = asp_wall_create(words, 0, 0, NULL);
    const asp_particle grain = {.d_p = d, .density = rho, .pair = asp_wall_pair(wall)};
    const double found = asp_description_capture_speed(words, &grain);
    const double e = young / (2 * (1 - nu * nu));
    const double own =
        sqrt(2 * e * r * r * r * work_of_adhesion(2 * ASP_PI * 2 * gamma / (e * r)) / mass);
    print_message("%g K: %.4g m/s, by quadrature %.4g, El-Batsh %.4g\n", kelvin[i], found, own, v);
    assert_near(found, own, 2e-4 * own);
    assert_near(found, 0.83 * v, 0.01 * v);
    for (int fast = 0; fast < 2; fast++) {
      const double v1[3] = {0, 0, -found * (fast ? 1.001 : 0.999)};
      const asp_key key = {1, 2, 3, 4, 0};
      asp_impact impact;
      assert_int_equal(asp_wall_impact(wall, &grain, v1, up, &key, &impact), ASP_OK);
      assert_int_equal(impact.outcome, fast ? ASP_REBOUND : ASP_DEPOSIT);
    }
    asp_wall_free(wall);
    asp_description_free(words);
  }
}
