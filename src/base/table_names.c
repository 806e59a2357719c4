/* The header of a table: names of columns with their units, and lines of key and value; see
 * table.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/grow.h"
#include "base/table.h"
#include "base/units.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

asp_code aspi_table_no_memory(const aspi_table *t, asp_error *error) {
  return aspi_fail(error, ASP_ENOMEM, "%.200s:%zu: out of memory for a line", t->text.path,
                   t->text.line);
}

void aspi_plain(const char *name, char *to, size_t size) {
  static const char *const written[][2] = {
      {"\xC2\xB0", "_deg"},  {"\xC2\xB5", "u"},        {"\xCE\xBC", "u"},
      {"%", "_percent"},     {"\xCE\xB1", "alpha"},    {"\xCE\xB2", "beta"},
      {"\xCE\xB8", "theta"}, {"\xC3\x85", "angstrom"}, {"\xE2\x84\xAB", "angstrom"},
      {"\xC3\xB6", "oe"},    {"\xC3\xA9", "e"},        {"\xC3\xBC", "ue"},
      {"\xC3\xA4", "ae"},    {"\xFC", "ue"},           {"\xCE\xA8", "psi"},
      {"\xCF\x88", "psi"},   {"\xCE\xB5", "epsilon"},  {"\xB0", "_deg"},
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

/* Cuts a line of the header as names; where single blanks separate them, a unit in brackets belongs
 * to the name before it. wide: tabs, or two blanks or more, separate names of several words. The
 * number of names without empty ones behind, and with them; -1: no memory. */
static int cut_names(aspi_table *t, const char *line, bool wide, int *all, aspi_column **list) {
  while (*line != t->separator && strchr("#%; \t", *line) && *line)
    line++;
  char *copy = strndup(line, strcspn(line, "\n")), *rest = copy, *field;
  const char separator = wide ? '\t' : t->separator;
  int count = 0, kept = 0;
  for (char *c = wide ? copy : NULL; c && (c = strstr(c, "  ")) != NULL;)
    for (*c++ = '\t'; *c == ' ';)
      memmove(c, c + 1, strlen(c));
  while ((field = aspi_text_field(&rest, separator)) != NULL) {
    char *before = kept > 0 ? (*list)[kept - 1].name : NULL;
    if (separator == ' ' && before && strchr("([{", *field)) {
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

const char *aspi_cell_unit(const char *field) {
  const char *unit = field + strspn(field, "+-0123456789.,eE ");
  return unit > field && aspi_unit_find(NULL, unit, strlen(unit), false) ? unit : "";
}

/* Units in the cells of the first row become part of the names. */
static asp_code take_units(aspi_table *t, asp_error *error) {
  bool any = t->nameless;
  for (int i = 0; i < t->count && t->columns == 0; i++)
    any = any || *aspi_cell_unit(t->fields[i]);
  if (any && !(t->column = calloc((size_t)t->count, sizeof *t->column)))
    return aspi_table_no_memory(t, error);
  t->columns = any ? t->count : t->columns;
  for (int i = 0; i < t->count && i < t->columns; i++) {
    aspi_column *c = &t->column[i];
    char plain[ASP_PLAIN_MOST];
    snprintf(c->unit, sizeof c->unit, "%s", aspi_cell_unit(t->fields[i]));
    aspi_plain(c->unit, plain, sizeof plain);
    size_t length = strlen(plain), all = strlen(c->plain);
    c->bracketed = c->bracketed || length > 0;
    if (length > 0 && (all < length || strcmp(c->plain + all - length, plain) != 0))
      aspi_append(c->plain, sizeof c->plain, "%s%s", all ? "_" : "", plain);
  }
  return ASP_OK;
}

asp_code aspi_table_parse_names(aspi_table *t, int least, asp_error *error) {
  const char *end = t->header + strlen(t->header), *line;
  for (int k = 0; k < 2 && (line = line_above(t, &end)) != NULL; k++) {
    aspi_column *list = NULL;
    int all, count = cut_names(t, line, false, &all, &list);
    if (t->separator == ' ' && count > t->count) {
      aspi_column *others = NULL;
      int all_others, wide = cut_names(t, line, true, &all_others, &others);
      bool fits = wide == t->count;
      free(fits ? list : others);
      list = fits ? others : list;
      count = fits ? wide : count;
      all = fits ? all_others : all;
    }
    if (count < 0) {
      free(list);
      return aspi_table_no_memory(t, error);
    }
    if (k == 0 && count == 1 && t->count > 1 && end > t->header) { /* the heading of a group */
      free(list);
      k--;
      continue;
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
  return take_units(t, error);
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
