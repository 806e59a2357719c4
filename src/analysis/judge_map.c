/* The judge in three dimensions: generated surfaces, or the pieces of a map; see judge.h. Exact
 * dilation, exact first hits along the rows, later hits by following each particle over the
 * surface. Nothing of a model is in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/dilated_map.h"
#include "analysis/judge.h"
#include "base/error.h"
#include "base/stream.h"
#include "spread/line.h"
#include "surface/ball.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PER_LAMBDA = 20, HITS_MOST = 64 };

/* The specular rebound from a face with that gradient. */
static void reflect(double v[3], const double gradient[2]) {
  double m[3] = {-gradient[0], -gradient[1], 1};
  double square = 1 + gradient[0] * gradient[0] + gradient[1] * gradient[1];
  double twice = 2 * (v[0] * m[0] + v[1] * m[1] + v[2]) / square;
  for (int k = 0; k < 3; k++)
    v[k] -= twice * m[k];
}

/* One particle from its first hit on. */
static void fly_on(const aspi_dilated_map *field, size_t row, const aspi_spot *spot, double alpha1,
                   aspi_angles *angles) {
  size_t at = row * field->columns + spot->face;
  double gradient[2] = {field->p[at], field->q[at]}, tilt = atan(gradient[0]);
  aspi_flight flight = {{spot->x, (double)row * field->step[1], spot->z},
                        {cos(alpha1), 0, -sin(alpha1)}};
  int hits = 1;
  reflect(flight.v, gradient);
  while (hits < HITS_MOST && aspi_dilated_map_next(field, &flight, gradient)) {
    reflect(flight.v, gradient);
    hits++;
  }
  aspi_angles_add(angles, flight.v, tilt, hits);
}

/* Places in the beam, one in each of `count` equal parts. */
static void draw_places(aspi_stream *stream, double *share, size_t count) {
  for (size_t k = 0; k < count; k++)
    share[k] = ((double)k + aspi_stream_uniform(stream)) / (double)count;
}

/* All particles of one surface in the directions in which its rows lie. */
static asp_code fly(const aspi_dilated_map *field, const double *degrees, size_t count, size_t rays,
                    uint32_t seed, aspi_angles *angles, asp_error *error) {
  aspi_line line;
  size_t per_row = (rays + field->rows - 1) / field->rows;
  asp_code code = aspi_line_create(&line, field->columns, field->step[0], error);
  if (code)
    return code;
  double *share = calloc(per_row, sizeof *share);
  aspi_spot *spots = calloc(per_row, sizeof *spots);
  if (!share || !spots)
    code = aspi_fail(error, ASP_ENOMEM, "out of memory for %zu flights a row", per_row);
  for (size_t row = 0; row < field->rows && !code; row++) {
    aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = seed, .wall = 1, .tag = row});
    aspi_line_set(&line, field->z + row * field->columns, field->p + row * field->columns, 1);
    for (size_t i = 0; i < count; i++) {
      double alpha1 = aspi_radians(degrees[i]);
      draw_places(&stream, share, per_row);
      aspi_line_hits(&line, tan(alpha1), share, per_row, spots);
      for (size_t k = 0; k < per_row; k++)
        fly_on(field, row, &spots[k], alpha1, &angles[i]);
    }
  }
  free(share);
  free(spots);
  aspi_line_free(&line);
  return code;
}

/* Horizontal part of a flight that comes straight down: it needs a direction to be followed. */
#define STEEPEST 1e-6

/* One particle in any direction, from the height of the highest point on. */
static void fly_one(const aspi_dilated_map *field, double alpha1, aspi_stream *stream,
                    aspi_angles *angles) {
  double x = aspi_stream_uniform(stream) * (double)field->columns * field->step[0];
  double y = aspi_stream_uniform(stream) * (double)field->rows * field->step[1];
  double azimuth = 2 * ASP_PI * aspi_stream_uniform(stream), t[2] = {cos(azimuth), sin(azimuth)};
  double along = fmax(cos(alpha1), STEEPEST), gradient[2], tilt = 0;
  aspi_flight flight = {{x, y, field->pyramid.top + 1e-3 * field->step[0]},
                        {along * t[0], along * t[1], -sin(alpha1)}};
  int hits = 0;
  while (hits < HITS_MOST && aspi_dilated_map_next(field, &flight, gradient)) {
    if (hits++ == 0)
      tilt = atan(gradient[0] * t[0] + gradient[1] * t[1]);
    reflect(flight.v, gradient);
  }
  const double *v = flight.v;
  aspi_angles_add(angles, (double[3]){v[0] * t[0] + v[1] * t[1], v[1] * t[0] - v[0] * t[1], v[2]},
                  tilt, hits);
}

static void fly_around(const aspi_dilated_map *field, const double *degrees, size_t count,
                       size_t rays, uint32_t seed, aspi_angles *angles) {
  for (size_t i = 0; i < count; i++)
    for (size_t k = 0; k < rays; k++) {
      aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = seed, .wall = 2, .tag = k});
      fly_one(field, aspi_radians(degrees[i]), &stream, &angles[i]);
    }
}

/* A rectangle of a map, from a column and a row on. */
static asp_map *part_of(const asp_map *map, const size_t from[2], const size_t size[2],
                        asp_error *error) {
  float *heights = aspi_map_room(size[0], size[1]);
  for (size_t j = 0; heights && j < size[1]; j++)
    memcpy(heights + j * size[0], map->heights + (from[1] + j) * map->columns + from[0],
           size[0] * sizeof *heights);
  return aspi_map_adopt(heights, size[0], size[1], map->step, false, error);
}

/* The axis along which a map is longer. */
static int long_axis(const asp_map *map) {
  return (double)map->rows * map->step[1] > (double)map->columns * map->step[0];
}

/* Part `number` of `count` of a map's half: strips along its longer side. */
static asp_map *piece_of(const asp_map *map, size_t half, size_t number, size_t count,
                         asp_error *error) {
  int axis = long_axis(map);
  size_t whole[2] = {map->columns, map->rows}, from[2], size[2];
  size[axis] = whole[axis] / 2;
  from[axis] = half ? whole[axis] - size[axis] : 0;
  size[!axis] = whole[!axis] / count;
  from[!axis] = number * size[!axis];
  if (size[0] < ASP_MAP_SIDE_LEAST || size[1] < ASP_MAP_SIDE_LEAST) {
    aspi_fail(error, ASP_EARG,
              "surfaces is %zu, too many pieces of a map of %zu x %zu points; each must have %d "
              "points along its sides",
              2 * count, map->columns, map->rows, ASP_MAP_SIDE_LEAST);
    return NULL;
  }
  return part_of(map, from, size, error);
}

asp_map *aspi_judge_map_half(const asp_map *map, size_t half, asp_error *error) {
  return piece_of(map, half, 0, 1, error);
}

double aspi_judge_map_angle_least(const aspi_judge_case *subject) {
  const asp_map *map = subject->map;
  double area = (double)map->columns * map->step[0] * (double)map->rows * map->step[1];
  double rise = ASPI_RISE_LEAST * subject->wall.r_q * subject->wall.lambda_1;
  return aspi_degrees(atan(rise * (double)subject->groups / area));
}

/* A map and its mirror images, which repeat without a step. */
static asp_map *mirrored(const asp_map *map, asp_error *error) {
  size_t columns = 2 * map->columns - 2, rows = 2 * map->rows - 2;
  float *heights = aspi_map_room(columns, rows);
  for (size_t j = 0; heights && j < rows; j++)
    for (size_t i = 0; i < columns; i++) {
      size_t row = j < map->rows ? j : rows - j, column = i < map->columns ? i : columns - i;
      heights[j * columns + i] = map->heights[row * map->columns + column];
    }
  return aspi_map_adopt(heights, columns, rows, map->step, true, error);
}

static asp_map *piece(const aspi_judge_case *subject, size_t number, asp_error *error) {
  size_t each = subject->groups / 2;
  asp_map *part = piece_of(subject->map, number / each, number % each, each, error);
  asp_map *map = part ? mirrored(part, error) : NULL;
  asp_map_free(part);
  return map;
}

static asp_map *generated(const aspi_judge_case *subject, uint32_t seed, asp_error *error) {
  const aspi_gauss *wall = &subject->wall;
  double c = cos(wall->axis), s = sin(wall->axis), a = 1 / (wall->lambda_1 * wall->lambda_1),
         b = 1 / (wall->lambda_2 * wall->lambda_2);
  double step[2] = {1 / (PER_LAMBDA * sqrt(c * c * a + s * s * b)),
                    1 / (PER_LAMBDA * sqrt(s * s * a + c * c * b))};
  return subject->make ? subject->make(subject, step, subject->points, seed)
                       : aspi_map_create(wall, step, subject->points, subject->points, seed, error);
}

/* The path of the sphere's center over one of the surfaces. */
static asp_code make_field(aspi_dilated_map *field, const aspi_judge_case *subject, uint32_t seed,
                           size_t number, asp_error *error) {
  asp_map *map = subject->map ? piece(subject, number, error) : generated(subject, seed, error);
  aspi_ball *ball = map ? aspi_ball_create(map, subject->d_p, error) : NULL;
  asp_code code = ball ? aspi_dilated_map_create(field, map, error) : error->code;
  if (!code) {
    field->crests = subject->map;
    aspi_ball_rows(ball, 0, map->rows, field->z, field->p, field->q);
    aspi_dilated_map_finish(field);
  }
  aspi_ball_free(ball);
  asp_map_free(map);
  return code;
}

asp_code aspi_judge_fly_surface(aspi_judge *judge, const aspi_judge_case *subject,
                                const double *degrees, size_t number, asp_error *error) {
  uint32_t seed = subject->seed + (uint32_t)number;
  size_t rays = subject->rays, count = judge->count;
  aspi_angles *angles = judge->angles + number * count;
  aspi_dilated_map field;
  asp_code code = make_field(&field, subject, seed, number, error);
  if (code)
    return code;
  if (subject->map) {
    fly_around(&field, degrees, count, rays, seed, angles);
  } else {
    code = fly(&field, degrees, count, rays / 2, seed, angles, error);
    aspi_dilated_map_turn(&field);
    if (!code)
      code = fly(&field, degrees, count, rays / 2, ~seed, angles, error);
  }
  aspi_dilated_map_free(&field);
  return code;
}
