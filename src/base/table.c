/* Tables in text files: lines, their fields, and rows of numbers; see table.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/table.h"
#include "base/error.h"
#include "base/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* A line of words ends the rows only after at least this many; fewer rows were part of the header.
 * Longer headers are kept up to here. */
enum { ROWS_LEAST = 3, HEADER_MOST = 1 << 16 };

/* Cuts the current line. */
static asp_code cut(aspi_table *t, asp_error *error) {
  char *rest = t->text.text, *field;
  bool joins = false; /* the next field, behind a sign */
  t->count = t->all = 0;
  while ((field = aspi_text_field(&rest, t->separator)) != NULL) {
    size_t sign = t->separator == ' ' && t->all > 0 ? aspi_table_sign(field) : 0;
    if (sign > 0 || joins) {
      for (char *c = t->fields[t->all - 1]; c < field; c++)
        *c = *c ? *c : ' ';
      joins = sign > 0 && !field[sign];
      continue;
    }
    if (t->all == t->room) {
      char **grown = aspi_grow(t->fields, (size_t)t->all, sizeof *grown);
      if (!grown)
        return aspi_table_no_memory(t, error);
      t->fields = grown;
      t->room = t->all ? 2 * t->all : 1;
    }
    t->fields[t->all++] = field;
    t->count = *field ? t->all : t->count;
  }
  return ASP_OK;
}

/* Strips unclosed tags from the front of a header line. */
static void take_off_tags(aspi_table *t) {
  char *line = t->text.text + strspn(t->text.text, " \t"), *end = strchr(line, '<');
  if (end == line && t->rows == 0) {
    char *text = strchr(line, '>');
    if (!text || strchr(text, '<'))
      return;
    t->text.length -= (size_t)(text + 1 - t->text.text);
    t->text.text = text + 1;
  } else if (end && end > line) {
    *end = '\0';
    t->text.length = (size_t)(end - t->text.text);
  }
}

asp_code aspi_table_line(aspi_table *t, bool *found, asp_error *error) {
  *found = t->has_row;
  if (t->has_row) {
    t->has_row = false;
    t->rows = 1;
    return ASP_OK;
  }
  for (;;) {
    asp_code code = aspi_text_line(&t->text, found, error);
    if (code || !*found)
      return code;
    const char *text = t->text.text, *first = text + strspn(text, " \t\v\f");
    bool empty = !*first && (t->separator == ' ' || !memchr(text, t->separator, t->text.length));
    if (empty || (*first == '#' && t->start > 0 && t->text.line >= t->start))
      continue;
    if (t->tagged)
      take_off_tags(t);
    return cut(t, error);
  }
}

aspi_word aspi_table_field(const aspi_table *t, int column, double *value) {
  *value = NAN;
  if (column < 0 || column >= t->all)
    return ASP_WORD_MISSING;
  const char *field = t->fields[column];
  aspi_word word = aspi_text_number(field, t->thousands, value);
  const char *unit = word == ASP_WORD_OTHER ? aspi_cell_unit(field) : "";
  if (!*unit || (column < t->columns && strcmp(t->column[column].unit, unit) != 0))
    return word;
  char number[ASP_PLAIN_MOST];
  snprintf(number, sizeof number, "%.*s", (int)(unit - field), field);
  return aspi_text_number(number, t->thousands, value);
}

static bool begins(const aspi_table *t, int least) {
  double value;
  bool numbers = *t->text.text != '#' && (t->width == 0 || t->all == t->width);
  for (int i = 0; i < least && numbers; i++)
    numbers = i < t->count && *t->fields[i] && aspi_table_field(t, i, &value) != ASP_WORD_OTHER;
  for (int i = 0; i < t->count && least == 0 && numbers; i++)
    if (aspi_table_field(t, i, &value) == ASP_WORD_NUMBER)
      return true;
  return numbers && least > 0;
}

/* Finds the line of the first row; 0 if there is none. Rows above a line of words, fewer than
 * ROWS_LEAST, are part of the header; but in a table (least 0) one word alone is the heading of a
 * group. */
static asp_code find_start(aspi_table *t, int least, asp_error *error) {
  size_t start = 0, first = 0, rows = 0;
  double value;
  bool found = true;
  asp_code code = ASP_OK;
  while (rows < ROWS_LEAST && !(code = aspi_table_line(t, &found, error)) && found) {
    bool row = begins(t, least), comment = *t->text.text == '#';
    if (row && rows++ == 0)
      start = t->text.line;
    first = first ? first : start;
    bool heading = least == 0 && t->count == 1;
    if (!row && !comment && !heading && aspi_table_field(t, 0, &value) != ASP_WORD_NUMBER)
      rows = 0;
  }
  t->start = rows > 0 ? start : first;
  return code ? code : aspi_text_rewind(&t->text, error);
}

/* Keeps the lines above the first row, up to HEADER_MOST and the line that passes it. */
static asp_code read_header(aspi_table *t, asp_error *error) {
  bool found = true;
  size_t length = 0;
  asp_code code = ASP_OK;
  FILE *header = open_memstream(&t->header, &length);
  if (!header)
    return aspi_table_no_memory(t, error);
  while (!(code = aspi_text_line(&t->text, &found, error)) && found &&
         (t->start == 0 || t->text.line < t->start)) {
    bool names_separator = t->text.line == 1 && strncasecmp(t->text.text, "sep=", 4) == 0;
    if (!aspi_text_blank(t->text.text) && !names_separator && ftell(header) < HEADER_MOST)
      fprintf(header, "%s\n", t->text.text);
  }
  bool bad = ferror(header);
  bad = fclose(header) != 0 || bad || !t->header;
  if (bad && !code)
    code = aspi_table_no_memory(t, error);
  if (!code && t->start > 0 && t->tagged)
    take_off_tags(t);
  return code;
}

static asp_code open_text(aspi_table *t, int least, asp_error *error) {
  asp_code code = aspi_text_rewind(&t->text, error);
  if (code || (code = aspi_table_survey(t, error)))
    return code;
  least = least > 0 && t->width == 1 ? 1 : least;
  if ((code = find_start(t, least, error)) || (code = read_header(t, error)))
    return code;
  if (t->start == 0 && !*t->header && least == 0)
    return aspi_file_fail(t->text.path, 1, error, "the file ends without column names");
  t->has_row = t->start > 0;
  code = cut(t, error);
  return code ? code : aspi_table_parse_names(t, least, error);
}

aspi_table *aspi_table_open(FILE *stream, const char *path, int least, asp_error *error) {
  FILE *file = stream ? stream : aspi_file_open(path, error);
  aspi_table *t = file ? calloc(1, sizeof *t) : NULL;
  if (file && !t) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for the table '%s'", path);
    if (!stream)
      fclose(file);
  }
  if (!t)
    return NULL;
  t->text = aspi_text_create(file, path);
  t->owns_stream = !stream;
  if (!open_text(t, least, error))
    return t;
  aspi_table_close(t);
  return NULL;
}

void aspi_table_close(aspi_table *t) {
  if (!t)
    return;
  if (t->owns_stream)
    fclose(t->text.stream);
  aspi_text_close(&t->text);
  free(t->column);
  free(t->header);
  free(t->fields);
  free(t);
}

/* True for a line of words among the rows, as the heading of a group. */
static bool is_heading(const aspi_table *t) {
  double value;
  bool words = t->count < t->columns;
  for (int i = 0; i < t->count && words; i++)
    words = !*t->fields[i] || aspi_table_field(t, i, &value) == ASP_WORD_OTHER;
  return words;
}

asp_code aspi_table_row(aspi_table *t, bool *found, asp_error *error) {
  asp_code code;
  do {
    code = aspi_table_line(t, found, error);
  } while (!code && *found && is_heading(t));
  if (code || !*found)
    return code;
  if (t->all == t->columns || (t->count <= t->columns && t->all > t->columns))
    return ASP_OK;
  return aspi_table_fail(t, error, "%d fields under %d column names%s", t->all, t->columns,
                         t->separator == ',' && t->all > t->columns
                             ? " (decimal commas need ; or tabs between the fields)"
                             : "");
}

asp_code aspi_table_number(const aspi_table *t, int column, double least, double most,
                           double *value, bool *missing, asp_error *error) {
  aspi_word word = aspi_table_field(t, column, value);
  if (missing)
    *missing = word == ASP_WORD_MISSING;
  if (word == ASP_WORD_MISSING && missing)
    return ASP_OK;
  if (word != ASP_WORD_NUMBER)
    return aspi_table_fail(t, error, "%s is '%s'; a number is expected", t->column[column].name,
                           t->fields[column]);
  if (*value >= least && *value <= most)
    return ASP_OK;
  return aspi_table_fail(t, error, "%s is %g; it must be %g to %g", t->column[column].name, *value,
                         least, most);
}
