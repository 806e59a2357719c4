/* One contact: exact cases, invariance, and properties over random walls and impacts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "choice.h"
#include "surface/heights.h"

#include <gsl/gsl_rng.h>

typedef struct setup {
  asp_surface *surface;
  asp_heights *profile; /* short: models that look at one build it anew for every wall */
  aspi_wall_choice choice;
  asp_wall *wall;
} setup;

/* Makes the wall of the choice as it is now. */
static void remake(setup *s) {
  asp_wall_free(s->wall);
  s->wall = wall_of(&s->choice);
}

static setup setup_create(const char *spread, const char *law, double slope) {
  setup s = {.choice = choice_of(law)};
  s.choice.spread = asp_spread_find(spread, NULL);
  s.choice.sizes = (aspi_sizes){1e-3, 0.1, 3};
  if (slope > 0) {
    s.choice.surface = s.surface = asp_surface_create(slope / sqrt(2), 1, NULL);
    s.choice.heights = s.profile =
        aspi_profile_generate(slope / sqrt(2), 1, 1 / 16., 2048, 1, NULL);
  }
  s.wall = wall_of(&s.choice);
  return s;
}

static void setup_free(setup *s) {
  asp_wall_free(s->wall);
  asp_surface_free(s->surface);
  asp_heights_free(s->profile);
}

static double dot(const double *a, const double *b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static const asp_pair quartz_on_nickel = {54.8e9, 200e6, 0.8, 0.3, 0, 0, 0};
static const asp_particle grain = {.d_p = 1e-5, .density = 2650, .pair = &quartz_on_nickel};
static const double up[3] = {0, 0, 1};

TEST(smooth_wall_is_the_law) {
  setup s = setup_create("none", "bons", 0);
  const asp_rebound_law *law = asp_rebound_find("bons", NULL);
  for (double alpha = 0.1; alpha < 1.57; alpha += 0.1) {
    double v1[3] = {100 * cos(alpha), 0, -100 * sin(alpha)};
    aspi_hit hit = {.v_n1 = 100 * sin(alpha),
                    .v_t1 = 100 * cos(alpha),
                    .d_p = grain.d_p,
                    .density = grain.density,
                    .pair = grain.pair,
                    .adhesion = true};
    aspi_bounce b = law->rebound(s.wall->parameters, &hit);
    asp_impact impact;
    asp_wall_impact(s.wall, &grain, v1, up, &(asp_key){1, 1, 1, 1, 0}, &impact);
    assert_near(impact.v2[0], b.v_t2, 1e-12);
    assert_near(impact.v2[1], 0, 1e-15);
    assert_near(impact.v2[2], b.v_n2, 1e-12);
    assert_int_equal(impact.hits, 1);
  }
  setup_free(&s);
}

static double bounces_with(const asp_wall *wall, uint32_t name, uint64_t tag, uint32_t number) {
  asp_impact impact;
  asp_wall_impact(wall, &grain, (double[]){0, 0, -100}, up, &(asp_key){7, name, tag, number, 0},
                  &impact);
  return impact.v2[2];
}

/* A grain keeps its yield stress on all walls and at all impacts. Without adhesion `bons` returns
 * Y/sqrt(rho E) from a plastic impact, with a rate 100 A/sqrt(rho E), so that speeds are log-normal
 * with the sd of the logarithm that is given; `thornton_ning` by Y^(5/8) well above yield (their
 * eq. 80: e by (v_y/v)^(1/4), v_y by Y^(5/2)). */
TEST(a_grain_keeps_its_yield_stress) {
  enum { N = 4000 };
#define DUST "materials quartz hastelloy-x "
  static const struct {
    const char *words;
    double power, median; /* 0: not known in closed form */
  } laws[] = {{DUST "yield_stress 200MPa scatter 0.3 deposit off", 1, 200e6},
              {DUST "rebound bons yield_rate 200000 scatter 0.3 deposit off", 1, 20e6},
              {DUST "rebound thornton_ning yield_stress 200MPa scatter 0.3 deposit off", 0.625, 0}};
  for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
    asp_wall *wall = asp_wall_from_text(laws[i].words, 0, 0, NULL);
    double sum = 0, squares = 0;
    for (uint64_t tag = 1; tag <= N; tag++) {
      double v = bounces_with(wall, 1, tag, 1), ln = log(v);
      assert_near(v, bounces_with(wall, 2, tag, 9), 0);
      sum += ln / N;
      squares += ln * ln / N;
    }
    double sd = laws[i].power * 0.3, error = sd / sqrt(N);
    assert_near(sqrt(squares - sum * sum), sd, 4 * error / sqrt(2) + 0.01 * (laws[i].power < 1));
    if (laws[i].median > 0)
      assert_near(sum, log(laws[i].median / sqrt(54.8e9 * 2650)), 4 * error);
    asp_wall_free(wall);
  }
}

/* Arrivals and removal have one adhesion: a grain sticks below v_a = (6 f' gamma (a + b)/(rho
 * d))^(1/2), and is held by 3 pi gamma r f', so one that sticks at a higher speed is let go at a
 * lower rate. */
TEST(a_grain_keeps_its_adhesion) {
  static const char words[] = "materials quartz hastelloy-x adhesion 0.1 adhesion_spread 3 deposit "
                              "freeze remove u_tau 0.5 gas_density 1.2 gas_viscosity 1.5e-5";
  asp_wall *wall = asp_wall_from_text(words, 0, 0, NULL);
  asp_particle own = grain;
  const double v = 3, v_y = 16.6, n = 2000;
  const double area = 0.1 + sqrt(v / v_y) / 7, enough = 2650 * 1e-5 * v * v / (6 * 0.8 * area);
  const double share = erfc(log(enough / 0.1) / log(3) / sqrt(2)) / 2;
  double most_stuck = 0, least_free = INFINITY, stuck = 0;
  own.pair = NULL;
  for (uint64_t tag = 1; tag <= n; tag++) {
    asp_impact impact;
    const asp_key key = {7, 1, tag, 3, 0};
    asp_wall_impact(wall, &own, (double[]){0, 0, -v}, up, &key, &impact);
    const double rate = asp_wall_removal(wall, &own, &(asp_key){7, 2, tag, 5, 0}).rate;
    const bool sticks = impact.outcome == ASP_DEPOSIT;
    stuck += sticks;
    most_stuck = sticks ? fmax(most_stuck, rate) : most_stuck;
    least_free = sticks ? least_free : fmin(least_free, rate);
  }
  assert_near(stuck / n, share, 4 * sqrt(share / n));
  assert_true(most_stuck <= least_free);
  asp_wall_free(wall);
}

/* A specular face tilted by delta turns the rebound by twice that: alpha2 = alpha1 + 2 delta. */
TEST(specular_rebound_turns_by_twice_the_tilt) {
  setup s = setup_create("truncated", "constant", 0.2);
  for (uint64_t tag = 0; tag < 10000; tag++) {
    double alpha = (0.5 + (double)(tag % 179)) * M_PI / 360;
    double v1[3] = {cos(alpha), 0, -sin(alpha)};
    asp_impact impact;
    asp_wall_impact(s.wall, &grain, v1, up, &(asp_key){1, 1, tag, 1, 0}, &impact);
    asp_coefficients c = asp_impact_coefficients(v1, up, &impact);
    assert_near(c.alpha1, alpha, 1e-14);
    assert_near(c.alpha2, alpha + 2 * impact.delta_alpha, 1e-13);
    assert_near(c.cor_v, 1, 1e-14);
    assert_near(c.cor_n, sin(c.alpha2) / sin(alpha), 1e-12 / sin(alpha));
    assert_near(c.cor_t, cos(c.alpha2) / cos(alpha), 1e-12 / cos(alpha));
  }
  setup_free(&s);
}

/* Turning wall and velocity together turns the result. */
TEST(frame_does_not_matter) {
  setup s = setup_create("weibull", "bons", 0.2);
  s.choice.isotropic = true;
  remake(&s);
  gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
  for (uint64_t tag = 0; tag < 2000; tag++) {
    double a = 6 * gsl_rng_uniform(rng), b = 3 * gsl_rng_uniform(rng), c = 6 * gsl_rng_uniform(rng);
    double ex[3] = {cos(a) * cos(b) * cos(c) - sin(a) * sin(c),
                    sin(a) * cos(b) * cos(c) + cos(a) * sin(c), -sin(b) * cos(c)};
    double ez[3] = {cos(a) * sin(b), sin(a) * sin(b), cos(b)};
    double ey[3] = {ez[1] * ex[2] - ez[2] * ex[1], ez[2] * ex[0] - ez[0] * ex[2],
                    ez[0] * ex[1] - ez[1] * ex[0]};
    double v1[3] = {80, 0, -60}, turned[3];
    for (int i = 0; i < 3; i++)
      turned[i] = 80 * ex[i] - 60 * ez[i];
    asp_impact here, there;
    asp_wall_impact(s.wall, &grain, v1, up, &(asp_key){3, 1, tag, 1, 0}, &here);
    asp_wall_impact(s.wall, &grain, turned, ez, &(asp_key){3, 1, tag, 1, 0}, &there);
    assert_near(dot(there.v2, ex), here.v2[0], 1e-9);
    assert_near(dot(there.v2, ey), here.v2[1], 1e-9);
    assert_near(dot(there.v2, ez), here.v2[2], 1e-9);
    assert_int_equal(here.outcome, there.outcome);
  }
  gsl_rng_free(rng);
  setup_free(&s);
}

/* The out-of-plane tilt is positive along b = n x t, and its slope is normal with sd s_eff. */
TEST(out_of_plane_tilt) {
  enum { N = 100000 };
  setup s = setup_create("weibull", "constant", 0.2);
  s.choice.isotropic = true;
  remake(&s);
  double square = 0, v1[3] = {0.6, 0, -0.8};
  for (uint64_t tag = 0; tag < N; tag++) {
    asp_impact impact;
    asp_wall_impact(s.wall, &grain, v1, up, &(asp_key){1, 1, tag, 1, 0}, &impact);
    double q = tan(impact.tilt_out);
    square += q * q / N;
    if (fabs(q) > 1e-3) /* a face that looks to -b throws the particle to -b */
      assert_true(impact.v2[1] * q < 0);
  }
  assert_near(sqrt(square), 0.2, 0.2 * 5 / sqrt(2. * N));
  setup_free(&s);
}

/* At normal impact the rebound has no preferred direction. */
TEST(normal_impact_is_isotropic) {
  enum { N = 100000 };
  setup s = setup_create("truncated", "constant", 0.3);
  double x = 0, y = 0, xx = 0, yy = 0, v1[3] = {0, 0, -1};
  for (uint64_t tag = 0; tag < N; tag++) {
    asp_impact impact;
    asp_wall_impact(s.wall, &grain, v1, up, &(asp_key){1, 1, tag, 1, 0}, &impact);
    x += impact.v2[0] / N;
    y += impact.v2[1] / N;
    xx += impact.v2[0] * impact.v2[0] / N;
    yy += impact.v2[1] * impact.v2[1] / N;
    asp_coefficients c = asp_impact_coefficients(v1, up, &impact);
    assert_true(isnan(c.cor_t));
  }
  assert_near(x, 0, 5 * sqrt(xx / N));
  assert_near(y, 0, 5 * sqrt(yy / N));
  assert_near(xx / yy, 1, 0.05);
  setup_free(&s);
}

TEST(no_deposits_where_none_are_taken) {
  setup s = setup_create("none", "bons", 0);
  asp_particle small = {.d_p = 1e-7, .density = 2650, .pair = &quartz_on_nickel};
  double v1[3] = {1, 0, -1};
  asp_impact impact;
  asp_wall_impact(s.wall, &small, v1, up, &(asp_key){1, 1, 1, 1, 0}, &impact);
  assert_int_equal(impact.outcome, ASP_DEPOSIT);
  assert_near(dot(impact.v2, impact.v2), 0, 0);
  asp_coefficients none = asp_impact_coefficients(v1, up, &impact);
  assert_true(isnan(none.cor_n) && isnan(none.cor_t) && isnan(none.cor_v_space));
  s.choice.deposit = false;
  remake(&s);
  asp_wall_impact(s.wall, &small, v1, up, &(asp_key){1, 1, 1, 1, 0}, &impact);
  assert_int_equal(impact.outcome, ASP_REBOUND);
  assert_near(impact.v2[2], 1, 1e-15);
  setup_free(&s);
}

/* A law that returns nothing, on a wall without deposits: the particle slides and does not sink. */
TEST(sliding) {
  setup s = setup_create("none", "constant", 0);
  assert_true(set_parameter(&s.choice, "cor_n", 0));
  s.choice.deposit = false;
  remake(&s);
  double v1[3] = {1, 0, -1};
  asp_impact impact;
  asp_wall_impact(s.wall, &grain, v1, up, &(asp_key){1, 1, 1, 1, 0}, &impact);
  assert_near(impact.v2[0], 1, 1e-15);
  assert_near(impact.v2[2], 0, 0);
  setup_free(&s);
}

/* Nearly normal, and with a normal of nearly unit length, a specular rebound keeps its energy. */
TEST(nearly_normal_impacts_keep_energy) {
  setup s = setup_create("normal", "constant", 0.2);
  double length = 1 + 1e-6, n[3] = {0.36 * length, 0.48 * length, 0.8 * length};
  for (uint64_t tag = 0; tag < 2000; tag++) {
    double small = pow(10, -2 - (double)(tag % 10)), v1[3] = {-0.36, -0.48 + small, -0.8};
    asp_impact impact;
    asp_wall_impact(s.wall, &grain, v1, n, &(asp_key){1, 1, tag, 1, 0}, &impact);
    assert_near(dot(impact.v2, impact.v2), dot(v1, v1), 1e-14);
  }
  setup_free(&s);
}

/* A particle that does not approach goes on as it came; a grazing one leaves for good. */
TEST(grazing_to_the_last_bit) {
  for (int rough = 0; rough < 2; rough++) {
    setup s = setup_create(rough ? "truncated" : "none", "constant", 0.2);
    for (int i = -3; i <= 3; i++) {
      double n[3] = {0.6, 0, 0.8}, v1[3] = {80, 0, -60 + i * 1e-14};
      asp_impact impact;
      asp_wall_impact(s.wall, &grain, v1, n, &(asp_key){1, 1, 7, 1, 0}, &impact);
      assert_true(dot(impact.v2, n) > 0);
      assert_near(dot(impact.v2, impact.v2), 1e4, 1e-9);
    }
    setup_free(&s);
  }
}

/* No face lies exactly along a flight, where rounding would say if it is hit. */
TEST(faces_are_hit_or_not) {
  setup s = setup_create("traced", "constant", 0.6);
  s.choice.multiple = true;
  remake(&s);
  const asp_particle one = {.d_p = 0.01, .density = 2650, .pair = &quartz_on_nickel};
  for (uint64_t k = 0; k < 20000; k++) {
    double alpha = 0.02 + 1.5 * (double)(k % 997) / 997;
    double v[3] = {cos(alpha), 0, -sin(alpha)};
    double near[3] = {(1 - 3e-11) * v[0], 0, (1 + 3e-11) * v[2]};
    const asp_key key = {1, 1, k, 1, 0};
    asp_impact a, b;
    asp_wall_impact(s.wall, &one, v, up, &key, &a);
    asp_wall_impact(s.wall, &one, near, up, &key, &b);
    assert_int_equal(a.hits, b.hits);
  }
  setup_free(&s);
}

/* What a particle that stays loses per face. Small slopes p with E p = s sqrt(pi/2), E p^2 = 2 s^2:
 * its approach is p alone, or where both sides of a trough touch, the sum of two. */
TEST(kinks_turn_by_both_sides) {
  enum { N = 40000 };
  setup s = setup_create("visible", "constant", 0.02);
  assert_true(set_parameter(&s.choice, "cor_n", 0.5) && set_parameter(&s.choice, "cor_t", 1));
  remake(&s);
  for (double kappa = 0.2; kappa < 20; kappa *= 2) {
    asp_particle of_size = grain;
    of_size.d_p = kappa / asp_surface_kappa(s.surface, 1);
    double slope = asp_wall_slope(s.wall, of_size.d_p), loss = 0, v1[3] = {10, 0, 0};
    for (uint64_t tag = 1; tag <= N; tag++) {
      asp_impact impact;
      asp_wall_impact_grazing(s.wall, &of_size, v1, up, 0, &(asp_key){1, 1, tag, 1, 0}, &impact);
      if (impact.hits > 0)
        loss += (1 - dot(impact.v2, impact.v2) / 100) / (0.75 * slope * slope) / N;
    }
    assert_near(loss, 2 + exp(-0.5 / (kappa * kappa)) * (2 + ASP_PI), 0.15);
  }
  setup_free(&s);
}

static const double along_x[3] = {10, 0, 0};

static bool grazes(const asp_wall *wall, const asp_particle *particle, double press,
                   const asp_key *key, asp_impact *impact) {
  assert_int_equal(asp_wall_impact_grazing(wall, particle, along_x, up, press, key, impact),
                   ASP_OK);
  return impact->hits > 0;
}

/* A particle pressed by a share b of what holds it on a crest, a sine of slope p, flies a parabola
 * to that sine, in phases u = k x: 1 - cos u = b u^2/2, where it comes down with p |sin u - b u|.
 * One that is pressed more stays. The law's first-hit slope is p, and no flight meets more. */
TEST(loose_particles_fly_to_the_next_face) {
  setup s = setup_create("visible", "constant", 0.02);
  const double v = 10, k = sqrt(6);
  asp_particle small = grain;
  small.d_p = 1e-3;
  for (uint64_t tag = 1; tag <= 300; tag++) {
    const asp_key key = {1, 1, tag, 1, 0};
    asp_impact impact;
    assert_true(grazes(s.wall, &small, 0, &key, &impact));
    const double p = tan(impact.delta_alpha), holds = v * v * p * k;
    for (double b = 0.9; b < 0.98; b += 0.03) {
      double low = 0.1, high = ASP_PI; /* the flight is over the sine up to the phase */
      for (int i = 0; i < 60; i++) {
        const double u = 0.5 * (low + high);
        *(1 - cos(u) > 0.5 * b * u * u ? &low : &high) = u;
      }
      assert_true(grazes(s.wall, &small, b * holds, &key, &impact));
      assert_near(tan(impact.delta_alpha) / p, fabs(sin(low) - b * low), 0.02);
    }
    assert_true(grazes(s.wall, &small, 0.56 * holds, &key, &impact));
    assert_near(tan(impact.delta_alpha) / p, 1, 1e-12);
    assert_false(grazes(s.wall, &small, 1.001 * holds, &key, &impact));
    assert_memory_equal(impact.v2, along_x, sizeof along_x);
  }
  setup_free(&s);
}

/* On a surface a trough is a kink where the Hessian of its heights, times the radius, has an
 * eigenvalue over 1: of that along the way, a, with Rayleigh's law, that across, with the mean a/3
 * and the variance 8/9, and the mixed one, with the variance 1/3. The share of kinks by quadrature;
 * no pressed particle meets anything else. */
TEST(kinks_of_surfaces_have_their_share) {
  enum { N = 20000, CELLS = 400 };
  setup s = setup_create("visible", "constant", 0.02);
  s.choice.isotropic = true;
  remake(&s);
  for (double kappa = 0.3; kappa < 3; kappa *= 2) {
    asp_particle of_size = grain;
    of_size.d_p = kappa / asp_surface_kappa(s.surface, 1);
    double met = 0, share = 0;
    for (uint64_t tag = 1; tag <= N; tag++) {
      asp_impact impact;
      met += grazes(s.wall, &of_size, 1e9, &(asp_key){1, 1, tag, 1, 0}, &impact) / (double)N;
    }
    for (int i = 0; i < CELLS; i++)
      for (int j = 0; j < CELLS; j++) {
        const double a = 6 * (i + 0.5) / CELLS, y = 12 * (j + 0.5) / CELLS - 6;
        const double density = a * exp(-a * a / 2) * exp(-y * y / 2) / sqrt(2 * ASP_PI);
        const double room = (1 - kappa * a) * (1 - kappa * (a / 3 + sqrt(8) / 3 * y));
        const double kink = kappa * a > 1 || room < 0 ? 1 : erfc(sqrt(1.5 * room) / kappa);
        share += density * kink * (6. / CELLS) * (12. / CELLS);
      }
    assert_near(met, share, 0.015);
  }
  setup_free(&s);
}

/* A particle without a pair gets that of the wall; many impacts are as many single ones. */
TEST(many_impacts_are_single_ones) {
  enum { N = 500 };
  asp_error error;
  static double v1[3 * N], n[3 * N];
  static asp_particle particles[N];
  static asp_coefficients coefficients[N];
  static asp_key keys[N];
  static asp_impact many[N];
  asp_wall *wall = asp_wall_from_text("surface rq 5um lambda_c 40um rebound bons spin on "
                                      "materials quartz hastelloy-x",
                                      0, 0, &error);
  assert_non_null(wall);
  for (int i = 0; i < N; i++) {
    double alpha = (i + 0.5) * M_PI / 2 / N;
    particles[i] = (asp_particle){.density = 2650, .d_p = 1e-6 * (1 + i % 40), .omega = {1e3 * i}};
    v1[3 * i] = 100 * cos(alpha);
    v1[3 * i + 2] = -100 * sin(alpha);
    n[3 * i + 2] = 1;
    keys[i] = (asp_key){7, 1, (uint64_t)i, 1, 0};
  }
  assert_int_equal(asp_wall_impacts(wall, N, particles, v1, n, keys, many, &error), ASP_OK);
  asp_impacts_coefficients(N, v1, n, many, coefficients);
  for (int i = 0; i < N; i++) {
    asp_impact impact;
    particles[i].pair = asp_wall_pair(wall);
    assert_int_equal(asp_wall_impact(wall, &particles[i], &v1[3 * i], &n[3 * i], &keys[i], &impact),
                     ASP_OK);
    assert_memory_equal(impact.v2, many[i].v2, sizeof impact.v2);
    assert_memory_equal(impact.omega, many[i].omega, sizeof impact.omega);
    assert_int_equal(impact.hits, many[i].hits);
    assert_int_equal(impact.outcome, many[i].outcome);
    assert_near(impact.delta_alpha, many[i].delta_alpha, 0);
    asp_coefficients cor = asp_impact_coefficients(&v1[3 * i], &n[3 * i], &impact);
    assert_memory_equal(&cor, &coefficients[i], sizeof cor);
  }
  asp_wall_free(wall);
}

/* Without materials a law that takes them has no rebound, and no wall is made unless particles are
 * to come with theirs. */
TEST(a_pair_is_needed) {
  asp_error error;
  asp_description *words = asp_description_parse("", NULL, NULL);
  assert_null(asp_wall_create(words, 0, 0, &error));
  assert_int_equal(error.code, ASP_EARG);
  assert_says(error.text, "materials needs two names (particle, wall), got 0");
  asp_description_expect_pairs(words);
  asp_wall *wall = asp_wall_create(words, 0, 0, &error);
  asp_description_free(words);
  const asp_particle bare = {.d_p = 1e-5, .density = 2650, .omega = {1, 2, 3}};
  const double v1[3] = {1, 2, -3};
  const asp_key key = {1, 1, 1, 1, 0};
  asp_impact impact;
  assert_null(asp_wall_pair(wall));
  assert_int_equal(asp_wall_impact(wall, &bare, v1, up, &key, &impact), ASP_EARG);
  assert_memory_equal(impact.v2, v1, sizeof v1);
  assert_memory_equal(impact.omega, bare.omega, sizeof bare.omega);
  assert_int_equal(asp_wall_impacts(wall, 1, &bare, v1, up, &key, &impact, &error), ASP_EARG);
  assert_says(error.text, "'bons' needs a pair");
  asp_wall_free(wall);
}

static const aspi_cor_point coefficients[] = {
    {1e-3, 0, 1, 1}, {1e-3, 1.5, 0.9, 0.5}, {1e3, 0, 0.8, 0.9}, {1e3, 1.5, 0.1, -0.3}};

/* Random walls, every model with every law, random particles and impacts: the outcome is finite,
 * leaves the wall or stays on it, and has no more energy than before. */
TEST(properties) {
  gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
  int models = asp_spread_count(), laws = asp_rebound_count();
  aspi_cor_table *table = aspi_cor_table_create(coefficients, 4, NULL);
  assert_non_null(table);
  for (int i = 0; i < 2 * models * laws; i++) {
    const asp_spread_model *model = asp_spread_at(i % models);
    double slope = pow(10, -6 + 7 * gsl_rng_uniform(rng));
    setup s = setup_create(model->name, "bons", slope);
    const asp_rebound_law *law = asp_rebound_at(i / models % laws);
    aspi_wall_choose_law(&s.choice, law);
    if (law->scatters && strcmp(model->name, "none") == 0)
      set_parameter(&s.choice, "scatter", gsl_rng_uniform(rng));
    s.choice.deposit = gsl_rng_uniform_int(rng, 2);
    s.choice.isotropic = gsl_rng_uniform_int(rng, 2);
    s.choice.multiple = gsl_rng_uniform_int(rng, 2);
    s.choice.table = table;
    remake(&s);
    for (uint64_t tag = 0; tag < 100; tag++) {
      double alpha = M_PI_2 * pow(10, -15 * gsl_rng_uniform(rng));
      double v = pow(10, -9 + 14 * gsl_rng_uniform(rng)), turn = 6.3 * gsl_rng_uniform(rng);
      double n[3] = {sin(turn), 0, cos(turn)}, v1[3];
      double t[3] = {cos(turn), 0, -sin(turn)};
      for (int k = 0; k < 3; k++)
        v1[k] = v * (cos(alpha) * t[k] - sin(alpha) * n[k]);
      if (!(dot(v1, n) < 0))
        continue;
      asp_particle p = {.d_p = pow(10, -9 + 8 * gsl_rng_uniform(rng)),
                        .density = 2650,
                        .pair = &quartz_on_nickel};
      asp_impact impact;
      asp_wall_impact(s.wall, &p, v1, n, &(asp_key){9, (uint32_t)i, tag, 1, 0}, &impact);
      double before = dot(v1, v1), after = dot(impact.v2, impact.v2);
      assert_true(isfinite(after) && isfinite(impact.delta_alpha) && isfinite(impact.tilt_out));
      assert_true(after <= before * (1 + 1e-14));
      assert_true(impact.hits >= 1 && impact.hits <= ASP_HITS_MAX + 1);
      assert_true(fabs(impact.delta_alpha) <= M_PI_2);
      if (impact.outcome == ASP_DEPOSIT)
        assert_near(after, 0, 0);
      else
        assert_true(dot(impact.v2, n) > 0);
    }
    setup_free(&s);
  }
  aspi_cor_table_free(table);
  gsl_rng_free(rng);
}

/* What would be divided by no more than rounding is not there: along the wall, where the last bits
 * of a product of vectors may send a particle into it or off it, and along the normal. */
TEST(no_coefficient_by_rounding) {
  static const double parts[] = {0, 4e-18, -4e-18, 1e-7, 1e-5, 1.7e-4, 1.8e-4};
  const double n[3] = {0, 0, 1};
  for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
    double part = parts[i], along[3] = {1, 0, -part}, down[3] = {fabs(part), 0, -1};
    bool there = part > 1e-6;
    const asp_impact impact = {.v2 = {0.6, 0.3, 0.2}, .outcome = ASP_REBOUND, .hits = 1};
    asp_coefficients slides = asp_impact_coefficients(along, n, &impact),
                     falls = asp_impact_coefficients(down, n, &impact);
    assert_int_equal(isfinite(slides.cor_n), there);
    assert_int_equal(isfinite(slides.cor_alpha) && isfinite(slides.cor_alpha_space), there);
    assert_int_equal(isfinite(falls.cor_t), part > tan(0.01 * M_PI / 180));
    assert_near(slides.cor_t, 0.6, 1e-9);
    assert_near(slides.cor_v_space, 0.7 / hypot(1, part), 1e-9);
    assert_near(falls.cor_n, 0.2, 1e-9);
    assert_near(falls.cor_v_space, 0.7 / hypot(1, part), 1e-9);
    if (there)
      assert_near(slides.cor_n / (0.2 / part), 1, 1e-9);
  }
  const asp_impact none = {.v2 = {0, 0, 0}};
  asp_coefficients still = asp_impact_coefficients((const double[3]){0, 0, 0}, n, &none);
  assert_true(isnan(still.cor_v) && isnan(still.cor_v_space) && isnan(still.cor_n));
}

/* A number that is none, or infinite, gives no impact and no numbers. */
TEST(no_number) {
  static const char *const walls[] = {"surface smooth rebound walton 0.9 0.3 0",
                                      "surface sigma 10 rebound walton 0.9 0.3 0.5",
                                      "surface sigma 10 spread profile rebound constant 0.5 0.5",
                                      "surface rq 1um lambda_c 20um materials quartz 304-ss",
                                      "surface sigma 10 rebound walton 0.9 0.3 0 grain lever 0.1"};
  static const double values[] = {NAN, INFINITY, -INFINITY};
  static const asp_body dumbbell = {
      .inverse_mass = 1, .inverse_inertia = {1, 1, 1, 0, 0, 0}, .lever = {0, 0, 1e-6}};
  for (size_t w = 0; w < sizeof walls / sizeof *walls; w++) {
    asp_wall *wall = asp_wall_from_text(walls[w], 0, 0, NULL);
    assert_non_null(wall);
    for (int k = 0; k < 45; k++) {
      double v1[3] = {1, 0, -1}, n[3] = {0, 0, 1}, lay[3] = {0, 1, 0};
      asp_body body = dumbbell;
      asp_particle one = grain;
      double *const numbers[] = {&v1[0],
                                 &v1[1],
                                 &v1[2],
                                 &n[2],
                                 &one.omega[0],
                                 &one.omega[2],
                                 &one.d_p,
                                 &lay[1],
                                 &one.temperature,
                                 &one.density,
                                 &body.lever[0],
                                 &body.inverse_mass,
                                 &body.inverse_inertia[1],
                                 &body.inverse_inertia[5],
                                 &n[0]};
      double *number = numbers[k % 15];
      *number = values[k / 15];
      one.lay = lay;
      one.body = k % 15 >= 10 && k % 15 < 14 ? &body : NULL;
      asp_impact impact;
      assert_int_equal(asp_wall_impact(wall, &one, v1, n, &(asp_key){1, 1, 1, 1, 0}, &impact),
                       ASP_OK);
      assert_int_equal(impact.hits, 0);
      assert_int_equal(impact.outcome, ASP_REBOUND);
      assert_true(isnan(impact.v2[0]) && isnan(impact.v2[2]) && isnan(impact.omega[1]));
      asp_coefficients c = asp_impact_coefficients(v1, up, &impact);
      assert_true(isnan(c.cor_n) && isnan(c.cor_v));
    }
    asp_wall_free(wall);
  }
}
