/* Maps inside the core.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SURFACE_MAP_H
#define ASP_SURFACE_MAP_H

#include "asperity_internal.h"

/* Row after row, x along a row. Single precision: a map is large, and no instrument has seven
 * digits. A periodic map repeats in both directions; any other ends at its edges. */
struct asp_map {
  size_t columns, rows;
  double step[2]; /* between columns, between rows */
  bool periodic;
  float *heights;
};

enum { ASP_MAP_SIDE_LEAST = 4, ASP_MAP_SIDE_MOST = 65536 };

/* A map that takes over `heights` (from malloc; NULL counts as out of memory), and frees them when
 * it fails. */
asp_map *aspi_map_adopt(float *heights, size_t columns, size_t rows, const double step[2],
                        bool periodic, asp_error *error);

/* GSL's complex FFT over rows and columns of 2^k points each, in place and without a norm; backward
 * with the positive sign. `room` is for aspi_fft2_room(rows) numbers. */
size_t aspi_fft2_room(size_t rows);
void aspi_fft2(double *data, size_t columns, size_t rows, bool backward, double *room);

/* Uninitialized room for the points of a map of that size, or NULL. */
float *aspi_map_room(size_t columns, size_t rows);

/* Maxima over blocks of points, to find what is high without a look at each: level k has one for
 * each block of 2^k x 2^k points, row after row; level 0 is the points themselves. */
enum { ASPI_LEVELS_MOST = 20 };
typedef struct aspi_level {
  ptrdiff_t columns, rows;
  const float *most;
} aspi_level;
typedef struct aspi_pyramid {
  int levels;
  aspi_level level[ASPI_LEVELS_MOST];
  float *memory; /* of the levels above 0; for the caller to free */
  double top;    /* the maximum of all points */
} aspi_pyramid;

/* Room for the maxima over an array of columns x rows points; false: out of memory. Then the
 * maxima, and again where the points have changed. */
bool aspi_pyramid_create(aspi_pyramid *pyramid, float *points, size_t columns, size_t rows);
void aspi_pyramid_fill(aspi_pyramid *pyramid);

static inline float aspi_larger_float(float a, float b) {
  return a > b ? a : b;
}

#endif
