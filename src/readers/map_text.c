/* Maps as text: a matrix of heights, a line a row, or lines of x, y, z on a grid. Numbers are
 * separated by blanks, tabs, semicolons, or commas; lines that begin with # and a header of any
 * kind go before, and lines of another kind may follow. Where the header names x, y and z, these
 * columns are taken, in any order and beside others. What Gwyddion writes at the head of its
 * matrices (`# Width: 100 um`, `# Height:`, `# Value units:`) is understood; else the spacing and
 * the unit must be given.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/number.h"
#include "base/text.h"
#include "base/units.h"
#include "readers/header.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_MOST = 1 << 22 };

/* One line and the numbers in it. */
typedef struct scanner {
  aspi_text source;
  char *line;
  size_t line_room;
  double *values; /* its fields; NAN where one is bad or missing */
  size_t count, room;
  char separator; /* of the fields; blank: white space */
  bool numbers;   /* all of them are */
  bool first;     /* the first of them is */
  bool open;      /* the line ends with a separator */
  bool decimals;  /* a field is whole and has a zero before other digits, as decimals may */
  bool ended;     /* at the end of the file */
} scanner;

static asp_code fail_at(const scanner *s, asp_error *error, const char *what) {
  return aspi_text_fail(&s->source, s->source.line, error, "%s", what);
}

static asp_code keep_value(scanner *s, double value, asp_error *error) {
  if (s->count == s->room) {
    size_t room = s->room ? 2 * s->room : 1024;
    double *grown = realloc(s->values, room * sizeof *grown);
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM,
                       "%.200s:%zu: out of memory for a line of over %zu numbers", s->source.path,
                       s->source.line, s->count);
    s->values = grown;
    s->room = room;
  }
  s->values[s->count++] = value;
  return ASP_OK;
}

/* Commas are decimal ones where they do not part the fields, or stand in quotes and are no marks
 * of groups. */
static asp_code keep_word(scanner *s, const char *word, asp_error *error) {
  double value = NAN;
  bool comma = s->separator != ',' && strchr(word, ',') != NULL;
  aspi_word kind = aspi_text_number(word, comma, &value);
  if (kind == ASP_WORD_OTHER && s->separator == ',')
    kind = aspi_text_number(word, true, &value);
  s->numbers = s->numbers && kind != ASP_WORD_OTHER;
  s->first = s->count == 0 ? kind != ASP_WORD_OTHER && *word : s->first;
  s->decimals = s->decimals || (s->separator == ',' && *word == '0' && word[1] &&
                                strspn(word, "0123456789") == strlen(word));
  return keep_value(s, value, error);
}

/* Decimal commas go before commas between fields where there are blanks, too. */
static char separator_of(const char *line) {
  char separator = aspi_text_separator(line);
  return separator == ',' && strchr(line, ' ') && !strstr(line, ", ") ? ' ' : separator;
}

static asp_code read_line(scanner *s, asp_error *error) {
  bool found;
  asp_code code =
      aspi_text_long_line(&s->source, &s->line, &s->line_room, LINE_MOST, &found, error);
  s->ended = !found;
  return code;
}

/* Cuts the line; one that begins with # or is no line of numbers has `numbers` false. */
static asp_code cut_line(scanner *s, asp_error *error) {
  asp_code code = ASP_OK;
  bool comment = s->line[strspn(s->line, " \t\v\f")] == '#';
  bool blank = aspi_text_blank(s->line) && (s->separator == ' ' || !strchr(s->line, s->separator));
  char *next = blank || comment ? NULL : s->line, *word;
  s->count = 0;
  s->numbers = s->first = next != NULL;
  s->open = s->decimals = false;
  while (!code && !s->open && (word = aspi_text_field(&next, s->separator)) != NULL) {
    s->open = !next && !*word && s->separator != ' '; /* the last separator ends a number */
    code = s->open ? ASP_OK : keep_word(s, word, error);
  }
  s->numbers = s->numbers && s->count > 0;
  return code;
}

static asp_code next_line(scanner *s, asp_error *error) {
  asp_code code = read_line(s, error);
  return code ? code : cut_line(s, error);
}

/* A field that is empty at the end of a line is a missing number where one is due. */
static asp_code complete(scanner *s, size_t due, asp_error *error) {
  return s->open && s->numbers && s->count + 1 == due ? keep_value(s, NAN, error) : ASP_OK;
}

static asp_code check_commas(const scanner *s, asp_error *error) {
  if (!s->decimals)
    return ASP_OK;
  return fail_at(s, error,
                 "whole numbers that begin with a zero: are there decimal commas? Separate numbers "
                 "by semicolons or tabs, or write decimal points");
}

/* A line that does not begin with a number ends the data, where none follow; `what` is the message
 * where some do. */
static asp_code check_end(scanner *s, size_t columns, const char *what, asp_error *error) {
  size_t line = s->source.line;
  asp_code code = ASP_OK;
  bool first = s->first;
  while (!first && !code && !s->ended) {
    code = next_line(s, error);
    first = s->numbers && s->count >= columns;
  }
  if (code || !first)
    return code;
  s->source.line = line;
  return fail_at(s, error, what);
}

/* Data of a header: lengths of the sides and the unit of heights; 0 if absent. */
typedef struct head {
  double side[2], unit_z;
  double units[2]; /* of the first column and of the last */
  aspi_header lines;
} head;

/* `name`, a number and a unit, or only a unit, in m; 0 when the line has no such thing. */
static double stated(const char *line, const char *name, bool number) {
  const char *at = strstr(line, name);
  if (!at)
    return 0;
  at += strlen(name);
  char *end = (char *)at;
  double value = number ? aspi_number(at, &end) : 1;
  if (number && end == at)
    return 0;
  at = end;
  size_t length = aspi_text_inside(&at);
  return value * aspi_unit_metres(at, length);
}

static void note_head(head *h, const char *line) {
  aspi_header_note(&h->lines, line);
  const char *const sides[2] = {"Width:", "Height:"};
  for (int k = 0; k < 2; k++)
    h->side[k] = h->side[k] > 0 ? h->side[k] : stated(line, sides[k], true);
  h->unit_z = h->unit_z > 0 ? h->unit_z : stated(line, "Value units:", false);
  double units[2] = {0, 0};
  int count = aspi_header_units(line, units);
  if (count == 0)
    return;
  h->units[0] = units[0];
  h->units[1] = count == 2 ? units[1] : units[0];
  size_t last = strlen(line);
  while (last > 0 && !strchr(",;\t", line[last - 1]))
    last--;
  if (last > 0 && aspi_header_units(line + last, units) > 0)
    h->units[1] = units[0];
}

/* Reads on to the first line of two numbers or more. */
static asp_code skip_head(scanner *s, head *h, asp_error *error) {
  for (;;) {
    char line[ASP_TEXT_MOST];
    asp_code code = read_line(s, error);
    if (code)
      return code;
    s->separator = separator_of(s->line);
    snprintf(line, sizeof line, "%s", s->line);
    if ((code = cut_line(s, error)) || (s->numbers && s->count > 1))
      return code;
    if (s->ended)
      return fail_at(s, error, "the file ends without a line of two numbers or more");
    note_head(h, line);
  }
}

static asp_code add_row(const scanner *s, double unit, aspi_missing *missing, aspi_raw *raw,
                        asp_error *error) {
  asp_code code = ASP_OK;
  for (size_t i = 0; i < s->count && !code; i++)
    code =
        aspi_raw_add(raw, unit * aspi_missing_note(missing, s->values[i], s->source.line), error);
  raw->rows++;
  return code;
}

static asp_code read_matrix(scanner *s, const head *h, const aspi_profile_options *options,
                            aspi_missing *missing, aspi_raw *raw, asp_error *error) {
  double unit = options->unit_z > 0 ? options->unit_z : h->unit_z;
  if (!(unit > 0))
    unit = h->units[1];
  if (!(unit > 0))
    return fail_at(s, error,
                   "no unit of the heights is stated before the first numbers; say which "
                   "unit of length they are in (reader: unit_z)");
  raw->columns = s->count;
  asp_code code = ASP_OK;
  for (; !s->ended && !code; code = code ? code : next_line(s, error)) {
    if (s->count == 0)
      continue;
    if (!s->numbers) {
      code = check_end(s, raw->columns, "a word that is no number among the heights", error);
      break;
    }
    if ((code = complete(s, raw->columns, error)) || (code = check_commas(s, error)))
      return code;
    if (s->count != raw->columns)
      return aspi_text_fail(&s->source, s->source.line, error,
                            "a row of %zu heights; the first one has %zu", s->count, raw->columns);
    code = add_row(s, unit, missing, raw, error);
  }
  if (code)
    return code;
  const size_t count[2] = {raw->columns, raw->rows};
  for (int k = 0; k < 2; k++)
    raw->step[k] = options->step[k] > 0 ? options->step[k] : h->side[k] / (double)count[k];
  if (!(raw->step[0] > 0))
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: a matrix of heights does not say how far apart its points are; tell "
                     "it (reader: step_x, step_y)",
                     s->source.path);
  raw->step[1] = raw->step[1] > 0 ? raw->step[1] : raw->step[0];
  return ASP_OK;
}

/* ---- x, y, z ---- */

/* The units of x, y and z: the user's, those of the columns, or those of the header as a whole. */
static asp_code find_units(const scanner *s, const head *h, const aspi_profile_options *options,
                           aspi_axes *axes, asp_error *error) {
  for (int k = 0; k < ASP_MAP_AXES; k++) {
    double own = k < 2 ? options->unit_x : options->unit_z, *unit = &axes->unit[k];
    *unit = own > 0 ? own : *unit > 0 ? *unit : h->units[k / 2];
    if (!(*unit > 0))
      return fail_at(s, error,
                     "no unit of length is stated before the first numbers; say which unit "
                     "of length the columns are in (reader: unit_x, unit_z)");
  }
  return ASP_OK;
}

static asp_code read_triples(scanner *s, const head *h, const aspi_profile_options *options,
                             aspi_axes *axes, aspi_missing *missing, aspi_raw *raw,
                             asp_error *error) {
  if (options->step[0] > 0)
    return fail_at(s, error,
                   "the spacing is given (step), but the file has the positions of its points");
  const char *expected = "three numbers are expected: x, y, z";
  asp_code code = find_units(s, h, options, axes, error);
  size_t fields = s->count;
  const int *at = axes->column;
  if (axes->are_depths)
    axes->unit[2] = -axes->unit[2];
  raw->were_depths = axes->are_depths;
  aspi_map_points t = {0};
  for (; !s->ended && !code; code = code ? code : next_line(s, error)) {
    if (s->count == 0)
      continue;
    if ((code = complete(s, fields, error)) || (code = check_commas(s, error)))
      break;
    if (s->count == fields && s->numbers && isfinite(s->values[at[0]]) &&
        isfinite(s->values[at[1]])) {
      double point[ASP_MAP_AXES] = {s->values[at[0]], s->values[at[1]],
                                    aspi_missing_note(missing, s->values[at[2]], s->source.line)};
      code = aspi_map_points_add(&t, point, error);
      continue;
    }
    code = t.count > 0 ? check_end(s, fields, expected, error) : fail_at(s, error, expected);
    break;
  }
  if (!code)
    code = t.count > 0 ? aspi_map_points_place(&t, s->source.path, axes->unit, raw, error)
                       : fail_at(s, error, expected);
  free(t.at);
  return code;
}

static asp_code read_file(scanner *s, head *h, const aspi_profile_options *options, aspi_raw *raw,
                          asp_error *error) {
  asp_code code = skip_head(s, h, error);
  if (code)
    return code;
  aspi_missing missing = {.stated = options->has_missing ? options->missing : NAN};
  aspi_axes axes = {{0, 1, 2}, {0}, false};
  bool named = s->count >= ASP_MAP_AXES && s->count <= ASP_COLUMNS_MOST &&
               aspi_find_axes(&h->lines, s->separator, (int)s->count, &axes);
  code = named || s->count == ASP_MAP_AXES
             ? read_triples(s, h, options, &axes, &missing, raw, error)
             : read_matrix(s, h, options, &missing, raw, error);
  return code ? code : aspi_missing_check(&missing, s->source.path, error);
}

asp_code aspi_read_map_text(const aspi_text *text, const aspi_profile_options *options,
                            aspi_raw *raw, asp_error *error) {
  scanner s = {.source = *text};
  head *h = calloc(1, sizeof *h);
  asp_code code =
      h ? read_file(&s, h, options, raw, error)
        : aspi_fail(error, ASP_ENOMEM, "%.200s: out of memory for its header", text->path);
  free(h);
  free(s.line);
  free(s.values);
  return code;
}
