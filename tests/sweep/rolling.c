/* A sphere that rolls down a generated rough slope, by geometry alone: the truth for particles that
 * stay on a wall. Its center moves on parabolas in steps that are short against the wall's
 * features; where a step ends below the place that the wall leaves to the center, the sphere is put
 * back onto it, and hits it if it approaches, by Walton's law at the local normal. The height of
 * the center is exact at every place: a path interpolated between points has rounded troughs,
 * through which a sphere rolls without a loss.
 *
 * `rolling FILE [WALLS [EVERY]]` computes every EVERY-th row of the table again, a sphere on each
 * of WALLS walls, and fails where speeds differ by more than four standard errors.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "gauss_map.h"
#include "base/running.h"
#include "asperity_internal.h"
#include "surface/ball.h"
#include "surface/heights.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Units: lambda_c, gravity. Points per lambda_c; lengths of the walls. */
enum { RESOLUTION = 16, PROFILE_LENGTH = 1024, MAP_LENGTH = 64 };

/* The motion begins at SPEED and takes DURATION; a step at most STEP_LENGTH and STEP_TIME. A sphere
 * that moves by less than STOP_LENGTH in STOP_TIME has stopped. */
static const double SPEED = 1.5, DURATION = 300, STEP_LENGTH = 0.004, STEP_TIME = 0.01;
static const double STOP_LENGTH = 0.2, STOP_TIME = 20;

typedef struct row {
  int dimensions;
  double slope_rms, d_p, angle, e, mu, speed, error, stopped;
} row;

static void must(bool good, const asp_error *error) {
  if (good)
    return;
  fprintf(stderr, "rolling: %s\n", error->text);
  exit(2);
}

/* A profile is a map whose rows are alike and so far apart that the sphere touches only one. */
static asp_heights *extruded(const asp_heights *profile, double apart, asp_error *error) {
  size_t n = profile->columns;
  double *z = aspi_allocate(n * ASP_SIDE_LEAST);
  for (size_t i = 0; z && i < n * ASP_SIDE_LEAST; i++)
    z[i] = profile->z[i % n];
  return aspi_heights_adopt(z, n, ASP_SIDE_LEAST, (double[]){profile->step[0], apart}, true, error);
}

static asp_heights *wall_of(const row *r, uint32_t seed) {
  asp_error error = {.code = ASP_OK};
  double r_q = r->slope_rms / sqrt(2), step = 1. / RESOLUTION;
  asp_heights *map;
  if (r->dimensions == 3)
    map = gauss_map_create(&(gauss_wall){r_q, 1, 1, 0}, (double[]){step, step},
                           RESOLUTION * MAP_LENGTH, RESOLUTION * MAP_LENGTH, seed, &error);
  else {
    asp_heights *profile =
        aspi_profile_generate(r_q, 1, step, RESOLUTION * PROFILE_LENGTH, seed, &error);
    must(profile, &error);
    map = extruded(profile, r->d_p, &error);
    asp_heights_free(profile);
  }
  must(map, &error);
  return map;
}

typedef struct sphere {
  const asp_wall *law;
  asp_particle particle;
  double g[3], x[3], v[3], time;
  aspi_ball_search way;
} sphere;

static double wrapped(double x, double length) {
  x -= length * floor(x / length);
  return x < length ? x : 0;
}

static aspi_touch touch(sphere *s, const asp_heights *map) {
  return aspi_ball_at(&s->way, wrapped(s->x[0], (double)map->columns * map->step[0]),
                      wrapped(s->x[1], (double)map->rows * map->step[1]));
}

static void step(sphere *s, const asp_heights *map) {
  double speed = sqrt(s->v[0] * s->v[0] + s->v[1] * s->v[1] + s->v[2] * s->v[2]);
  double dt = fmin(STEP_TIME, STEP_LENGTH / speed);
  for (int d = 0; d < 3; d++) {
    s->x[d] += (s->v[d] + 0.5 * dt * s->g[d]) * dt;
    s->v[d] += dt * s->g[d];
  }
  s->time += dt;
  aspi_touch at = touch(s, map);
  if (s->x[2] > at.height)
    return;
  s->x[2] = at.height;
  double m = 1 / sqrt(1 + at.p * at.p + at.q * at.q), n[3] = {-at.p * m, -at.q * m, m};
  if (s->v[0] * n[0] + s->v[1] * n[1] + s->v[2] * n[2] >= 0)
    return;
  asp_impact impact;
  asp_wall_impact_mean(s->law, &s->particle, s->v, n, &(asp_key){.seed = 1}, &impact);
  memcpy(s->v, impact.v2, sizeof s->v);
  memcpy(s->particle.omega, impact.omega, sizeof s->particle.omega);
}

/* Mean speed along the slope in the last half of the motion; NAN: it stopped. */
static double roll(const row *r, const asp_wall *law, uint32_t seed) {
  asp_heights *map = wall_of(r, seed);
  asp_error error = {.code = ASP_OK};
  aspi_ball *ball = aspi_ball_create(map, r->d_p, &error);
  must(ball, &error);
  double angle = r->angle * ASP_PI / 180, x_checked = 0, next = STOP_TIME, x_half = 0, half = 0;
  sphere s = {.law = law,
              .particle = {.d_p = r->d_p, .omega = {0, 2 * SPEED / r->d_p, 0}},
              .g = {sin(angle), 0, -cos(angle)},
              .v = {SPEED, 0, 0},
              .way = aspi_ball_begin(ball)};
  s.x[2] = touch(&s, map).height;
  bool moves = true;
  while (s.time < DURATION && moves) {
    step(&s, map);
    if (!(half > 0) && s.time >= DURATION / 2) {
      half = s.time;
      x_half = s.x[0];
    }
    if (s.time < next)
      continue;
    moves = fabs(s.x[0] - x_checked) >= STOP_LENGTH;
    x_checked = s.x[0];
    next += STOP_TIME;
  }
  aspi_ball_free(ball);
  asp_heights_free(map);
  return moves ? (s.x[0] - x_half) / (s.time - half) : NAN;
}

/* Prints the row by as many walls. True if the speed is that of the table. */
static bool compute(const row *r, int walls) {
  char text[200];
  snprintf(text, sizeof text, "surface sigma 1 rebound walton %.17g %.17g 0 deposit off", r->e,
           r->mu);
  asp_error error = {.code = ASP_OK};
  asp_wall *law = asp_wall_from_text(text, r->d_p, r->d_p, &error);
  must(law, &error);
  aspi_running speed = {0, 0, 0};
#pragma omp parallel for schedule(dynamic)
  for (int k = 1; k <= walls; k++) {
    double v = roll(r, law, (uint32_t)k);
#pragma omp critical
    if (!isnan(v))
      aspi_running_add(&speed, v);
  }
  asp_wall_free(law);
  double se = speed.n > 1 ? aspi_running_sd(&speed) / sqrt(speed.n) : NAN;
  double mean = speed.n > 0 ? speed.mean : NAN;
  printf("%d,%g,%g,%g,%g,%g,%.4g,%.2g,%.3g\n", r->dimensions, r->slope_rms, r->d_p, r->angle, r->e,
         r->mu, mean, se, 1 - speed.n / walls);
  fflush(stdout);
  return !(fabs(mean - r->speed) > 4 * hypot(se, r->error));
}

int main(int argc, char **argv) {
  FILE *in = argc > 1 ? fopen(argv[1], "r") : NULL;
  int walls = argc > 2 ? atoi(argv[2]) : 32, every = argc > 3 ? atoi(argv[3]) : 1, wrong = 0;
  if (!in || walls < 2 || every < 1)
    return fputs("usage: rolling FILE [WALLS [EVERY]]\n", stderr), 2;
  char line[400];
  for (int i = 0; fgets(line, sizeof line, in);) {
    row r;
    if (sscanf(line, "%d,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &r.dimensions, &r.slope_rms, &r.d_p,
               &r.angle, &r.e, &r.mu, &r.speed, &r.error, &r.stopped) != 9 ||
        i++ % every > 0 || compute(&r, walls))
      continue;
    fprintf(stderr, "rolling: the table has %s", line);
    wrong++;
  }
  fclose(in);
  return wrong > 0;
}
