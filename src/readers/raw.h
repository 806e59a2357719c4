/* Heights as a file has them, row by row; a profile is one row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_RAW_H
#define ASP_READERS_RAW_H

#include "asperity.h"

/* NAN where a height is bad or missing. Memory grows with what is read, so that a header's counts
 * alone allocate nothing. */
typedef struct aspi_raw {
  void *heights; /* m; doubles, or of a map floats over its first good height, `zero` */
  bool is_map;
  size_t points, room, columns, rows;
  double step[2];   /* m, between columns and rows; of a profile the first alone */
  double zero;      /* NAN before the first good height */
  size_t read, bad; /* points in the file, and the bad ones of them */
  size_t bad_line;  /* where the first bad point or gap is; 0: not known */
  bool resampled;
  size_t repeats;               /* positions that repeat the one before */
  bool falls;                   /* positions fall in the file */
  int column[2];                /* of positions and heights, from 1, where there are others too */
  int second_column;            /* of Y, where positions are distances in X and Y; else 0 */
  size_t end_line;              /* where the data end before the file does; 0: nowhere */
  double step_least, step_most; /* m */
} aspi_raw;

static inline double aspi_raw_at(const aspi_raw *raw, size_t i) {
  return raw->is_map ? (double)((const float *)raw->heights)[i] : ((const double *)raw->heights)[i];
}

static inline void aspi_raw_put(aspi_raw *raw, size_t i, double height) {
  if (raw->is_map)
    ((float *)raw->heights)[i] = (float)height;
  else
    ((double *)raw->heights)[i] = height;
}

/* Adds a height (m). */
asp_code aspi_raw_add(aspi_raw *raw, double height, asp_error *error);

size_t aspi_raw_count_bad(const aspi_raw *raw);

/* The least and the greatest good height; *least > *most where there is none. */
void aspi_raw_range(const aspi_raw *raw, double *least, double *most);

#endif
