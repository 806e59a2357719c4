/* Laws that turn the particle: measured oblique impacts, rolling, sticking, energy; and the law of
 * Thornton & Ning against its limits, an integrated contact and the curve of Johnson, Kendall &
 * Roberts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "choice.h"

#include <gsl/gsl_rng.h>

static const double up[3] = {0, 0, 1};

/* A smooth wall by the words behind `rebound`, for particles with pairs of their own. */
static asp_wall *smooth(const char *law) {
  char text[200];
  snprintf(text, sizeof text, "rebound %s", law);
  asp_description *words = asp_description_parse(text, NULL, NULL);
  assert_non_null(words);
  asp_description_expect_pairs(words);
  asp_wall *wall = asp_wall_create(words, 0, 0, NULL);
  assert_non_null(wall);
  asp_description_free(words);
  return wall;
}

static asp_impact hit(const asp_wall *wall, const asp_pair *pair, const double v1[3],
                      const double omega[3]) {
  asp_particle particle = {
      .d_p = 5e-3, .density = 3950, .pair = pair, .omega = {omega[0], omega[1], omega[2]}};
  asp_impact impact;
  asp_wall_impact(wall, &particle, v1, up, &(asp_key){1, 1, 1, 1, 0}, &impact);
  return impact;
}

static const double still[3] = {0, 0, 0};

/* Kharaz, Gorham & Salman 2001: 5 mm alumina on glass, 3.9 m/s, e 0.98, mu 0.092. Sliding needs no
 * other constant; between sliding and normal impact the contact gives way. */
TEST(measured_oblique_impacts) {
  static const double measured[][2] = {{30.16, .9019}, {40.45, .8469}, {50.70, .7719},
                                       {59.78, .6883}, {69.92, .5964}, {80.37, .6728},
                                       {86.07, .7450}};
  for (int compliant = 0; compliant < 2; compliant++) {
    asp_wall *wall =
        smooth(compliant ? "walton 0.98 0.092 0 compliance 0.7" : "walton 0.98 0.092 0.156");
    for (int i = 0; i < 7; i++) {
      double alpha = measured[i][0] * M_PI / 180, beyond = compliant ? 0.03 : 0.08;
      double v1[3] = {3.9 * cos(alpha), 0, -3.9 * sin(alpha)};
      asp_impact impact = hit(wall, NULL, v1, still);
      assert_near(impact.v2[0] / v1[0], measured[i][1], measured[i][0] < 60 ? 0.01 : beyond);
      assert_near(impact.v2[2] / -v1[2], 0.98, 1e-12);
    }
    asp_wall_free(wall);
  }
}

/* Where it sticks: 5/7 without spin, 2/7 of the surface's speed without flight, and the surface
 * goes on with -beta0 times its speed; a particle that rolls already loses nothing. */
TEST(sticks_and_rolls) {
  asp_wall *wall = smooth("walton 1 100 0");
  double v1[3] = {1, 0, -2}, r = 2.5e-3, down[3] = {0, 0, -2};
  asp_impact impact = hit(wall, NULL, v1, still);
  assert_near(impact.v2[0], 5. / 7, 1e-14);
  assert_near(impact.omega[1], 5. / 7 / r, 1e-10); /* v_x = omega_y r: it rolls */
  impact = hit(wall, NULL, down, (double[3]){0, 1 / r, 0});
  assert_near(impact.v2[0], 2. / 7, 1e-14);
  assert_near(impact.omega[1] * r, 2. / 7, 1e-13);
  impact = hit(wall, NULL, v1, (double[3]){0, 1 / r, 3});
  assert_near(impact.v2[0], 1, 1e-14);
  assert_near(impact.omega[1] * r, 1, 1e-13);
  assert_near(impact.omega[2], 3, 1e-14);
  asp_wall_free(wall);
  wall = smooth("walton 1 100 0.4");
  impact = hit(wall, NULL, v1, (double[3]){0, -1 / r, 0});
  assert_near(impact.v2[0] - r * impact.omega[1], -0.4 * 2, 1e-13);
  asp_wall_free(wall);
}

/* Bons with spin: the law's own impulse as long as it is small, rolling where it is large. */
TEST(bons_takes_part) {
  static const asp_pair pair = {50e9, 2e9, 0, 0.1, 0, 0, 0};
  asp_wall *off = smooth("bons"), *on = smooth("bons spin on");
  for (double alpha = 0.05; alpha < 1.5; alpha += 0.05) {
    double v1[3] = {cos(alpha), 0, -sin(alpha)};
    asp_impact a = hit(off, &pair, v1, (double[3]){1, 2, 3}), b = hit(on, &pair, v1, still);
    assert_near(a.omega[0] + a.omega[1] + a.omega[2], 6, 0);
    assert_near(b.v2[0], fmax(a.v2[0], 5. / 7 * v1[0]), 1e-14);
    assert_near(b.omega[1] * 2.5e-3, 2.5 * (v1[0] - b.v2[0]), 1e-12);
  }
  asp_wall_free(off);
  asp_wall_free(on);
}

static double energy(const double v[3], const double w[3], double r) {
  double square = 0;
  for (int d = 0; d < 3; d++)
    square += v[d] * v[d] + 0.4 * r * r * w[d] * w[d];
  return square;
}

/* Over random walls, constants, flights and spins, through later hits too. */
TEST(energy_with_spin_never_grows) {
  static const char *const laws[] = {"walton", "bons", "thornton_ning"};
  static const asp_pair pair = {50e9, 2e8, 0, 0.4, 0, 0, 0};
  asp_surface *surface = asp_surface_create(0.15, 1, NULL);
  gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
  for (uint64_t tag = 1; tag <= 20000; tag++) {
    aspi_wall_choice choice = choice_of(laws[tag % 3]);
    static const char *const random[] = {"beta0", "mu", "e"};
    set_parameter(&choice, "spin", 1);
    for (int i = 0; i < 3; i++)
      set_parameter(&choice, random[i], (i == 1 ? 2 : 1) * gsl_rng_uniform(rng));
    set_parameter(&choice, "compliance", tag % 5 == 0 ? gsl_rng_uniform(rng) : 0);
    choice.deposit = false;
    choice.spread = asp_spread_find("visible", NULL);
    choice.isotropic = tag % 2;
    choice.multiple = tag % 4 < 2;
    choice.surface = tag % 7 ? surface : NULL;
    asp_wall *wall = wall_of(&choice);
    double r = 0.01, v[3], w[3];
    for (int d = 0; d < 3; d++) {
      v[d] = 2 * gsl_rng_uniform(rng) - 1;
      w[d] = (2 * gsl_rng_uniform(rng) - 1) / r * (tag % 3 ? 1 : 5);
    }
    v[2] = -fabs(v[2]);
    asp_particle particle = {
        .d_p = 2 * r, .density = 2650, .pair = &pair, .omega = {w[0], w[1], w[2]}};
    asp_impact impact;
    asp_wall_impact(wall, &particle, v, up, &(asp_key){1, 1, tag, 1, 0}, &impact);
    assert_true(energy(impact.v2, impact.omega, r) <= energy(v, w, r) * (1 + 1e-13));
    assert_true(impact.v2[2] >= 0);
    asp_wall_free(wall);
  }
  gsl_rng_free(rng);
  asp_surface_free(surface);
}

/* ---- Thornton & Ning --------------------------------------------------------------------------
 */
static const double E = 50e9, RHO = 2500, R = 2.5e-3;

static double restitution_of(double d_p, double density, const asp_pair *pair, double speed) {
  asp_wall *wall = smooth("thornton_ning pressure_ratio 1");
  asp_particle particle = {.d_p = d_p, .density = density, .pair = pair};
  double v1[3] = {0, 0, -speed};
  asp_impact impact;
  asp_wall_impact(wall, &particle, v1, up, &(asp_key){1, 1, 1, 1, 0}, &impact);
  asp_wall_free(wall);
  return impact.v2[2] / speed;
}

static double restitution(double speed, double pressure, double gamma) {
  asp_pair pair = {E, pressure, gamma, 0, 0, 0, 0};
  return restitution_of(2 * R, RHO, &pair, speed);
}

static double yields_at(double pressure) {
  return M_PI * M_PI / sqrt(40) * sqrt(pow(pressure, 5) / (pow(E, 4) * RHO));
}

/* The contact itself, step by step: Hertz, then a force that grows linearly, then Hertz with the
 * radius of the dent. */
static double integrated(double speed, double pressure) {
  double mass = 4 * M_PI / 3 * R * R * R * RHO, v = speed, a = 0, force = 0;
  double a_y = R * pow(M_PI * pressure / (2 * E), 2), f_y = 4. / 3 * E * sqrt(R) * pow(a_y, 1.5);
  double dt = 1e-4 * pow(mass * mass / (E * E * R * speed), 0.2);
  for (double next; v > 0;) { /* the middle of each step */
    next = a + 0.5 * dt * v;
    force = next < a_y ? 4. / 3 * E * sqrt(R) * pow(next, 1.5)
                       : f_y + M_PI * pressure * R * (next - a_y);
    v -= force / mass * dt;
    a = next + 0.5 * dt * v;
  }
  /* The area of a contact that has yielded has the radius^2 R a; unloading is Hertz from there. */
  if (a > a_y) {
    double edge = sqrt(R * a), dent = 4 * E * edge * edge * edge / (3 * force);
    a = edge * edge / dent;
    double k = 4. / 3 * E * sqrt(dent);
    for (v = 0; a > 0; a -= dt * v)
      v += k * pow(a, 1.5) / mass * dt;
    return v / speed;
  }
  return 1;
}

TEST(plastic_contact_as_integrated) {
  double pressure = 1e9, v_y = yields_at(pressure);
  for (double ratio = 1.1; ratio < 2000; ratio *= 2.5)
    assert_near(restitution(ratio * v_y, pressure, 0), integrated(ratio * v_y, pressure), 2e-3);
}

/* Their own closed form above yield, its limits, and the elastic contact that adheres. */
TEST(limits_of_thornton_and_ning) {
  double pressure = 1e9, v_y = yields_at(pressure);
  assert_near(restitution(0.999 * v_y, pressure, 0), 1, 1e-12);
  assert_near(restitution(1.0001 * v_y, pressure, 0), 1, 1e-3);
  for (double ratio = 1.1; ratio < 1e5; ratio *= 3) {
    double q = 1 / ratio;
    double e = sqrt(6 * sqrt(3) / 5) * sqrt(1 - q * q / 6) *
               pow(q / (q + 2 * sqrt(1.2 - q * q / 5)), 0.25);
    assert_near(restitution(ratio * v_y, pressure, 0), e, 1e-12);
  }
  assert_near(restitution(1e6 * v_y, pressure, 0) / (1.185 * pow(1e-6, 0.25)), 1, 1e-3);
  double gamma = 0.5, work = 0.3 + 0.2 / pow(4, 4. / 3);
  double v_s = sqrt(1.5 / M_PI * work * pow(2 * M_PI, 5. / 3));
  assert_near(v_s, 1.84, 0.001);
  v_s *= pow(pow(2 * gamma / R, 5) / (pow(RHO, 3) * E * E), 1. / 6);
  assert_near(restitution(0.999 * v_s, 1e12, gamma), 0, 0);
  for (double ratio = 1.001; ratio < 1e3; ratio *= 2)
    assert_near(restitution(ratio * v_s, 1e12, gamma), sqrt(1 - 1 / (ratio * ratio)), 1e-12);
  /* With both, less comes back than with either. */
  assert_true(restitution(20 * v_s, 1e7, gamma) <
              fmin(restitution(20 * v_s, 1e7, 0), restitution(20 * v_s, 1e12, gamma)));
}

/* Force of a contact of Johnson, Kendall & Roberts with the radius of curvature dent. */
static double clings(double a, double dent, double work) {
  return 4 * E * a * a * a / (3 * dent) - sqrt(8 * M_PI * work * E * a * a * a);
}

static double approach(double a, double dent, double work) {
  return a * a / dent - sqrt(2 * M_PI * work * a / E);
}

/* The same contact, its pressure capped at p_y inside the radius (a^2 - a_y^2)^(1/2), in small
 * steps of the contact's radius. */
static double integrated_with_adhesion(double speed, double pressure, double gamma) {
  double work = 2 * gamma, energy = 2 * M_PI / 3 * R * R * R * RHO * speed * speed, a_y = R;
  for (double low = 0, high = R; high - low > 1e-15 * R; a_y = 0.5 * (low + high))
    *(2 * E * a_y / (M_PI * R) - sqrt(2 * work * E / (M_PI * a_y)) < pressure ? &low : &high) = a_y;
  double a = cbrt(2 * M_PI * work * R * R / E), da = 1e-4 * fmin(a, a_y), force = 0, next = 0;
  for (double last = clings(a, R, work); energy > 0; last = force, a = next) {
    next = a + da;
    force = next < a_y ? clings(next, R, work)
                       : M_PI * (next * next - a_y * a_y) * pressure + clings(a_y, R, 0) -
                             a_y * sqrt(8 * M_PI * work * E * next);
    energy -= 0.5 * (force + last) * (approach(next, R, work) - approach(a, R, work));
  }
  double dent = 4 * E * a * a * a / (3 * (force + sqrt(8 * M_PI * work * E * a * a * a)));
  double end = cbrt(M_PI * work * dent * dent / (8 * E)), back = 0;
  for (da = (a - end) / 20000; a > end + 0.5 * da; a -= da)
    back += 0.5 * (clings(a, dent, work) + clings(a - da, dent, work)) *
            (approach(a, dent, work) - approach(a - da, dent, work));
  return back > 0 ? sqrt(back / (2 * M_PI / 3 * R * R * R * RHO)) / speed : 0;
}

TEST(adhesive_plastic_contact_as_integrated) {
  for (double pressure = 1e7; pressure < 2e9; pressure *= 10)
    for (double speed = 1e-3; speed < 50; speed *= 3)
      assert_near(restitution(speed, pressure, 0.5), integrated_with_adhesion(speed, pressure, 0.5),
                  2e-3);
}

/* The fastest of its rebounds, and the speed under which it sticks. */
static double best_of(double d_p, double density, const asp_pair *pair, double *sticks) {
  double best = 0;
  *sticks = 0;
  for (double speed = 1e-3; speed < 10; speed *= 1.02) {
    double e = restitution_of(d_p, density, pair, speed);
    best = fmax(best, e);
    if (!(e > 0))
      *sticks = speed;
  }
  return best;
}

/* Their figure 10 by a digest: 10 um, of the constants that give its v_y 0.62 and v_s 0.016 m/s at
 * 3.04 GPa. And ammonium fluorescein on silicon (Pasha et al. 2014, digest): about 1.6 m/s. */
TEST(published_adhesive_plastic_impacts) {
  static const double figure[][3] = {{3.04e9, 1, 0.016}, {1e9, 0.9, 0.016}, {0.5e9, 0.5, 0.032}};
  double sticks;
  for (int i = 0; i < 3; i++) {
    asp_pair pair = {118e9, figure[i][0], 0.1, 0, 0, 0, 0};
    assert_near(best_of(20e-6, 7850, &pair, &sticks), figure[i][1], 0.015);
    assert_near(sticks, figure[i][2], 0.002);
  }
  asp_pair fluorescein = {1.31e9, 35.3e6, 0.1, 0, 0, 0, 0};
  best_of(4.9e-6, 1350, &fluorescein, &sticks);
  assert_near(sticks, 1.42, 0.03);
}
