/* The judge in three dimensions: flights over the wall against brute force, and the numbers of an
 * independent reference (2048 x 2048 points, 8 to 12 surfaces).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "judge_3d.h"
#include "spread/flight.h"

#include <stdlib.h>

#define DEGREE (ASP_PI / 180)

/* Bilinear, anywhere on the plane; u and v in points. */
static double height_at(const aspi_field *f, double u, double v) {
  double n = (double)f->columns, m = (double)f->rows;
  u -= n * floor(u / n);
  v -= m * floor(v / m);
  ptrdiff_t i = (ptrdiff_t)u % f->columns, j = (ptrdiff_t)v % f->rows;
  const float *one = f->z + 3 * f->columns * j, *two = f->z + 3 * f->columns * ((j + 1) % f->rows);
  ptrdiff_t k = 3 * ((i + 1) % f->columns);
  i *= 3;
  u -= floor(u);
  v -= floor(v);
  return (1 - v) * ((1 - u) * one[i] + u * one[k]) + v * ((1 - u) * two[i] + u * two[k]);
}

static void field_of(aspi_field *f, asp_heights *map, double d_p) {
  const aspi_grid all = {1, {0, 0}, {map->columns, map->rows}};
  assert_int_equal(aspi_field_create(f, map, d_p, &all, NULL), ASP_OK);
}

/* Flights that begin in the air, over a map whose sides are no powers of two, against small steps.
 */
TEST(flights_end_where_small_steps_do) {
  gauss_wall wall = {0.2, 1, 1, 0};
  asp_heights *map = gauss_map_create(&wall, (const double[2]){0.1, 0.08}, 128, 128, 7, NULL);
  map->columns = 101;
  map->rows = 97;
  for (size_t j = 0; j < map->rows; j++)
    memmove(map->z + j * 101, map->z + j * 128, 101 * sizeof *map->z);
  aspi_field f;
  field_of(&f, map, 0.4);
  int hits = 0;
  for (int k = 0; k < 400; k++) {
    double azimuth = 0.7 * k, rise = 0.35 * sin(1.3 * k) - 0.05, gradient[2];
    const double v[3] = {cos(azimuth), sin(azimuth), rise};
    aspi_spot spot = {{fmod(3.1 * k, 101), fmod(9.6 * k, 97)}, 0, false}, begin;
    spot.z = height_at(&f, spot.x[0], spot.x[1]) + 0.15;
    begin = spot;
    bool found = aspi_field_next(&f, v, &spot, gradient);
    double t = 0, step = 2e-4;
    bool met = false;
    for (; !met && t < 60; t += met ? 0 : step)
      met = begin.z + t * rise <=
            height_at(&f, begin.x[0] + t * v[0] / f.step[0], begin.x[1] + t * v[1] / f.step[1]);
    assert_int_equal(found, met);
    hits += met;
    if (!met)
      continue;
    assert_near(spot.z, begin.z + t * rise, 2 * step);
    assert_near(spot.z, height_at(&f, spot.x[0], spot.x[1]), 1e-5);
    assert_true(v[2] - gradient[0] * v[0] - gradient[1] * v[1] < 0);
  }
  assert_true(hits > 100 && hits < 390);
  aspi_field_free(&f);
  asp_heights_free(map);
}

/* Where a map is coarse, the gradient of a contact and that of the surface between the points
 * differ, and a face may send a particle under its neighbor: it hits that, and is not lost. */
TEST(no_flight_ends_below_a_coarse_wall) {
  gauss_wall wall = {0.2, 1, 1, 0};
  asp_heights *map = gauss_map_create(&wall, (const double[2]){0.15, 0.15}, 128, 128, 3, NULL);
  aspi_field f;
  field_of(&f, map, 0.1);
  int hits = 0;
  for (int k = 0; k < 20000; k++) {
    double azimuth = 0.7 * k, gradient[2];
    double v[3] = {cos(azimuth), sin(azimuth), -0.1 - 1e-4 * k};
    aspi_spot spot = aspi_field_enter(&f, fmod(0.016 * k, 1), fmod(0.04 * k, 1));
    while (aspi_field_next(&f, v, &spot, gradient)) {
      double square = 1 + gradient[0] * gradient[0] + gradient[1] * gradient[1];
      double twice = 2 * (v[2] - v[0] * gradient[0] - v[1] * gradient[1]) / square;
      assert_true(twice < 0);
      v[0] += twice * gradient[0];
      v[1] += twice * gradient[1];
      v[2] -= twice;
      hits++;
    }
    assert_true(v[2] > 0);
  }
  assert_true(hits > 21000);
  aspi_field_free(&f);
  asp_heights_free(map);
}

/* The mean tilt of grazing first hits, which pass several edges on their way. */
static double mean_tilt(asp_heights *map, bool periodic) {
  enum { FLIGHTS = 20000 };
  aspi_field f;
  double sum = 0;
  map->periodic = periodic;
  field_of(&f, map, 0.2);
  for (int k = 0; k < FLIGHTS; k++) {
    double azimuth = 0.7 * k, gradient[2];
    const double v[3] = {cos(azimuth), sin(azimuth), -0.03};
    aspi_spot spot = aspi_field_enter(&f, fmod(0.0161 * k, 1), fmod(0.0417 * k, 1));
    assert_true(aspi_field_next(&f, v, &spot, gradient));
    assert_true(spot.x[0] >= 0 && spot.x[0] <= (double)f.cells[0]);
    assert_true(spot.x[1] >= 0 && spot.x[1] <= (double)f.cells[1]);
    sum += atan(gradient[0] * v[0] + gradient[1] * v[1]) / FLIGHTS;
  }
  aspi_field_free(&f);
  return sum;
}

/* Flights over a piece of a map, whose edges do not fit together, have the first hits of flights
 * over the map, which repeats. */
TEST(edges_do_not_change_first_hits) {
  enum { ALL = 256, PIECE = 150 };
  gauss_wall wall = {0.125, 1, 1, 0};
  asp_heights *map = gauss_map_create(&wall, (const double[2]){0.08, 0.08}, ALL, ALL, 9, NULL);
  double should = mean_tilt(map, true), is = 0;
  for (size_t k = 0; k < 4; k++) {
    static double piece[PIECE * PIECE];
    for (size_t j = 0; j < PIECE; j++)
      memcpy(piece + j * PIECE, map->z + (j + k / 2 * (ALL - PIECE)) * ALL + k % 2 * (ALL - PIECE),
             PIECE * sizeof *piece);
    asp_heights *part = asp_heights_create(piece, PIECE, PIECE, 0.08, 0.08, false, NULL);
    is += mean_tilt(part, false) / 4;
    asp_heights_free(part);
  }
  print_message("mean tilt over edges %.4f, without them %.4f\n", is, should);
  assert_near(is, should, 0.03 * should);
  asp_heights_free(map);
}

/* On one row, weights and places agree, and every one of them is where the beam says. */
TEST(first_hits_fill_the_beam) {
  gauss_wall wall = {0.2, 1, 1, 0};
  asp_heights *map = gauss_map_create(&wall, (const double[2]){0.05, 0.1}, 1024, 128, 5, NULL);
  aspi_field f;
  field_of(&f, map, 2);
  line over;
  assert_int_equal(line_create(&over, (size_t)f.columns, f.step[0], NULL), ASP_OK);
  enum { COUNT = 20000 };
  static double share[COUNT], weight[1024], count[1024];
  static line_spot spots[COUNT];
  for (int k = 0; k < COUNT; k++)
    share[k] = (k + 0.5) / COUNT;
  for (int way = -1; way < 2; way += 2) {
    double fall = 0.1, sum = 0, off = 0;
    memset(count, 0, sizeof count);
    line_over_row(&over, &f, 3, way);
    line_first_hits(&over, fall, weight);
    line_hits(&over, fall, share, COUNT, spots);
    for (int k = 0; k < COUNT; k++) {
      count[spots[k].face] += 1. / COUNT;
      double x = spots[k].x / f.step[0];
      x = way > 0 ? x : 1023 - x;
      assert_near(spots[k].z, height_at(&f, x, 3), 2e-3);
      assert_true(over.slope[spots[k].face] > -fall);
    }
    for (size_t i = 0; i < 1024; i++) {
      sum += weight[i];
      off = fmax(off, fabs(count[i] - weight[i]));
    }
    assert_near(sum, 1, 1e-9);
    assert_true(off < 2. / COUNT);
  }
  line_free(&over);
  aspi_field_free(&f);
  asp_heights_free(map);
}

/* A case of the table: the angle from the flight to axis 1, d_p, alpha1, and what stands there;
 * surfaces of `points` along a side, of which grazing flights need long ones. */
typedef struct known {
  double axis, d_p, alpha1, rebound, rebound_se, lateral;
  size_t points, surfaces;
} known;

static aspi_judge judge_of(const surfaces *subject, double degrees) {
  aspi_judge judge;
  assert_int_equal(judge_in_space(&judge, subject, &degrees, 1, NULL), ASP_OK);
  return judge;
}

static aspi_mean_error mean_of(const aspi_judge *judge, size_t sum) {
  return aspi_angles_mean(aspi_judge_groups(judge, 0), sum);
}

TEST(numbers_agree_with_the_independent_reference) {
  const known cases[] = {
      {0, 10, 2, 25.08, 0.06, 0.98, 1024, 3},
      {45, 10, 5, 18.51, 0.08, 3.35, 512, 6},
      {45, 185, 10, 18.68, 0.08, 3.32, 512, 6},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    const known *c = &cases[k];
    surfaces subject = {.wall = {5, 40, 200, c->axis * DEGREE},
                        .d_p = c->d_p,
                        .groups = c->surfaces,
                        .rays = 40000,
                        .seed = 100,
                        .points = c->points};
    aspi_judge all = judge_of(&subject, c->alpha1);
    aspi_mean_error mean = mean_of(&all, offsetof(aspi_angles, rebound_sum));
    aspi_mean_error side = mean_of(&all, offsetof(aspi_angles, lateral_sum));
    aspi_mean_error square = mean_of(&all, offsetof(aspi_angles, lateral_square));
    double error = 4 * hypot(fmax(mean.se, 0.003 * c->rebound), c->rebound_se);
    print_message("axis %g, d_p %g, alpha1 %g: %.3f +- %.3f (%.2f), lateral %.3f, sd %.3f (%.2f)\n",
                  c->axis, c->d_p, c->alpha1, mean.value, mean.se, c->rebound, side.value,
                  sqrt(square.value - side.value * side.value), c->lateral);
    assert_near(mean.value, c->rebound, error);
    assert_near(sqrt(square.value - side.value * side.value), c->lateral, 0.03 * c->lateral);
    if (c->axis == 45 && c->d_p == 10) /* to the side on which the lay lies */
      assert_near(side.value, -3.30, 0.15);
    aspi_judge_free(&all);
  }
}

/* The divergence of a sample of the same law is nothing, within its own error. */
TEST(divergences_have_no_bias) {
  surfaces subject = {.wall = {5, 40, 40, 0},
                      .d_p = 10,
                      .groups = 12,
                      .rays = 10000,
                      .seed = 1,
                      .points = 256},
           other = subject;
  other.groups = 32;
  other.seed = 1000;
  aspi_judge all = judge_of(&subject, 10), many = judge_of(&other, 10);
  aspi_angles model = {0};
  for (size_t k = 0; k < other.groups; k++)
    aspi_angles_merge(&model, &many.angles[k]);
  aspi_mean_error d = aspi_judge_divergence(&all, 0, &model, 1, offsetof(aspi_angles, rebound));
  print_message("D_KL %.5f +- %.5f\n", d.value, d.se);
  assert_near(d.value, 0, 0.002);
  aspi_judge_free(&all);
  aspi_judge_free(&many);
}

/* A map of ridges: a grazing particle that has hit a crest does not hit it again. With steps of the
 * map from 2.5 to 1.25 um the law of such a map has later hits in 0.016 to 0.018 of the impacts. */
static asp_heights *ridges(const surfaces *subject, const double step[2], size_t points,
                           uint32_t seed) {
  (void)step;
  asp_heights *map =
      gauss_map_create(&subject->wall, (const double[2]){2.5, 2.5}, points, points, seed, NULL);
  for (size_t i = 0; i < points * points; i++)
    map->z[i] = -2 * fabs(map->z[i]);
  return map;
}

TEST(crests_are_hit_once) {
  surfaces subject = {.wall = {5, 40, 40, 0},
                      .d_p = 40,
                      .groups = 4,
                      .rays = 4000,
                      .seed = 1,
                      .points = 512,
                      .make = ridges};
  aspi_judge all = judge_of(&subject, 2);
  double later = mean_of(&all, offsetof(aspi_angles, later)).value;
  print_message("ridges, 2 deg: later hits %.4f\n", later);
  assert_true(later > 0.012 && later < 0.025);
  aspi_judge_free(&all);
}
