/* Files of impacts, as `asperity cor` and the ledger of a wall write them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SCATTER_H
#define ASP_CLI_SCATTER_H

#include "cli/measured_columns.h"

typedef struct impact_file {
  const char *path;
  uint32_t wanted, needed; /* columns, of measured_columns.h: read where they are there; must be */
  asp_code (*take)(void *taker, const double of[MEASURED_COLUMNS], asp_error *error); /* a row */
  void *taker;
  char comment[1024]; /* the file's first one */
} impact_file;

/* Hands over the rows of a file one by one. Exits on a file that is not one of these. */
void cli_scatter_read_rows(impact_file *file);

/* All of them. */
aspi_scatter_impacts cli_scatter_read_impacts(const char *path);

#endif
