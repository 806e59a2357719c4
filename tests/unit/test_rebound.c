/* The rebound laws against closed forms, an integrated spring, and the numbers of PHYSICS worked
 * out by hand; materials and pairs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "rebound/laws.h"

static asp_pair pair_of(const char *particle, const char *wall, double gamma, double mu) {
  asp_pair *made = asp_pair_create(aspi_materials_find(NULL, particle, NULL),
                                   aspi_materials_find(NULL, wall, NULL), NULL);
  assert_non_null(made);
  assert_int_equal(asp_pair_set(made, "surface_energy", gamma, NULL), ASP_OK);
  assert_int_equal(asp_pair_set(made, "friction", mu, NULL), ASP_OK);
  asp_pair pair = *made;
  asp_pair_free(made);
  return pair;
}

static aspi_bounce bons(const asp_pair *pair, double v_n1, double v_t1, double d_p, double rate) {
  const asp_rebound_law *law = asp_rebound_find("bons", NULL);
  double parameters[ASP_PARAMETERS_MAX];
  for (int i = 0; i < law->n_parameters; i++)
    parameters[i] = law->parameters[i].default_value;
  parameters[aspi_rebound_parameter_find(law, "yield_rate")] = rate;
  aspi_hit hit = {
      .v_n1 = v_n1, .v_t1 = v_t1, .d_p = d_p, .density = 2650, .pair = pair, .adhesion = true};
  return law->rebound(parameters, &hit);
}

static double yield_speed(const asp_pair *pair) {
  return pair->yield_stress / sqrt(2650 * pair->modulus);
}

TEST(composite_modulus_and_yield_speed) {
  asp_pair ti = pair_of("quartz", "ti-6al-4v", 0, 0), ni = pair_of("ard", "hastelloy-x", 0, 0);
  assert_near(ti.modulus, 46.2e9, 0.05e9);
  assert_near(ni.modulus, 54.8e9, 0.05e9);
  assert_near(yield_speed(&ti), 18.1, 0.05);
  assert_near(yield_speed(&ni), 16.6, 0.05);
}

/* Without adhesion: elastic up to the yield speed, and no faster than it above. */
TEST(elastic_then_plastic) {
  asp_pair pair = pair_of("quartz", "hastelloy-x", 0, 0);
  double v_y = yield_speed(&pair);
  for (double v = 1e-6; v < 1e4; v *= 1.7)
    assert_near(bons(&pair, v, 0, 1e-5, 0).v_n2, fmin(v, v_y), 1e-14 * v_y);
}

/* The same from the mechanics: a cylinder (A = pi d^2/4, l = 2d/3) on a spring k = E_c A/l,
 * yielding at the compression w_crit = sigma_y l/E_c at constant force; unloading along the spring.
 * Integrated by small steps, compared with min(v, v_y). */
static double integrated_spring(const asp_pair *pair, double v, double d_p) {
  double area = M_PI * d_p * d_p / 4, length = 2 * d_p / 3, mass = 2650 * area * length;
  double k = pair->modulus * area / length, w_crit = pair->yield_stress * length / pair->modulus;
  double w = 0, plastic = 0, dt = 1e-4 * sqrt(mass / k);
  do {
    double stretch = w - plastic;
    if (stretch > w_crit) {
      plastic = w - w_crit;
      stretch = w_crit;
    }
    v -= k * stretch / mass * dt;
    w += v * dt;
  } while (w > plastic);
  return -v;
}

TEST(agrees_with_an_integrated_spring) {
  asp_pair pair = pair_of("quartz", "ti-6al-4v", 0, 0);
  static const double speeds[] = {1, 10, 18, 25, 60};
  for (size_t i = 0; i < sizeof speeds / sizeof *speeds; i++)
    assert_near(bons(&pair, speeds[i], 0, 2e-5, 0).v_n2, integrated_spring(&pair, speeds[i], 2e-5),
                2e-3 * speeds[i]);
}

/* Where the particle just sticks: the elastic capture speed of 10 um on Hastelloy X is 5.8 m/s. */
TEST(capture_speed) {
  asp_pair pair = pair_of("quartz", "hastelloy-x", 0.8, 0);
  double lo = 0.1, hi = 16;
  for (int i = 0; i < 60; i++) {
    double mid = (lo + hi) / 2;
    if (bons(&pair, mid, 0, 1e-5, 0).v_n2 > 0)
      hi = mid;
    else
      lo = mid;
  }
  double v = hi, share = 0.1 + sqrt(v / yield_speed(&pair)) / 7;
  assert_near(v, 5.8, 0.05);
  assert_near(v * v, 6 * 0.8 * share / (2650 * 1e-5), 1e-9 * v * v);
}

/* With a constant yield stress, everything under d* = 6 gamma (a + b)/(rho v_y^2) sticks at any
 * speed. */
TEST(smallest_that_rebounds) {
  static const struct {
    const char *wall;
    double d_star;
  } table[] = {{"hastelloy-x", 1.60e-6}, {"ti-6al-4v", 1.35e-6}, {"al-2024", 1.12e-6}};
  for (size_t i = 0; i < 3; i++) {
    asp_pair pair = pair_of("quartz", table[i].wall, 0.8, 0.3);
    double v_y = yield_speed(&pair), d_star = 6 * 0.8 * (0.1 + 1 / 7.) / (2650 * v_y * v_y);
    assert_near(d_star, table[i].d_star, 0.006e-6);
    for (double v = 1; v < 1e4; v *= 3)
      assert_true(!(bons(&pair, v, 0, 0.999 * d_star, 0).v_n2 > 0));
    assert_true(bons(&pair, 1000, 0, 1.001 * d_star, 0).v_n2 > 0);
  }
}

/* CoR_T = 1 - (mu/2)(1 + CoR_N) sin 2 alpha', the law's other form. */
TEST(tangential_form) {
  asp_pair pair = pair_of("quartz", "hastelloy-x", 0, 0.3);
  for (double alpha = 0.01; alpha < M_PI_2; alpha += 0.03) {
    aspi_bounce b = bons(&pair, 100 * sin(alpha), 100 * cos(alpha), 1e-5, 0);
    double cor_n = b.v_n2 / (100 * sin(alpha));
    assert_near(b.v_t2 / (100 * cos(alpha)), 1 - 0.15 * (1 + cor_n) * sin(2 * alpha), 1e-13);
  }
  pair.friction = 10;
  assert_near(bons(&pair, 100, 100, 1e-5, 0).v_t2, 0, 0);
}

TEST(rate_dependent_yield) {
  asp_pair pair = pair_of("quartz", "hastelloy-x", 0, 0.3);
  for (double v = 1; v < 1000; v *= 10) {
    assert_near(bons(&pair, v, 0, 1e-5, 3.0e6).v_n2 / v, 0.25, 0.005);
    assert_near(bons(&pair, v, 0, 1e-5, 3.6e6).v_n2 / v, 0.30, 0.005);
  }
}

/* Where nothing is elastic (v_y = 0), the ratio v_n1/v_y is taken as 1 and nothing returns. */
TEST(no_yield_stress) {
  asp_pair pair = pair_of("quartz", "hastelloy-x", 0.8, 0.3);
  pair.yield_stress = 0;
  aspi_bounce b = bons(&pair, 10, 10, 1e-5, 0);
  assert_near(b.v_n2, 0, 0);
  assert_true(b.v_t2 > 0 && b.v_t2 < 10);
}

/* 200 MPa up to 1000 K, 0.225 MPa/K less above, never below 0; whichever form the yield has. */
TEST(hot_particles_yield_earlier) {
  static const double table[][2] = {{0, 200e6},    {1000, 200e6}, {1400, 110e6},
                                    {1888, 0.2e6}, {1889, 0},     {3000, 0}};
  const asp_rebound_law *law = asp_rebound_find("bons", NULL);
  asp_pair pair = pair_of("quartz", "hastelloy-x", 0, 0);
  double parameters[ASP_PARAMETERS_MAX];
  for (int i = 0; i < law->n_parameters; i++)
    parameters[i] = law->parameters[i].default_value;
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    aspi_hit hit = {.v_n1 = 100, .d_p = 1e-5, .density = 2650, .pair = &pair};
    hit.temperature = table[i][0];
    double v_y = table[i][1] / sqrt(2650 * pair.modulus);
    assert_near(law->rebound(parameters, &hit).v_n2, v_y, 1e-12);
  }
  parameters[aspi_rebound_parameter_find(law, "yield_rate")] = 3e6;
  aspi_hit hit = {.v_n1 = 100, .d_p = 1e-5, .density = 2650, .pair = &pair, .temperature = 1400};
  assert_near(law->rebound(parameters, &hit).v_n2, 0.55 * 3e8 / sqrt(2650 * pair.modulus), 1e-12);
}

/* An exponent other than 0.5 takes the same law by another road. */
TEST(contact_area_exponent) {
  asp_pair pair = pair_of("quartz", "hastelloy-x", 0.8, 0);
  const asp_rebound_law *law = asp_rebound_find("bons", NULL);
  double v_y = yield_speed(&pair);
  for (double c = 0; c < 3; c += 0.25) {
    double parameters[ASP_PARAMETERS_MAX] = {0, 0.1, 0.2, c};
    aspi_hit hit = {.v_n1 = 10, .d_p = 1e-5, .density = 2650, .pair = &pair, .adhesion = true};
    double taken = 6 * 0.8 * (0.1 + 0.2 * pow(10 / v_y, c)) / (2650 * 1e-5);
    assert_near(law->rebound(parameters, &hit).v_n2, sqrt(100 - taken), 1e-12);
  }
}

TEST(materials_of_ones_own) {
  static const struct {
    const char *name;
    double value;
    const char *range;
  } bad[] = {
      {"youngs_modulus", -1, "> 0"},          {"youngs_modulus", 0, "> 0"},
      {"youngs_modulus", NAN, "> 0"},         {"poissons_ratio", 0.5, "less than 0.5"},
      {"poissons_ratio", -1, "more than -1"}, {"yield_stress", -1, ">= 0"},
      {"yield_stress", INFINITY, ">= 0"},     {"density", 0, "> 0"},
  };
  asp_error error;
  char name[] = "brass";
  asp_material *m = asp_material_create(name, NULL);
  assert_non_null(m);
  *name = 'g'; /* the name is copied */
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    assert_int_equal(asp_material_set(m, bad[i].name, bad[i].value, &error), ASP_EARG);
    assert_says(error.text, bad[i].name);
    assert_says(error.text, "brass");
    assert_says(error.text, bad[i].range);
    assert_near(asp_material_get(m, bad[i].name), 0, 0);
  }
  assert_int_equal(asp_material_set(m, "color", 1, &error), ASP_ENAME);
  assert_says(error.text, "yield_stress");
  assert_true(isnan(asp_material_get(m, "color")));
  assert_int_equal(asp_material_set(m, "density", 8500, NULL), ASP_OK);
  assert_near(asp_material_get(m, "density"), 8500, 0);
  assert_string_equal(asp_material_name(m), "brass");
  assert_string_equal(m->title, "");
  asp_material_free(m);
}

TEST(pairs_are_checked) {
  asp_error error;
  const asp_material *quartz = aspi_materials_find(NULL, "quartz", NULL);
  asp_material *m = asp_material_create("unset", NULL);
  assert_null(asp_pair_create(m, quartz, &error));
  assert_says(error.text, "Young's modulus of the particle is 0; it must be");
  assert_null(asp_pair_create(quartz, m, &error));
  assert_says(error.text, "Young's modulus of the wall");
  asp_material_set(m, "youngs_modulus", 1e-308, NULL);
  asp_pair *pair = asp_pair_create(m, quartz, &error);
  assert_non_null(pair);
  assert_near(asp_pair_get(pair, "friction"), ASP_FRICTION, 0);
  assert_near(asp_pair_get(pair, "surface_energy"), ASP_SURFACE_ENERGY, 0);
  static const char *const names[] = {"yield_stress", "surface_energy", "friction"};
  static const double bad[] = {-1, NAN, INFINITY};
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      assert_int_equal(asp_pair_set(pair, names[i], bad[k], &error), ASP_EARG);
      assert_says(error.text, names[i]);
    }
    assert_int_equal(asp_pair_set(pair, names[i], 0.25, NULL), ASP_OK);
    assert_near(asp_pair_get(pair, names[i]), 0.25, 0);
  }
  assert_int_equal(asp_pair_set(pair, "modulus", 1, &error), ASP_ENAME);
  assert_true(asp_pair_get(pair, "modulus") > 0 && isnan(asp_pair_get(pair, "gloss")));
  asp_pair_free(pair);
  asp_material_free(m);
}

/* What front ends know of a law: the getters give the record's own, and a keyword of several
 * parameters stands at each of them, in a row. */
TEST(laws_describe_themselves) {
  for (int i = 0; i < asp_rebound_count(); i++) {
    const asp_rebound_law *law = asp_rebound_at(i);
    assert_string_equal(asp_rebound_name(law), law->name);
    assert_true(asp_rebound_needs_pair(law) == law->needs_pair);
    assert_true(*law->summary && *law->source);
    for (int k = 0; k < law->n_parameters; k++) {
      const aspi_keyword *p = &law->parameters[k];
      assert_int_equal(aspi_rebound_parameter_find(law, p->name), k);
      assert_true(*p->text && p->unit);
      assert_true(p->least <= p->default_value);
      assert_true(p->default_value <= p->most);
    }
  }
  const asp_rebound_law *bons = asp_rebound_find("bons", NULL);
  const char *keywords[] = {"yield_rate", "contact_area", "contact_area", "contact_area",
                            "soften",     "soften",       "spin"};
  assert_int_equal(bons->n_parameters, 7);
  for (int k = 0; k < 7; k++)
    assert_string_equal(aspi_keyword_word(&bons->parameters[k]), keywords[k]);
  const aspi_keyword *spin = &bons->parameters[6];
  assert_string_equal(spin->values, "off | on");
  const asp_rebound_law *constant = asp_rebound_find("constant", NULL);
  assert_string_equal(aspi_keyword_word(&constant->parameters[0]), "");
}

TEST(names_are_listed) {
  asp_error error;
  assert_null(asp_rebound_find("bonds", &error));
  for (int i = 0; i < asp_rebound_count(); i++) {
    assert_says(error.text, asp_rebound_at(i)->name);
    assert_ptr_equal(asp_rebound_find(asp_rebound_at(i)->name, NULL), asp_rebound_at(i));
  }
  assert_null(aspi_materials_find(NULL, "unobtainium", &error));
  assert_says(error.text, "unobtainium");
  assert_says(error.text, "hastelloy-x");
  assert_true(aspi_rebound_parameter_find(asp_rebound_find("constant", NULL), "cor_x") < 0);
}
