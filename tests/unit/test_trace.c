/* The geometry: the law of the first hit and the paths against brute force, against each other, and
 * against numbers of an independent ray tracer; the models against the geometry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "analysis/judge.h"
#include "spread/flight.h"
#include "wall/wall.h"
#include "surface/rolling.h"
#include "surface/heights.h"
#include "surface/size_law.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_rng.h>
#include <stdlib.h>

#define DEGREE (ASP_PI / 180)

static double heights_of_one(const aspi_field *line, size_t i) {
  double z = 0;
  for (size_t k = 0; k < i; k++)
    z += aspi_field_slope(line, k);
  return z;
}

/* The first face that a ray from (x, z) with slope m meets beyond face `own` (none: n), by asking
 * every face; n when there is none within two periods. Heights in points, over point 0. */
static size_t brute(const aspi_field *line, const double *h, double x, double z, double m,
                    size_t own) {
  size_t n = (size_t)line->columns, begin = (size_t)x;
  for (size_t k = begin; k < begin + 2 * n; k++) {
    if (k % n == own && k < begin + n)
      continue;
    double from = fmax((double)k, x), p = aspi_field_slope(line, k % n);
    double low = h[k % n] + p * (from - (double)k), high = h[k % n] + p;
    if (z + m * (from - x) >= low - 1e-12 && z + m * ((double)k + 1 - x) <= high + 1e-12)
      return k % n;
  }
  return n;
}

static aspi_field field_over(const asp_heights *profile, double d_p) {
  aspi_field field;
  assert_int_equal(aspi_field_create(&field, profile, d_p, NULL, NULL), ASP_OK);
  return field;
}

/* The shares of the first hits at alpha1. */
static void weigh(const aspi_field *line, double alpha1, double *weight) {
  aspi_field_first_hits(line, aspi_field_fall(line, alpha1), weight);
}

static double slope_rms(const aspi_field *line) {
  double square = 0;
  for (size_t i = 0; i < (size_t)line->columns; i++)
    square += aspi_field_slope(line, i) * aspi_field_slope(line, i) / (double)(size_t)line->columns;
  return sqrt(square);
}

TEST(first_hits_agree_with_brute_force) {
  asp_heights *profile = aspi_profile_generate(0.2, 1, 1 / 16., 512, 5, NULL);
  aspi_field line = field_over(profile, 0.5); /* resolves 5 degrees */
  size_t n = (size_t)line.columns;
  double *weight = malloc(n * sizeof *weight), *h = malloc(n * sizeof *h);
  for (size_t i = 0; i < n; i++)
    h[i] = heights_of_one(&line, i);
  for (double angle = 8; angle < 90; angle += 16.3) {
    enum { RAYS = 20000 };
    double sum = 0, *count = calloc(n, sizeof *count), off = 0, top = 0;
    weigh(&line, angle * DEGREE, weight);
    for (size_t i = 0; i < n; i++) {
      sum += weight[i];
      top = fmax(top, h[i]);
    }
    assert_near(sum, 1, 1e-9);
    for (int i = 0; i < RAYS; i++)
      count[brute(&line, h, (i + 0.5) / RAYS * (double)n, top + 1e-9, -tan(angle * DEGREE), n)]++;
    for (size_t i = 0; i < n; i++)
      off = fmax(off, fabs(count[i] / RAYS - weight[i]));
    assert_true(off < 3. / RAYS); /* a regular beam counts a face's width to one ray at each end */
    free(count);
  }
  free(weight);
  free(h);
  aspi_field_free(&line);
  asp_heights_free(profile);
}

/* Flies on at that elevation; `way` 1 or -1. */
static bool fly(const aspi_field *field, double elevation, int way, aspi_spot *spot,
                double *delta) {
  double gradient[2], v[3] = {way * cos(elevation), 0, sin(elevation)};
  bool hit = aspi_field_next(field, v, spot, gradient);
  *delta = atan(way * gradient[0]);
  return hit;
}

TEST(paths_agree_with_brute_force) {
  asp_heights *profile = aspi_profile_generate(0.3, 1, 1 / 16., 512, 6, NULL);
  aspi_field field = field_over(profile, 0.3);
  aspi_field line = field_over(profile, 0.3);
  size_t n = (size_t)line.columns;
  double *h = malloc(n * sizeof *h);
  for (size_t i = 0; i < n; i++)
    h[i] = heights_of_one(&line, i);
  gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
  double shift = field.z[0] / field.step[0] - h[0];
  for (int i = 0; i < 1000; i++) {
    double delta, alpha = 0.2 + 1.3 * gsl_rng_uniform(rng);
    aspi_spot spot = aspi_field_enter(&field, gsl_rng_uniform(rng), 0);
    assert_true(fly(&field, -alpha, 1, &spot, &delta));
    size_t own = (size_t)spot.x[0];
    double rise = alpha + 2 * delta, z = spot.z / field.step[0] - shift, x = spot.x[0];
    if (!(fabs(rise) < 1.5))
      continue; /* flies back, which the mirror image covers below */
    bool hits = fly(&field, rise, 1, &spot, &delta);
    size_t should = brute(&line, h, x, z, tan(rise), own);
    assert_int_equal(hits ? (size_t)spot.x[0] : n, should);
  }
  gsl_rng_free(rng);
  free(h);
  aspi_field_free(&field);
  aspi_field_free(&line);
  asp_heights_free(profile);
}

/* A profile and its mirror image are the same wall for a particle that flies the other way. */
TEST(flights_back_are_flights_over_the_mirror_image) {
  enum { N = 1024 };
  asp_heights *there = aspi_profile_generate(0.3, 1, 1 / 16., N, 7, NULL);
  double mirrored[N];
  for (int i = 0; i < N; i++)
    mirrored[i] = there->z[N - 1 - i];
  asp_heights *back = asp_heights_create(mirrored, N, 1, 1 / 16., 1 / 16., true, NULL);
  aspi_field one = field_over(there, 0), other = field_over(back, 0);
  for (int i = 0; i < 2000; i++) {
    double da, db, alpha = 0.02 + 0.0007 * i;
    aspi_spot a = aspi_field_enter(&one, 0.3, 0), b;
    fly(&one, -alpha, 1, &a, &da);
    b = a;
    b.x[0] = N - 1 - a.x[0] < 0 ? 2 * N - 1 - a.x[0] : N - 1 - a.x[0];
    b.z += other.top - one.top;
    bool hit = fly(&one, -0.1 + 0.0002 * i, -1, &a, &da);
    assert_int_equal(hit, fly(&other, -0.1 + 0.0002 * i, 1, &b, &db));
    if (hit)
      assert_near(da, db, 1e-5);
  }
  aspi_field_free(&one);
  aspi_field_free(&other);
  asp_heights_free(there);
  asp_heights_free(back);
}

/* Rebound angles and shares of later hits that an independent tracer found (phi_r 0.125, d_p =
 * lambda_c/4; an ensemble). */
TEST(rebounds_agree_with_an_independent_tracer) {
  static const double angle[] = {2, 10, 30};
  static const double known[][2] = {{25.22, 0.021}, {27.33, 0.073}, {37.31, 0.045}};
  aspi_judge_case subject = {
      .r_q = 0.125, .lambda_c = 1, .d_p = 0.25, .rays = 60000, .groups = 3, .seed = 2};
  aspi_judge judge;
  assert_int_equal(aspi_judge_create(&judge, &subject, angle, 3, NULL), ASP_OK);
  for (size_t i = 0; i < 3; i++) {
    aspi_angle_groups groups = aspi_judge_groups(&judge, i);
    double mean = aspi_angles_mean(groups, offsetof(aspi_angles, rebound_sum)).value;
    double later = aspi_angles_mean(groups, offsetof(aspi_angles, later)).value;
    print_message("alpha1 %g: mean %.2f (%.2f), later hits %.4f (%.3f)\n", angle[i], mean,
                  known[i][0], later, known[i][1]);
    assert_near(mean, known[i][0], 0.2);
    assert_near(later, known[i][1], 0.004);
  }
  aspi_judge_free(&judge);
}

/* A plateau with valleys (heights of a Gaussian profile through a smooth function), measured with
 * `across` points across a particle of 1; one wall for all of them. */
enum { ACROSS_FINE = 1024 };

static asp_heights *plateau(double lambda_c, int across) {
  enum { N = 1 << 17 };
  double r_q = lambda_c / 8;
  asp_heights *gauss = aspi_profile_generate(r_q, lambda_c, 1. / ACROSS_FINE, N, 3, NULL);
  size_t step = (size_t)(ACROSS_FINE / across), n = N / step;
  double *z = malloc(n * sizeof *z);
  for (size_t i = 0; i < n; i++)
    z[i] = -1.3 * r_q * log1p(exp(0.6 - 1.4 / r_q * gauss->z[i * step]));
  asp_heights *measured = asp_heights_create(z, n, 1, 1. / across, 1. / across, false, NULL);
  free(z);
  asp_heights_free(gauss);
  return measured;
}

/* Shares of the rebound angle in bins of one degree, by the first hits. */
static void count_rebounds(const aspi_field *line, double alpha1, double share[180]) {
  size_t n = (size_t)line->columns;
  double *weight = malloc(n * sizeof *weight);
  memset(share, 0, 180 * sizeof *share);
  weigh(line, alpha1, weight);
  for (size_t i = 0; i < n; i++)
    if (weight[i] > 0)
      share[(int)fmax(0, (alpha1 + 2 * atan(aspi_field_slope(line, i))) / DEGREE)] += weight[i];
  free(weight);
}

static double divergence(const double *of, const double *from, int bins) {
  double kl = 0;
  for (int i = 0; i < bins; i++)
    kl += of[i] > 0 ? of[i] * log(of[i] / fmax(from[i], 1e-6)) : 0;
  return kl;
}

/* Angles at which few points across a particle are compared with many. */
static const double few[] = {2, 10, 40};

/* Few points across a particle, against the dilation of very many: no comb of tilts, and the
 * same slope. */
static void compare_few(double lambda_c, int across, double reference[3][180], double slope) {
  asp_heights *measured = plateau(lambda_c, across);
  asp_surface *surface = asp_surface_create_profile(measured, 1, 1, 1, NULL);
  aspi_field line = field_over(measured, 1);
  for (int k = 0; k < 3; k++) {
    double share[180], kl;
    count_rebounds(&line, few[k] * DEGREE, share);
    kl = divergence(reference[k], share, 180);
    print_message("lambda_c %g, %d points across, %g deg: D_KL %.5f\n", lambda_c, across, few[k],
                  kl);
    assert_true(kl < (across < 16 ? 0.01 : 0.003));
  }
  assert_near(slope_rms(&line), slope, 0.01 * slope);
  assert_near(asp_surface_slope(surface, 1), slope, 0.01 * slope);
  aspi_field_free(&line);
  asp_surface_free(surface);
  asp_heights_free(measured);
}

TEST(few_points_across_are_enough) {
  for (double lambda_c = 0.5; lambda_c < 3; lambda_c *= 4) {
    asp_heights *fine = plateau(lambda_c, ACROSS_FINE);
    double reference[3][180];
    asp_heights *dilated = aspi_profile_rolled(fine, 1, 1, NULL);
    aspi_field line = field_over(dilated, 0);
    for (int k = 0; k < 3; k++)
      count_rebounds(&line, few[k] * DEGREE, reference[k]);
    for (int across = 8; across <= 16; across *= 2)
      compare_few(lambda_c, across, reference, slope_rms(&line));
    aspi_field_free(&line);
    asp_heights_free(dilated);
    asp_heights_free(fine);
  }
}

/* The judge of a measured profile rolls, too: of one wall with few and with many points across. */
TEST(few_points_across_judge_as_many) {
  double share[2][ASPI_ANGLE_BINS], mean[2];
  for (int many = 0; many < 2; many++) {
    asp_heights *measured = plateau(2, many ? ACROSS_FINE : 16);
    aspi_judge_case subject = {.r_q = 0.25,
                               .lambda_c = 2,
                               .d_p = 1,
                               .rays = 1000,
                               .groups = 4,
                               .seed = 2,
                               .profile = measured};
    aspi_judge judge;
    assert_int_equal(aspi_judge_create(&judge, &subject, few + 1, 1, NULL), ASP_OK);
    memcpy(share[many], judge.first->share, sizeof share[many]);
    mean[many] = judge.first->mean / DEGREE;
    aspi_judge_free(&judge);
    asp_heights_free(measured);
  }
  double kl = divergence(share[1], share[0], ASPI_ANGLE_BINS);
  print_message("judged: first hits, D_KL %.5f, means %.3f and %.3f deg\n", kl, mean[0], mean[1]);
  assert_true(kl < 0.002);
  assert_near(mean[0], mean[1], 0.03);
}

/* The table of Gaussian walls against an ensemble that did not make it: shares below slopes, and
 * the mean tilt. */
TEST(ensembles_agree_with_their_table) {
  enum { PROFILES = 3, POINTS = 2048 * 48, SLOPES = 9 };
  static const double kappas[] = {0, 0.3, 1.1, 3.1}, as[] = {0.12, 0.45, 1.3, 4};
  const asp_spread_model *model = asp_spread_find("profile", NULL);
  double *weight = malloc(POINTS * sizeof *weight), worst = 0, worst_mean = 0;
  for (int k = 0; k < 4; k++) {
    double phi_r = 0.125, d_p = kappas[k] / (sqrt(3) * phi_r),
           slope = sqrt(2) * phi_r * aspi_closed_form(kappas[k]);
    double below[4][SLOPES] = {{0}}, mean[4] = {0};
    for (int p = 0; p < 2 * PROFILES; p++) {
      asp_heights *profile = aspi_profile_generate_scaled(
          phi_r, 1, 1 / 48., POINTS, 500 + (uint32_t)p / 2, p % 2 ? -1 : 1, NULL);
      asp_heights *path = aspi_profile_rolled(profile, d_p, 1, NULL);
      aspi_field line = field_over(path, 0);
      for (int a = 0; a < 4; a++) {
        weigh(&line, atan(as[a] * slope), weight);
        for (size_t i = 0; i < POINTS; i++) {
          double x = aspi_field_slope(&line, i) / slope;
          mean[a] += weight[i] * x / (2 * PROFILES);
          for (int n = 0; n < SLOPES && weight[i] > 0; n++)
            below[a][n] += x < 0.5 * n - 1 ? weight[i] / (2 * PROFILES) : 0;
        }
      }
      aspi_field_free(&line);
      asp_heights_free(path);
      asp_heights_free(profile);
    }
    for (int a = 0; a < 4; a++) {
      aspi_spread_input input = {
          .slope = slope, .sigma = atan(slope), .alpha1 = atan(as[a] * slope), .kappa = kappas[k]};
      double sum = 0;
      for (int i = 0; i < 2000; i++)
        sum += tan(model->quantile(&input, (i + 0.5) / 2000)) / slope / 2000;
      worst_mean = fmax(worst_mean, fabs(sum - mean[a]));
      for (int n = 0; n < SLOPES; n++)
        worst = fmax(worst,
                     fabs(model->distribution(&input, atan((0.5 * n - 1) * slope)) - below[a][n]));
    }
  }
  print_message("table of first hits: shares off by %.4f, means by %.4f s\n", worst, worst_mean);
  assert_true(worst < 0.012);
  assert_true(worst_mean < 0.03);
  free(weight);
}

/* A diameter a quarter of the way, on a scale of ratios, from one bin to the next takes that in a
 * quarter of the draws. */
TEST(sizes_in_between_are_shared) {
  enum { N = 20000 };
  const aspi_sizes sizes = {1, 16, 3};
  double next = 0;
  for (uint64_t tag = 1; tag <= N; tag++) {
    aspi_stream stream = aspi_stream_begin(&(asp_key){1, 1, tag, 1, 0});
    const int bin = aspi_sizes_draw(&sizes, pow(4, 1.25), &stream);
    assert_true(bin == 1 || bin == 2);
    next += bin == 2;
  }
  assert_near(next / N, 0.25, 4 * sqrt(0.25 * 0.75 / N));
}

TEST(bad_sizes_are_named) {
  asp_error error;
  asp_heights *profile = aspi_profile_generate(0.1, 1, 1 / 16., 1024, 1, NULL);
  static const aspi_sizes bad[] = {{0, 1, 2},   {NAN, 1, 2}, {1, 0.5, 2},
                                   {1, NAN, 2}, {1, 2, 0},   {1, 2, 100000}};
  const aspi_height_field of = {.heights = profile};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    assert_null(aspi_spread_traced.prepare(&of, &bad[i], &error));
    assert_int_equal(error.code, ASP_EARG);
    assert_says(error.text, "d_p");
  }
  aspi_field field;
  assert_int_equal(aspi_field_create(&field, profile, -1, NULL, &error), ASP_EARG);
  assert_int_equal(aspi_field_create(&field, profile, 1e9, NULL, &error), ASP_EARG);
  asp_heights_free(profile);
}

/* A measured profile, which does not repeat, goes on as its mirror image. */
TEST(measured_profiles) {
  static const double heights[] = {0, 1, 3, 2, 5, 4, 4.5, 1, 0.5, 2};
  asp_heights *profile = asp_heights_create(heights, 10, 1, 1, 1, false, NULL);
  aspi_field line = field_over(profile, 0);
  assert_int_equal((size_t)line.columns, 18);
  for (size_t i = 0; i < 9; i++) {
    assert_near(aspi_field_slope(&line, i), heights[i + 1] - heights[i], 1e-12);
    assert_near(aspi_field_slope(&line, 17 - i), heights[i] - heights[i + 1], 1e-12);
  }
  aspi_field_free(&line);
  asp_heights_free(profile);
}

/* A plateau across a plain. A flight that sinks over the plain leaves the map again and again, and
 * comes back over the plain: it never lands higher than it began. */
TEST(flights_come_back_over_what_lies_below) {
  enum { N = 32 };
  static double z[N * N];
  for (int i = 0; i < N * N; i++)
    z[i] = i / N < 8 || i / N > 23 ? 0 : 10;
  asp_heights *map = asp_heights_create(z, N, N, 1, 1, false, NULL);
  const aspi_grid grid = {1, {0, 0}, {N, N}};
  aspi_field field;
  assert_int_equal(aspi_field_create(&field, map, 0, &grid, NULL), ASP_OK);
  int landed = 0;
  for (int k = 0; k < 200; k++) {
    const double way[3] = {k % 2 ? 1 : -1, k % 4 < 2 ? 0.05 : -0.05, -0.01};
    double gradient[2];
    aspi_spot spot = {{0.15 * k + 0.5, 1 + 0.025 * k}, 5, false};
    landed += aspi_field_next(&field, way, &spot, gradient);
    assert_true(spot.z <= 5);
  }
  assert_int_equal(landed, 200);
  aspi_field_free(&field);
  asp_heights_free(map);
}
