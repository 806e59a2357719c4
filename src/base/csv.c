/* Tables in text files; see csv.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/csv.h"
#include "base/error.h"
#include "base/file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

static asp_code read_header(aspi_csv *csv, asp_error *error) {
  bool found;
  asp_code code = next_line(csv, &found, error);
  if (code)
    return code;
  if (!found)
    return aspi_text_fail(&csv->text, csv->text.line, error, "the file ends without column names");
  strcpy(csv->header, csv->text.text);
  const char *separator = strchr(csv->header, ';');
  separator = separator ? separator : strchr(csv->header, '\t');
  separator = separator ? separator : strchr(csv->header, ',');
  csv->separator = separator ? *separator : ' ';
  csv->columns = aspi_text_split(csv->header, csv->separator, csv->names, ASP_CSV_COLUMNS);
  double number;
  for (int i = 0; i < csv->columns; i++)
    if (aspi_text_number(csv->names[i], false, &number) == ASP_WORD_NUMBER)
      return aspi_text_fail(
          &csv->text, csv->text.line, error,
          "'%s' stands where a column name is expected; the first line that is no "
          "comment must name the columns",
          csv->names[i]);
  return ASP_OK;
}

aspi_csv *aspi_csv_create(FILE *stream, const char *path, asp_error *error) {
  aspi_csv *csv = malloc(sizeof *csv);
  if (!csv) {
    fclose(stream);
    aspi_fail(error, ASP_ENOMEM, "out of memory for the table '%s'", path);
    return NULL;
  }
  csv->stream = stream;
  csv->text = aspi_text_create(stream, path);
  *csv->comment = '\0';
  if (read_header(csv, error)) {
    aspi_csv_close(csv);
    return NULL;
  }
  return csv;
}

aspi_csv *aspi_csv_open(const char *path, asp_error *error) {
  FILE *stream = aspi_file_open(path, error);
  return stream ? aspi_csv_create(stream, path, error) : NULL;
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
  for (int i = 0; i < csv->columns; i++) {
    size_t used = strlen(list);
    snprintf(list + used, sizeof list - used, " %s", csv->names[i]);
  }
  aspi_fail(error, ASP_EDATA, "%.200s: column '%s' is missing; there are:%s", csv->text.path, name,
            list);
  return -1;
}

asp_code aspi_csv_row(aspi_csv *csv, bool *found, asp_error *error) {
  asp_code code = next_line(csv, found, error);
  if (code || !*found)
    return code;
  int count = aspi_text_split(csv->text.text, csv->separator, csv->fields, ASP_CSV_COLUMNS);
  if (count == csv->columns)
    return ASP_OK;
  return aspi_text_fail(&csv->text, csv->text.line, error, "%d fields under %d column names%s",
                        count, csv->columns,
                        csv->separator == ',' && count > csv->columns
                            ? " (decimal commas need ; or tabs between the fields)"
                            : "");
}

asp_code aspi_csv_number(const aspi_csv *csv, int column, double least, double most, double *value,
                         bool *missing, asp_error *error) {
  aspi_word word = ASP_WORD_MISSING;
  *value = NAN;
  if (column >= 0)
    word = aspi_text_number(csv->fields[column], csv->separator == ';' || csv->separator == '\t',
                            value);
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
