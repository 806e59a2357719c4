/* Columns of a table of impacts or of measured coefficients of restitution: those that
 * `asperity cor` and the ledger of a wall write, and a few other English names. A name may carry
 * its unit; the columns of a ledger are in the units that its first comment names.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_MEASURED_COLUMNS_H
#define ASP_CLI_MEASURED_COLUMNS_H

#include "analysis/impacts.h"
#include "base/csv.h"

#include <stdint.h>

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
  DELTA_ALPHA, /* from here on of impacts of a model alone, by these names */
  COR_V_SPACE,
  MESH,
  TRIANGLE,
  MASS,
  ERODED,
  MEASURED_COLUMNS
};

/* Sets of columns. */
#define COLUMN_BIT(column) (UINT32_C(1) << (column))

/* Positions of the columns in the file, -1 if absent; their units in SI, NAN where they have no
 * size, as in `units lj`; and, for columns of a rebound, the view that they are of. */
typedef struct cli_columns {
  int at[MEASURED_COLUMNS];
  double factor[MEASURED_COLUMNS];
  aspi_measured_view view[MEASURED_COLUMNS];
  bool is_ledger;
} cli_columns;

/* Finds those columns of a table; exits where one is there twice, or its unit is not read or
 * missing. */
void cli_columns_find(const aspi_csv *csv, const char *path, uint32_t wanted, cli_columns *to);

/* Numbers of the row in SI and degrees, NAN where there are none; the outcome is 1 for a deposit,
 * else 0. ASP_EDATA names the column that is no number, out of its range, or `needed` and empty. */
asp_code cli_columns_row(const aspi_csv *csv, const cli_columns *columns, uint32_t needed,
                         double value[MEASURED_COLUMNS], asp_error *error);

/* Warns of a file whose largest impact angle looks like radians. */
void cli_warn_radians(const char *path, double most);

#endif
