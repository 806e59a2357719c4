/* Files of impacts; see scatter.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/scatter.h"
#include "base/error.h"
#include "cli/cli.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Tangential speeds in space and in the plane that differ by more, as a share of v1, are of a
 * rebound to the side: a ledger's numbers are rounded. */
#define SIDEWAYS 1e-3

/* Exits where a column is missing; CoR_T stands for CoR_N. */
static void check_needed(const impact_file *f, const aspi_csv *csv, const cli_columns *l) {
  static const char *const names[MEASURED_COLUMNS] = {
      [ALPHA1] = "alpha1_deg", [V1] = "v1",     [POINT] = "cor_n",
      [D_P] = "d_p",           [MESH] = "mesh", [TRIANGLE] = "triangle",
      [ERODED] = "eroded_mass"};
  asp_error error;
  for (int c = 0; c < MEASURED_COLUMNS; c++) {
    if (!(f->needed & COLUMN_BIT(c)))
      continue;
    if (l->at[c] >= 0 && isnan(l->factor[c]))
      cli_bad_usage("%s: '%s' is in a ledger's units, which have no size in SI", f->path, names[c]);
    if (l->at[c] >= 0 || (c == POINT && l->at[POINT + COR_T] >= 0))
      continue;
    aspi_csv_need(csv, names[c], &error);
    cli_bad_usage("%s; %s", error.text,
                  c == ERODED
                      ? "a ledger has it with 'columns full', or state 'erosion LAW' behind "
                        "it"
                      : "impacts are a ledger or what 'asperity cor' writes, and data stand "
                        "behind them");
  }
}

void cli_scatter_read_rows(impact_file *f) {
  asp_error error;
  cli_columns l;
  aspi_csv *csv = aspi_csv_open(f->path, &error);
  cli_must(csv, &error);
  cli_columns_find(csv, f->path, f->wanted | f->needed, &l);
  snprintf(f->comment, sizeof f->comment, "%.1000s", csv->comment);
  check_needed(f, csv, &l);
  uint32_t needed = f->needed & ~COLUMN_BIT(POINT); /* deposits have no coefficients */
  double of[MEASURED_COLUMNS];
  for (bool found = true; found;) {
    asp_code code = aspi_csv_row(csv, &found, &error);
    if (!code && found && !(code = cli_columns_row(csv, &l, needed, of, &error))) {
      if (l.at[OUTCOME] < 0)
        of[OUTCOME] = !(of[POINT] > 0);
      code = f->take(f->taker, of, &error);
    }
    cli_must(!code, &error);
  }
  aspi_csv_close(csv);
}

/* ---- all impacts of a file ---- */

/* CoR_T of the whole speed along the wall. */
static double cor_t_space(const double of[]) {
  double alpha = cli_radians(of[ALPHA1]), normal = of[POINT] * sin(alpha);
  double ratio = isnan(of[COR_V_SPACE]) ? of[V2] / of[V1] : of[COR_V_SPACE];
  return isnan(of[POINT + COR_T]) ? NAN
                                  : sqrt(fmax(0, ratio * ratio - normal * normal)) / cos(alpha);
}

static asp_code add_impact(void *taker, const double of[], asp_error *error) {
  aspi_scatter_impacts *impacts = taker;
  bool deposit = of[OUTCOME] > 0;
  double whole = deposit ? NAN : cor_t_space(of);
  if ((impacts->count & (impacts->count - 1)) == 0) {
    size_t room = impacts->count ? 2 * impacts->count : 1;
    aspi_scatter_point *grown = realloc(impacts->points, room * sizeof *grown);
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu rows", impacts->count);
    impacts->points = grown;
  }
  impacts->sideways = impacts->sideways ||
                      (whole - fabs(of[POINT + COR_T])) * cos(cli_radians(of[ALPHA1])) > SIDEWAYS;
  impacts->rough = impacts->rough || fabs(of[DELTA_ALPHA]) > 0;
  impacts->deposits += deposit;
  impacts->points[impacts->count++] = (aspi_scatter_point){
      of[ALPHA1], (float)of[V1], (float)of[D_P],
      deposit,    (float)whole,  {deposit ? NAN : of[POINT], deposit ? NAN : of[POINT + COR_T]}};
  return ASP_OK;
}

aspi_scatter_impacts cli_scatter_read_impacts(const char *path) {
  aspi_scatter_impacts impacts = {.count = 0};
  impact_file from = {.path = path,
                      .wanted = COLUMN_BIT(POINT + COR_T) | COLUMN_BIT(DELTA_ALPHA) |
                                COLUMN_BIT(V1) | COLUMN_BIT(D_P) | COLUMN_BIT(V2) |
                                COLUMN_BIT(COR_V_SPACE) | COLUMN_BIT(OUTCOME),
                      .needed = COLUMN_BIT(ALPHA1) | COLUMN_BIT(POINT),
                      .take = add_impact,
                      .taker = &impacts};
  cli_scatter_read_rows(&from);
  memcpy(impacts.comment, from.comment, sizeof impacts.comment);
  double most = 0;
  for (size_t i = 0; i < impacts.count; i++)
    most = fmax(most, impacts.points[i].degrees);
  if (impacts.count == impacts.deposits)
    cli_bad_usage("%s: no rebound in it (%zu deposits)", path, impacts.deposits);
  cli_warn_radians(path, most);
  return impacts;
}
