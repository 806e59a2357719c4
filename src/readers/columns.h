/* Which columns of a text have positions and heights, and in what units.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/table.h"
#include "readers/points.h"

#define ASK_COLUMNS                                                                                \
  "say which columns are positions and heights (asperity surface --x-column 1 --column 2), "       \
  "or the step of heights alone (--step 0.5um)"
#define DECIMAL_COMMAS                                                                             \
  "are there decimal commas? Separate columns by semicolons or tabs, or write decimal points"

enum { X, Y, Z, VALID, AXES };

/* A text that is being read. */
typedef struct aspi_columns {
  aspi_table *table;
  const aspi_profile_options *options;
  int column[AXES];                 /* from 0, -1 if there is none; of a matrix Z is -1 */
  double unit[3];                   /* m; < 0 for depths */
  double step[2];                   /* m, as the user or the file states it; 0: it is not stated */
  double known_unit;                /* of the heights, by the format; 0: unknown */
  double value[3];                  /* of the current row in those columns, not in a matrix */
  int due;                          /* fields of a row */
  size_t stated;                    /* rows by the header, 0: it does not say */
  size_t left, left_line, end_line; /* lines with digits behind the rows, and where they end */
  size_t traces;                    /* of a profile: blocks whose positions begin anew */
  double first, last; /* position of the current one's first row, and of the last row */
  aspi_missing missing;
} aspi_columns;

/* Chooses the columns and their units: by what the user asks for, by their names, or by guess. */
asp_code aspi_columns_choose(aspi_columns *r, bool is_map, asp_error *error);
