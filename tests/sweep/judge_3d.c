/* The judge in three dimensions; see judge_3d.h. Exact dilation, exact first hits along the rows,
 * later hits by following each particle over the surface. Nothing of a model is in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "judge_3d.h"
#include "base/units.h"
#include "base/error.h"
#include "base/stream.h"
#include "spread/flight.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PER_LAMBDA = 20, HITS_MOST = 64 };

/* The rebound from a face with that gradient, by the law. False: the particle sticks. */
static bool rebound(const surfaces *subject, double v[3], const double gradient[2]) {
  double square = 1 + gradient[0] * gradient[0] + gradient[1] * gradient[1], m = 1 / sqrt(square);
  const asp_particle particle = {.d_p = subject->d_p, .density = subject->density};
  const double n[3] = {-gradient[0] * m, -gradient[1] * m, m};
  asp_impact impact;
  asp_wall_impact_mean(subject->law, &particle, v, n, &(asp_key){.seed = 1}, &impact);
  memcpy(v, impact.v2, sizeof impact.v2);
  return impact.outcome == ASP_REBOUND;
}

/* The specular rebound. */
static void reflect(double v[3], const double gradient[2]) {
  double m[3] = {-gradient[0], -gradient[1], 1};
  double square = 1 + gradient[0] * gradient[0] + gradient[1] * gradient[1];
  double twice = 2 * (v[0] * m[0] + v[1] * m[1] + v[2]) / square;
  for (int k = 0; k < 3; k++)
    v[k] -= twice * m[k];
}

/* One particle from its first hit on, along x (way 1) or against it (-1). */
static void fly_on(const aspi_field *field, const surfaces *subject, size_t row,
                   const line_spot *spot, int way, double alpha1, aspi_angles *angles) {
  double last = (double)field->columns - 1, x = spot->x / field->step[0], length = last + 1;
  double from_far = last - x < 0 ? last - x + length : last - x;
  size_t at = way > 0 ? spot->face : (size_t)last - spot->face;
  const float *point = field->z + 3 * (row * (size_t)field->columns + at);
  double speed = subject->law ? subject->speed : 1, gradient[2] = {point[1], point[2]};
  double v[3] = {way * speed * cos(alpha1), 0, -speed * sin(alpha1)};
  aspi_spot place = {{way > 0 ? fmod(x, length) : from_far, (double)row}, spot->z, true};
  double tilt = atan(way * gradient[0]);
  int hits = 0;
  do {
    if (!subject->law)
      reflect(v, gradient);
    else if (!rebound(subject, v, gradient))
      return;
  } while (++hits < HITS_MOST && aspi_field_next(field, v, &place, gradient));
  const double turned[3] = {way * v[0], way * v[1], v[2]};
  aspi_angles_add(angles, turned, tilt, hits);
}

/* Places in the beam, one in each of `count` equal parts. */
static void draw_places(aspi_stream *stream, double *share, size_t count) {
  for (size_t k = 0; k < count; k++)
    share[k] = ((double)k + aspi_stream_uniform(stream)) / (double)count;
}

asp_code line_create(line *made, size_t n, double step, asp_error *error) {
  *made = (line){n, step, aspi_allocate(3 * n), NULL, NULL};
  if (!made->slope)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a line of %zu points", n);
  made->end_x = made->slope + n;
  made->end_z = made->end_x + n;
  return ASP_OK;
}

void line_free(line *made) {
  free(made->slope);
}

/* The maximum of g over the period before the one that begins with face 0. */
static double highest_before(const line *over, double fall) {
  double highest = -INFINITY, period = over->step * (double)over->n;
  for (size_t i = 0; i < over->n; i++) {
    double g = over->end_z[i] + fall * (over->end_x[i] - period);
    highest = g > highest ? g : highest;
  }
  return highest;
}

void line_first_hits(const line *over, double fall, double *weight) {
  double highest = highest_before(over, fall), rise = fall * over->step * (double)over->n;
  for (size_t i = 0; i < over->n; i++) {
    double g = over->end_z[i] + fall * over->end_x[i];
    weight[i] = g > highest ? (g - highest) / rise : 0;
    highest = g > highest ? g : highest;
  }
}

void line_over_row(line *over, const aspi_field *field, size_t row, int way) {
  ptrdiff_t n = (ptrdiff_t)over->n;
  double step = over->step, sign = way;
  const float *z = field->z + 3 * (row * over->n + (way > 0 ? 0 : over->n - 1)), *p = z + 1;
  ptrdiff_t stride = 3 * way;
  for (ptrdiff_t i = 0; i < n; i++) {
    ptrdiff_t k = (i + 1 < n ? i + 1 : 0) * stride;
    double here = z[i * stride], next = z[k], a = sign * p[i * stride], b = sign * p[k];
    double off = next - b * step - here, bend = a - b;
    /* The crossing of the tangents where it lies between the points, else the middle. */
    double at = 0.5 * step, height = 0.5 * (here + next + 0.5 * step * bend);
    if (off * bend > 0 && fabs(off) < fabs(bend) * step) {
      at = off / bend;
      height = here + a * at;
    }
    over->slope[i] = a;
    over->end_x[i] = (double)i * step + at;
    over->end_z[i] = height;
  }
}

void line_hits(const line *over, double fall, const double *share, size_t count, line_spot *spots) {
  double rise = fall * over->step * (double)over->n, first = highest_before(over, fall);
  size_t k = 0, n = over->n;
  for (size_t i = 0; i < n && k < count; i++) {
    double g = over->end_z[i] + fall * over->end_x[i];
    for (; k < count && first + share[k] * rise <= g; k++) {
      /* On the face, back from its end. */
      double back = (g - first - share[k] * rise) / (over->slope[i] + fall);
      spots[k] = (line_spot){i, over->end_x[i] - back, over->end_z[i] - over->slope[i] * back};
    }
  }
  for (; k < count; k++)
    spots[k] = (line_spot){n - 1, over->end_x[n - 1], over->end_z[n - 1]};
}

/* All particles of one surface, along its rows. */
static asp_code fly(const aspi_field *field, const surfaces *subject, int way,
                    const double *degrees, size_t count, uint32_t seed, aspi_angles *angles,
                    asp_error *error) {
  line row_line;
  size_t lines = (size_t)field->rows, per_row = (subject->rays / 2 + lines - 1) / lines;
  asp_code code = line_create(&row_line, (size_t)field->columns, field->step[0], error);
  if (code)
    return code;
  double *share = calloc(per_row, sizeof *share);
  line_spot *spots = calloc(per_row, sizeof *spots);
  if (!share || !spots)
    code = aspi_fail(error, ASP_ENOMEM, "out of memory for %zu flights a row", per_row);
  for (size_t row = 0; row < lines && !code; row++) {
    aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = seed, .wall = 1, .tag = row});
    line_over_row(&row_line, field, row, way);
    for (size_t i = 0; i < count; i++) {
      double alpha1 = aspi_radians(degrees[i]);
      draw_places(&stream, share, per_row);
      line_hits(&row_line, tan(alpha1), share, per_row, spots);
      for (size_t k = 0; k < per_row; k++)
        fly_on(field, subject, row, &spots[k], way, alpha1, &angles[i]);
    }
  }
  free(share);
  free(spots);
  line_free(&row_line);
  return code;
}

static asp_heights *generated(const surfaces *subject, uint32_t seed, asp_error *error) {
  const gauss_wall *wall = &subject->wall;
  double c = cos(wall->axis), s = sin(wall->axis), a = 1 / (wall->lambda_1 * wall->lambda_1),
         b = 1 / (wall->lambda_2 * wall->lambda_2);
  double step[2] = {1 / (PER_LAMBDA * sqrt(c * c * a + s * s * b)),
                    1 / (PER_LAMBDA * sqrt(s * s * a + c * c * b))};
  return subject->make
             ? subject->make(subject, step, subject->points, seed)
             : gauss_map_create(wall, step, subject->points, subject->points, seed, error);
}

static asp_code fly_both_ways(const surfaces *subject, uint32_t seed, const double *degrees,
                              size_t count, aspi_angles *angles, asp_error *error) {
  asp_heights *map = generated(subject, seed, error);
  if (!map)
    return error->code;
  aspi_field field = {0};
  const aspi_grid all = {1, {0, 0}, {map->columns, map->rows}};
  asp_code code = aspi_field_create(&field, map, subject->d_p, &all, error);
  asp_heights_free(map);
  if (!code)
    code = fly(&field, subject, 1, degrees, count, seed, angles, error);
  if (!code)
    code = fly(&field, subject, -1, degrees, count, ~seed, angles, error);
  aspi_field_free(&field);
  return code;
}

asp_code judge_in_space(aspi_judge *judge, const surfaces *subject, const double *degrees,
                        size_t count, asp_error *error) {
  size_t groups = subject->groups;
  asp_error worst = {.code = ASP_OK};
  *judge = (aspi_judge){.groups = groups, .count = count};
  judge->angles = calloc(groups * count, sizeof *judge->angles);
  if (!judge->angles)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a judge of %zu groups", groups);
#pragma omp parallel for schedule(dynamic)
  for (size_t g = 0; g < groups; g++) {
    asp_error own = {.code = ASP_OK};
    fly_both_ways(subject, subject->seed + (uint32_t)g, degrees, count, judge->angles + g * count,
                  &own);
#pragma omp critical
    worst = own.code ? own : worst;
  }
  if (worst.code) {
    aspi_judge_free(judge);
    *error = worst;
  }
  return worst.code;
}
