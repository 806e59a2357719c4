/* The dilated wall that a sphere flies over: heights of its center, and their maxima over blocks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "surface/heights.h"

/* Maxima over blocks of cells, so that a flight can skip cells: level k has one maximum per block
 * of 4^k x 4^k cells. A tile of 4 x 4 blocks is contiguous in memory. */
typedef struct aspi_tops {
  ptrdiff_t across, tiles; /* number of tiles along x, and of all */
  float *most;
} aspi_tops;

enum { ASPI_TOPS_MOST = 32 };

/* Heights of the center of a sphere that rests on the wall (the dilated wall), bilinear between
 * points. A profile is one row: faces between points, along x alone. */
typedef struct aspi_field {
  ptrdiff_t columns, rows, cells[2]; /* cells between points along x and y */
  int axes;                          /* 1 for one row, else 2 */
  double step[2];
  double radius;    /* of the sphere; for kinks */
  bool wraps;       /* repeats beyond its edges */
  ptrdiff_t stride; /* numbers per point: 1, or 3 with the gradient of the contact */
  float *z;         /* numbers of all points, row after row; then the maxima */
  ptrdiff_t tile;   /* blocks in a tile: 16, or 4 of one row */
  int levels;
  aspi_tops level[ASPI_TOPS_MOST];
  double top;        /* the highest point */
  double bottom;     /* a height below all points */
  double fall_least; /* beams are followed no flatter than this; see aspi_fall_least */
} aspi_field;

/* The slope at which a beam falls by 16 rms heights over this length, so that its first hits lie on
 * many peaks. */
double aspi_fall_least(double r_q, double length);

/* The length of a side. */
static inline double aspi_field_length(const aspi_field *field, int axis) {
  return (double)field->cells[axis] * field->step[axis];
}

/* False: the gradient at a hit comes from the heights. */
static inline bool aspi_field_has_gradients(const aspi_field *field) {
  return field->stride > 1;
}

/* Points of a map: every `stride`th of each side, from `first` on. */
typedef struct aspi_grid {
  size_t stride, first[2], count[2];
} aspi_grid;

/* The dilation of a profile by a disc of diameter d_p, or of a map at the points of a grid (which
 * counts for maps only) by a sphere: from 0 to the shorter side. A measured profile continues as
 * its mirror image; a map repeats if it is periodic and all of its points are there. */
asp_code aspi_field_create(aspi_field *field, const asp_heights *heights, double d_p,
                           const aspi_grid *grid, asp_error *error);
void aspi_field_free(aspi_field *field);

/* Multiplies the heights of a row. */
void aspi_field_scale(aspi_field *row, double factor);

/* For a row: the slope of the face behind point i; the slope tan(alpha1) at which a beam falls, at
 * least aspi_fall_least; and the share of the beam that first hits each face, into weight[columns],
 * sum 1: the rise of the running maximum of z + x fall over the face, in the second of two periods.
 */
double aspi_field_slope(const aspi_field *field, size_t i);
double aspi_field_fall(const aspi_field *field, double alpha1);
void aspi_field_first_hits(const aspi_field *field, double fall, double *weight);

/* Point k along a side of n; the last cell of a side that repeats ends at the first point. */
static inline ptrdiff_t aspi_field_next_point(ptrdiff_t k, ptrdiff_t n) {
  return k + 1 < n ? k + 1 : 0;
}

/* A cell: its first corner, and the points and heights of all corners. */
typedef struct aspi_cell {
  double at[2];
  const float *point[4];
  double z[4];
} aspi_cell;

static inline aspi_cell aspi_cell_at(const aspi_field *f, const ptrdiff_t at[2]) {
  const float *one = f->z + f->stride * f->columns * at[1];
  ptrdiff_t i = f->stride * at[0], k = f->stride * aspi_field_next_point(at[0], f->columns);
  aspi_cell c = {{(double)at[0], (double)at[1]}, {one + i, one + k}, {one[i], one[k]}};
  if (f->axes > 1) {
    const float *two = f->z + f->stride * f->columns * aspi_field_next_point(at[1], f->rows);
    c.point[2] = two + i;
    c.point[3] = two + k;
    c.z[2] = two[i];
    c.z[3] = two[k];
  }
  return c;
}

/* The maximum over a block of cells. */
static inline float *aspi_field_top(const aspi_field *f, int level, ptrdiff_t i, ptrdiff_t j) {
  const aspi_tops *of = &f->level[level];
  if (f->axes == 1) /* tiles of one row are in order */
    return of->most + i;
  return of->most + ((j >> 2) * of->across + (i >> 2)) * f->tile + 4 * (j & 3) + (i & 3);
}
