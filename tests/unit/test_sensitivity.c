/* Weights of the draws of impacts, and what they say about other walls, against runs at these.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"

#include "analysis/sensitivity.h"

#define WALL(surface) surface " materials quartz 304-ss"
static const double up[3] = {0, 0, 1};

static asp_wall *wall_of(const char *words) {
  asp_error error = {.code = ASP_OK};
  asp_wall *wall = asp_wall_from_text(words, 1e-6, 1e-4, &error);
  assert_string_equal(error.text, "");
  return wall;
}

static void set_speed(double speed, double degrees, double v[3]) {
  v[0] = speed * cos(degrees * ASP_PI / 180);
  v[1] = 0;
  v[2] = -speed * sin(degrees * ASP_PI / 180);
}

/* Means of an impact over many, with the squares of their standard errors. */
enum { WEIGHT, STUCK, HITS, UP, ALONG, MEANS };
static void add(const asp_impact *impact, double weight, double mean[MEANS], double square[MEANS]) {
  const double x[MEANS] = {1, impact->outcome == ASP_DEPOSIT, impact->hits, impact->v2[2],
                           impact->v2[0]};
  for (int k = 0; k < MEANS; k++) {
    mean[k] += weight * x[k];
    square[k] += weight * weight * x[k] * x[k];
  }
}

static void check_weights(const char *own, const char *other, double d_p, double degrees) {
  enum { N = 2500 };
  asp_wall *wall = wall_of(own);
  const asp_wall *others[] = {wall, wall_of(other)};
  const double lay[3] = {1, 2, 0};
  const asp_particle grain = {.d_p = d_p, .density = 2650, .lay = lay, .omega = {1e4, 2e4, 0}};
  double v1[3], weights[2], mean[2][MEANS] = {{0}}, square[2][MEANS] = {{0}};
  set_speed(30, degrees, v1);
  for (uint64_t tag = 1; tag <= N; tag++) {
    asp_impact by_weights, plain, there;
    const asp_key key = {1, 2, tag, 1, 0}, other_key = {2, 2, tag, 1, 0};
    assert_int_equal(
        asp_wall_weights(wall, 1, &grain, v1, up, &key, 2, others, &by_weights, weights, NULL),
        ASP_OK);
    asp_wall_impact(wall, &grain, v1, up, &key, &plain);
    assert_memory_equal(by_weights.v2, plain.v2, sizeof plain.v2);
    assert_near(weights[0], 1, 1e-12);
    add(&plain, weights[1], mean[0], square[0]);
    asp_wall_impact(others[1], &grain, v1, up, &other_key, &there);
    add(&there, 1, mean[1], square[1]);
  }
  for (int k = 0; k < MEANS; k++) {
    double variance = 0;
    for (int of = 0; of < 2; of++)
      variance += square[of][k] / N - mean[of][k] * mean[of][k] / N / N;
    assert_near(mean[0][k] / N, mean[1][k] / N, 4 * sqrt(fmax(0, variance) / N) + 1e-4);
  }
  asp_wall_free(wall);
  asp_wall_free((asp_wall *)others[1]);
}

TEST(weights_give_the_other_wall) {
  static const char *const walls[][2] = {
      {WALL("surface rq 5um lambda_c 40um"), WALL("surface rq 5.6um lambda_c 38um")},
      {WALL("surface rq 5um lambda_c 40um spread visible plane"),
       WALL("surface rq 4.5um lambda_c 40um spread visible plane")},
      {WALL("surface rq 3um lambda_c 40um 80um lay 1 2 0"),
       WALL("surface rq 3um lambda_c 36um 80um lay 1 2 0")},
      {"surface sigma 12 rebound walton 0.8 0.3 0.2",
       "surface sigma 13 rebound walton 0.8 0.3 0.2"},
      {WALL("surface rq 5um lambda_c 40um yield_stress 20MPa scatter 0.3 adhesion 0.5"),
       WALL("surface rq 5.5um lambda_c 40um yield_stress 20MPa scatter 0.3 adhesion 0.5")},
      {WALL("surface rq 5um lambda_c 40um grain lever 0.05"),
       WALL("surface rq 5.5um lambda_c 40um grain lever 0.05")}};
  for (size_t i = 0; i < sizeof walls / sizeof *walls; i++)
    for (int k = 0; k < 3; k++)
      check_weights(walls[i][0], walls[i][1], k == 2 ? 1e-4 : 1e-5, (const double[]){2, 15, 70}[k]);
}

/* Every model, with some that draw again; `profile` has its laws by phi_r. */
TEST(weights_of_every_model) {
  char words[2][120];
  int refused = 0;
  for (int i = 1; i < asp_spread_count(); i++) {
    const char *name = asp_spread_name(asp_spread_at(i));
    for (int of = 0; of < 2; of++)
      snprintf(words[of], sizeof words[of],
               "surface rq %dum lambda_c 40um spread %s rebound walton 0.8 0.2 0", of ? 11 : 10,
               name);
    asp_wall *wall = wall_of(words[0]);
    const asp_wall *const others[] = {wall};
    const asp_particle grain = {.d_p = 1e-5, .density = 2650};
    asp_impact impact;
    double weight, v[3];
    set_speed(30, 15, v);
    bool has = !asp_wall_weights(wall, 1, &grain, v, up, &(asp_key){1, 1, 1, 1, 0}, 1, others,
                                 &impact, &weight, NULL);
    asp_wall_free(wall);
    refused += !has;
    for (int k = 0; k < 3 && has; k++)
      check_weights(words[0], words[1], 1e-5, (const double[]){3, 15, 70}[k]);
  }
  assert_int_equal(refused, 1); /* traced */
}

/* A much steeper wall is refused: by its slope along the lay, too. */
TEST(steeper_walls_are_refused) {
  static const char *const walls[][2] = {
      {"surface sigma 5 rebound walton 0.8 0.2 0", "surface sigma %g rebound walton 0.8 0.2 0"},
      {"surface rq 3um lambda_c 40um 80um lay 1 2 0 rebound walton 0.8 0.2 0",
       "surface rq 3um lambda_c 40um %gum lay 1 2 0 rebound walton 0.8 0.2 0"}};
  static const double given[][2] = {{6.95, 7.05}, {58, 56.5}};
  const double lay[3] = {1, 2, 0};
  const asp_particle grain = {.d_p = 1e-6, .density = 2650, .lay = lay};
  double v1[3], weight;
  set_speed(30, 30, v1);
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < 2; k++) {
      char words[100];
      snprintf(words, sizeof words, walls[i][1], given[i][k]);
      asp_wall *own = wall_of(walls[i][0]), *other = wall_of(words);
      const asp_wall *const others[] = {other};
      asp_impact impact;
      asp_error error = {.code = ASP_OK};
      assert_int_equal(asp_wall_weights(own, 1, &grain, v1, up, &(asp_key){1, 1, 1, 1, 0}, 1,
                                        others, &impact, &weight, &error),
                       k ? ASP_ERANGE : ASP_OK);
      assert_true(!k || strstr(error.text, "it must be at most 1.4 times"));
      asp_wall_free(own);
      asp_wall_free(other);
    }
}

TEST(walls_without_weights_are_refused) {
  static const char *const walls[] = {
      WALL("surface smooth"),
      WALL("surface rq 5um lambda_c 40um spread visible isotropic collisions single"),
      WALL("surface rq 5um lambda_c 40um dp_bins 1 spread traced plane"),
      WALL("surface rq 5um lambda_c 40um spread visible plane")};
  asp_wall *own = wall_of(WALL("surface rq 5um lambda_c 40um"));
  const asp_particle grain = {.d_p = 1e-5, .density = 2650};
  const asp_key key = {1, 1, 1, 1, 0};
  double v1[3], weight;
  set_speed(30, 30, v1);
  for (size_t i = 0; i < sizeof walls / sizeof *walls; i++) {
    asp_impact impact;
    asp_error error;
    const asp_wall *other = wall_of(walls[i]);
    assert_int_equal(
        asp_wall_weights(own, 1, &grain, v1, up, &key, 1, &other, &impact, &weight, &error),
        ASP_EARG);
    assert_says(error.text, "it must be rough");
    asp_wall_free((asp_wall *)other);
  }
  asp_wall_free(own);
}

/* ---- runs of particles that hit up to three times ---- */

enum { PARTICLES = 1000, ROWS = 3 * PARTICLES };
#define STEP 1e-3

/* Particles of the tags behind `first` on walls[0]; fills the impacts and returns how many. */
static size_t fly(asp_wall *const walls[4], uint64_t first, aspi_drawn *drawn) {
  size_t n = 0;
  for (uint64_t tag = first + 1; tag <= first + PARTICLES; tag++) {
    const asp_particle grain = {.d_p = 1e-5, .density = 2650};
    double v[3], weights[3];
    asp_impact is;
    set_speed(30, 10 + (double)(tag % 30), v);
    for (uint32_t impact = 1; impact <= 3; impact++) {
      const asp_key key = {1, 2, tag, impact, 0};
      asp_wall_weights(walls[0], 1, &grain, v, up, &key, 3, (const asp_wall *const *)walls + 1, &is,
                       weights, NULL);
      bool stuck = is.outcome == ASP_DEPOSIT;
      drawn[n++] =
          (aspi_drawn){.tag = (double)tag,
                       .row = impact,
                       .self = {1, log(weights[0] / weights[1]) / (2 * STEP), 0, weights[2]},
                       .result = {stuck, stuck, is.eroded, stuck ? NAN : is.v2[2] / 30, NAN}};
      if (stuck)
        break;
      memcpy(v, is.v2, sizeof v);
      v[2] = -fabs(v[2]);
    }
  }
  return n;
}

static asp_wall *rough(double factor) {
  char words[100];
  snprintf(words, sizeof words, WALL("surface rq %.9gum lambda_c 40um"), 4 * factor);
  return wall_of(words);
}

static void run_on(double factor, uint64_t first, aspi_drawn *drawn,
                   aspi_derivative found[2][ASPI_PARTS]) {
  asp_wall *walls[] = {rough(factor), rough(factor * exp(STEP)), rough(factor * exp(-STEP)),
                       rough(factor * 1.1)};
  double effective;
  size_t n = fly(walls, first, drawn), grains = aspi_drawn_order(drawn, n, &effective);
  assert_int_equal(grains, PARTICLES);
  assert_in_range((uintmax_t)effective, PARTICLES / 2, PARTICLES);
  aspi_sensitivity(drawn, n, ASPI_STUCK, grains, found[0]);
  aspi_sensitivity(drawn, n, ASPI_COR, grains, found[1]);
  for (int i = 0; i < 4; i++)
    asp_wall_free(walls[i]);
}

/* The means over runs of what tells a value, with its spread, and of the value. */
TEST(one_run_tells_of_others) {
  enum { RUNS = 12 };
  static aspi_drawn drawn[ROWS];
  double mean[2][ASPI_PARTS] = {{0}}, square[2][ASPI_PARTS] = {{0}}, se[2][ASPI_PARTS] = {{0}};
  double more[2] = {0}, less[2] = {0}, other[2] = {0};
  for (uint64_t r = 0; r < RUNS; r++) {
    aspi_derivative up_there[2][ASPI_PARTS], down_there[2][ASPI_PARTS], there[2][ASPI_PARTS],
        found[2][ASPI_PARTS];
    run_on(exp(0.05), (100 + r) * PARTICLES, drawn, up_there);
    run_on(exp(-0.05), (100 + r) * PARTICLES, drawn, down_there);
    run_on(1.1, (200 + r) * PARTICLES, drawn, there);
    run_on(1, r * PARTICLES, drawn, found);
    for (int result = 0; result < 2; result++) {
      more[result] += up_there[result][ASPI_RUN].value / RUNS;
      less[result] += down_there[result][ASPI_RUN].value / RUNS;
      other[result] += there[result][ASPI_RUN].value / RUNS;
      for (int k = 0; k < ASPI_PARTS; k++) {
        mean[result][k] += found[result][k].value / RUNS;
        square[result][k] += found[result][k].value * found[result][k].value / RUNS;
        se[result][k] += found[result][k].se / RUNS;
      }
    }
  }
  for (int i = 0; i < 2; i++) {
    for (int k = 0; k < ASPI_PARTS; k += k == ASPI_DERIVATIVE ? 2 : 1) { /* one has a parameter */
      double sd = sqrt((square[i][k] - mean[i][k] * mean[i][k]) * RUNS / (RUNS - 1));
      assert_near(se[i][k] / sd, 1, 0.4);
    }
    double run = se[i][ASPI_RUN] / sqrt(RUNS), own = se[i][ASPI_DERIVATIVE] / sqrt(RUNS);
    assert_near(mean[i][ASPI_DERIVATIVE], (more[i] - less[i]) / 0.1,
                4 * hypot(own, run * sqrt(2) / 0.1));
    assert_near(mean[i][ASPI_OTHER], other[i], 4 * hypot(se[i][ASPI_OTHER] / sqrt(RUNS), run));
  }
}
