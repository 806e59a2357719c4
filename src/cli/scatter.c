/* Files of coefficients of restitution; see scatter.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/scatter.h"
#include "base/csv.h"
#include "base/error.h"
#include "base/ledger_columns.h"
#include "cli/cli.h"
#include "cli/measured.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Tangential speeds in space and in the plane that differ by more, as a share of v1, are of a
 * rebound to the side: a ledger's numbers are rounded. */
#define SIDEWAYS 1e-3

static void *grow(void *list, size_t count, size_t size) {
  if (count & (count - 1))
    return list;
  void *grown = realloc(list, (count ? 2 * count : 1) * size);
  if (!grown)
    cli_fail("out of memory for %zu rows", count);
  return grown;
}

static void warn_radians(const char *path, double most, size_t count) {
  if (count > 0 && most < CLI_RADIANS_MOST)
    cli_warn("%s: all impact angles are below %g; they are taken as degrees, but look like radians",
             path, CLI_RADIANS_MOST);
}

/* Names of the columns in a ledger's file. */
#define LEDGER_NAMED(ID, name, type, text) name,
static const char *const ledger_name[] = {LEDGER_COLUMNS(LEDGER_NAMED)
                                              LEDGER_MORE_COLUMNS(LEDGER_NAMED)};

/* The columns of an impact: where a ledger has them, their names in the output of `asperity cor`
 * where those differ, and their range. */
enum { NUMBER, LENGTH, SPEED, MASS };
#define IMPACTS "; impacts are a ledger or what 'asperity cor' writes, and data stand behind them"
static const struct {
  int place;
  const char *other;
  int kind;
  double least, most;
  const char *cure; /* where it is missing */
} columns[IMPACT_COLUMNS] = {
    [IMPACT_ALPHA1] = {LEDGER_ALPHA1, NULL, NUMBER, 0, 90, IMPACTS},
    [IMPACT_DELTA] = {LEDGER_DELTA_ALPHA, NULL, NUMBER, -90, 90},
    [IMPACT_V1] = {LEDGER_V1, "v1_m_s", SPEED, 0, 1e15},
    [IMPACT_D_P] = {LEDGER_D_P, "dp_um", LENGTH, 0, 1e15},
    [IMPACT_COR_N] = {LEDGER_COR_N, NULL, NUMBER, -1e15, 1e15, IMPACTS},
    [IMPACT_COR_T] = {LEDGER_COR_T, NULL, NUMBER, -1e15, 1e15},
    [IMPACT_V2] = {LEDGER_V2, NULL, SPEED, 0, 1e15},
    [IMPACT_COR_V_SPACE] = {-1, "cor_v_space", NUMBER, 0, 1e15},
    [IMPACT_MESH] = {LEDGER_MESH, NULL, NUMBER, 0, INT_MAX},
    [IMPACT_TRIANGLE] = {LEDGER_TRIANGLE, NULL, NUMBER, 0, INT_MAX},
    [IMPACT_MASS] = {LEDGER_MASS, NULL, MASS, 0, INFINITY},
    [IMPACT_ERODED] = {LEDGER_ERODED_MASS, NULL, MASS, 0, INFINITY,
                       "; a ledger has it with 'columns full', or state 'erosion LAW' behind it"},
    [IMPACT_OUTCOME] = {LEDGER_OUTCOME, NULL, NUMBER, 0, 2},
};

static const char *name_of(int column) {
  return columns[column].place < 0 ? columns[column].other : ledger_name[columns[column].place];
}

static const char *cure_of(int column) {
  return columns[column].cure ? columns[column].cure : "";
}

/* A file as it is read. */
typedef struct file {
  impact_file *to;
  int at[IMPACT_COLUMNS]; /* -1: there is none */
  double unit[MASS + 1];  /* in SI, of each kind */
  double of[IMPACT_COLUMNS];
} file;

static bool is_needed(const file *f, int column) {
  return f->to->needs >> column & 1;
}

/* Leaves out columns that are of no use, and returns one that is needed and not there; -1: none.
 * CoR_T stands for CoR_N. */
static int find_missing(file *f) {
  for (int k = 0; k < IMPACT_COLUMNS; k++)
    if (!(f->to->uses >> k & 1))
      f->at[k] = -1;
    else if (is_needed(f, k) && f->at[k] < 0 && !(k == IMPACT_COR_N && f->at[IMPACT_COR_T] >= 0))
      return k;
  return -1;
}

/* Only coefficients may lack in a row of a column that is needed: deposits have none. */
static bool may_lack(const file *f, int column) {
  return !is_needed(f, column) || column == IMPACT_COR_N;
}

/* Hands a row over, in SI. */
static asp_code take_row(file *f, asp_error *error) {
  for (int k = 0; k < IMPACT_COLUMNS; k++)
    f->of[k] *= f->unit[columns[k].kind];
  return f->to->take(f->to->taker, f->of, error);
}

static asp_code read_row(file *f, const aspi_csv *csv, asp_error *error) {
  bool missing;
  for (int k = 0; k < IMPACT_OUTCOME; k++) {
    asp_code code = aspi_csv_number(csv, f->at[k], columns[k].least, columns[k].most, &f->of[k],
                                    may_lack(f, k) ? &missing : NULL, error);
    if (code)
      return code;
  }
  bool deposit = !(f->of[IMPACT_COR_N] > 0);
  asp_code code = f->at[IMPACT_OUTCOME] < 0
                      ? ASP_OK
                      : cli_measured_outcome(csv, f->at[IMPACT_OUTCOME], &deposit, error);
  f->of[IMPACT_OUTCOME] = deposit;
  return code;
}

/* The units of a ledger, from its comment; else SI. The command writes diameters in micrometers. */
static asp_code read_units(file *f, bool micrometers, asp_error *error) {
  static const struct {
    const char *name;
    double unit[MASS + 1];
  } units[] = {{"si", {1, 1, 1, 1}},
               {"cgs", {1, 1e-2, 1e-2, 1e-3}},
               {"micro", {1, 1e-6, 1, 1e-15}},
               {"nano", {1, 1e-9, 1, 1e-21}}};
  if (micrometers)
    f->unit[LENGTH] = 1e-6;
  const char *named = strstr(f->to->comment, "; units ");
  if (!named)
    return ASP_OK;
  named += strlen("; units ");
  const int length = (int)strcspn(named, ";");
  for (size_t i = 0; i < sizeof units / sizeof *units; i++)
    if (strlen(units[i].name) == (size_t)length && strncmp(units[i].name, named, length) == 0) {
      memcpy(f->unit, units[i].unit, sizeof f->unit);
      return ASP_OK;
    }
  f->to->has_no_size = true;
  for (int k = 0; k < IMPACT_COLUMNS; k++)
    if (is_needed(f, k) && columns[k].kind != NUMBER)
      return aspi_fail(error, ASP_EDATA, "%s: '%s' is in 'units %.*s', which have no size in SI",
                       f->to->path, name_of(k), length, named);
  return ASP_OK;
}

static asp_code read_csv_rows(file *f, aspi_csv *csv, asp_error *error) {
  snprintf(f->to->comment, sizeof f->to->comment, "%.1000s", csv->comment);
  for (int k = 0; k < IMPACT_COLUMNS; k++) {
    f->at[k] = aspi_csv_find(csv, name_of(k));
    if (f->at[k] < 0 && columns[k].other)
      f->at[k] = aspi_csv_find(csv, columns[k].other);
  }
  int missing = find_missing(f);
  if (missing >= 0) {
    asp_error why;
    aspi_csv_need(csv, name_of(missing), &why);
    return aspi_fail(error, ASP_EDATA, "%s%s", why.text, cure_of(missing));
  }
  asp_code code = read_units(f, aspi_csv_find(csv, "dp_um") >= 0, error);
  for (bool found; !code;)
    if ((code = aspi_csv_row(csv, &found, error)) || !found || (code = read_row(f, csv, error)) ||
        (code = take_row(f, error)))
      return code;
  return code;
}

static asp_code read_file(file *f, asp_error *error) {
  aspi_csv *csv = aspi_csv_open(f->to->path, error);
  if (!csv)
    return error->code;
  asp_code code = read_csv_rows(f, csv, error);
  aspi_csv_close(csv);
  return code;
}

void cli_scatter_read_rows(impact_file *to) {
  file f = {.to = to, .unit = {1, 1, 1, 1}};
  asp_error error;
  cli_must(!read_file(&f, &error), &error);
}

/* ---- all impacts of a file ---- */

/* CoR_T of the whole speed along the wall. */
static double cor_t_space(const double of[]) {
  double alpha = cli_radians(of[IMPACT_ALPHA1]), normal = of[IMPACT_COR_N] * sin(alpha);
  double ratio =
      isnan(of[IMPACT_COR_V_SPACE]) ? of[IMPACT_V2] / of[IMPACT_V1] : of[IMPACT_COR_V_SPACE];
  return isnan(of[IMPACT_COR_T]) ? NAN
                                 : sqrt(fmax(0, ratio * ratio - normal * normal)) / cos(alpha);
}

static asp_code add_impact(void *taker, const double of[], asp_error *error) {
  (void)error;
  aspi_scatter_impacts *impacts = taker;
  bool deposit = of[IMPACT_OUTCOME] > 0;
  double whole = deposit ? NAN : cor_t_space(of);
  impacts->sideways =
      impacts->sideways ||
      (whole - fabs(of[IMPACT_COR_T])) * cos(cli_radians(of[IMPACT_ALPHA1])) > SIDEWAYS;
  impacts->rough = impacts->rough || fabs(of[IMPACT_DELTA]) > 0;
  impacts->deposits += deposit;
  impacts->points = grow(impacts->points, impacts->count, sizeof *impacts->points);
  impacts->points[impacts->count++] = (aspi_scatter_point){
      of[IMPACT_ALPHA1],     (float)of[IMPACT_V1],
      (float)of[IMPACT_D_P], deposit,
      (float)whole,          {deposit ? NAN : of[IMPACT_COR_N], deposit ? NAN : of[IMPACT_COR_T]}};
  return ASP_OK;
}

aspi_scatter_impacts cli_scatter_read_impacts(const char *path) {
  aspi_scatter_impacts impacts = {.count = 0};
  impact_file from = {.path = path,
                      .uses = ~(1u << IMPACT_MESH | 1u << IMPACT_TRIANGLE | 1u << IMPACT_MASS |
                                1u << IMPACT_ERODED),
                      .needs = 1 << IMPACT_ALPHA1 | 1 << IMPACT_COR_N,
                      .take = add_impact,
                      .taker = &impacts};
  cli_scatter_read_rows(&from);
  memcpy(impacts.comment, from.comment, sizeof impacts.comment);
  double most = 0;
  for (size_t i = 0; i < impacts.count; i++) {
    most = fmax(most, impacts.points[i].degrees);
    if (from.has_no_size)
      impacts.points[i].v1 = impacts.points[i].d_p = NAN;
  }
  if (impacts.count == impacts.deposits)
    cli_bad_usage("%s: no rebound in it (%zu deposits)", path, impacts.deposits);
  warn_radians(path, most, impacts.count);
  return impacts;
}
