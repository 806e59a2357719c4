/* Tables in text files; see table.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/table.h"
#include "base/error.h"
#include "base/grow.h"
#include "base/units.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* A line of words ends the rows only after at least this many; fewer rows were part of the header.
 * Longer headers are kept up to here. */
enum { ROWS_LEAST = 3, HEADER_MOST = 1 << 16 };

/* ---- lines ---- */

static asp_code fail_memory(const aspi_table *t, asp_error *error) {
  return aspi_fail(error, ASP_ENOMEM, "%.200s:%zu: out of memory for a line", t->text.path,
                   t->text.line);
}

/* Cuts the current line. */
static asp_code cut(aspi_table *t, asp_error *error) {
  char *rest = t->text.text, *field;
  t->count = t->all = 0;
  while ((field = aspi_text_field(&rest, t->separator)) != NULL) {
    if (t->all == t->room) {
      char **grown = aspi_grow(t->fields, (size_t)t->all, sizeof *grown);
      if (!grown)
        return fail_memory(t, error);
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
  return aspi_text_number(t->fields[column], t->thousands, value);
}

/* ---- the header ---- */

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
 * ROWS_LEAST, are part of the header. */
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
    if (!row && !comment && aspi_table_field(t, 0, &value) != ASP_WORD_NUMBER)
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
    return fail_memory(t, error);
  while (!(code = aspi_text_line(&t->text, &found, error)) && found &&
         (t->start == 0 || t->text.line < t->start)) {
    bool names_separator = t->text.line == 1 && strncasecmp(t->text.text, "sep=", 4) == 0;
    if (!aspi_text_blank(t->text.text) && !names_separator && ftell(header) < HEADER_MOST)
      fprintf(header, "%s\n", t->text.text);
  }
  bool bad = ferror(header);
  bad = fclose(header) != 0 || bad || !t->header;
  if (bad && !code)
    code = fail_memory(t, error);
  if (!code && t->start > 0 && t->tagged)
    take_off_tags(t);
  return code;
}

/* ---- names ---- */

void aspi_plain(const char *name, char *to, size_t size) {
  static const char *const written[][2] = {
      {"\xC2\xB0", "_deg"},  {"\xC2\xB5", "u"},        {"\xCE\xBC", "u"},
      {"%", "_percent"},     {"\xCE\xB1", "alpha"},    {"\xCE\xB2", "beta"},
      {"\xCE\xB8", "theta"}, {"\xC3\x85", "angstrom"}, {"\xE2\x84\xAB", "angstrom"},
      {"\xC3\xB6", "oe"},    {"\xC3\xA9", "e"},        {"\xB0", "_deg"},
      {"\xB5", "u"},         {"\xC5", "angstrom"},     {"\xF6", "oe"},
      {"\xE9", "e"}};
  size_t n = 0;
  while (*name && n + 12 < size) {
    size_t i = 0, count = sizeof written / sizeof *written;
    while (i < count && strncmp(name, written[i][0], strlen(written[i][0])) != 0)
      i++;
    const char other[] = {isalnum((unsigned char)*name) ? (char)tolower((unsigned char)*name) : '_',
                          '\0'};
    const char *as = i < count ? written[i][1] : other;
    as += *as == '_' && (n == 0 || to[n - 1] == '_');
    n += (size_t)sprintf(to + n, "%s", as);
    name += i < count ? strlen(written[i][0]) : 1;
  }
  while (n > 0 && to[n - 1] == '_')
    n--;
  to[n] = '\0';
}

/* A unit of a line of units, in brackets or bare. */
static bool is_unit(const char *field, size_t length) {
  char name[ASP_PLAIN_MOST], copy[ASP_PLAIN_MOST];
  snprintf(copy, sizeof copy, "%.*s", (int)length, field);
  aspi_plain(copy, name, sizeof name);
  for (char *c = name; *c; c++)
    *c = *c == '_' ? '/' : *c;
  return !*name || aspi_unit_find(NULL, name, strlen(name), false);
}

/* A comment of units alone, as `# mm um`. */
static bool is_unit_line(const char *line, size_t length) {
  bool all = true;
  for (size_t from = 1, n; from < length && all; from += n + 1) {
    n = strcspn(line + from, " \t;,\n");
    all = is_unit(line + from, n);
  }
  return all;
}

/* The last line of the header above `end`, which becomes its index. Comments count only if they are
 * units, or there are no other lines. NULL if there is none. */
static const char *line_above(const aspi_table *t, const char **end) {
  bool others = *t->header && *t->header != '#';
  for (const char *c = t->header; (c = strchr(c, '\n')) != NULL; c++)
    others = others || (c[1] && c[1] != '#');
  while (*end > t->header) {
    const char *line = --*end;
    while (line > t->header && line[-1] != '\n')
      line--;
    size_t length = (size_t)(*end - line);
    *end = line;
    if (*line != '#' || !others || is_unit_line(line, length))
      return line;
  }
  return NULL;
}

/* Cuts a line of the header as names; where blanks separate them, a unit in brackets belongs to the
 * name before it. The number of names without empty ones behind, and with them; -1: no memory. */
static int cut_names(aspi_table *t, const char *line, int *all, aspi_column **list) {
  while (*line != t->separator && strchr("#%; \t", *line) && *line)
    line++;
  char *copy = strndup(line, strcspn(line, "\n")), *rest = copy, *field;
  int count = 0, kept = 0;
  while ((field = aspi_text_field(&rest, t->separator)) != NULL) {
    char *before = kept > 0 ? (*list)[kept - 1].name : NULL;
    if (t->separator == ' ' && before && strchr("([{", *field)) {
      aspi_append(before, ASP_PLAIN_MOST, " %s", field);
      continue;
    }
    aspi_column *grown = aspi_grow(*list, (size_t)kept, sizeof *grown);
    if (!grown)
      break;
    *list = grown;
    snprintf(grown[kept++].name, ASP_PLAIN_MOST, "%s", field);
    count = *field ? kept : count;
  }
  free(copy);
  *all = kept;
  return field || !copy ? -1 : count;
}

/* Names from the last line above the first row, of which the fields are counted, or the last two,
 * of which the second has their units. */
static asp_code parse_names(aspi_table *t, int least, asp_error *error) {
  const char *end = t->header + strlen(t->header), *line;
  for (int k = 0; k < 2 && (line = line_above(t, &end)) != NULL; k++) {
    aspi_column *list = NULL;
    int all, count = cut_names(t, line, &all, &list);
    if (count < 0) {
      free(list);
      return fail_memory(t, error);
    }
    count = count < t->count && all >= t->count ? t->count : count;
    bool fits = k ? count == t->columns
                  : least == 0 || count >= t->count || (count > 1 && t->separator != ' ');
    if (count < 1 || !fits || (least > 0 && count > t->all)) {
      free(list);
      break;
    }
    bool units = k == 0;
    for (int i = 0; i < count; i++) {
      char whole[2 * ASP_PLAIN_MOST];
      snprintf(whole, sizeof whole, "%.70s %.70s", list[i].name, k ? t->column[i].name : "");
      aspi_plain(whole, list[i].plain, sizeof list[i].plain);
      list[i].bracketed = strpbrk(whole, "[(");
      units = units && is_unit(list[i].name, strlen(list[i].name));
    }
    free(t->column);
    t->column = list;
    t->columns = count;
    if (!units)
      break;
  }
  t->nameless = t->columns == 0 && least == 0 && t->count > 0;
  if (!t->nameless)
    return ASP_OK;
  t->columns = t->count;
  t->column = calloc((size_t)t->columns, sizeof *t->column);
  return t->column ? ASP_OK : fail_memory(t, error);
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
  return code ? code : parse_names(t, least, error);
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

/* ---- rows and values ---- */

asp_code aspi_table_row(aspi_table *t, bool *found, asp_error *error) {
  asp_code code = aspi_table_line(t, found, error);
  if (code || !*found)
    return code;
  if (t->all == t->columns || (t->count <= t->columns && t->all > t->columns))
    return ASP_OK;
  return aspi_table_fail(t, error, "%d fields under %d column names%s", t->all, t->columns,
                         t->separator == ',' && t->all > t->columns
                             ? " (decimal commas need ; or tabs between the fields)"
                             : "");
}

int aspi_table_find(const aspi_table *t, const char *name) {
  for (int i = 0; i < t->columns; i++)
    if (strcmp(t->column[i].plain, name) == 0)
      return i;
  return -1;
}

int aspi_table_asked(const aspi_table *t, const char *asked, int most) {
  char *end;
  long number = strtol(asked, &end, 10);
  if (!*end)
    return number >= 1 && number <= most ? (int)number - 1 : -1;
  for (int i = 0; i < t->columns; i++) {
    const char *name = t->column[i].name;
    size_t length = strcspn(name, "([{/_ ");
    if (strcasecmp(name, asked) == 0 ||
        (strlen(asked) == length && strncasecmp(name, asked, length) == 0))
      return i;
  }
  return -1;
}

int aspi_table_need(const aspi_table *t, const char *name, asp_error *error) {
  int index = aspi_table_find(t, name);
  if (index >= 0)
    return index;
  char list[240] = "";
  for (int i = 0; i < t->columns; i++)
    aspi_append(list, sizeof list, " %s", t->column[i].name);
  if (t->nameless)
    aspi_table_fail(t, error,
                    "no column names: the line above the first row must contain them, not '%.40s'",
                    t->count ? t->fields[0] : "");
  else
    aspi_fail(error, ASP_EDATA, "%.200s: column '%s' is missing; there are:%s", t->text.path, name,
              list);
  return -1;
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

/* The text behind a key at the front of a line and the signs behind it, or NULL. A blank in the key
 * is any of " _-.". */
static const char *behind(const char *line, const char *key, size_t length) {
  static const char blanks[] = " _-.";
  while (*line != '\n' && !isalnum((unsigned char)*line) && (unsigned char)*line < 0x80)
    line++;
  for (size_t i = 0; i < length; i++)
    if (key[i] == ' ' ? strspn(line, blanks) == 0
                      : tolower((unsigned char)*line) != (unsigned char)key[i])
      return NULL;
    else
      line += key[i] == ' ' ? strspn(line, blanks) : 1;
  if (isalnum((unsigned char)*line) || (unsigned char)*line >= 0x80)
    return NULL;
  line += strspn(line, " \t:=;,\">");
  return *line == '\n' ? NULL : line;
}

const char *aspi_table_value(const aspi_table *t, const char *keys) {
  for (const char *line = t->header; line && *line; line = strchr(line, '\n') + 1)
    for (const char *key = keys; *key;
         key += key[strcspn(key, "|")] ? strcspn(key, "|") + 1 : strcspn(key, "|")) {
      const char *value = behind(line, key, strcspn(key, "|"));
      if (value)
        return value;
    }
  return NULL;
}
