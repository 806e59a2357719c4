/* A dilated wall is made of a profile or a map, and is met by beams.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/field.h"
#include "base/error.h"
#include "surface/ball.h"
#include "surface/rolling.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* A steeper beam is vertical. */
#define FALL_MOST 1e12

/* Points of the path over a profile, unless the profile has more. */
#define ROW_POINTS_MOST ((size_t)131072)

double aspi_fall_least(double r_q, double length) {
  return 16 * r_q / length;
}

/* Lays out the maxima; returns how many there are. */
static size_t lay_out(aspi_field *f, float *room) {
  ptrdiff_t columns = f->columns, rows = f->rows;
  size_t used = 0;
  f->tile = rows > 1 ? 16 : 4;
  f->levels = 0;
  do {
    aspi_tops *at = &f->level[f->levels++];
    columns = (columns + 3) / 4;
    rows = (rows + 3) / 4;
    *at = (aspi_tops){columns, columns * rows, room + used};
    used += (size_t)(at->tiles * f->tile);
  } while (columns > 1 || rows > 1);
  return used;
}

static asp_code create(aspi_field *f, size_t columns, size_t rows, size_t stride,
                       asp_error *error) {
  *f = (aspi_field){.columns = (ptrdiff_t)columns,
                    .rows = (ptrdiff_t)rows,
                    .axes = rows > 1 ? 2 : 1,
                    .stride = (ptrdiff_t)stride};
  float none;
  size_t count = stride * columns * rows + lay_out(f, &none);
  f->z = count <= SIZE_MAX / sizeof(float) ? malloc(count * sizeof(float)) : NULL;
  if (!f->z)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a dilated wall of %zu x %zu points",
                     columns, rows);
  lay_out(f, f->z + stride * columns * rows);
  return ASP_OK;
}

void aspi_field_free(aspi_field *f) {
  free(f->z);
}

/* Computes the maxima over blocks from the maxima of the cells. */
static void fill_tops(aspi_field *f) {
  for (int k = 0; k < f->levels; k++)
    for (ptrdiff_t n = 0; n < f->level[k].tiles; n++) {
      const float *tile = f->level[k].most + n * f->tile;
      float most = tile[0];
      for (ptrdiff_t i = 1; i < f->tile; i++)
        most = tile[i] > most ? tile[i] : most;
      if (k + 1 < f->levels)
        *aspi_field_top(f, k + 1, n % f->level[k].across, n / f->level[k].across) = most;
      else
        f->top = most;
    }
}

/* Fills in the members that follow from the heights. */
static void finish(aspi_field *f) {
  double mean = 0, square = 0, n = (double)(f->columns * f->rows);
  const aspi_tops *last = &f->level[f->levels - 1];
  for (float *top = f->level[0].most; top < last->most + last->tiles * f->tile; top++)
    *top = -FLT_MAX;
  f->cells[0] = f->columns - !f->wraps;
  f->cells[1] = f->rows - !f->wraps;
  f->bottom = INFINITY;
  for (ptrdiff_t j = 0; j < f->rows; j++)
    for (ptrdiff_t i = 0; i < f->columns; i++) {
      aspi_cell c = aspi_cell_at(f, (const ptrdiff_t[2]){i, j});
      if (i < f->cells[0] && j < f->cells[1])
        *aspi_field_top(f, 0, i, j) =
            (float)fmax(fmax(c.z[0], c.z[1]), f->axes > 1 ? fmax(c.z[2], c.z[3]) : -INFINITY);
      f->bottom = fmin(f->bottom, c.z[0]);
      mean += c.z[0] / n;
      square += c.z[0] * c.z[0] / n;
    }
  f->bottom -= f->step[0]; /* clearly below */
  f->fall_least = aspi_fall_least(sqrt(fmax(0, square - mean * mean)), n * f->step[0]);
  fill_tops(f);
}

static asp_code fill_row(aspi_field *f, const asp_heights *profile, double d_p, asp_error *error) {
  asp_error own;
  error = error ? error : &own;
  asp_heights *rolled = NULL; /* a point follows the profile itself */
  if (d_p > 0 && !(rolled = aspi_profile_path(profile, d_p, ROW_POINTS_MOST, error)))
    return error->code;
  const asp_heights *path = rolled ? rolled : profile;
  size_t points = path->columns, n = path->periodic ? points : 2 * points - 2;
  asp_code code = create(f, n, 1, 1, error);
  for (size_t i = 0; i < n && !code; i++)
    f->z[i] = (float)(path->z[i < points ? i : n - i] - path->z[0]);
  f->step[0] = f->step[1] = path->step[0];
  f->wraps = true;
  asp_heights_free(rolled);
  return code;
}

static asp_code fill_map(aspi_field *f, const asp_heights *map, double d_p, const aspi_grid *g,
                         asp_error *error) {
  aspi_ball *ball = aspi_ball_create(map, d_p, error);
  asp_code code = ball ? create(f, g->count[0], g->count[1], 3, error) : ASP_ENOMEM;
  double dx = map->step[0], dy = map->step[1], stride = (double)g->stride;
  f->radius = 0.5 * d_p;
  f->step[0] = dx * stride;
  f->step[1] = dy * stride;
  f->wraps = map->periodic && g->count[0] == map->columns && g->count[1] == map->rows;
  for (ptrdiff_t j = 0; j < f->rows && !code; j++) {
    aspi_ball_search search = aspi_ball_begin(ball);
    for (ptrdiff_t i = 0; i < f->columns; i++) {
      aspi_touch touch = aspi_ball_at(&search, ((double)g->first[0] + stride * (double)i) * dx,
                                      ((double)g->first[1] + stride * (double)j) * dy);
      float *point = f->z + f->stride * (j * f->columns + i);
      point[0] = (float)(touch.height - map->z[0]);
      point[1] = (float)touch.p;
      point[2] = (float)touch.q;
    }
  }
  aspi_ball_free(ball);
  return code;
}

asp_code aspi_field_create(aspi_field *f, const asp_heights *heights, double d_p,
                           const aspi_grid *grid, asp_error *error) {
  *f = (aspi_field){0};
  asp_code code = aspi_check_range(error, "d_p", "", d_p, 0, INFINITY);
  if (!code)
    code = heights->rows > 1 ? fill_map(f, heights, d_p, grid, error)
                             : fill_row(f, heights, d_p, error);
  if (!code)
    finish(f);
  return code;
}

void aspi_field_scale(aspi_field *f, double factor) {
  for (ptrdiff_t i = 0; i < f->stride * f->columns * f->rows; i++)
    f->z[i] = (float)(factor * (double)f->z[i]);
  finish(f);
}

/* ---- the first hits on a row: a path is a constant value of g = z + x fall, and touches where g
 * passes its running maximum ---- */

double aspi_field_slope(const aspi_field *f, size_t i) {
  size_t next = (size_t)aspi_field_next_point((ptrdiff_t)i, f->columns);
  return ((double)f->z[next] - (double)f->z[i]) / f->step[0];
}

double aspi_field_fall(const aspi_field *f, double alpha1) {
  return fmin(fmax(tan(alpha1), f->fall_least), FALL_MOST);
}

void aspi_field_first_hits(const aspi_field *f, double fall, double *weight) {
  double rise = fall * f->step[0], highest = -INFINITY;
  for (ptrdiff_t k = -f->columns; k < f->columns; k++) {
    ptrdiff_t i = k < 0 ? k + f->columns : k;
    double g = f->z[aspi_field_next_point(i, f->columns)] + rise * (double)(k + 1);
    weight[i] = g > highest && k >= 0 ? (g - highest) / (rise * (double)f->columns) : 0;
    highest = g > highest ? g : highest;
  }
}
