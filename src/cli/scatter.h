/* Files of impacts, as `asperity cor` and the ledger of a wall write them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SCATTER_H
#define ASP_CLI_SCATTER_H

#include "analysis/impacts.h"
#include "asperity.h"

/* Columns of an impact, in SI and degrees; NAN where the file has none. */
enum {
  IMPACT_ALPHA1,
  IMPACT_DELTA,
  IMPACT_V1,
  IMPACT_D_P,
  IMPACT_COR_N,
  IMPACT_COR_T,
  IMPACT_V2,
  IMPACT_COR_V_SPACE,
  IMPACT_MESH,
  IMPACT_TRIANGLE,
  IMPACT_MASS,
  IMPACT_ERODED,
  IMPACT_OUTCOME, /* 0 rebound, 1 deposit */
  IMPACT_COLUMNS
};

typedef struct impact_file {
  const char *path;
  unsigned uses;  /* 1 << column: those that are read where they are there */
  unsigned needs; /* 1 << column: those that must be there */
  asp_code (*take)(void *taker, const double of[], asp_error *error); /* a row */
  void *taker;
  char comment[1024]; /* the file's first one */
  bool has_no_size;   /* its units, as lj, have no size in SI */
} impact_file;

/* Hands over the rows of a file one by one. Exits on a file that is not one of these. */
void cli_scatter_read_rows(impact_file *file);

/* All of them. Exits alike, and warns where angles look like radians. */
aspi_scatter_impacts cli_scatter_read_impacts(const char *path);

#endif
