/* The judge in three dimensions; see judge_3d.h. Exact dilation, exact first hits along the rows,
 * later hits by following each particle over the surface. Nothing of a model is in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "judge_3d.h"
#include "base/units.h"
#include "base/error.h"
#include "base/stream.h"
#include "dilated_map.h"
#include "spread/line.h"
#include "surface/ball.h"

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

/* One particle from its first hit on. */
static void fly_on(const aspi_dilated_map *field, const surfaces *subject, size_t row,
                   const line_spot *spot, double alpha1, aspi_angles *angles) {
  size_t at = row * field->columns + spot->face;
  double gradient[2] = {field->p[at], field->q[at]}, tilt = atan(gradient[0]);
  double speed = subject->law ? subject->speed : 1;
  aspi_flight flight = {{spot->x, (double)row * field->step[1], spot->z},
                        {speed * cos(alpha1), 0, -speed * sin(alpha1)}};
  int hits = 0;
  do {
    if (!subject->law)
      reflect(flight.v, gradient);
    else if (!rebound(subject, flight.v, gradient))
      return;
  } while (++hits < HITS_MOST && aspi_dilated_map_next(field, &flight, gradient));
  aspi_angles_add(angles, flight.v, tilt, hits);
}

/* Places in the beam, one in each of `count` equal parts. */
static void draw_places(aspi_stream *stream, double *share, size_t count) {
  for (size_t k = 0; k < count; k++)
    share[k] = ((double)k + aspi_stream_uniform(stream)) / (double)count;
}

/* All particles of one surface in the directions in which its rows lie. */
/* The maximum of g over the period before the one that begins with face 0. */
static double highest_before(const aspi_line *line, double fall) {
  double highest = -INFINITY, period = line->step * (double)line->n;
  for (size_t i = 0; i < line->n; i++) {
    double g = line->end_z[i] + fall * (line->end_x[i] - period);
    highest = g > highest ? g : highest;
  }
  return highest;
}

void line_hits(const aspi_line *line, double fall, const double *share, size_t count,
               line_spot *spots) {
  double rise = fall * line->step * (double)line->n, first = highest_before(line, fall);
  size_t k = 0, n = line->n;
  for (size_t i = 0; i < n && k < count; i++) {
    double g = line->end_z[i] + fall * line->end_x[i];
    for (; k < count && first + share[k] * rise <= g; k++) {
      /* On the face, back from its end. */
      double back = (g - first - share[k] * rise) / (line->slope[i] + fall);
      spots[k] = (line_spot){i, line->end_x[i] - back, line->end_z[i] - line->slope[i] * back};
    }
  }
  for (; k < count; k++)
    spots[k] = (line_spot){n - 1, line->end_x[n - 1], line->end_z[n - 1]};
}

static asp_code fly(const aspi_dilated_map *field, const surfaces *subject, const double *degrees,
                    size_t count, uint32_t seed, aspi_angles *angles, asp_error *error) {
  aspi_line line;
  size_t per_row = (subject->rays / 2 + field->rows - 1) / field->rows;
  asp_code code = aspi_line_create(&line, field->columns, field->step[0], error);
  if (code)
    return code;
  double *share = calloc(per_row, sizeof *share);
  line_spot *spots = calloc(per_row, sizeof *spots);
  if (!share || !spots)
    code = aspi_fail(error, ASP_ENOMEM, "out of memory for %zu flights a row", per_row);
  for (size_t row = 0; row < field->rows && !code; row++) {
    aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = seed, .wall = 1, .tag = row});
    aspi_line_set(&line, field->z + row * field->columns, field->p + row * field->columns, 1);
    for (size_t i = 0; i < count; i++) {
      double alpha1 = aspi_radians(degrees[i]);
      draw_places(&stream, share, per_row);
      line_hits(&line, tan(alpha1), share, per_row, spots);
      for (size_t k = 0; k < per_row; k++)
        fly_on(field, subject, row, &spots[k], alpha1, &angles[i]);
    }
  }
  free(share);
  free(spots);
  aspi_line_free(&line);
  return code;
}

static asp_map *generated(const surfaces *subject, uint32_t seed, asp_error *error) {
  const gauss_wall *wall = &subject->wall;
  double c = cos(wall->axis), s = sin(wall->axis), a = 1 / (wall->lambda_1 * wall->lambda_1),
         b = 1 / (wall->lambda_2 * wall->lambda_2);
  double step[2] = {1 / (PER_LAMBDA * sqrt(c * c * a + s * s * b)),
                    1 / (PER_LAMBDA * sqrt(s * s * a + c * c * b))};
  return subject->make
             ? subject->make(subject, step, subject->points, seed)
             : gauss_map_create(wall, step, subject->points, subject->points, seed, error);
}

/* The path of the sphere's center over one of the surfaces. */
static asp_code make_field(aspi_dilated_map *field, const surfaces *subject, uint32_t seed,
                           asp_error *error) {
  asp_map *map = generated(subject, seed, error);
  aspi_ball *ball = map ? aspi_ball_create(map, subject->d_p, error) : NULL;
  asp_code code = ball ? aspi_dilated_map_create(field, map, error) : error->code;
  if (!code) {
    field->crests = subject->crests;
    aspi_ball_rows(ball, 0, map->rows, field->z, field->p, field->q);
    aspi_dilated_map_finish(field);
  }
  aspi_ball_free(ball);
  asp_map_free(map);
  return code;
}

static asp_code fly_both_ways(const surfaces *subject, uint32_t seed, const double *degrees,
                              size_t count, aspi_angles *angles, asp_error *error) {
  aspi_dilated_map field;
  asp_code code = make_field(&field, subject, seed, error);
  if (code)
    return code;
  code = fly(&field, subject, degrees, count, seed, angles, error);
  aspi_dilated_map_turn(&field);
  if (!code)
    code = fly(&field, subject, degrees, count, ~seed, angles, error);
  aspi_dilated_map_free(&field);
  return code;
}

asp_code judge_in_space(aspi_judge *judge, const surfaces *subject, const double *degrees,
                        size_t count, asp_error *error) {
  size_t groups = subject->groups;
  asp_error worst = {ASP_OK, ""};
  *judge = (aspi_judge){.groups = groups, .count = count, .folds = 1};
  judge->angles = calloc(groups * count, sizeof *judge->angles);
  if (!judge->angles)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a judge of %zu groups", groups);
#pragma omp parallel for schedule(dynamic)
  for (size_t g = 0; g < groups; g++) {
    asp_error own = {ASP_OK, ""};
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
