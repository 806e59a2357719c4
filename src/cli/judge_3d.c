/* The judge in three dimensions; see judge_3d.h. Generated surfaces (WALLS-3D, section 7), exact
 * dilation, exact first hits along the rows, later hits by following each particle over the
 * surface. Nothing of a model is in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/judge_3d.h"
#include "base/stream.h"
#include "spread/field.h"
#include "spread/line.h"
#include "surface/ball.h"

#include <math.h>
#include <stdlib.h>

enum { PER_LAMBDA = 20, HITS_MOST = 64 };

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
static void follow(const aspi_field *field, size_t row, const aspi_spot *spot, double alpha1,
                   judge_angles *angles) {
  size_t at = row * field->columns + spot->face;
  double gradient[2] = {field->p[at], field->q[at]}, tilt = atan(gradient[0]);
  aspi_flight flight = {{spot->x, (double)row * field->step[1], spot->z},
                        {cos(alpha1), 0, -sin(alpha1)}};
  int hits = 1;
  reflect(flight.v, gradient);
  while (hits < HITS_MOST && aspi_field_next(field, &flight, gradient)) {
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

/* All particles of one surface in the direction in which it lies. */
static void fly(const aspi_field *field, const cli_list *alpha1, size_t rays, uint32_t seed,
                judge_angles *angles) {
  asp_error error;
  aspi_line line;
  size_t per_row = (rays + field->rows - 1) / field->rows;
  double *share = malloc(per_row * sizeof *share);
  aspi_spot *spots = malloc(per_row * sizeof *spots);
  if (!share || !spots || aspi_line_create(&line, field->columns, field->step[0], &error))
    cli_fail("out of memory");
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

/* What one surface says. */
static void judge(const judge_case *subject, const cli_list *alpha1, size_t rays, uint32_t seed,
                  judge_angles *angles) {
  const aspi_gauss *wall = &subject->wall;
  size_t side = subject->points;
  asp_error error;
  double c = cos(wall->axis), s = sin(wall->axis), a = 1 / (wall->lambda_1 * wall->lambda_1),
         b = 1 / (wall->lambda_2 * wall->lambda_2);
  double step[2] = {1 / (PER_LAMBDA * sqrt(c * c * a + s * s * b)),
                    1 / (PER_LAMBDA * sqrt(s * s * a + c * c * b))};
  asp_map *map = subject->make ? subject->make(subject, step, side, seed)
                               : aspi_map_create(wall, step, side, side, seed, &error);
  aspi_ball *ball = map ? aspi_ball_create(map, subject->d_p, &error) : NULL;
  aspi_field field;
  if (!ball || aspi_field_create(&field, map, &error))
    cli_fail("%s", error.text);
  aspi_ball_rows(ball, 0, map->rows, field.z, field.p, field.q);
  aspi_ball_free(ball);
  asp_map_free(map);
  aspi_field_finish(&field);
  fly(&field, alpha1, rays / 2, seed, angles);
  aspi_field_turn(&field);
  fly(&field, alpha1, rays / 2, ~seed, angles);
  aspi_field_free(&field);
}

judge_all judge_create(const judge_case *subject, const cli_list *angles, size_t rays,
                       uint32_t seed) {
  size_t surfaces = subject->surfaces;
  judge_all all = {surfaces, angles->count, calloc(surfaces * angles->count, sizeof(judge_angles))};
  if (!all.angles)
    cli_fail("out of memory");
  cli_progress progress = cli_progress_begin("surfaces", (double)surfaces);
  size_t done = 0;
#pragma omp parallel for schedule(dynamic)
  for (size_t k = 0; k < surfaces; k++) {
    judge(subject, angles, rays, seed + (uint32_t)k, all.angles + k * all.count);
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

/* D_KL of all surfaces but one (`out`; none where it is their number) against the model. */
static double divergence_without(const judge_all *all, size_t i, const judge_angles *model,
                                 size_t histogram, size_t out) {
  const double *other = histogram_of(model, histogram);
  double n = 0, sum = 0;
  for (size_t k = 0; k < all->surfaces; k++)
    n += k == out ? 0 : all->angles[k * all->count + i].n;
  for (int bin = 0; bin < JUDGE_BINS; bin++) {
    double count = 0;
    for (size_t k = 0; k < all->surfaces; k++)
      count += k == out ? 0 : histogram_of(&all->angles[k * all->count + i], histogram)[bin];
    if (count > 0)
      sum += count / n * log(count / n * model->n / fmax(other[bin], 0.5));
  }
  return sum;
}

judge_value judge_divergence(const judge_all *all, size_t i, const judge_angles *model,
                             size_t histogram) {
  double n = (double)all->surfaces, mean = 0, square = 0, used = 0;
  const double *other = histogram_of(model, histogram);
  double whole = divergence_without(all, i, model, histogram, all->surfaces);
  for (size_t k = 0; k < all->surfaces; k++) {
    double part = divergence_without(all, i, model, histogram, k);
    mean += part / n;
    square += part * part / n;
  }
  for (int bin = 0; bin < JUDGE_BINS; bin++)
    used += other[bin] > 0;
  judge_value d = {n * whole - (n - 1) * mean - (used - 1) / (2 * model->n),
                   sqrt((n - 1) * fmax(0, square - mean * mean))};
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
