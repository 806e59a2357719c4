/* One-dimensional structured arrays in NumPy's .npy format (versions 1 to 3, little-endian whole
 * numbers and floating-point numbers), read as a stream: the ledger of a wall, or what a script
 * made of it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_NPY_H
#define ASP_CLI_NPY_H

#include "asperity.h"

#include <stdbool.h>
#include <stdio.h>

enum { NPY_COLUMNS = 64, NPY_TITLE = 1024, NPY_ROW_MOST = NPY_COLUMNS * 8 };

typedef struct npy_column {
  char name[64], kind; /* i, u or f */
  int size, offset;
} npy_column;

typedef struct npy {
  FILE *stream;
  const char *path; /* for messages */
  unsigned long long rows, row;
  int columns, row_size;
  npy_column column[NPY_COLUMNS];
  char title[NPY_TITLE]; /* the first title of a column, or "" */
  unsigned char bytes[NPY_ROW_MOST + 8];
} npy;

/* True if a file begins as one; the stream is back at its beginning then. */
bool cli_npy_is(FILE *stream);

asp_code cli_npy_open(npy *array, FILE *stream, const char *path, asp_error *error);

/* Index of a column, or -1. */
int cli_npy_find(const npy *array, const char *name);

/* The next row; *found is false at the end. ASP_EDATA where the file ends before its rows do. */
asp_code cli_npy_next(npy *array, bool *found, asp_error *error);

/* A number of the row; NAN for column -1. */
double cli_npy_value(const npy *array, int column);

#endif
