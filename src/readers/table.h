/* Numbers in columns of a text: a header of any kind, lines of numbers, then lines of any other
 * kind. The names right above the numbers, or the user, say which columns hold positions and
 * heights, and in which units.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_TABLE_H
#define ASP_READERS_TABLE_H

#include "readers/read.h"

typedef struct aspi_field {
  const char *text;
  double value; /* NAN where it is missing */
  aspi_word kind;
} aspi_field;

typedef struct aspi_table {
  aspi_text text;
  char separator;     /* , ; tab, or a blank for any white space */
  aspi_field *fields; /* of the line at hand */
  int count, due,
      raw;         /* fields of the line; of the first line, without empty ones behind, and all */
  size_t lines;    /* of numbers, with the one at hand */
  size_t end_line; /* where the data end before the file does; 0: nowhere */
  char above[2][ASP_TEXT_MOST]; /* the lines right above the numbers, the nearest first */
  double side[2], unit;         /* m, as Gwyddion states them of a matrix; 0: it does not */
  char *line;
  size_t line_room;
  int room;
} aspi_table;

/* Columns of X, Y and heights, from 0, -1 where there is none; their units in m. */
typedef struct aspi_axes {
  int column[3];
  double unit[3]; /* < 0 for depths */
} aspi_axes;

/* Opens a text at its beginning and reads up to the first line that begins with `least` numbers. */
asp_code aspi_table_open(const aspi_text *text, int least, aspi_table **table, asp_error *error);
void aspi_table_close(aspi_table *table);

/* Finds the columns. In a profile X is -1 if its step is given, and Y is a column if positions are
 * distances in both. A map of heights in all columns is a matrix. */
asp_code aspi_table_find(aspi_table *table, const aspi_profile_options *options, bool is_map,
                         aspi_axes *axes, bool *is_matrix, asp_error *error);

/* Checks the line at hand, and reads on to the next one with numbers in those columns (NULL: in
 * all), where heights may be missing; *found is false behind the last one. */
asp_code aspi_table_check(aspi_table *table, const aspi_axes *axes, asp_error *error);
asp_code aspi_table_next(aspi_table *table, const aspi_axes *axes, bool *found, asp_error *error);

#endif
