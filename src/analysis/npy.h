/* One-dimensional structured arrays in NumPy's .npy format (versions 1 to 3, little-endian whole
 * numbers and floating-point numbers), read as a stream: the ledger of a wall, or what a script
 * made of it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_NPY_H
#define ASP_ANALYSIS_NPY_H

#include "asperity.h"

#include <stdbool.h>
#include <stdio.h>

enum { ASPI_NPY_COLUMNS = 64, ASPI_NPY_TITLE = 1024, ASPI_NPY_ROW_MOST = ASPI_NPY_COLUMNS * 8 };

typedef struct aspi_npy_column {
  char name[64], kind; /* i, u or f */
  int size, offset;
} aspi_npy_column;

typedef struct aspi_npy {
  FILE *stream;
  const char *path; /* for messages */
  unsigned long long rows, row;
  int columns, row_size;
  aspi_npy_column column[ASPI_NPY_COLUMNS];
  char title[ASPI_NPY_TITLE]; /* the first title of a column, or "" */
  unsigned char bytes[ASPI_NPY_ROW_MOST + 8];
} aspi_npy;

/* True if a file begins as one; the stream is back at its beginning then. */
bool aspi_npy_is(FILE *stream);

asp_code aspi_npy_open(aspi_npy *array, FILE *stream, const char *path, asp_error *error);

/* Index of a column, or -1. */
int aspi_npy_find(const aspi_npy *array, const char *name);

/* The next row; *found is false at the end. ASP_EDATA where the file ends before its rows do. */
asp_code aspi_npy_next(aspi_npy *array, bool *found, asp_error *error);

/* A number of the row; NAN for column -1. */
double aspi_npy_value(const aspi_npy *array, int column);

#endif
