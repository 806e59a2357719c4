/* Finds the columns of positions and heights in a text file, and their units, from the line of
 * names above them, if there is one. Two columns may have other names than those of positions and
 * heights; of more, the user says which ones are meant.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/header.h"
#include "base/error.h"
#include "base/units.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Quantity that a column's name stands for. */
typedef enum kind { UNKNOWN, POSITION, HEIGHT, NO_LENGTH } kind;

/* A column according to the lines of names. */
typedef struct column {
  char name[64];
  double unit; /* m; 0: none is stated */
  kind kind;
  bool is_depth; /* a height that counts downward */
} column;

/* The first words of names, in English and German. */
static const char *const known[] = {
    [POSITION] = "x pos position positions distance dist lateral length travel scan weg strecke",
    [HEIGHT] = "z height heights h raw profile depth depths level amplitude elevation hoehe tiefe "
               "profil",
    [NO_LENGTH] =
        "point pt points no nr number index idx i n id sample t time zeit punkt messpunkt lfd "
        "pixel px angle temperature intensity force speed line quality valid",
};

/* Names of heights that count downward. */
static const char depths[] = "depth depths tiefe";

/* True if a name has a unit in brackets or behind a slash, of length or not. */
static bool has_unit(const char *name) {
  const char *mark = strpbrk(name, "([{/");
  return mark && isalpha((unsigned char)mark[1]);
}

static size_t first_word(const char *name) {
  size_t length = 0;
  while (isalpha((unsigned char)name[length]))
    length++;
  return length;
}

static kind kind_of(const char *name) {
  size_t length = first_word(name);
  if (aspi_text_holds(name, "pixel"))
    return NO_LENGTH;
  for (int k = POSITION; k <= NO_LENGTH; k++)
    if (aspi_word_index(known[k], name, length, false) >= 0)
      return (kind)k;
  return UNKNOWN;
}

/* Adds one line of the header to the columns, and returns the number of columns that it names; 0 if
 * it is no line of names. */
static int take_names(const char *line, char separator, int fields, column *columns,
                      bool *has_names) {
  char copy[ASP_TEXT_MOST], *name[ASP_COLUMNS_MOST];
  strcpy(copy, line);
  int count = aspi_text_names(copy, separator, name, ASP_COLUMNS_MOST);
  while (count > 0 && !*name[count - 1])
    count--;
  if (count < 1 || count > fields || (count < fields && (separator == ' ' || count < 2)))
    return 0;
  *has_names = false;
  for (int i = 0; i < count; i++) {
    double unit[2];
    bool bare = aspi_unit_metres(name[i], strlen(name[i])) > 0;
    int units = bare ? 1 : aspi_header_units(name[i], unit);
    if (bare)
      unit[0] = aspi_unit_metres(name[i], strlen(name[i]));
    if (!(columns[i].unit > 0) && units == 1)
      columns[i].unit = unit[0];
    if (bare || *columns[i].name)
      continue;
    *has_names = *has_names || *name[i];
    snprintf(columns[i].name, sizeof columns[i].name, "%.63s", name[i]);
    columns[i].kind = kind_of(name[i]);
    columns[i].is_depth = aspi_word_index(depths, name[i], first_word(name[i]), false) >= 0;
    if (units == 0 && has_unit(name[i]))
      columns[i].kind = NO_LENGTH;
  }
  return count;
}

/* The lines of names above the data: the last one, or, where that has units only, the one above it
 * too. Returns how many columns they name; 0: there are none. */
static int read_header(const aspi_header *header, char separator, int fields, column *columns) {
  int named = 0;
  bool has_names = false;
  for (int i = 0; i < ASP_HEADER_NEAR && !has_names; i++) {
    int count =
        *header->line[i] ? take_names(header->line[i], separator, fields, columns, &has_names) : 0;
    if (count == 0)
      break;
    named = count > named ? count : named;
  }
  return named;
}

/* The name without its unit, for comparing: up to a bracket, a slash, or an underscore. */
static bool same_name(const char *name, const char *asked) {
  size_t length = strcspn(name, "([{/_");
  while (length > 0 && isspace((unsigned char)name[length - 1]))
    length--;
  return strcasecmp(name, asked) == 0 ||
         (strlen(asked) == length && strncasecmp(name, asked, length) == 0);
}

/* A column that was asked for by its number or name, from 0; -1: none was; -2 and a message. */
static int asked_for(const char *what, const char *asked, const column *columns, int fields,
                     char *why, size_t size) {
  if (!asked || !*asked)
    return -1;
  char *end;
  long number = strtol(asked, &end, 10);
  if (!*end && number >= 1 && number <= fields)
    return (int)number - 1;
  for (int i = 0; i < fields && *end; i++)
    if (same_name(columns[i].name, asked))
      return i;
  snprintf(why, size, "column '%.40s' is asked for as %s; the file has %d columns%s", asked, what,
           fields, *end ? ", none of that name" : "");
  return -2;
}

/* The first column of that kind that is not the other one; -1: none. */
static int first_of(kind wanted, const column *columns, int fields, int other) {
  for (int i = 0; i < fields; i++)
    if (i != other && columns[i].kind == wanted)
      return i;
  return -1;
}

/* Two columns are taken by their names only where both are known; else the first is
 * that of positions. */
static bool are_known(const column *columns) {
  return (columns[0].kind == POSITION && columns[1].kind == HEIGHT) ||
         (columns[0].kind == HEIGHT && columns[1].kind == POSITION);
}

#define ASK_COLUMNS                                                                                \
  "say which columns are positions and heights (reader: x_column, column), "                       \
  "or the step of heights alone (reader: column, step_x)"

/* Facts about a file's columns, and a buffer for the reason of a failure. */
typedef struct choice {
  const aspi_profile_options *options;
  column columns[ASP_COLUMNS_MOST];
  int fields, used, named; /* fields of a line, those before empty ones, and names above them */
  char separator;
  char *why;
  size_t size;
} choice;

/* True if every column has a name, or there are no more columns than needed. */
static bool are_named(const choice *c) {
  if (c->used <= (c->options->step[0] > 0 ? 1 : 2) || c->named == c->used || c->named == c->fields)
    return true;
  snprintf(c->why, c->size, "%d columns under %d names%s; " ASK_COLUMNS, c->used, c->named,
           c->separator == ','
               ? " (or are there decimal commas? Those need semicolons or tabs between the columns)"
               : "");
  return false;
}

/* A column that nobody asked for and that is no length by its name or unit. */
static bool is_none(const choice *c, int found, int asked) {
  if (asked >= 0 || found < 0 || found >= c->fields || c->columns[found].kind != NO_LENGTH)
    return false;
  snprintf(c->why, c->size, "'%.40s' is no length by the header; " ASK_COLUMNS,
           c->columns[found].name);
  return true;
}

/* A column by its number alone, from 1. */
static int numbered(const choice *c, int number) {
  if (number <= c->fields)
    return number - 1;
  snprintf(c->why, c->size, "column %d is asked for; the file has %d columns", number, c->fields);
  return -2;
}

/* The columns that the user asked for, -1 where none; false where they cannot be meant. */
static bool find_asked(const choice *c, int *x, int *z) {
  const aspi_profile_options *o = c->options;
  *x = asked_for("positions", o->x_column, c->columns, c->fields, c->why, c->size);
  *z = asked_for("heights", o->z_column, c->columns, c->fields, c->why, c->size);
  if (o->x_number > 0 && *x == -1)
    *x = numbered(c, o->x_number);
  if (o->column > 0 && *z == -1)
    *z = numbered(c, o->column);
  bool same = *x >= 0 && *x == *z;
  if (same)
    snprintf(c->why, c->size, "column %d is asked for as positions and as heights", *x + 1);
  return *x != -2 && *z != -2 && !same;
}

/* Fills in a missing x or z column; x = fields means no x column, -1 means none was found. */
static void complete(const choice *c, int *x, int *z) {
  int n = c->fields;
  bool heights_alone = c->options->step[0] > 0;
  if (c->named == 0 || (n <= 2 && !are_known(c->columns))) {
    *x = *x >= 0 ? *x : *z == 0 && n > 1 ? 1 : 0;
    *z = *z >= 0 ? *z : heights_alone && c->columns[0].kind != NO_LENGTH ? 0 : *x == 1 ? 0 : 1;
  }
  if (*z < 0)
    *z = first_of(HEIGHT, c->columns, n, *x);
  if (*x < 0)
    *x = first_of(POSITION, c->columns, n, *z);
}

static int first_named(char name, const column *columns, int fields) {
  for (int i = 0; i < fields; i++)
    if (tolower((unsigned char)*columns[i].name) == name &&
        !isalpha((unsigned char)columns[i].name[1]))
      return i;
  return -1;
}

/* The column Y beside a column X of positions, where both give a place on the wall; -1: none. */
static int second_axis(const choice *c, int x, int z) {
  int y = first_named('y', c->columns, c->fields);
  return first_named('x', c->columns, c->fields) == x && y != z && y != x ? y : -1;
}

static bool choose_both(const choice *c, aspi_columns *chosen) {
  int asked_x, asked_z;
  if (!find_asked(c, &asked_x, &asked_z) || (asked_z < 0 && !are_named(c)))
    return false;
  bool heights_alone = c->options->step[0] > 0;
  int x = heights_alone ? c->fields : asked_x, z = asked_z;
  complete(c, &x, &z);
  if (x < 0 || z < 0) {
    int only = x >= 0 && x < c->fields ? x : z;
    snprintf(c->why, c->size, "%s%.40s%s named as a position or a height; " ASK_COLUMNS,
             only < 0 ? "no column is" : "only '", only < 0 ? "" : c->columns[only].name,
             only < 0 ? "" : "' is");
    return false;
  }
  if (is_none(c, x, asked_x) || is_none(c, z, asked_z))
    return false;
  *chosen = (aspi_columns){.x = heights_alone ? -1 : x,
                           .y = asked_x < 0 && x < c->fields ? second_axis(c, x, z) : -1,
                           .z = z,
                           .unit_x = x < c->fields ? c->columns[x].unit : 1,
                           .unit_z = z < c->fields ? c->columns[z].unit : 0,
                           .are_depths = z < c->fields && c->columns[z].is_depth};
  chosen->unit_y = chosen->y >= 0 ? c->columns[chosen->y].unit : 0;
  return true;
}

bool aspi_choose_columns(const aspi_header *header, char separator, int fields, int used,
                         const aspi_profile_options *options, aspi_columns *chosen, char *why,
                         size_t size) {
  choice c; /* of its columns those that there are are set, and two at least */
  c.options = options;
  c.fields = fields;
  c.used = used;
  c.separator = separator;
  c.why = why;
  c.size = size;
  memset(c.columns, 0, (size_t)(fields > 2 ? fields : 2) * sizeof *c.columns);
  c.named = read_header(header, separator, c.fields, c.columns);
  return choose_both(&c, chosen);
}

bool aspi_find_axes(const aspi_header *header, char separator, int fields, aspi_axes *axes) {
  column columns[ASP_COLUMNS_MOST] = {{"", 0, UNKNOWN, false}};
  *axes = (aspi_axes){{0, 1, 2}, {0}, false};
  if (fields > ASP_COLUMNS_MOST)
    return false;
  read_header(header, separator, fields, columns);
  int found[3] = {first_named('x', columns, fields), first_named('y', columns, fields),
                  first_named('z', columns, fields)};
  if (found[2] < 0)
    found[2] = first_of(HEIGHT, columns, fields, -1);
  bool named = found[0] >= 0 && found[1] >= 0 && found[2] >= 0;
  for (int k = 0; k < 3; k++) {
    if (named)
      axes->column[k] = found[k];
    axes->unit[k] = columns[axes->column[k]].unit;
  }
  axes->are_depths = named && columns[found[2]].is_depth;
  return named;
}

void aspi_header_note(aspi_header *header, const char *line) {
  if (aspi_text_blank(line))
    return;
  memmove(header->line[1], header->line[0], (ASP_HEADER_KEPT - 1) * sizeof *header->line);
  snprintf(header->line[0], sizeof *header->line, "%s", line);
}

/* A line that states the unit of one axis, as `X unit: mm`; false where it does not. */
static bool take_axis(const char *line, aspi_columns *columns) {
  double unit[2];
  line += strspn(line, "#%; \t\"");
  kind axis = kind_of(line);
  if (!aspi_text_holds(line, "unit") || (axis != POSITION && axis != HEIGHT) ||
      aspi_units_in(line, unit) != 1)
    return false;
  double *to = axis == POSITION ? &columns->unit_x : &columns->unit_z;
  *to = *to > 0 ? *to : unit[0];
  return true;
}

asp_code aspi_find_units(const aspi_text *text, const aspi_profile_options *options,
                         const aspi_header *header, aspi_columns *columns, asp_error *error) {
  double stated[2] = {0, 0};
  int count = 0;
  bool found = columns->unit_x > 0 && columns->unit_z > 0;
  for (int i = 0; i < ASP_HEADER_KEPT && count == 0 && !found; i++) {
    if (!take_axis(header->line[i], columns) && i < ASP_HEADER_NEAR)
      count = aspi_header_units(header->line[i], stated);
    found = columns->unit_x > 0 && columns->unit_z > 0;
  }
  if (count == 2 && !found) {
    columns->unit_x = columns->x < 0 ? 1 : stated[0];
    columns->unit_z = stated[1];
  } else if (count == 1 && !found && columns->x < 0) {
    columns->unit_z = stated[0];
  }
  if (options->unit_x > 0 && columns->x >= 0)
    columns->unit_x = options->unit_x;
  if (options->unit_z > 0)
    columns->unit_z = options->unit_z;
  if (columns->unit_x > 0 && columns->unit_z > 0)
    return ASP_OK;
  return aspi_text_fail(text, text->line, error,
                        "%s before the first numbers; say which unit of length the columns are in "
                        "(reader: unit_x, unit_z)",
                        count == 0   ? "no unit of length is stated"
                        : count == 1 ? "one unit is stated for two columns"
                                     : "more than two units are stated");
}
