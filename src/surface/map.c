/* A map: equally spaced heights over an area.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/map.h"
#include "base/error.h"

#include <gsl/gsl_fft_complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define HEIGHT_MOST 1e30 /* squares of it are numbers in double precision */

float *aspi_map_room(size_t columns, size_t rows) {
  return columns <= SIZE_MAX / sizeof(float) / rows ? malloc(columns * rows * sizeof(float)) : NULL;
}

asp_map *aspi_map_adopt(float *heights, size_t columns, size_t rows, const double step[2],
                        bool periodic, asp_error *error) {
  asp_map *map = heights ? malloc(sizeof *map) : NULL;
  if (!map) {
    free(heights);
    aspi_fail(error, ASP_ENOMEM, "out of memory for a map of %zu x %zu points", columns, rows);
    return NULL;
  }
  *map = (asp_map){columns, rows, {step[0], step[1]}, periodic, heights};
  return map;
}

/* Columns that are gathered, transformed and put back at a time: a cache line. */
enum { GATHERED = 4 };

size_t aspi_fft2_room(size_t rows) {
  return 2 * GATHERED * rows;
}

static void transform(double *data, size_t n, bool backward) {
  if (backward)
    gsl_fft_complex_radix2_backward(data, 1, n);
  else
    gsl_fft_complex_radix2_forward(data, 1, n);
}

void aspi_fft2(double *data, size_t columns, size_t rows, bool backward, double *room) {
  for (size_t j = 0; j < rows; j++)
    transform(data + 2 * j * columns, columns, backward);
  for (size_t i = 0; i < columns; i += GATHERED) {
    for (size_t j = 0; j < rows; j++)
      for (size_t k = 0; k < GATHERED; k++)
        memcpy(room + 2 * (k * rows + j), data + 2 * (j * columns + i + k), 2 * sizeof *data);
    for (size_t k = 0; k < GATHERED; k++)
      transform(room + 2 * k * rows, rows, backward);
    for (size_t j = 0; j < rows; j++)
      for (size_t k = 0; k < GATHERED; k++)
        memcpy(data + 2 * (j * columns + i + k), room + 2 * (k * rows + j), 2 * sizeof *data);
  }
}

asp_map *asp_map_from_heights(const float *heights, size_t columns, size_t rows, double step_x,
                              double step_y, bool periodic, asp_error *error) {
  if (aspi_check_length(error, "step_x", step_x) || aspi_check_length(error, "step_y", step_y))
    return NULL;
  const size_t side[2] = {columns, rows};
  for (int i = 0; i < 2; i++)
    if (!heights || side[i] < ASP_MAP_SIDE_LEAST || side[i] > ASP_MAP_SIDE_MOST) {
      aspi_fail(error, ASP_EARG, "a side of a map has %zu points; it must have %d to %d",
                heights ? side[i] : 0, ASP_MAP_SIDE_LEAST, ASP_MAP_SIDE_MOST);
      return NULL;
    }
  float *copy = aspi_map_room(columns, rows);
  for (size_t i = 0; copy && i < columns * rows; i++) {
    if (!(fabsf(heights[i]) <= HEIGHT_MOST)) {
      aspi_fail(error, ASP_EARG, "height %zu is %g; it must be a number up to %g", i, heights[i],
                HEIGHT_MOST);
      free(copy);
      return NULL;
    }
    copy[i] = heights[i];
  }
  return aspi_map_adopt(copy, columns, rows, (const double[2]){step_x, step_y}, periodic, error);
}

bool aspi_pyramid_create(aspi_pyramid *p, float *points, size_t columns, size_t rows) {
  size_t total = 0;
  *p = (aspi_pyramid){.levels = 1};
  aspi_level *at = p->level;
  *at = (aspi_level){(ptrdiff_t)columns, (ptrdiff_t)rows, points};
  for (; p->levels < ASPI_LEVELS_MOST && (at->columns > 1 || at->rows > 1); p->levels++) {
    at[1] = (aspi_level){(at->columns + 1) / 2, (at->rows + 1) / 2, NULL};
    at++;
    total += (size_t)(at->columns * at->rows);
  }
  return (p->memory = malloc((total + 1) * sizeof *p->memory));
}

void aspi_pyramid_fill(aspi_pyramid *p) {
  float *next = p->memory;
  for (int k = 1; k < p->levels; k++) {
    const aspi_level *below = &p->level[k - 1];
    aspi_level *at = &p->level[k];
    at->most = next;
    for (ptrdiff_t j = 0; j < at->rows; j++) {
      const float *one = below->most + 2 * j * below->columns;
      const float *two = 2 * j + 1 < below->rows ? one + below->columns : one;
      for (ptrdiff_t i = 0; i < at->columns; i++) {
        ptrdiff_t a = 2 * i, b = a + 1 < below->columns ? a + 1 : a;
        *next++ =
            aspi_larger_float(aspi_larger_float(one[a], one[b]), aspi_larger_float(two[a], two[b]));
      }
    }
  }
  p->top = *p->level[p->levels - 1].most;
}

size_t asp_map_columns(const asp_map *map) {
  return map->columns;
}

size_t asp_map_rows(const asp_map *map) {
  return map->rows;
}

double asp_map_step_x(const asp_map *map) {
  return map->step[0];
}

double asp_map_step_y(const asp_map *map) {
  return map->step[1];
}

const float *asp_map_heights(const asp_map *map) {
  return map->heights;
}

void asp_map_free(asp_map *map) {
  if (map)
    free(map->heights);
  free(map);
}
