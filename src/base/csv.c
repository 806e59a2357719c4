/* Tables in text files; see csv.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/csv.h"
#include "base/error.h"
#include "base/file.h"
#include "base/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The next line that is neither blank nor a comment. */
static asp_code next_line(aspi_csv *csv, bool *found, asp_error *error) {
  for (;;) {
    asp_code code = aspi_text_line(&csv->text, found, error);
    if (code || !*found)
      return code;
    char *text = csv->text.text;
    const char *first = text + strspn(text, " \t\v\f");
    if (*first == '#' && !*csv->comment)
      strcpy(csv->comment, first);
    if (*first && *first != '#')
      return ASP_OK;
  }
}

/* Fields that are numbers; -1 where there are none but empty ones. */
static int numbers_of(char **fields, int count) {
  int numbers = 0;
  bool any = false;
  for (int i = 0; i < count; i++) {
    double value;
    any = any || *fields[i];
    numbers += aspi_text_number(fields[i], &value) == ASP_WORD_NUMBER;
  }
  return any ? numbers : -1;
}

#define FIELDS "%d fields under %d column names%s"

/* What may be wrong where a row has too many fields. */
static const char *commas(const aspi_csv *csv, int count) {
  return csv->separator == ',' && count > csv->columns
             ? " (decimal commas need ; or tabs between the fields)"
             : "";
}

/* A unit as a line of units has them, in brackets or bare. */
static bool is_unit(const char *field) {
  field += strspn(field, "([{ ");
  size_t length = strcspn(field, ")]} ");
  return length == 0 || strncmp(field, "-", length) == 0 ||
         aspi_unit_find(NULL, field, length, false);
}

/* The lines above the data: the last two without numbers, the very last first, cut into fields; and
 * what is wrong with the first number found where a column name should be. */
typedef struct above {
  char line[2][ASP_TEXT_MOST], copy[2][ASP_TEXT_MOST], *name[2][ASP_CSV_COLUMNS];
  int count[2];
  char wrong[240];
  size_t wrong_line;
} above;

/* Takes the names from the line above the first row, or from the one above a line of units, which
 * are put behind them. The number of names. */
static int take_names(aspi_csv *csv, above *a) {
  for (int k = 0; k < 2; k++) {
    strcpy(a->copy[k], a->line[k]);
    a->count[k] =
        *a->copy[k] ? aspi_text_names(a->copy[k], csv->separator, a->name[k], ASP_CSV_COLUMNS) : 0;
  }
  bool units = a->count[0] > 0 && a->count[1] == a->count[0];
  for (int i = 0; i < a->count[0]; i++)
    units = units && is_unit(a->name[0][i]);
  char *out = csv->header;
  csv->columns = a->count[units];
  for (int i = 0; i < csv->columns; i++) {
    bool has_unit = units && *a->name[0][i];
    csv->names[i] = out;
    out += sprintf(out, "%s%s%s", a->name[units][i], has_unit ? " " : "",
                   has_unit ? a->name[0][i] : "") +
           1;
  }
  return csv->columns;
}

/* Takes in a line above the data; true where it is the first one of them. */
static bool is_data(aspi_csv *csv, above *a) {
  char copy[ASP_TEXT_MOST], *fields[ASP_CSV_COLUMNS];
  const char *line = csv->text.text;
  csv->separator = csv->forced ? csv->separator : aspi_text_separator(line);
  strcpy(copy, line);
  int count = aspi_text_split(copy, csv->separator, fields, ASP_CSV_COLUMNS);
  int numbers = numbers_of(fields, count);
  if (numbers <= 0) {
    strcpy(a->line[1], a->line[0]);
    strcpy(a->line[0], numbers < 0 ? "" : line);
    return false;
  }
  int named = take_names(csv, a);
  if (named == count)
    return true;
  if (!*a->wrong) {
    a->wrong_line = csv->text.line;
    if (named > 0)
      snprintf(a->wrong, sizeof a->wrong, FIELDS, count, named, commas(csv, count));
    else
      snprintf(a->wrong, sizeof a->wrong,
               "'%.40s' stands where a column name is expected; the line above the first numbers "
               "must name the columns",
               fields[0]);
  }
  *a->line[0] = *a->line[1] = '\0';
  return false;
}

/* `sep=;`, as spreadsheets understand it. */
static bool take_separator(aspi_csv *csv) {
  const char *line = csv->text.text;
  if (csv->text.line != 1 || strncasecmp(line, "sep=", 4) != 0 || !line[4])
    return false;
  csv->separator = line[4];
  return csv->forced = true;
}

/* Titles, the line of names, and a line of units below it, up to the first row. */
static asp_code read_header(aspi_csv *csv, asp_error *error) {
  above *a = calloc(1, sizeof *a);
  bool found = true, any = false;
  asp_code code = a ? ASP_OK : aspi_fail(error, ASP_ENOMEM, "out of memory for a table's header");
  while (!code && !csv->has_row && !(code = next_line(csv, &found, error)) && found) {
    any = true;
    csv->has_row = !take_separator(csv) && is_data(csv, a);
  }
  if (!code && !any)
    code = aspi_text_fail(&csv->text, csv->text.line, error, "the file ends without column names");
  else if (!code && !csv->has_row && *a->wrong)
    code = aspi_text_fail(&csv->text, a->wrong_line, error, "%s", a->wrong);
  else if (!code && !csv->has_row) {
    csv->separator = csv->forced ? csv->separator : aspi_text_separator(a->line[0]);
    *a->line[1] = '\0';
    take_names(csv, a);
  }
  free(a);
  return code;
}

aspi_csv *aspi_csv_open(const char *path, asp_error *error) {
  FILE *stream = aspi_file_open(path, error);
  aspi_csv *csv = stream ? malloc(sizeof *csv) : NULL;
  if (stream && !csv) {
    fclose(stream);
    aspi_fail(error, ASP_ENOMEM, "out of memory for the table '%s'", path);
  }
  if (!csv)
    return NULL;
  csv->stream = stream;
  csv->has_row = csv->forced = false;
  csv->text = aspi_text_create(stream, path);
  *csv->comment = '\0';
  if (!read_header(csv, error))
    return csv;
  aspi_csv_close(csv);
  return NULL;
}

void aspi_csv_close(aspi_csv *csv) {
  if (csv)
    fclose(csv->stream);
  free(csv);
}

int aspi_csv_find(const aspi_csv *csv, const char *name) {
  for (int i = 0; i < csv->columns; i++)
    if (strcmp(csv->names[i], name) == 0)
      return i;
  return -1;
}

int aspi_csv_need(const aspi_csv *csv, const char *name, asp_error *error) {
  int index = aspi_csv_find(csv, name);
  if (index >= 0)
    return index;
  char list[240] = "";
  for (int i = 0; i < csv->columns; i++)
    aspi_append(list, sizeof list, " %s", csv->names[i]);
  aspi_fail(error, ASP_EDATA, "%.200s: column '%s' is missing; there are:%s", csv->text.path, name,
            list);
  return -1;
}

asp_code aspi_csv_row(aspi_csv *csv, bool *found, asp_error *error) {
  asp_code code = ASP_OK;
  *found = true;
  if (!csv->has_row)
    code = next_line(csv, found, error);
  csv->has_row = false;
  if (code || !*found)
    return code;
  int count = aspi_text_split(csv->text.text, csv->separator, csv->fields, ASP_CSV_COLUMNS);
  if (count == csv->columns)
    return ASP_OK;
  return aspi_text_fail(&csv->text, csv->text.line, error, FIELDS, count, csv->columns,
                        commas(csv, count));
}

asp_code aspi_csv_number(const aspi_csv *csv, int column, double least, double most, double *value,
                         bool *missing, asp_error *error) {
  aspi_word word = ASP_WORD_MISSING;
  *value = NAN;
  if (column >= 0)
    word = aspi_text_number(csv->fields[column], value);
  if (missing)
    *missing = word == ASP_WORD_MISSING;
  if (word == ASP_WORD_MISSING && missing)
    return ASP_OK;
  if (word != ASP_WORD_NUMBER)
    return aspi_text_fail(&csv->text, csv->text.line, error, "%s is '%s'; a number is expected",
                          csv->names[column], csv->fields[column]);
  if (*value >= least && *value <= most)
    return ASP_OK;
  return aspi_text_fail(&csv->text, csv->text.line, error, "%s is %g; it must be %g to %g",
                        csv->names[column], *value, least, most);
}
