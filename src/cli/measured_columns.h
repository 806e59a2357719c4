/* Columns of a table of measured coefficients of restitution: their names as people write them, and
 * their units.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_MEASURED_COLUMNS_H
#define ASP_CLI_MEASURED_COLUMNS_H

#include "analysis/impacts.h"
#include "base/csv.h"

enum {
  ALPHA1,
  V1,
  ALPHA2,
  V2,
  V1_N,
  V1_T,
  V2_N,
  V2_T,
  COR_V,
  COR_ALPHA,
  POINT,
  MEAN = POINT + COR_BOTH,
  SD = MEAN + COR_BOTH,
  SE = SD + COR_BOTH,
  COUNT = SE + COR_BOTH,
  D_P,
  RADIUS,
  OUTCOME,
  MEASURED_COLUMNS
};

/* Positions of the columns in the file, -1 if absent; their units; and, for columns of a rebound,
 * the view that they are of. */
typedef struct cli_columns {
  int at[MEASURED_COLUMNS];
  double factor[MEASURED_COLUMNS];
  aspi_measured_view view[MEASURED_COLUMNS];
} cli_columns;

/* Finds the columns of a table; exits where one is there twice, or its unit is not read or missing.
 */
void cli_columns_find(const aspi_csv *csv, const char *path, cli_columns *to);

/* True for angles (in degrees), and for columns of words. */
bool cli_column_is_angle(int column);
bool cli_column_is_word(int column);

#endif
