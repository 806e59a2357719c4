/* A sphere on a rough slope, by geometry alone. Its center moves above the path that the wall
 * leaves to it, on parabolas in steps that are short against the wall's features. Where a step ends
 * below the path, the sphere is put back onto it, and hits it if it approaches: by the wall's law,
 * at the local normal. Rolling is a series of such hits. No model of the tilt is in it.
 *
 * In three dimensions the height of the center is exact at every place: a path that is interpolated
 * between points has rounded troughs, through which a sphere rolls without a loss.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/roll.h"
#include "base/error.h"
#include "surface/closing.h"
#include "surface/map.h"
#include "surface/profile.h"

#include <math.h>

/* Points per lambda_c, and lengths in lambda_c. */
enum { PROFILE_RESOLUTION = 128, PROFILE_LENGTH = 1024, MAP_RESOLUTION = 16, MAP_LENGTH = 64 };

/* A step takes at most STEP_LENGTH lambda_c and STEP_TIME sqrt(lambda_c/g). */
#define STEP_LENGTH 0.004
#define STEP_TIME 0.01

/* A sphere has stopped that moves by less than STOP_LENGTH in STOP_TIME. */
#define STOP_LENGTH 0.2
#define STOP_TIME 20.0

/* Start: the sphere settles, and is stopped once per unit of time meanwhile; then the slope's
 * tangent rises by RISE s_eff per unit of time, until the sphere is AWAY. */
#define SETTLE_TIME 100.0
#define RISE 0.005
#define AWAY 10.0

double aspi_slope_time(const aspi_slope *s) {
  return sqrt(s->lambda_c / s->gravity);
}

double aspi_slope_speed(const aspi_slope *s) {
  return sqrt(s->lambda_c * s->gravity);
}

asp_code aspi_ground_create(aspi_ground *g, double r_q, double lambda_c, double d_p, bool in_space,
                            uint32_t seed, asp_error *error) {
  double step = lambda_c / (in_space ? MAP_RESOLUTION : PROFILE_RESOLUTION);
  *g = (aspi_ground){.path = NULL};
  if (in_space) {
    size_t points = (size_t)MAP_RESOLUTION * MAP_LENGTH;
    g->map = aspi_map_create(&(aspi_gauss){r_q, lambda_c, lambda_c, 0}, (double[]){step, step},
                             points, points, seed, error);
    g->ball = g->map ? aspi_ball_create(g->map, d_p, error) : NULL;
    return g->ball ? ASP_OK : error->code;
  }
  size_t points = (size_t)PROFILE_RESOLUTION * PROFILE_LENGTH;
  asp_profile *profile = asp_profile_create(r_q, lambda_c, step, points, seed, error);
  g->path = profile ? aspi_profile_rolled(profile, d_p, 1, error) : NULL;
  asp_profile_free(profile);
  return g->path ? ASP_OK : error->code;
}

void aspi_ground_free(aspi_ground *g) {
  aspi_ball_free(g->ball);
  asp_map_free(g->map);
  asp_profile_free(g->path);
}

static double wrapped(double x, double length) {
  x -= length * floor(x / length);
  return x < length ? x : 0;
}

/* Height of the center at (x, y), and its gradient. */
static aspi_touch touch(const aspi_ground *g, aspi_ball_search *way, double x, double y) {
  if (g->ball)
    return aspi_ball_at(way, wrapped(x, (double)g->map->columns * g->map->step[0]),
                        wrapped(y, (double)g->map->rows * g->map->step[1]));
  const double *z = asp_profile_heights(g->path), step = asp_profile_spacing(g->path);
  size_t n = asp_profile_points(g->path);
  double at = wrapped(x / step, (double)n);
  size_t i = (size_t)at, next = i + 1 < n ? i + 1 : 0;
  double rise = z[next] - z[i];
  return (aspi_touch){z[i] + (at - (double)i) * rise, rise / step, 0};
}

aspi_sphere aspi_sphere_place(const aspi_ground *g, double x, double y) {
  aspi_sphere s = {.x = {x, y, 0}};
  if (g->ball)
    s.way = aspi_ball_begin(g->ball);
  s.x[2] = touch(g, &s.way, x, y).height;
  return s;
}

static void stop(aspi_sphere *s) {
  for (int d = 0; d < 3; d++)
    s->v[d] = s->omega[d] = 0;
}

void aspi_sphere_step(const aspi_ground *g, const aspi_slope *slope, aspi_sphere *s) {
  double fall[3] = {slope->gravity * sin(slope->angle), 0, -slope->gravity * cos(slope->angle)};
  double speed = sqrt(s->v[0] * s->v[0] + s->v[1] * s->v[1] + s->v[2] * s->v[2]);
  double dt = STEP_TIME * aspi_slope_time(slope);
  if (speed * dt > STEP_LENGTH * slope->lambda_c)
    dt = STEP_LENGTH * slope->lambda_c / speed;
  for (int d = 0; d < 3; d++) {
    s->x[d] += (s->v[d] + 0.5 * dt * fall[d]) * dt;
    s->v[d] += dt * fall[d];
  }
  s->time += dt;
  aspi_touch at = touch(g, &s->way, s->x[0], s->x[1]);
  if (s->x[2] > at.height)
    return;
  s->x[2] = at.height;
  double m = 1 / sqrt(1 + at.p * at.p + at.q * at.q), n[3] = {-at.p * m, -at.q * m, m};
  if (!(s->v[0] * n[0] + s->v[1] * n[1] + s->v[2] * n[2] < 0))
    return;
  asp_particle particle = slope->particle;
  asp_impact impact;
  for (int d = 0; d < 3; d++)
    particle.omega[d] = s->omega[d];
  asp_wall_impact_mean(slope->wall, &particle, s->v, n, &(asp_key){.seed = 1}, &impact);
  for (int d = 0; d < 3; d++) {
    s->v[d] = impact.v2[d];
    s->omega[d] = impact.omega[d];
  }
  s->stuck = impact.outcome == ASP_DEPOSIT;
}

aspi_roll aspi_ground_roll(const aspi_ground *g, const aspi_slope *slope, double x, double y,
                           double duration) {
  double unit = aspi_slope_time(slope), half = 0.5 * duration * unit, checked = 0;
  aspi_sphere s = aspi_sphere_place(g, x, y), at_half = s, before = s;
  s.v[0] = ASPI_ROLL_SPEED * aspi_slope_speed(slope);
  s.omega[1] = 2 * s.v[0] / slope->particle.d_p;
  while (s.time < 2 * half && !s.stuck) {
    aspi_sphere_step(g, slope, &s);
    if (!(at_half.time > 0) && s.time >= half)
      at_half = s;
    if (s.time < checked + STOP_TIME * unit)
      continue;
    s.stuck = s.stuck || fabs(s.x[0] - before.x[0]) < STOP_LENGTH * slope->lambda_c;
    checked = s.time;
    before = s;
  }
  if (s.stuck)
    return (aspi_roll){0, true};
  return (aspi_roll){(s.x[0] - at_half.x[0]) / (s.time - at_half.time), false};
}

double aspi_ground_start(const aspi_ground *g, const aspi_slope *slope, double x, double y,
                         double s_eff) {
  double unit = aspi_slope_time(slope);
  aspi_slope rising = *slope;
  aspi_sphere s = aspi_sphere_place(g, x, y);
  rising.angle = 0;
  for (double next = unit; s.time < SETTLE_TIME * unit;) {
    aspi_sphere_step(g, &rising, &s);
    if (s.time < next)
      continue;
    stop(&s);
    next += unit;
  }
  const aspi_sphere lies = s;
  while (hypot(s.x[0] - lies.x[0], s.x[1] - lies.x[1]) < AWAY * slope->lambda_c) {
    double tangent = RISE * s_eff * (s.time - lies.time) / unit;
    if (tangent > 1 || s.stuck)
      return INFINITY;
    rising.angle = atan(tangent);
    aspi_sphere_step(g, &rising, &s);
  }
  return tan(rising.angle);
}
