/* Tables in text files: lines of fields under a line of column names. That line is the last one
 * above the first line that has a number in a field of its own; a line of units may stand between,
 * and titles above. The separator is the one that a first line `sep=` names; otherwise the first of
 * semicolon, tab, comma and blank that the first row has. A comma in a number is a decimal point.
 * Quotes hold a field together, lines that begin with # are comments, blank lines are skipped, and
 * a byte-order mark is left out. The file is read as a stream.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_BASE_CSV_H
#define ASP_BASE_CSV_H

#include "base/text.h"

enum { ASP_CSV_COLUMNS = 64 };

typedef struct aspi_csv {
  FILE *stream;
  aspi_text text;
  char separator;
  bool forced, has_row; /* the separator by `sep=`; the line at hand is a row not taken yet */
  char *comment;        /* the first one, however long, or "" */
  char above[2][ASP_TEXT_MOST]; /* the lines above the first row, the nearest first */
  int columns, count;           /* names, and fields of the row */
  char *names[ASP_CSV_COLUMNS], *fields[ASP_CSV_COLUMNS];
  const char *units[ASP_CSV_COLUMNS]; /* of a line of units, else "" */
} aspi_csv;

/* Opens a file and reads up to its column names. NULL on error; the message names file and line. */
aspi_csv *aspi_csv_open(const char *path, asp_error *error);
void aspi_csv_close(aspi_csv *csv);

/* Index of a column, or -1. */
int aspi_csv_find(const aspi_csv *csv, const char *name);

/* Index of a column, or -1 with a message that lists the columns there are. */
int aspi_csv_need(const aspi_csv *csv, const char *name, asp_error *error);

/* Reads the next row into csv->fields; *found is false at the end of the file. ASP_EDATA if the
 * number of fields differs from the number of names. */
asp_code aspi_csv_row(aspi_csv *csv, bool *found, asp_error *error);

/* The number in a column of the row, least <= value <= most; *missing where it is empty or a mark
 * for a missing value. Column -1 is always missing. With `missing` NULL there must be a number. */
asp_code aspi_csv_number(const aspi_csv *csv, int column, double least, double most, double *value,
                         bool *missing, asp_error *error);

#endif
