/* Points of a map in any order, put on the grid that they are on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/read.h"
#include "surface/heights.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* x and y of a point of a grid are off it by no more than this part of the spacing. */
#define OFF_GRID 0.2

asp_code aspi_map_points_add(aspi_map_points *t, const double point[ASP_MAP_AXES],
                             asp_error *error) {
  if (t->count == t->room) {
    size_t room = t->room ? t->room + t->room / 2 : 65536;
    double(*grown)[ASP_MAP_AXES] =
        room <= SIZE_MAX / sizeof *grown ? realloc(t->at, room * sizeof *grown) : NULL;
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM, "out of memory for a map of over %zu points", t->count);
    t->at = grown;
    t->room = room;
  }
  memcpy(t->at[t->count++], point, sizeof *t->at);
  return ASP_OK;
}

/* The grid along one axis. */
typedef struct grid {
  double first, step;
  size_t count;
} grid;

/* Differences of two coordinates below this part of the step (of a square grid with the same number
 * of points) are rounding, not a step of the grid. */
#define GRID_PART (1 / 32.)

/* The grid along one axis: from the least to the greatest coordinate, by the mean of the steps
 * between neighbors. `room` is for all coordinates. */
static bool find_grid(const aspi_map_points *t, int axis, double *room, grid *g) {
  for (size_t i = 0; i < t->count; i++)
    room[i] = t->at[i][axis];
  gsl_sort(room, 1, t->count);
  double range = room[t->count - 1] - room[0], small = INFINITY, sum = 0, used = 0;
  double none = GRID_PART * range / sqrt((double)t->count);
  for (size_t i = 1; i < t->count; i++)
    if (room[i] - room[i - 1] > none)
      small = fmin(small, room[i] - room[i - 1]);
  for (size_t i = 1; i < t->count; i++) {
    double d = room[i] - room[i - 1];
    if (d > none && d < 1.5 * small) {
      sum += d;
      used++;
    }
  }
  if (!(used > 0))
    return false;
  double steps = round(range / (sum / used));
  *g = (grid){room[0], range / steps, (size_t)fmin(steps, 1e9) + 1};
  return true;
}

/* The grids along x and y, and room for the heights on them, which are all missing yet. */
static asp_code find_grids(const aspi_map_points *t, const char *path, grid g[2], aspi_raw *raw,
                           asp_error *error) {
  double *room = aspi_allocate(t->count);
  if (!room)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a map of %zu points", t->count);
  int axis = 0;
  while (axis < 2 && find_grid(t, axis, room, &g[axis]))
    axis++;
  free(room);
  if (axis < 2)
    return aspi_fail(error, ASP_EDATA, "%.200s: the %s of its points are on no grid of equal steps",
                     path, axis ? "y" : "x");
  raw->columns = g[0].count;
  raw->rows = g[1].count;
  if ((double)raw->columns * (double)raw->rows > 4 * (double)t->count + 1e4)
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: its %zu points fill less than a quarter of their grid of %zu x %zu",
                     path, t->count, raw->columns, raw->rows);
  raw->z = aspi_allocate(raw->columns * raw->rows);
  if (!raw->z)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a map of %zu x %zu points", raw->columns,
                     raw->rows);
  raw->points = raw->room = raw->columns * raw->rows;
  for (size_t i = 0; i < raw->points; i++)
    raw->z[i] = NAN;
  return ASP_OK;
}

asp_code aspi_map_points_place(const aspi_map_points *t, const char *path,
                               const double unit[ASP_MAP_AXES], aspi_raw *raw, asp_error *error) {
  grid g[2];
  asp_code code = find_grids(t, path, g, raw, error);
  for (size_t i = 0; i < t->count && !code; i++) {
    const double *at = t->at[i];
    double u = (at[0] - g[0].first) / g[0].step, v = (at[1] - g[1].first) / g[1].step;
    double column = round(u), row = round(v);
    if (fabs(u - column) > OFF_GRID || fabs(v - row) > OFF_GRID)
      return aspi_fail(error, ASP_EDATA,
                       "%.200s: point %zu, at x %g, y %g, is off the grid of %g x %g that the "
                       "others are on",
                       path, i + 1, at[0], at[1], g[0].step, g[1].step);
    raw->z[(size_t)row * raw->columns + (size_t)column] = at[2] * unit[2];
  }
  for (int k = 0; k < 2 && !code; k++)
    raw->step[k] = g[k].step * unit[k];
  return code;
}
