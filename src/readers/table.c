/* Numbers in columns of a text; see table.h. What the header does not say is asked for.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/table.h"
#include "base/error.h"
#include "base/number.h"
#include "base/units.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { LINE_MOST = 1 << 22 };

/* With fewer lines of numbers than this, one of another kind is no end of them. */
enum { LINES_LEAST = 3 };

/* ---- lines ---- */

/* Commas are decimal ones where blanks stand between the fields. */
static char separator_of(const char *line) {
  char separator = aspi_text_separator(line);
  const char *blank = separator == ',' ? strchr(line + strspn(line, " "), ' ') : NULL;
  bool between = blank && blank[strspn(blank, " ")] && !strstr(line, ", ") && !strstr(line, " ,");
  return between ? ' ' : separator;
}

static asp_code read_line(aspi_table *t, bool *found, asp_error *error) {
  return aspi_text_long_line(&t->text, &t->line, &t->line_room, LINE_MOST, found, error);
}

/* Cuts the line; empty fields behind those that are due are left out. */
static asp_code cut(aspi_table *t, asp_error *error) {
  char *next = t->line, *word;
  for (t->count = 0; (word = aspi_text_field(&next, t->separator)) != NULL; t->count++) {
    if (t->count == t->room) {
      int room = t->room ? 2 * t->room : 16;
      aspi_field *grown = realloc(t->fields, (size_t)room * sizeof *grown);
      if (!grown)
        return aspi_fail(error, ASP_ENOMEM, "%.200s:%zu: out of memory for a line of %d numbers",
                         t->text.path, t->text.line, t->count);
      t->fields = grown;
      t->room = room;
    }
    aspi_field *f = &t->fields[t->count];
    f->text = word;
    f->kind = aspi_text_number(word, &f->value);
  }
  t->raw = t->lines ? t->raw : t->count;
  while (t->count > t->due && !*t->fields[t->count - 1].text)
    t->count--;
  return ASP_OK;
}

/* Meters in `name`, a number and a unit, or a unit alone; `else_` where the line has none. */
static double stated(const char *line, const char *name, bool number, double else_) {
  const char *at = strstr(line, name);
  char *end;
  if (!at)
    return else_;
  at += strlen(name);
  double value = number ? aspi_number(at, &end) : 1;
  at = number ? end : at;
  size_t length = aspi_text_inside(&at);
  return value * aspi_unit_meters(at, length);
}

static void note_header(aspi_table *t, const char *line) {
  if (aspi_text_blank(line))
    return;
  memcpy(t->above[1], t->above[0], sizeof *t->above);
  snprintf(t->above[0], sizeof *t->above, "%s", line);
  t->side[0] = stated(line, "Width:", true, t->side[0]);
  t->side[1] = stated(line, "Height:", true, t->side[1]);
  t->unit = stated(line, "Value units:", false, t->unit);
}

static bool begins(const aspi_table *t, int least) {
  bool numbers = t->count >= least;
  for (int i = 0; i < least && numbers; i++)
    numbers = t->fields[i].kind != ASP_WORD_OTHER && *t->fields[i].text;
  return numbers;
}

static asp_code skip_header(aspi_table *t, int least, asp_error *error) {
  for (bool found;;) {
    char line[ASP_TEXT_MOST];
    asp_code code = read_line(t, &found, error);
    if (!code && !found)
      code = aspi_text_fail(&t->text, t->text.line, error,
                            least == 1 ? "the file ends without a line that begins with a number"
                                       : "the file ends without a line of two numbers or more "
                                         "(heights alone of a profile need the step between them, "
                                         "reader: step_x)");
    if (code)
      return code;
    t->separator = separator_of(t->line);
    snprintf(line, sizeof line, "%s", t->line);
    if ((code = cut(t, error)) || begins(t, least))
      return code;
    note_header(t, line);
  }
}

asp_code aspi_table_open(const aspi_text *text, int least, aspi_table **table, asp_error *error) {
  aspi_table *t = *table = calloc(1, sizeof *t);
  if (!t)
    return aspi_fail(error, ASP_ENOMEM, "%.200s: out of memory for its header", text->path);
  t->text = *text;
  asp_code code = skip_header(t, least, error);
  t->due = t->count;
  t->lines = 1;
  return code;
}

void aspi_table_close(aspi_table *t) {
  if (!t)
    return;
  free(t->line);
  free(t->fields);
  free(t);
}

static bool fits(const aspi_table *t, const aspi_axes *axes) {
  bool good = t->count > 0;
  for (int i = 0; i < t->count && !axes; i++)
    good = good && t->fields[i].kind != ASP_WORD_OTHER;
  for (int k = 0; k < 3 && axes && good; k++) {
    int at = axes->column[k];
    good = at < 0 || (at < t->count && (t->fields[at].kind == ASP_WORD_NUMBER ||
                                        (k == 2 && t->fields[at].kind == ASP_WORD_MISSING)));
  }
  return good;
}

static asp_code fail_line(const aspi_table *t, size_t line, const char *shown, asp_error *error) {
  return aspi_text_fail(&t->text, line, error,
                        "'%s' where numbers are expected (or a height that is missing: nan, bad, "
                        "--- or nothing)",
                        shown);
}

#define DECIMAL_COMMAS                                                                             \
  "are there decimal commas? Separate columns by semicolons or tabs, or write decimal points"

asp_code aspi_table_check(aspi_table *t, const aspi_axes *axes, asp_error *error) {
  if (!fits(t, axes))
    return fail_line(t, t->text.line, t->fields[0].text, error);
  if (t->count > t->due || (!axes && t->count < t->due))
    return aspi_text_fail(&t->text, t->text.line, error,
                          "%d fields, the first line of numbers has %d%s", t->count, t->due,
                          t->separator == ',' ? ": " DECIMAL_COMMAS : "");
  for (int i = 0; i < t->count && !axes && t->separator == ','; i++)
    if (*t->fields[i].text == '0' && isdigit((unsigned char)t->fields[i].text[1]))
      return aspi_text_fail(&t->text, t->text.line, error,
                            "numbers that begin with a zero: " DECIMAL_COMMAS);
  return ASP_OK;
}

asp_code aspi_table_next(aspi_table *t, const aspi_axes *axes, bool *found, asp_error *error) {
  char shown[48] = "";
  size_t other = 0; /* the first line of another kind */
  asp_code code;
  while (!(code = read_line(t, found, error)) && *found) {
    if (t->line[strspn(t->line, " \t")] == '#' ||
        (aspi_text_blank(t->line) && (t->separator == ' ' || !strchr(t->line, t->separator))))
      continue;
    if (!other)
      snprintf(shown, sizeof shown, "%.47s", t->line);
    if ((code = cut(t, error)))
      return code;
    bool good = fits(t, axes), first = t->count > 0 && t->fields[0].kind == ASP_WORD_NUMBER;
    if (other ? good && first : !good && (first || t->lines < LINES_LEAST))
      return fail_line(t, other ? other : t->text.line, shown, error);
    if (good && !other) {
      t->lines++;
      return aspi_table_check(t, axes, error);
    }
    other = other ? other : t->text.line;
  }
  t->end_line = other;
  return code;
}

/* ---- names ---- */

/* Quantity that a column's name stands for. */
typedef enum kind { UNKNOWN, POSITION, HEIGHT } kind;

/* The first words of names, in English and German; and of heights that count downward. */
static const char *const known[] = {
    [POSITION] = "x pos position positions distance dist lateral length travel scan weg strecke",
    [HEIGHT] = "z height heights h raw profile depth depths level amplitude elevation hoehe tiefe "
               "profil"};
static const char depths[] = "depth depths tiefe";

typedef struct column {
  const char *name;
  double unit; /* m; 0: none is stated */
} column;

typedef struct heading {
  column column[ASP_COLUMNS_MOST];
  int columns, named; /* of the table, and those of them that have a name */
  char text[2][ASP_TEXT_MOST];
} heading;

/* The unit at the end of a name, in brackets or behind a blank, slash or underscore; *bare: there
 * is nothing before it. */
static double unit_in(const char *name, bool *bare) {
  size_t end = strlen(name), from;
  while (end > 0 && strchr(")]} ", name[end - 1]))
    end--;
  for (from = end; from > 0 && !strchr("([{/_ ", name[from - 1]);)
    from--;
  *bare = strspn(name, "([{ ") >= from;
  return aspi_unit_meters(name + from, end - from);
}

static size_t first_word(const char *name) {
  size_t length = 0;
  while (isalpha((unsigned char)name[length]))
    length++;
  return length;
}

static kind kind_of(const column *c) {
  const char *mark = strpbrk(c->name, "([{/");
  if (mark && isalpha((unsigned char)mark[1]) && !(c->unit > 0)) /* a unit, but of no length */
    return UNKNOWN;
  for (int k = POSITION; k <= HEIGHT; k++)
    if (aspi_word_index(known[k], c->name, first_word(c->name), false) >= 0)
      return (kind)k;
  return UNKNOWN;
}

/* Names and units in the line right above the numbers, or in the two above them: names, units. */
static void read_heading(const aspi_table *t, heading *h) {
  h->columns = t->due;
  h->named = 0;
  for (int i = 0; i < ASP_COLUMNS_MOST; i++)
    h->column[i] = (column){"", 0};
  for (int k = 0; k < 2; k++) {
    char *name[ASP_COLUMNS_MOST];
    strcpy(h->text[k], t->above[k]);
    int count = aspi_text_names(h->text[k], t->separator, name, ASP_COLUMNS_MOST);
    while (count > 0 && !*name[count - 1])
      count--;
    if (count < 1 || count > t->raw || (count < t->due && (t->separator == ' ' || count < 2)))
      return;
    bool units = k == 0;
    for (int i = 0; i < count; i++) {
      bool bare;
      double unit = unit_in(name[i], &bare);
      units = units && bare && (unit > 0 || !*name[i] || strcmp(name[i], "-") == 0);
      h->column[i].unit = h->column[i].unit > 0 ? h->column[i].unit : unit;
      h->column[i].name = name[i];
    }
    h->named = count;
    h->columns = count > t->due ? count : t->due;
    if (!units)
      return;
    for (int i = 0; i < count; i++)
      h->column[i].name = "";
    h->named = 0;
  }
}

/* The first column of that kind that is not the other one; -1: none. */
static int first_of(const heading *h, kind wanted, int other) {
  for (int i = 0; i < h->named; i++)
    if (i != other && kind_of(&h->column[i]) == wanted)
      return i;
  return -1;
}

/* The first column whose name is one letter and more. */
static int first_named(const heading *h, char letter) {
  for (int i = 0; i < h->named; i++)
    if (tolower((unsigned char)*h->column[i].name) == letter && first_word(h->column[i].name) == 1)
      return i;
  return -1;
}

/* ---- columns ---- */

#define ASK_COLUMNS                                                                                \
  "say which columns are positions and heights (reader: x_column, column), "                       \
  "or the step of heights alone (reader: column, step_x)"

/* A column that is asked for by its number from 1, or by its number or name as text: from 0, -1
 * where none is. Names are compared without their unit. */
static asp_code find_asked(const aspi_table *t, const heading *h, const char *asked, int number,
                           int *found, asp_error *error) {
  char *end = NULL;
  if (asked)
    number = (int)strtol(asked, &end, 10);
  *found = number - 1;
  if (!asked || !*end) {
    if (number <= h->columns && (number > 0 || !asked))
      return ASP_OK;
    return aspi_text_fail(&t->text, t->text.line, error,
                          "column %d is asked for; the file has %d columns", number, h->columns);
  }
  for (*found = 0; *found < h->named; ++*found) {
    const char *name = h->column[*found].name;
    size_t length = strcspn(name, "([{/_ ");
    if (strcasecmp(name, asked) == 0 ||
        (strlen(asked) == length && strncasecmp(name, asked, length) == 0))
      return ASP_OK;
  }
  return aspi_text_fail(&t->text, t->text.line, error,
                        "column '%.40s' is asked for; none of the %d columns has that name", asked,
                        h->columns);
}

/* The columns that neither the user nor a line of names states. Of two columns without known names
 * the first one is that of positions. */
static void complete(const heading *h, bool heights_alone, int *x, int *z) {
  bool none = first_of(h, POSITION, -1) < 0 && first_of(h, HEIGHT, -1) < 0;
  if (h->named == 0 || (none && h->columns <= 2 && !heights_alone)) {
    *x = *x >= 0 || heights_alone ? *x : *z == 0 && h->columns > 1 ? 1 : 0;
    *z = *z >= 0 ? *z : heights_alone || *x == 1 ? 0 : 1;
  }
  *z = *z < 0 ? first_of(h, HEIGHT, *x) : *z;
  *x = *x < 0 && !heights_alone ? first_of(h, POSITION, *z) : *x;
}

static asp_code find_units(const aspi_table *t, const heading *h,
                           const aspi_profile_options *options, aspi_axes *axes, asp_error *error) {
  for (int k = 0; k < 3; k++) {
    double own = k < 2 ? options->unit_x : options->unit_z;
    int at = axes->column[k];
    axes->unit[k] = at < 0 ? 1 : own > 0 ? own : h->column[at].unit;
    if (!(axes->unit[k] > 0))
      return aspi_text_fail(&t->text, t->text.line, error,
                            "no unit of length is stated of column %d before the first numbers; "
                            "say which unit of length the columns are in (reader: unit_x, unit_z)",
                            at + 1);
    if (k == 2 &&
        aspi_word_index(depths, h->column[at].name, first_word(h->column[at].name), false) >= 0)
      axes->unit[k] *= -1;
  }
  return ASP_OK;
}

static asp_code choose(aspi_table *t, const heading *h, const aspi_profile_options *options,
                       aspi_axes *axes, asp_error *error) {
  bool alone = options->step[0] > 0;
  int x = -1, z = -1;
  asp_code code = alone ? ASP_OK : find_asked(t, h, options->x_column, 0, &x, error);
  code = code ? code : find_asked(t, h, options->z_column, options->column, &z, error);
  if (code)
    return code;
  if (x >= 0 && x == z)
    return aspi_text_fail(&t->text, t->text.line, error,
                          "column %d is asked for as positions and as heights", x + 1);
  bool by_user = x >= 0;
  if (z < 0 && h->columns > (alone ? 1 : 2) && h->named < t->due)
    return aspi_text_fail(&t->text, t->text.line, error,
                          "%d columns under %d names%s; " ASK_COLUMNS, h->columns, h->named,
                          t->separator == ',' ? " (or " DECIMAL_COMMAS ")" : "");
  complete(h, alone, &x, &z);
  if (z < 0 || (x < 0 && !alone))
    return aspi_text_fail(&t->text, t->text.line, error, "no column is named as %s; " ASK_COLUMNS,
                          z < 0 ? "a height" : "a position");
  int y = first_named(h, 'y');
  bool both = y >= 0 && y != z && !by_user && x >= 0 && first_named(h, 'x') == x;
  *axes = (aspi_axes){.column = {x, both ? y : -1, z}};
  return find_units(t, h, options, axes, error);
}

asp_code aspi_table_find(aspi_table *t, const aspi_profile_options *options, bool is_map,
                         aspi_axes *axes, bool *is_matrix, asp_error *error) {
  heading *h = malloc(sizeof *h);
  if (!h)
    return aspi_fail(error, ASP_ENOMEM, "%.200s: out of memory for its header", t->text.path);
  read_heading(t, h);
  asp_code code = ASP_OK;
  *is_matrix = false;
  if (is_map) {
    int x = first_named(h, 'x'), y = first_named(h, 'y'), z = first_named(h, 'z');
    z = z < 0 ? first_of(h, HEIGHT, -1) : z;
    bool named = x >= 0 && y >= 0 && z >= 0;
    *axes = named ? (aspi_axes){.column = {x, y, z}} : (aspi_axes){.column = {0, 1, 2}};
    *is_matrix = !named && t->due != 3;
    code = *is_matrix ? ASP_OK : find_units(t, h, options, axes, error);
  } else {
    code = choose(t, h, options, axes, error);
  }
  t->due = h->columns;
  free(h);
  return code ? code : aspi_table_check(t, *is_matrix ? NULL : axes, error);
}
