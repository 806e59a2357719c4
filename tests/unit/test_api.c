/* Every public function on every kind of object that the public functions make, with arguments that
 * are out of their ranges: a result or an error, never a crash. tests/rooms checks that none is
 * missing here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "wall/wall.h"

#include <float.h>
#include <stdlib.h>

static const double odd[] = {0, -1, 1, 1e-6, NAN, INFINITY, DBL_MAX};
enum { ODD = sizeof odd / sizeof *odd };
static const char *const names[] = {NULL,      "",         "nonsense", "friction", "modulus",
                                    "s_q",     "lambda_c", "meter",    "file",     "bons",
                                    "visible", "seed",     "density",  "surface"};
enum { NAMES = sizeof names / sizeof *names };

/* A call that fails has a code and a message. */
static void failed(bool is, const asp_error *error) {
  if (!is)
    return;
  assert_true(error->code < ASP_OK && *error->text);
}

TEST(lists_end) {
  asp_error error;
  for (int i = -2; i < 100; i++) {
    assert_int_equal(asp_spread_at(i) != NULL, i >= 0 && i < asp_spread_count());
    assert_int_equal(asp_rebound_at(i) != NULL, i >= 0 && i < asp_rebound_count());
    assert_int_equal(asp_material_at(i) != NULL, i >= 0 && i < asp_material_count());
  }
  for (int i = 0; i < NAMES; i++) {
    failed(!asp_spread_find(names[i], &error), &error);
    failed(!asp_rebound_find(names[i], &error), &error);
    asp_key_wall(names[i]);
  }
  for (int i = 0; i < asp_spread_count(); i++) {
    const asp_spread_model *model = asp_spread_at(i);
    assert_true(*asp_spread_name(model));
  }
  for (int i = 0; i < asp_rebound_count(); i++) {
    assert_non_null(asp_rebound_name(asp_rebound_at(i)));
    asp_rebound_needs_pair(asp_rebound_at(i));
  }
  assert_true(*asp_version());
}

static void walk_pair(asp_pair *pair) {
  asp_error error;
  for (int i = 0; i < NAMES; i++)
    for (int k = 0; k < ODD; k++) {
      failed(asp_pair_set(pair, names[i], odd[k], &error), &error);
      asp_pair_get(pair, names[i]);
    }
  asp_pair_free(pair);
}

TEST(materials_and_pairs) {
  asp_error error;
  const asp_material *quartz = asp_material_at(0);
  asp_material *own = asp_material_create(NULL, &error), *bare = asp_material_create("x", &error);
  assert_non_null(asp_material_name(own));
  for (int i = 0; i < NAMES; i++)
    for (int k = 0; k < ODD; k++) {
      failed(asp_material_set(own, names[i], odd[k], &error), &error);
      asp_material_get(own, names[i]);
      asp_material_get(quartz, names[i]);
    }
  const asp_material *const all[] = {NULL, quartz, own, bare};
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < 4; k++) {
      asp_pair *pair = asp_pair_create(all[i], all[k], &error);
      failed(!pair, &error);
      if (pair)
        walk_pair(pair);
    }
  asp_material_free(own);
  asp_material_free(bare);
  asp_material_free(NULL);
  asp_pair_free(NULL);
}

TEST(profiles_and_maps) {
  asp_error error;
  static const double bad[4] = {0, NAN, 1, 2}, flat[4] = {1, 1, 1, 1};
  static const double level[16] = {0};
  failed(!asp_heights_create(NULL, 10, 1, 1, 1, true, &error), &error);
  failed(!asp_heights_create(bad, 4, 1, 1, 1, true, &error), &error);
  for (int i = 0; i < ODD; i++) {
    asp_heights_free(asp_heights_create(flat, 4, 1, odd[i], odd[i], false, &error));
    asp_heights_free(asp_heights_create(level, 4, 4, odd[i], odd[ODD - 1 - i], true, &error));
  }
  failed(!asp_heights_create(NULL, 4, 4, 1, 1, true, &error), &error);
  failed(!asp_heights_create(level, 1, 0, 1, 1, true, &error), &error);
  asp_heights *profile = asp_heights_create(flat, 4, 1, 1, 1, false, &error);
  asp_heights_free(profile);
  asp_heights *map = asp_heights_create(level, 4, 4, 1, 1, true, &error);
  asp_heights_numbers numbers;
  failed(asp_heights_describe(map, &numbers, &error), &error);
  asp_heights_free(map);
  asp_heights_free(NULL);
}

TEST(readers) {
  asp_error error, doubt;
  char text[10];
  for (int i = 0; i < NAMES; i++)
    for (int is_map = 0; is_map < 2; is_map++)
      failed(!asp_heights_read(names[i], is_map, 1, text, sizeof text, &doubt, &error), &error);
}

static void walk_surface(const asp_surface *surface) {
  asp_error error;
  if (!surface)
    return;
  asp_surface_r_q(surface);
  asp_surface_lambda_c(surface);
  asp_surface_lambda_along(surface);
  asp_surface_phi_r(surface);
  asp_surface_slope_rms(surface);
  for (int k = 0; k < ODD; k++) {
    asp_surface_kappa(surface, odd[k]);
    asp_surface_slope(surface, odd[k]);
    failed(asp_surface_check(surface, odd[k], &error), &error);
  }
}

/* Impacts of any numbers: a pair is all that may be missing. */
static void walk_wall(const asp_wall *wall) {
  asp_error error;
  asp_impact impact;
  asp_coefficients coefficients;
  const asp_key key = {1, 1, 1, 1, 0};
  const double lay[3] = {1, 0, 0};
  bool lacks = wall->law->needs_pair && !asp_wall_pair(wall);
  assert_true(asp_wall_seed(wall) >= 1);
  assert_non_null(asp_spread_name(asp_wall_spread(wall)));
  walk_surface(asp_wall_surface(wall));
  for (int k = 0; k < ODD; k++)
    assert_true(asp_wall_surface(wall) ? !(asp_wall_slope(wall, odd[k]) < 0)
                                       : asp_wall_slope(wall, odd[k]) == 0);
  for (int i = 0; i < ODD * ODD * ODD; i++) {
    double a = odd[i % ODD], b = odd[i / ODD % ODD], d_p = odd[i / ODD / ODD];
    const asp_particle particle = {.d_p = d_p, .density = a, .lay = i % 2 ? lay : NULL};
    const double v1[3] = {a, 1, b}, n[3] = {0, i % 3 ? 0 : b, i % 5 ? 1 : a};
    asp_code code = asp_wall_impact(wall, &particle, v1, n, &key, &impact);
    assert_int_equal(code, lacks ? ASP_EARG : ASP_OK);
    asp_impact_coefficients(v1, n, &impact);
    code = asp_wall_impacts(wall, 1, &particle, v1, n, &key, &impact, &error);
    failed(code, &error);
    assert_int_equal(asp_wall_impacts(wall, 0, NULL, NULL, NULL, NULL, NULL, &error), ASP_OK);
    asp_impacts_coefficients(1, v1, n, &impact, &coefficients);
  }
}

/* A description as it is, then with its numbers set, then with heights of the caller's. */
static void walk_description(asp_description *d, const asp_heights *profile,
                             const asp_heights *map) {
  asp_error error;
  char text[40];
  for (int step = 0; step < 3; step++) {
    for (int i = 0; i < NAMES; i++) {
      asp_description_word(d, names[i]);
      asp_description_get(d, names[i]);
      for (int k = 0; k < ODD && step == 1; k++)
        failed(asp_description_set(d, names[i], odd[k], &error), &error);
    }
    assert_true(asp_description_text(d, NULL, 0) == asp_description_text(d, text, sizeof text));
    asp_description_lay(d);
    asp_description_needs_sizes(d);
    for (int i = -1; i < 3; i++) {
      const asp_material *m = asp_description_material(d, i);
      assert_int_equal(m != NULL, i >= 0 && i < asp_description_materials(d));
      asp_pair *pair = asp_description_pair(d, m, asp_material_at(0), &error);
      failed(!pair, &error);
      asp_pair_free(pair);
    }
    for (int i = 0; i < ODD; i++) {
      asp_wall *wall = asp_wall_create(d, odd[i], i % 2 ? 20e-6 : odd[i], &error);
      failed(!wall, &error);
      if (wall && (i == 0 || i == 3))
        walk_wall(wall);
      asp_wall_free(wall);
    }
    if (step == 1) {
      failed(asp_description_set_heights(d, profile, &error), &error);
      failed(asp_description_set_heights(d, map, &error), &error);
    }
  }
}

TEST(descriptions_and_walls) {
  static const char *const texts[] = {
      "",
      "rebound constant 0.9 0.9",
      "surface rq 5um lambda_c 40um materials quartz steel rebound walton 0.9 0.3 0",
      "surface rq 5um lambda_c 40um 80um lay axial rebound constant 0.9 0.9 seed 3",
      "surface sigma 8 spread weibull plane collisions single erosion dnv density 7800 rebound "
      "constant 0.9 0.9",
      "surface profile no.csv dp_bins 2 rebound constant 0.9 0.9",
      "surface profile no.csv dp_bins 2 spread traced rebound constant 0.9 0.9",
      "surface map no.sdf dp_bins 1 rebound constant 0.9 0.9",
      "deposit freeze remove gas_density 1.2 gas_viscosity 1.5e-5 u_tau 2",
      "friction 0.4 surface_energy 0.1 materials quartz"};
  const asp_units unknown = {.name = NULL};
  asp_error error;
  enum { SIDE = 32 };
  static double heights[SIDE * SIDE];
  for (int i = 0; i < SIDE * SIDE; i++)
    heights[i] = 1e-6 * sin(0.5 * (i % SIDE)) * cos(0.4 * i / SIDE);
  asp_heights *map = asp_heights_create(heights, SIDE, SIDE, 1e-6, 1e-6, false, &error);
  asp_heights *profile = asp_heights_create(heights, SIDE * SIDE, 1, 1e-6, 1e-6, false, &error);
  assert_true(map && profile);
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
    for (int k = 0; k < 2; k++) {
      asp_description *d = asp_description_parse(texts[i], k ? &unknown : NULL, &error);
      failed(!d, &error);
      if (d)
        walk_description(d, profile, map);
      asp_description_free(d);
    }
  failed(!asp_description_parse(NULL, NULL, &error), &error);
  failed(!asp_description_parse("surface 'rq", NULL, &error), &error);
  assert_string_equal(asp_code_name(ASP_ERANGE), "ASP_ERANGE");
  assert_string_equal(asp_code_name((asp_code)1), "unknown");
  failed(!asp_wall_create(NULL, 0, 0, &error), &error);
  failed(!asp_wall_from_text(NULL, 0, 0, &error), &error);
  asp_wall_free(NULL);
  asp_description_free(NULL);
  asp_heights_free(profile);
  asp_heights_free(map);
}

/* A description that a word was wrong in fails for good. */
TEST(a_broken_description_stays_so) {
  asp_error error;
  int taken;
  const char *words[] = {"seed", "x"};
  asp_description *d = asp_description_parse("", NULL, NULL);
  assert_int_equal(asp_description_read(d, 2, words, NULL, &taken, &error), ASP_EARG);
  words[1] = "3";
  assert_int_equal(asp_description_read(d, 2, words, NULL, &taken, &error), ASP_EARG);
  assert_says(error.text, "seed is 'x'");
  assert_int_equal(asp_description_check(d, &error), ASP_EARG);
  assert_null(asp_wall_create(d, 0, 0, &error));
  assert_says(error.text, "seed is 'x'");
  asp_description_free(d);
}
