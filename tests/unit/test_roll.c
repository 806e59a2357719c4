/* A sphere on a rough slope: the reference by geometry against closed forms, and both the reference
 * and the model against numbers of an independent computation (units: lambda_c, gravity).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/roll.h"
#include "base/running.h"
#include "choice.h"
#include "surface/closing.h"

#define DEGREE (ASP_PI / 180)

/* A wall of that rms slope; `plane`: a profile. */
static aspi_slope slope_on(const char *plane, double slope_rms, double d_p, double degrees,
                           double e, double mu) {
  char text[200];
  snprintf(text, sizeof text, "surface rq %g lambda_c 1 spread visible %s rebound walton %g %g 0",
           slope_rms / sqrt(2), plane, e, mu);
  asp_error error = {ASP_OK, ""};
  asp_wall *wall = asp_wall_from_text(text, d_p, d_p, &error);
  assert_string_equal(error.text, "");
  return (aspi_slope){.wall = wall,
                      .particle = {.d_p = d_p},
                      .friction = mu,
                      .lambda_c = 1,
                      .gravity = 1,
                      .angle = degrees * DEGREE};
}

/* The reference takes the law only. */
static aspi_slope slope_of(double d_p, double degrees, double e, double mu) {
  return slope_on("plane", 0.2, d_p, degrees, e, mu);
}

static void free_wall(const aspi_slope *slope) {
  asp_wall_free((asp_wall *)slope->wall);
}

/* Down a wall without roughness a sphere rolls with 5/7 of the acceleration along it. */
static void rolls_down_a_smooth_slope(void **state) {
  (void)state;
  for (int space = 0; space < 2; space++) {
    aspi_ground ground;
    assert_int_equal(aspi_ground_create(&ground, 1e-9, 1, 4, space, 1, NULL), ASP_OK);
    aspi_slope slope = slope_of(4, 5, 0.5, 0.3);
    aspi_sphere s = aspi_sphere_place(&ground, 0, 0);
    while (s.time < 20)
      aspi_sphere_step(&ground, &slope, &s);
    assert_near(s.v[0] / s.time, 5. / 7 * sin(5 * DEGREE), 1e-3 * sin(5 * DEGREE));
    assert_near(s.omega[1] * 2, s.v[0], 1e-2 * s.v[0]);
    free_wall(&slope);
    aspi_ground_free(&ground);
  }
}

/* A bump of height h is passed with 7/10 v^2 > g h rolling, and with 1/2 v^2 > g h sliding. */
static void passes_a_bump(void **state) {
  (void)state;
  enum { POINTS = 4096 };
  static double z[POINTS];
  const double height = 0.2, step = 1. / 128;
  for (int i = 0; i < POINTS; i++)
    z[i] = height * exp(-pow((i - POINTS / 2) * step / 3, 2));
  asp_profile *profile = asp_profile_from_heights(z, POINTS, step, false, NULL);
  aspi_ground ground = {.path = aspi_profile_rolled(profile, 2, 1, NULL)};
  for (int rolls = 0; rolls < 2; rolls++)
    for (int fast = 0; fast < 2; fast++) {
      aspi_slope slope = slope_of(2, 0, 0.5, rolls ? 0.5 : 0);
      aspi_sphere s = aspi_sphere_place(&ground, 6, 0);
      s.v[0] = (fast ? 1.03 : 0.97) * sqrt(height / (rolls ? 0.7 : 0.5));
      s.omega[1] = rolls ? s.v[0] : 0;
      while (s.x[0] > 5 && s.x[0] < 26 && s.time < 400)
        aspi_sphere_step(&ground, &slope, &s);
      assert_int_equal(s.x[0] >= 26, fast);
      free_wall(&slope);
    }
  aspi_ground_free(&ground);
  asp_profile_free(profile);
}

/* Elastic and without friction, the energy stays, but for what lifts the sphere onto the wall. */
static void keeps_energy(void **state) {
  (void)state;
  for (int space = 0; space < 2; space++) {
    aspi_ground ground;
    assert_int_equal(aspi_ground_create(&ground, 0.14, 1, 4, space, 3, NULL), ASP_OK);
    aspi_slope slope = slope_of(4, 0, 1, 0);
    aspi_sphere s = aspi_sphere_place(&ground, 0, 0);
    s.x[2] += 1;
    s.v[0] = 2;
    double energy = s.x[2] + 2;
    while (s.time < 50)
      aspi_sphere_step(&ground, &slope, &s);
    double now = s.x[2] + 0.5 * (s.v[0] * s.v[0] + s.v[1] * s.v[1] + s.v[2] * s.v[2]);
    assert_near(now, energy, 0.01 * energy);
    free_wall(&slope);
    aspi_ground_free(&ground);
  }
}

/* Two rows of the independent computation: speed, standard error. */
static void moves_as_computed_elsewhere(void **state) {
  (void)state;
  static const struct {
    bool space;
    double d_p, speed, se;
  } rows[] = {{false, 4, 1.492, 0.010}, {true, 1, 1.399, 0.043}};
  for (int i = 0; i < 2; i++) {
    aspi_running speed = {0, 0, 0};
    for (uint32_t seed = 1; seed <= 6; seed++) {
      aspi_ground ground;
      assert_int_equal(
          aspi_ground_create(&ground, 0.2 / sqrt(2), 1, rows[i].d_p, rows[i].space, seed, NULL),
          ASP_OK);
      aspi_slope slope = slope_of(rows[i].d_p, 5, 0.5, 0.3);
      aspi_roll roll = aspi_ground_roll(&ground, &slope, 0, 0, rows[i].space ? 100 : 400);
      if (!roll.stopped)
        aspi_running_add(&speed, roll.speed);
      free_wall(&slope);
      aspi_ground_free(&ground);
    }
    assert_true(speed.n > 3);
    double se = hypot(rows[i].se, aspi_running_sd(&speed) / sqrt(speed.n));
    print_message("speed %.3f, elsewhere %.3f, standard error %.3f\n", speed.mean, rows[i].speed,
                  se);
    assert_near(speed.mean, rows[i].speed, 3.5 * se);
  }
}

/* Mean speed by the model, on the surface or the profile of slope_rms 0.2. */
static aspi_running model_speed(bool space, double d_p, double degrees, double step) {
  aspi_slope slope = slope_on(space ? "" : "plane", 0.2, d_p, degrees, 0.5, 0.3);
  aspi_running speed = {0, 0, 0};
  for (uint64_t tag = 1; tag <= 32; tag++) {
    aspi_roll roll = aspi_slope_roll(&slope, step, space ? 300 : 400, tag);
    if (!roll.stopped)
      aspi_running_add(&speed, roll.speed);
  }
  assert_true(speed.n > 20);
  free_wall(&slope);
  return speed;
}

/* The model against the same computation, and with a step a tenth as long. */
static void the_model_moves_as_the_wall(void **state) {
  (void)state;
  static const struct {
    bool space;
    double d_p, degrees, speed;
  } rows[] = {{false, 4, 5, 1.492}, {false, 4, 2, 1.142}, {true, 4, 5, 1.384}, {true, 1, 5, 1.399}};
  for (int i = 0; i < 4; i++) {
    aspi_running speed = model_speed(rows[i].space, rows[i].d_p, rows[i].degrees, 0.05);
    print_message("model %.3f, elsewhere %.3f\n", speed.mean, rows[i].speed);
    assert_near(speed.mean, rows[i].speed, 0.15 * rows[i].speed);
  }
  aspi_running coarse = model_speed(false, 4, 5, 0.05), fine = model_speed(false, 4, 5, 0.005);
  assert_near(coarse.mean, fine.mean, 0.05 * fine.mean);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(rolls_down_a_smooth_slope), cmocka_unit_test(passes_a_bump),
      cmocka_unit_test(keeps_energy), cmocka_unit_test(moves_as_computed_elsewhere),
      cmocka_unit_test(the_model_moves_as_the_wall)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
