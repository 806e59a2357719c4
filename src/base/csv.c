/* Tables in text files; see csv.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/csv.h"
#include "base/error.h"
#include "base/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { COMMENT_MOST = 1 << 22 }; /* characters */

/* Goes past the comments at hand, which may be longer than other lines; keeps the first one. */
static asp_code take_comments(aspi_csv *csv, asp_error *error) {
  int c;
  while ((c = getc(csv->stream)) == '#') {
    ungetc(c, csv->stream);
    bool found;
    size_t room = 0;
    asp_code code = csv->comment ? ASP_OK
                                 : aspi_text_long_line(&csv->text, &csv->comment, &room,
                                                       COMMENT_MOST, &found, error);
    if (code)
      return code;
    while (room == 0 && (c = aspi_text_character(&csv->text)) != EOF && c != '\n')
      ;
  }
  ungetc(c, csv->stream);
  return ASP_OK;
}

/* The next line that is neither blank nor a comment. */
static asp_code next_line(aspi_csv *csv, bool *found, asp_error *error) {
  for (;;) {
    asp_code code = take_comments(csv, error);
    if (!code)
      code = aspi_text_line(&csv->text, found, error);
    if (code || !*found)
      return code;
    const char *text = csv->text.text, *first = text + strspn(text, " \t\v\f");
    if (*first && *first != '#')
      return ASP_OK;
  }
}

/* Cuts the line at hand into fields; true if one of them is a number. */
static bool cut(aspi_csv *csv) {
  double value;
  bool any = false;
  csv->separator = csv->forced ? csv->separator : aspi_text_separator(csv->text.text);
  csv->count = aspi_text_split(csv->text.text, csv->separator, csv->fields, ASP_CSV_COLUMNS);
  for (int i = 0; i < csv->count && !any; i++)
    any = aspi_text_number(csv->fields[i], &value) == ASP_WORD_NUMBER;
  return any;
}

/* A unit as a line of units has them, in brackets or bare. */
static bool is_unit(const char *field) {
  field += strspn(field, "([{ ");
  size_t length = strcspn(field, ")]} ");
  return length == 0 || strncmp(field, "-", length) == 0 ||
         aspi_unit_find(NULL, field, length, false);
}

/* Takes the names from the line above the first row, or from the one above a line of units. */
static void take_names(aspi_csv *csv) {
  char *upper[ASP_CSV_COLUMNS];
  int count = aspi_text_names(csv->above[1], csv->separator, upper, ASP_CSV_COLUMNS);
  csv->columns = *csv->above[0]
                     ? aspi_text_names(csv->above[0], csv->separator, csv->names, ASP_CSV_COLUMNS)
                     : 0;
  bool units = csv->columns > 0 && count == csv->columns;
  for (int i = 0; i < csv->columns; i++)
    units = units && is_unit(csv->names[i]);
  for (int i = 0; i < csv->columns; i++) {
    csv->units[i] = units ? csv->names[i] : "";
    csv->names[i] = units ? upper[i] : csv->names[i];
  }
}

/* `sep=;`, as spreadsheets understand it. */
static bool take_separator(aspi_csv *csv) {
  const char *line = csv->text.text;
  if (csv->text.line != 1 || strncasecmp(line, "sep=", 4) != 0 || !line[4])
    return false;
  csv->separator = line[4];
  return csv->forced = true;
}

static asp_code check_count(const aspi_csv *csv, asp_error *error) {
  if (csv->columns == 0)
    return aspi_text_fail(&csv->text, csv->text.line, error,
                          "'%.40s' stands where a column name is expected; the line above the "
                          "first numbers must name the columns",
                          csv->fields[0]);
  if (csv->count == csv->columns)
    return ASP_OK;
  return aspi_text_fail(&csv->text, csv->text.line, error, "%d fields under %d column names%s",
                        csv->count, csv->columns,
                        csv->separator == ',' && csv->count > csv->columns
                            ? " (decimal commas need ; or tabs between the fields)"
                            : "");
}

/* Titles, the line of names, and a line of units below it, up to the first row. */
static asp_code read_header(aspi_csv *csv, asp_error *error) {
  asp_error wrong = {ASP_OK, ""}; /* with the first number that is no row's */
  asp_code code = ASP_OK;
  bool found = true, any = false;
  while (!csv->has_row && !(code = next_line(csv, &found, error)) && found) {
    char line[ASP_TEXT_MOST];
    any = true;
    if (take_separator(csv))
      continue;
    strcpy(line, csv->text.text);
    bool number = cut(csv);
    if (number) {
      take_names(csv);
      csv->has_row = !check_count(csv, wrong.code ? NULL : &wrong);
    }
    if (!csv->has_row) {
      strcpy(csv->above[1], number ? "" : csv->above[0]);
      strcpy(csv->above[0], number ? "" : line);
    }
  }
  if (!code && !any)
    code = aspi_text_fail(&csv->text, csv->text.line, error, "the file ends without column names");
  else if (!code && !csv->has_row && wrong.code)
    code = aspi_fail(error, wrong.code, "%s", wrong.text);
  else if (!code && !csv->has_row)
    take_names(csv);
  return code;
}

aspi_csv *aspi_csv_open(const char *path, asp_error *error) {
  FILE *stream = aspi_file_open(path, error);
  aspi_csv *csv = stream ? calloc(1, sizeof *csv) : NULL;
  if (stream && !csv) {
    fclose(stream);
    aspi_fail(error, ASP_ENOMEM, "out of memory for the table '%s'", path);
  }
  if (!csv)
    return NULL;
  csv->stream = stream;
  csv->text = aspi_text_create(stream, path);
  asp_code code = read_header(csv, error);
  if (!code && !csv->comment && !(csv->comment = calloc(1, 1)))
    code = aspi_fail(error, ASP_ENOMEM, "out of memory for the table '%s'", path);
  if (!code)
    return csv;
  aspi_csv_close(csv);
  return NULL;
}

void aspi_csv_close(aspi_csv *csv) {
  if (!csv)
    return;
  fclose(csv->stream);
  free(csv->comment);
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
  *found = true;
  if (csv->has_row) {
    csv->has_row = false;
    return ASP_OK;
  }
  asp_code code = next_line(csv, found, error);
  if (code || !*found)
    return code;
  csv->count = aspi_text_split(csv->text.text, csv->separator, csv->fields, ASP_CSV_COLUMNS);
  return check_count(csv, error);
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
