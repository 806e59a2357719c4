/* Files of coefficients of restitution; see scatter.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/scatter.h"
#include "base/csv.h"
#include "base/error.h"
#include "base/file.h"
#include "base/ledger_columns.h"
#include "cli/cli.h"
#include "cli/npy.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* An engine's array has 0 where CoR_T is undefined, at normal impact. */
#define NORMAL_IMPACT (90 - 1e-6)

/* Tangential speeds in space and in the plane that differ by more, as a share of v1, are of a
 * rebound to the side: a ledger's numbers are rounded. */
#define SIDEWAYS 1e-3

/* Degrees below this, all of them, are radians. */
#define RADIANS_MOST 1.6

static void *grow(void *list, size_t count, size_t size) {
  if (count & (count - 1))
    return list;
  void *grown = realloc(list, (count ? 2 * count : 1) * size);
  if (!grown)
    cli_fail("out of memory for %zu rows", count);
  return grown;
}

static void warn_radians(const char *path, double most, size_t count) {
  if (count > 0 && most < RADIANS_MOST)
    cli_warn("%s: all impact angles are below %g; they are taken as degrees, but look like radians",
             path, RADIANS_MOST);
}

/* Names of the columns in a ledger's file. */
#define LEDGER_NAMED(ID, name, type, text) name,
static const char *const ledger_name[] = {LEDGER_COLUMNS(LEDGER_NAMED)};

/* The values of one impact, from any kind of file. */
typedef struct impact_row {
  double degrees, delta, v1, d_p, cor[COR_BOTH], v2, cor_v_space; /* the last two: one of them */
  bool deposit;
} impact_row;

/* CoR_T of the whole speed along the wall. */
static double cor_t_space(const impact_row *row) {
  double alpha = row->degrees * (ASP_PI / 180), normal = row->cor[COR_N] * sin(alpha);
  double ratio = isnan(row->cor_v_space) ? row->v2 / row->v1 : row->cor_v_space;
  return isnan(row->cor[COR_T]) ? NAN : sqrt(fmax(0, ratio * ratio - normal * normal)) / cos(alpha);
}

static void add_impact(scatter_impacts *impacts, const impact_row *row) {
  double whole = row->deposit ? NAN : cor_t_space(row);
  impacts->sideways =
      impacts->sideways ||
      (whole - fabs(row->cor[COR_T])) * cos(row->degrees * (ASP_PI / 180)) > SIDEWAYS;
  impacts->rough = impacts->rough || fabs(row->delta) > 0;
  impacts->deposits += row->deposit;
  impacts->points = grow(impacts->points, impacts->count, sizeof *impacts->points);
  impacts->points[impacts->count++] =
      (scatter_point){row->degrees,
                      (float)(row->v1 * impacts->metre_per_second),
                      (float)(row->d_p * impacts->metre),
                      row->deposit,
                      (float)whole,
                      {row->deposit ? NAN : row->cor[0], row->deposit ? NAN : row->cor[1]}};
}

typedef struct impact_columns {
  int degrees, delta, v1, d_p, cor[COR_BOTH], outcome, v2, cor_v_space;
} impact_columns;

static asp_code read_row(const aspi_csv *csv, const impact_columns *at, impact_row *row,
                         asp_error *error) {
  bool missing;
  asp_code code;
  if ((code = aspi_csv_number(csv, at->degrees, 0, 90, &row->degrees, NULL, error)) ||
      (code = aspi_csv_number(csv, at->delta, -90, 90, &row->delta, &missing, error)) ||
      (code = aspi_csv_number(csv, at->v1, 0, 1e15, &row->v1, &missing, error)) ||
      (code = aspi_csv_number(csv, at->d_p, 0, 1e15, &row->d_p, &missing, error)) ||
      (code =
           aspi_csv_number(csv, at->cor[COR_N], -1e15, 1e15, &row->cor[COR_N], &missing, error)) ||
      (code =
           aspi_csv_number(csv, at->cor[COR_T], -1e15, 1e15, &row->cor[COR_T], &missing, error)) ||
      (code = aspi_csv_number(csv, at->v2, 0, 1e15, &row->v2, &missing, error)) ||
      (code = aspi_csv_number(csv, at->cor_v_space, 0, 1e15, &row->cor_v_space, &missing, error)))
    return code;
  const char *outcome = at->outcome < 0 ? "" : csv->fields[at->outcome];
  row->deposit = at->outcome < 0 ? !(row->cor[COR_N] > 0)
                                 : strcmp(outcome, "rebound") != 0 && strcmp(outcome, "0") != 0;
  return ASP_OK;
}

/* The first of two columns that is there. */
static int find_either(const aspi_csv *csv, const char *first, const char *second) {
  int index = aspi_csv_find(csv, first);
  return index >= 0 ? index : aspi_csv_find(csv, second);
}

/* The units of a ledger, from its comment, as meters and meters per second; else SI. The command
 * writes diameters in micrometers. */
static void read_units(scatter_impacts *impacts, bool micrometres) {
  static const struct {
    const char *words;
    double metre, metre_per_second;
  } units[] = {{"units cgs;", 1e-2, 1e-2}, {"units micro;", 1e-6, 1}, {"units nano;", 1e-9, 1}};
  impacts->metre = micrometres ? 1e-6 : 1;
  for (size_t i = 0; i < sizeof units / sizeof *units; i++)
    if (strstr(impacts->comment, units[i].words)) {
      impacts->metre = units[i].metre;
      impacts->metre_per_second = units[i].metre_per_second;
    }
}

static asp_code read_csv_rows(aspi_csv *csv, scatter_impacts *impacts, asp_error *error) {
  snprintf(impacts->comment, sizeof impacts->comment, "%.1000s", csv->comment);
  read_units(impacts, aspi_csv_find(csv, "dp_um") >= 0);
  impact_columns at = {.v1 = find_either(csv, ledger_name[LEDGER_V1], "v1_m_s"),
                       .d_p = find_either(csv, ledger_name[LEDGER_D_P], "dp_um"),
                       .degrees = aspi_csv_need(csv, ledger_name[LEDGER_ALPHA1], error),
                       .delta = aspi_csv_find(csv, ledger_name[LEDGER_DELTA_ALPHA]),
                       .cor = {aspi_csv_find(csv, ledger_name[LEDGER_COR_N]),
                               aspi_csv_find(csv, ledger_name[LEDGER_COR_T])},
                       .outcome = aspi_csv_find(csv, ledger_name[LEDGER_OUTCOME]),
                       .v2 = aspi_csv_find(csv, ledger_name[LEDGER_V2]),
                       .cor_v_space = aspi_csv_find(csv, "cor_v_space")};
  if (at.degrees < 0 || (at.cor[0] < 0 && aspi_csv_need(csv, ledger_name[LEDGER_COR_N], error) < 0))
    return ASP_EDATA;
  impact_row row;
  asp_code code;
  for (bool found;;) {
    if ((code = aspi_csv_row(csv, &found, error)) || !found ||
        (code = read_row(csv, &at, &row, error)))
      return code;
    add_impact(impacts, &row);
  }
}

/* The number of a column in the local array, from 1. */
static int number_of(int column) {
  return column + 1;
}

/* `ITEM: ENTRIES f_wall[11] f_wall[17] ...`: where a column of the ledger stands, or -1. */
static int find_entry(char *const names[], int count, int column) {
  for (int i = 0; i < count; i++) {
    const char *bracket = strrchr(names[i], '[');
    if (strncmp(names[i], "f_", 2) == 0 && bracket && atoi(bracket + 1) == number_of(column))
      return i;
  }
  return -1;
}

static asp_code read_dump_row(aspi_csv *csv, const impact_columns *at, scatter_impacts *impacts,
                              asp_error *error) {
  int count = aspi_text_split(csv->text.text, ' ', csv->fields, ASP_CSV_COLUMNS);
  if (count != csv->columns)
    return aspi_text_fail(&csv->text, csv->text.line, error, "%d numbers under %d columns", count,
                          csv->columns);
  impact_row row;
  asp_code code = read_row(csv, at, &row, error);
  if (code)
    return code;
  if (row.degrees > NORMAL_IMPACT && !(fabs(row.cor[COR_T]) > 0))
    row.cor[COR_T] = NAN;
  add_impact(impacts, &row);
  return ASP_OK;
}

static asp_code read_dump_header(aspi_csv *csv, impact_columns *at, asp_error *error) {
  strcpy(csv->header, csv->text.text + strlen("ITEM: ENTRIES"));
  csv->separator = ' ';
  csv->columns = aspi_text_split(csv->header, ' ', csv->names, ASP_CSV_COLUMNS);
  *at = (impact_columns){find_entry(csv->names, csv->columns, LEDGER_ALPHA1),
                         find_entry(csv->names, csv->columns, LEDGER_DELTA_ALPHA),
                         find_entry(csv->names, csv->columns, LEDGER_V1),
                         find_entry(csv->names, csv->columns, LEDGER_D_P),
                         {find_entry(csv->names, csv->columns, LEDGER_COR_N),
                          find_entry(csv->names, csv->columns, LEDGER_COR_T)},
                         find_entry(csv->names, csv->columns, LEDGER_OUTCOME),
                         find_entry(csv->names, csv->columns, LEDGER_V2),
                         -1};
  if (at->degrees >= 0 && (at->cor[0] >= 0 || at->cor[1] >= 0))
    return ASP_OK;
  return aspi_text_fail(&csv->text, csv->text.line, error,
                        "the dump needs column %d (alpha1), and %d or %d (cor_n, cor_t), of the "
                        "wall's array: f_ID[%d] f_ID[%d] f_ID[%d]",
                        number_of(LEDGER_ALPHA1), number_of(LEDGER_COR_N), number_of(LEDGER_COR_T),
                        number_of(LEDGER_ALPHA1), number_of(LEDGER_COR_N), number_of(LEDGER_COR_T));
}

/* A `dump local` file: blocks of a header of ITEM lines, then rows. */
static asp_code read_dump(aspi_csv *csv, scatter_impacts *impacts, asp_error *error) {
  impact_columns at;
  bool in_rows = false, found;
  asp_code code = ASP_OK;
  while (!code && !(code = aspi_text_line(&csv->text, &found, error)) && found) {
    const char *line = csv->text.text;
    if (strncmp(line, "ITEM: ENTRIES", 13) == 0) {
      in_rows = true;
      code = read_dump_header(csv, &at, error);
    } else if (strncmp(line, "ITEM:", 5) == 0) {
      in_rows = false;
    } else if (in_rows && line[strspn(line, " ")]) {
      code = read_dump_row(csv, &at, impacts, error);
    }
  }
  return code;
}

/* A number of the row within its bounds; NAN is a missing one, where that may be. */
static asp_code read_value(const npy *array, int column, double least, double most,
                           bool may_be_missing, double *value, asp_error *error) {
  *value = cli_npy_value(array, column);
  if ((*value >= least && *value <= most) || (may_be_missing && isnan(*value)))
    return ASP_OK;
  return aspi_fail(error, ASP_EDATA, "%s: row %llu: %s is %g; it must be %g to %g", array->path,
                   array->row, array->column[column].name, *value, least, most);
}

static asp_code read_array_row(const npy *array, const impact_columns *at, impact_row *row,
                               asp_error *error) {
  asp_code code;
  if ((code = read_value(array, at->degrees, 0, 90, false, &row->degrees, error)) ||
      (code = read_value(array, at->delta, -90, 90, true, &row->delta, error)) ||
      (code = read_value(array, at->v1, 0, 1e15, true, &row->v1, error)) ||
      (code = read_value(array, at->d_p, 0, 1e15, true, &row->d_p, error)) ||
      (code = read_value(array, at->cor[COR_N], -1e15, 1e15, true, &row->cor[COR_N], error)) ||
      (code = read_value(array, at->cor[COR_T], -1e15, 1e15, true, &row->cor[COR_T], error)) ||
      (code = read_value(array, at->v2, 0, 1e15, true, &row->v2, error)))
    return code;
  row->cor_v_space = NAN;
  row->deposit =
      at->outcome < 0 ? !(row->cor[COR_N] > 0) : fabs(cli_npy_value(array, at->outcome)) > 0;
  return ASP_OK;
}

static asp_code read_array(FILE *stream, const char *path, scatter_impacts *impacts,
                           asp_error *error) {
  npy array;
  asp_code code = cli_npy_open(&array, stream, path, error);
  if (code)
    return code;
  impact_columns at = {.degrees = cli_npy_find(&array, ledger_name[LEDGER_ALPHA1]),
                       .delta = cli_npy_find(&array, ledger_name[LEDGER_DELTA_ALPHA]),
                       .v1 = cli_npy_find(&array, ledger_name[LEDGER_V1]),
                       .d_p = cli_npy_find(&array, ledger_name[LEDGER_D_P]),
                       .cor = {cli_npy_find(&array, ledger_name[LEDGER_COR_N]),
                               cli_npy_find(&array, ledger_name[LEDGER_COR_T])},
                       .outcome = cli_npy_find(&array, ledger_name[LEDGER_OUTCOME]),
                       .v2 = cli_npy_find(&array, ledger_name[LEDGER_V2]),
                       .cor_v_space = -1};
  if (at.degrees < 0 || at.cor[COR_N] < 0)
    return aspi_fail(error, ASP_EDATA, "%s: column '%s' is missing", path,
                     ledger_name[at.degrees < 0 ? LEDGER_ALPHA1 : LEDGER_COR_N]);
  snprintf(impacts->comment, sizeof impacts->comment, "%s", array.title);
  read_units(impacts, false);
  impact_row row;
  for (bool found;;) {
    if ((code = cli_npy_next(&array, &found, error)) || !found ||
        (code = read_array_row(&array, &at, &row, error)))
      return code;
    add_impact(impacts, &row);
  }
}

static bool is_dump(FILE *stream) {
  char first[6] = "";
  bool dump = fgets(first, sizeof first, stream) && strcmp(first, "ITEM:") == 0;
  rewind(stream);
  return dump;
}

static asp_code read_impacts(const char *path, scatter_impacts *impacts, asp_error *error) {
  FILE *stream = aspi_file_open(path, error);
  if (!stream)
    return error->code;
  asp_code code;
  if (cli_npy_is(stream)) {
    code = read_array(stream, path, impacts, error);
    fclose(stream);
    return code;
  }
  if (is_dump(stream)) {
    aspi_csv *csv = cli_allocate(1, sizeof *csv);
    csv->text = aspi_text_create(stream, path);
    code = read_dump(csv, impacts, error);
    free(csv);
    fclose(stream);
    return code;
  }
  aspi_csv *csv = aspi_csv_create(stream, path, error);
  if (!csv)
    return error->code;
  code = read_csv_rows(csv, impacts, error);
  aspi_csv_close(csv);
  return code;
}

scatter_impacts scatter_read_impacts(const char *path) {
  scatter_impacts impacts = {.metre = 1, .metre_per_second = 1};
  asp_error error;
  if (read_impacts(path, &impacts, &error))
    cli_bad_file(NULL, &error);
  double most = 0;
  for (size_t i = 0; i < impacts.count; i++)
    most = fmax(most, impacts.points[i].degrees);
  if (impacts.count == impacts.deposits)
    cli_bad_usage("%s: no rebound in it (%zu deposits)", path, impacts.deposits);
  warn_radians(path, most, impacts.count);
  return impacts;
}

void scatter_free_impacts(scatter_impacts *impacts) {
  free(impacts->points);
}
