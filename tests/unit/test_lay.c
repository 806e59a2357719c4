/* Walls with a lay: what theory says of them, and surfaces in three dimensions, none of which made
 * the model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "choice.h"
#include "judge_3d.h"
#include "surface/size_law.h"
#include "wall/roughness.h"

#include <stdlib.h>

#define DEGREE (ASP_PI / 180)

static const double up[3] = {0, 0, 1};

typedef struct setup {
  asp_surface *surface;
  asp_wall *wall;
} setup;

static setup setup_create(double lambda, double along, const char *tilt) {
  setup s = {.surface = asp_surface_create_lay(5, lambda, along, NULL)};
  aspi_wall_choice choice = choice_of("constant");
  choice.spread = asp_spread_find("visible", NULL);
  choice.isotropic = strcmp(tilt, "isotropic") == 0;
  choice.multiple = true;
  choice.deposit = false;
  choice.surface = s.surface;
  s.wall = wall_of(&choice);
  return s;
}

static void setup_free(setup *s) {
  asp_wall_free(s->wall);
  asp_surface_free(s->surface);
}

/* An impact along x; psi is the angle from x to the axis across the lay, toward n x t = y. */
static asp_impact meet(const setup *s, double d_p, double alpha1, double psi, uint64_t tag) {
  double lay[3] = {-sin(psi), cos(psi), 0.3}, v1[3] = {cos(alpha1), 0, -sin(alpha1)};
  asp_particle grain = {.d_p = d_p, .density = 1, .lay = lay};
  asp_impact impact;
  asp_wall_impact(s->wall, &grain, v1, up, &(asp_key){3, 1, tag, 1, 0}, &impact);
  return impact;
}

static aspi_angles many(const setup *s, double d_p, double alpha1, double psi, size_t n) {
  aspi_angles all = {0};
  for (size_t i = 0; i < n; i++) {
    asp_impact impact = meet(s, d_p, alpha1, psi, i);
    aspi_angles_add(&all, impact.v2, impact.delta_alpha, impact.hits);
  }
  return all;
}

/* Equal lengths are a wall without a lay, to the bit; and what points the other way is the same. */
TEST(a_lay_has_no_sense) {
  setup equal = setup_create(40, 40, "isotropic"), lay = setup_create(40, 200, "isotropic");
  for (uint64_t tag = 0; tag < 3000; tag++) {
    double alpha1 = 0.001 * (double)(tag % 1500), psi = 0.01 * (double)tag;
    asp_impact a = meet(&equal, 100, alpha1, psi, tag), b = meet(&equal, 100, alpha1, 0, tag);
    asp_impact c = meet(&lay, 100, alpha1, psi, tag),
               d = meet(&lay, 100, alpha1, psi + ASP_PI, tag);
    for (int k = 0; k < 3; k++) {
      assert_near(a.v2[k], b.v2[k], 0);
      assert_near(c.v2[k], d.v2[k], 1e-9);
    }
  }
  setup_free(&equal);
  setup_free(&lay);
}

/* The other side of the lay steers to the other side. */
TEST(mirrored_lays_mirror_the_law) {
  enum { N = 25000 };
  setup s = setup_create(40, 200, "isotropic");
  aspi_angles left = many(&s, 10, 0.1, 0.6, N), right = many(&s, 10, 0.1, -0.6, N);
  double error = 5 * sqrt(2 * left.lateral_square / N / N);
  assert_true(left.lateral_sum / N < -1);
  assert_near(left.lateral_sum / N, -right.lateral_sum / N, error);
  assert_near(left.rebound_sum / N, right.rebound_sum / N, 5 * sqrt(2. / N) * 10);
  setup_free(&s);
}

/* Endless grooves: across them a profile, without a tilt out of the plane; along them faces that
 * tilt out of the plane only, with the slope across. */
TEST(grooves) {
  enum { N = 25000 };
  setup s = setup_create(40, 4e8, "isotropic"), plane = setup_create(40, 40, "plane");
  double square = 0, lower = 0;
  for (uint64_t tag = 0; tag < N; tag++) {
    asp_impact across = meet(&s, 1e-6, 0.2, 0, tag), flat = meet(&plane, 1e-6, 0.2, 0, tag);
    assert_near(across.delta_alpha, flat.delta_alpha, 1e-9);
    assert_near(across.tilt_out, 0, 1e-6);
    asp_impact along = meet(&s, 1e-6, 0.2, ASP_PI / 2, tag);
    assert_near(along.delta_alpha, 0, 1e-5);
    square += pow(tan(along.tilt_out), 2) / N;
    lower += (0.2 - atan2(along.v2[2], hypot(along.v2[0], along.v2[1]))) / N;
  }
  double slope = asp_surface_slope_rms(s.surface);
  assert_near(sqrt(square), slope, slope * 5 / sqrt(2. * N));
  assert_true(lower > 0);
  setup_free(&s);
  setup_free(&plane);
}

/* At normal incidence both slopes are what the surface has, whatever the direction of the lay. */
TEST(normal_incidence_shows_all_slopes) {
  enum { N = 50000 };
  setup s = setup_create(40, 120, "isotropic");
  double psi = 0.5, xx = 0, xy = 0, yy = 0, d_p = 100, slope[2];
  for (uint64_t tag = 0; tag < N; tag++) {
    asp_impact impact = meet(&s, d_p, ASP_PI / 2, psi, tag);
    if (impact.hits > 1)
      continue;
    /* a specular face turns -n into v2: its normal is along v2 + n */
    double p = -impact.v2[0] / (1 + impact.v2[2]), q = -impact.v2[1] / (1 + impact.v2[2]);
    xx += p * p / N, xy += p * q / N, yy += q * q / N;
  }
  aspi_surface_sphere_slopes(s.surface, d_p, slope);
  double c = cos(psi), t = sin(psi), one = slope[0] * slope[0], two = slope[1] * slope[1];
  assert_near(xx, c * c * one + t * t * two, 0.02 * one);
  assert_near(yy, t * t * one + c * c * two, 0.02 * one);
  assert_near(xy, (one - two) * c * t, 0.02 * one);
  setup_free(&s);
}

/* A sphere that grazes rests on summits: formula (4) for the slope across the flight. */
TEST(grazing_spheres_meet_less_slope) {
  enum { N = 25000 };
  setup s = setup_create(40, 40, "isotropic");
  double d_p = 185, alpha1 = 0.02, slope[2], square = 0;
  aspi_surface_sphere_slopes(s.surface, d_p, slope);
  for (uint64_t tag = 0; tag < N; tag++)
    square += pow(tan(meet(&s, d_p, alpha1, 0, tag).tilt_out), 2) / N;
  double kappa = asp_surface_kappa(s.surface, d_p), a = tan(alpha1) / slope[0];
  double left = 1 - 0.19 * tanh(2 * kappa) * exp(-2.3 * a);
  assert_true(left < 0.88);
  assert_near(sqrt(square) / slope[0], left, 5 / sqrt(2. * N));
  setup_free(&s);
}

/* The mean lateral angle that an independent reference found at psi = 45 degrees. */
TEST(lays_steer) {
  enum { N = 40000 };
  static const double known[][2] = {{2, -3.17}, {5, -3.30}, {10, -3.29}, {30, -2.81}};
  setup s = setup_create(40, 200, "isotropic");
  for (int i = 0; i < 4; i++) {
    aspi_angles a = many(&s, 10, known[i][0] * DEGREE, ASP_PI / 4, N);
    print_message("alpha1 %g: lateral %.3f (%.2f)\n", known[i][0], a.lateral_sum / N, known[i][1]);
    assert_near(a.lateral_sum / N, known[i][1], 0.15);
  }
  setup_free(&s);
}

/* psi, d_p, alpha1 (degrees): the rebound angle and the lateral one, against surfaces. */
TEST(walls_with_a_lay_are_surfaces) {
  static const double cases[][3] = {{45, 10, 5}};
  enum { N = 70000 };
  setup s = setup_create(40, 200, "isotropic");
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    double psi = cases[i][0] * DEGREE, d_p = cases[i][1], alpha1 = cases[i][2] * DEGREE;
    surfaces subject = {.wall = {5, 40, 200, psi},
                        .d_p = d_p,
                        .groups = 2,
                        .rays = 7000,
                        .seed = 300,
                        .points = 1024};
    aspi_judge all;
    assert_int_equal(judge_in_space(&all, &subject, &cases[i][2], 1, NULL), ASP_OK);
    aspi_angles model = many(&s, d_p, alpha1, psi, N);
    aspi_mean_error rebound =
        aspi_judge_divergence(&all, 0, &model, 1, offsetof(aspi_angles, rebound));
    aspi_mean_error lateral =
        aspi_judge_divergence(&all, 0, &model, 1, offsetof(aspi_angles, lateral));
    print_message("psi %g, d_p %g, alpha1 %g: D_KL %.4f +- %.4f, lateral %.4f +- %.4f\n",
                  cases[i][0], d_p, cases[i][2], rebound.value, rebound.se, lateral.value,
                  lateral.se);
    assert_true(rebound.value < 0.006 + 3 * rebound.se);
    assert_true(lateral.value < 0.006 + 3 * lateral.se);
    aspi_judge_free(&all);
  }
  setup_free(&s);
}

/* The wall of a map; NULL and a message where there is none. */
static asp_wall *wall_of_map(const asp_heights *map, const char *words, asp_error *error) {
  char text[200];
  snprintf(text, sizeof text, "surface map wall %s rebound constant 1 1 deposit off", words);
  asp_description *description = asp_description_parse(text, NULL, error);
  assert_non_null(description);
  assert_int_equal(asp_description_set_heights(description, map, error), ASP_OK);
  asp_wall *wall = asp_wall_create(description, 1, 1, error);
  asp_description_free(description);
  return wall;
}

/* Elastic ridges push across their lay, whichever way they are met. */
TEST(ridges_push_across_their_lay) {
  const double step[2] = {0.2, 0.2}, lay[3] = {0.8, 0.6, 0};
  asp_error error;
  asp_heights *map = gauss_map_create(&(gauss_wall){0.2, 1, 12, 0.5}, step, 256, 256, 1, &error);
  assert_non_null(map);
  asp_wall *wall = wall_of_map(map, "lay 0.8 0.6 0 dp_bins 1", &error);
  if (!wall)
    fail_msg("%s", error.text);
  const asp_particle grain = {.d_p = 1, .density = 1, .lay = lay};
  double along = 0, across = 0;
  for (uint64_t tag = 1; tag <= 2000; tag++) {
    const double turn = 0.1 * (double)tag, v1[3] = {0.9 * cos(turn), 0.9 * sin(turn), -0.4};
    asp_impact impact;
    asp_wall_impact(wall, &grain, v1, up, &(asp_key){1, 1, tag, 1, 0}, &impact);
    const double x = impact.v2[0] - v1[0], y = impact.v2[1] - v1[1];
    along += fabs(lay[0] * x + lay[1] * y);
    across += fabs(lay[0] * y - lay[1] * x);
  }
  print_message("impulses along the lay over those across: %.3f\n", along / across);
  assert_true(along < 0.2 * across);
  asp_wall_free(wall);
  asp_heights_free(map);
}

/* A lay in words is a vector of length 1, along any axis. */
TEST(lays_have_unit_length) {
  static const double lays[][3] = {{0, 3, 4}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  for (size_t i = 0; i < sizeof lays / sizeof *lays; i++) {
    char text[100];
    snprintf(text, sizeof text,
             "surface rq 5um lambda_c 40um 80um lay %g %g %g rebound constant 1 1", lays[i][0],
             lays[i][1], lays[i][2]);
    asp_description *words = asp_description_parse(text, NULL, NULL);
    assert_non_null(words);
    const asp_lay lay = asp_description_lay(words);
    for (int d = 0; d < 3; d++)
      assert_near(lay.vector[d], lays[i][d] / (i ? 2 : 5), 1e-15);
    asp_description_free(words);
  }
}

/* A map that is half as long again along its lay as across must say so. */
TEST(maps_with_a_lay_need_its_direction) {
  const double step[2] = {0.1, 0.1};
  for (double along = 1; along < 2.5; along++) {
    asp_error error;
    asp_heights *map =
        gauss_map_create(&(gauss_wall){0.05, 1, along, 0}, step, 256, 256, 1, &error);
    assert_non_null(map);
    asp_wall *wall = wall_of_map(map, "dp_bins 1", &error);
    assert_int_equal(wall != NULL, along < 1.5);
    assert_true(wall || strstr(error.text, "the wall has a lay"));
    asp_wall_free(wall);
    asp_heights_free(map);
  }
}

/* A flight across the lay has the kappa of that direction along itself, and the smaller one across
 * itself; one along the lay the other way round. */
TEST(headings_have_their_own_size) {
  setup made = setup_create(40, 80, "isotropic");
  const aspi_roughness rough = {
      .wall = made.wall, .slope = {0.2, 0.1}, .kappa = 3, .shrink = 0.25, .across = {1, 0, 0}};
  for (int i = 0; i < 2; i++) {
    const aspi_slopes_along s = aspi_roughness_along(&rough, (aspi_heading){1 - i, i});
    assert_near(s.kappa, i ? 0.75 : 3, 1e-15);
    assert_near(s.kappa_across, i ? 3 : 0.75, 1e-15);
  }
  setup_free(&made);
}
