/* The judge in three dimensions; see judge_3d.h. Generated surfaces, exact
 * dilation, exact first hits along the rows, later hits by following each particle over the
 * surface. Nothing of a model is in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/judge_3d.h"
#include "base/stream.h"
#include "analysis/dilated_map.h"
#include "spread/line.h"
#include "surface/ball.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PER_LAMBDA = 20, HITS_MOST = 64 };

/* Rms heights that a beam must pass, so that its first hits lie on many peaks of a piece. */
#define RISE_LEAST 16

static int bin_of(double degrees) {
  int bin = (int)floor(degrees);
  return bin < 0 ? 0 : bin < JUDGE_BINS ? bin : JUDGE_BINS - 1;
}

void judge_add(judge_angles *a, const double v2[3], double tilt, int hits) {
  double speed = sqrt(v2[0] * v2[0] + v2[1] * v2[1] + v2[2] * v2[2]);
  double rebound = cli_degrees(atan2(v2[2], v2[0])), lateral = cli_degrees(asin(v2[1] / speed));
  a->n++;
  a->rebound[bin_of(rebound)]++;
  a->lateral[bin_of(lateral + 90)]++;
  a->tilt[bin_of(cli_degrees(tilt) + 90)]++;
  a->rebound_sum += rebound;
  a->lateral_sum += lateral;
  a->lateral_square += lateral * lateral;
  a->later += hits > 1;
}

/* The specular rebound from a face with that gradient. */
static void reflect(double v[3], const double gradient[2]) {
  double m[3] = {-gradient[0], -gradient[1], 1};
  double square = 1 + gradient[0] * gradient[0] + gradient[1] * gradient[1];
  double twice = 2 * (v[0] * m[0] + v[1] * m[1] + v[2]) / square;
  for (int k = 0; k < 3; k++)
    v[k] -= twice * m[k];
}

/* One particle from its first hit on. */
static void follow(const aspi_dilated_map *field, size_t row, const aspi_spot *spot, double alpha1,
                   judge_angles *angles) {
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
  judge_add(angles, flight.v, tilt, hits);
}

/* Places in the beam, one in each of `count` equal parts. */
static void draw_places(aspi_stream *stream, double *share, size_t count) {
  for (size_t k = 0; k < count; k++)
    share[k] = ((double)k + aspi_stream_uniform(stream)) / (double)count;
}

/* All particles of one surface in the directions in which its rows lie. */
static void fly(const aspi_dilated_map *field, const cli_list *alpha1, size_t rays, uint32_t seed,
                judge_angles *angles) {
  asp_error error;
  aspi_line line;
  size_t per_row = (rays + field->rows - 1) / field->rows;
  double *share = cli_allocate(per_row, sizeof *share);
  aspi_spot *spots = cli_allocate(per_row, sizeof *spots);
  if (aspi_line_create(&line, field->columns, field->step[0], &error))
    cli_fail("%s", error.text);
  for (size_t row = 0; row < field->rows; row++) {
    aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = seed, .wall = 1, .tag = row});
    aspi_line_set(&line, field->z + row * field->columns, field->p + row * field->columns, 1);
    for (size_t i = 0; i < alpha1->count; i++) {
      draw_places(&stream, share, per_row);
      aspi_line_hits(&line, tan(alpha1->values[i]), share, per_row, spots);
      for (size_t k = 0; k < per_row; k++)
        follow(field, row, &spots[k], alpha1->values[i], &angles[i]);
    }
  }
  free(share);
  free(spots);
  aspi_line_free(&line);
}

/* Horizontal part of a flight that comes straight down: it needs a direction to be followed. */
#define STEEPEST 1e-6

/* One particle in any direction, from the height of the highest point on. */
static void fly_one(const aspi_dilated_map *field, double alpha1, aspi_stream *stream,
                    judge_angles *angles) {
  double x = aspi_stream_uniform(stream) * (double)field->columns * field->step[0];
  double y = aspi_stream_uniform(stream) * (double)field->rows * field->step[1];
  double azimuth = 2 * ASP_PI * aspi_stream_uniform(stream), t[2] = {cos(azimuth), sin(azimuth)};
  double along = fmax(cos(alpha1), STEEPEST), gradient[2], tilt = 0;
  aspi_flight flight = {{x, y, field->top + 1e-3 * field->step[0]},
                        {along * t[0], along * t[1], -sin(alpha1)}};
  int hits = 0;
  while (hits < HITS_MOST && aspi_dilated_map_next(field, &flight, gradient)) {
    if (hits++ == 0)
      tilt = atan(gradient[0] * t[0] + gradient[1] * t[1]);
    reflect(flight.v, gradient);
  }
  const double *v = flight.v;
  judge_add(angles, (double[3]){v[0] * t[0] + v[1] * t[1], v[1] * t[0] - v[0] * t[1], v[2]}, tilt,
            hits);
}

static void fly_around(const aspi_dilated_map *field, const cli_list *alpha1, size_t rays,
                       uint32_t seed, judge_angles *angles) {
  for (size_t i = 0; i < alpha1->count; i++)
    for (size_t k = 0; k < rays; k++) {
      aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = seed, .wall = 2, .tag = k});
      fly_one(field, alpha1->values[i], &stream, &angles[i]);
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
  if (size[0] < ASP_MAP_SIDE_LEAST || size[1] < ASP_MAP_SIDE_LEAST)
    cli_bad_usage("--surfaces: %zu pieces of a map of %zu x %zu points are too many; each must "
                  "have %d points along its sides",
                  2 * count, map->columns, map->rows, ASP_MAP_SIDE_LEAST);
  return part_of(map, from, size, error);
}

asp_map *judge_half(const asp_map *map, size_t half, asp_error *error) {
  return piece_of(map, half, 0, 1, error);
}

double judge_angle_least(const judge_case *subject, double s_q, double lambda_c) {
  const asp_map *map = subject->map;
  double area = (double)map->columns * map->step[0] * (double)map->rows * map->step[1];
  return cli_degrees(atan(RISE_LEAST * s_q * lambda_c * (double)subject->surfaces / area));
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

static asp_map *piece(const judge_case *subject, size_t number, asp_error *error) {
  size_t each = subject->surfaces / 2;
  asp_map *part = piece_of(subject->map, number / each, number % each, each, error);
  asp_map *map = part ? mirrored(part, error) : NULL;
  asp_map_free(part);
  return map;
}

static asp_map *generated(const judge_case *subject, uint32_t seed, asp_error *error) {
  const aspi_gauss *wall = &subject->wall;
  double c = cos(wall->axis), s = sin(wall->axis), a = 1 / (wall->lambda_1 * wall->lambda_1),
         b = 1 / (wall->lambda_2 * wall->lambda_2);
  double step[2] = {1 / (PER_LAMBDA * sqrt(c * c * a + s * s * b)),
                    1 / (PER_LAMBDA * sqrt(s * s * a + c * c * b))};
  return subject->make ? subject->make(subject, step, subject->points, seed)
                       : aspi_map_create(wall, step, subject->points, subject->points, seed, error);
}

/* What one surface says. */
static void judge(const judge_case *subject, const cli_list *alpha1, size_t rays, uint32_t seed,
                  size_t number, judge_angles *angles) {
  asp_error error;
  seed += (uint32_t)number;
  asp_map *map = subject->map ? piece(subject, number, &error) : generated(subject, seed, &error);
  aspi_ball *ball = map ? aspi_ball_create(map, subject->d_p, &error) : NULL;
  aspi_dilated_map field;
  if (!ball || aspi_dilated_map_create(&field, map, &error))
    cli_fail("%s", error.text);
  field.crests = subject->map;
  aspi_ball_rows(ball, 0, map->rows, field.z, field.p, field.q);
  aspi_ball_free(ball);
  asp_map_free(map);
  aspi_dilated_map_finish(&field);
  if (subject->map) {
    fly_around(&field, alpha1, rays, seed, angles);
  } else {
    fly(&field, alpha1, rays / 2, seed, angles);
    aspi_dilated_map_turn(&field);
    fly(&field, alpha1, rays / 2, ~seed, angles);
  }
  aspi_dilated_map_free(&field);
}

judge_all judge_create(const judge_case *subject, const cli_list *angles, size_t rays,
                       uint32_t seed) {
  size_t surfaces = subject->surfaces;
  judge_all all = {surfaces, angles->count, subject->map ? 2 : 1,
                   cli_allocate(surfaces * angles->count, sizeof(judge_angles))};
  cli_progress progress = cli_progress_begin("surfaces", (double)surfaces);
  size_t done = 0;
#pragma omp parallel for schedule(dynamic)
  for (size_t k = 0; k < surfaces; k++) {
    judge(subject, angles, rays, seed, k, all.angles + k * all.count);
#pragma omp critical
    cli_progress_show(&progress, (double)++done);
  }
  cli_progress_end(&progress);
  return all;
}

void judge_free(judge_all *all) {
  free(all->angles);
}

static const double *histogram_of(const judge_angles *angles, size_t offset) {
  return (const double *)(const void *)((const char *)angles + offset);
}

/* D_KL of all surfaces of a fold but one (`out`; none where it is their number) against the model.
 */
static double divergence_of(const judge_all *all, size_t i, size_t fold, const judge_angles *model,
                            size_t histogram, size_t out) {
  const double *other = histogram_of(model, histogram);
  size_t first = all->surfaces * fold / all->folds, end = all->surfaces * (fold + 1) / all->folds;
  double n = 0, sum = 0;
  for (size_t k = first; k < end; k++)
    n += k == out ? 0 : all->angles[k * all->count + i].n;
  for (int bin = 0; bin < JUDGE_BINS; bin++) {
    double count = 0;
    for (size_t k = first; k < end; k++)
      count += k == out ? 0 : histogram_of(&all->angles[k * all->count + i], histogram)[bin];
    if (count > 0)
      sum += count / n * log(count / n * model->n / fmax(other[bin], 0.5));
  }
  return sum;
}

/* Of one fold, by the jackknife, less the bias of the model's sampling. */
static judge_value divergence_of_fold(const judge_all *all, size_t i, size_t fold,
                                      const judge_angles *model, size_t histogram) {
  size_t first = all->surfaces * fold / all->folds, end = all->surfaces * (fold + 1) / all->folds;
  double n = (double)(end - first), mean = 0, square = 0, used = 0;
  double whole = divergence_of(all, i, fold, model, histogram, all->surfaces);
  for (size_t k = first; k < end; k++) {
    double part = divergence_of(all, i, fold, model, histogram, k);
    mean += part / n;
    square += part * part / n;
  }
  for (int bin = 0; bin < JUDGE_BINS; bin++)
    used += histogram_of(model, histogram)[bin] > 0;
  return (judge_value){n * whole - (n - 1) * mean - (used - 1) / (2 * model->n),
                       sqrt((n - 1) * fmax(0, square - mean * mean))};
}

judge_value judge_divergence(const judge_all *all, size_t i, const judge_angles *models,
                             size_t histogram) {
  judge_value d = {0, 0};
  double folds = (double)all->folds;
  for (size_t fold = 0; fold < all->folds; fold++) {
    judge_value of = divergence_of_fold(all, i, fold, &models[fold], histogram);
    d.value += of.value / folds;
    d.se = hypot(d.se, of.se / folds);
  }
  return d;
}

judge_value judge_mean(const judge_all *all, size_t i, size_t sum) {
  double n = (double)all->surfaces, mean = 0, square = 0;
  for (size_t k = 0; k < all->surfaces; k++) {
    const judge_angles *a = &all->angles[k * all->count + i];
    double value = *histogram_of(a, sum) / a->n;
    mean += value / n;
    square += value * value / n;
  }
  return (judge_value){mean, sqrt(fmax(0, square - mean * mean) / (n - 1))};
}
