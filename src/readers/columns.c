/* Profiles as text in columns: a header of any kind, then lines of position and height, or of
 * heights alone, then lines of any other kind. Where there are X, Y and a height, the position is
 * the distance from the first point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/header.h"
#include "readers/positions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct column_layout {
  char separator; /* , ; tab, or a blank for any white space */
  bool comma;     /* decimal */
  aspi_columns columns;
  double step; /* of heights alone, in units of x */
} column_layout;

/* State of reading the rows. */
typedef struct scan {
  aspi_positions positions;
  size_t end_line; /* where the data end before the file does; 0: never */
  int fields;      /* of the first line, without empty ones at its end */
  aspi_missing missing;
} scan;

/* Position and height of a line, as written and as numbers; a missing height is NAN. */
typedef struct column_pair {
  const char *position, *second, *height; /* second: "" where a position is one number */
  double x, y, z;
} column_pair;

/* Reads the pair of a line that is cut into fields; `count` is that of the pairs before. */
static aspi_word pair_of(char **fields, int count, const column_layout *layout, size_t index,
                         column_pair *pair) {
  const aspi_columns *c = &layout->columns;
  if (count <= c->x || count <= c->y || count <= c->z)
    return ASP_WORD_OTHER;
  pair->second = c->y < 0 ? "" : fields[c->y];
  pair->y = 0;
  pair->position = c->x < 0 ? "" : fields[c->x];
  pair->height = fields[c->z];
  pair->x = (double)index * layout->step;
  if (c->x >= 0 && aspi_text_number(pair->position, layout->comma, &pair->x) != ASP_WORD_NUMBER)
    return ASP_WORD_OTHER;
  if (c->y >= 0 && aspi_text_number(pair->second, layout->comma, &pair->y) != ASP_WORD_NUMBER)
    return ASP_WORD_OTHER;
  return aspi_text_number(pair->height, layout->comma, &pair->z);
}

/* Fields without the empty ones at the line's end. */
static int used_of(char **fields, int count) {
  while (count > 0 && !*fields[count - 1])
    count--;
  return count;
}

/* True if a line is one of data, and its layout; *why is not empty where the columns that are meant
 * are not clear. */
static bool finds_layout(const char *line, const aspi_profile_options *options,
                         const aspi_header *header, column_layout *found, char *why, size_t size) {
  static const struct {
    char separator;
    bool comma;
  } layouts[] = {{';', true}, {'\t', true}, {',', false}, {' ', false}, {' ', true}, {',', true}};
  char copy[ASP_TEXT_MOST], *fields[ASP_COLUMNS_MOST];
  for (size_t i = 0; i < sizeof layouts / sizeof *layouts; i++) {
    if (layouts[i].separator != ' ' && !strchr(line, layouts[i].separator))
      continue;
    strcpy(copy, line);
    int count = aspi_text_split(copy, layouts[i].separator, fields, ASP_COLUMNS_MOST);
    *found = (column_layout){.separator = layouts[i].separator,
                             .comma = layouts[i].comma,
                             .step = options->step[0] > 0 ? options->step[0] : 1};
    if (count == 0)
      continue;
    *why = '\0';
    if (!aspi_choose_columns(header, layouts[i].separator, count, used_of(fields, count), options,
                             &found->columns, why, size))
      found->columns = (aspi_columns){.x = options->step[0] > 0 ? -1 : 0,
                                      .y = -1,
                                      .z = options->step[0] > 0 || count < 2 ? 0 : 1};
    column_pair pair;
    aspi_word word = pair_of(fields, count, found, 0, &pair);
    if (word == ASP_WORD_NUMBER || (word == ASP_WORD_MISSING && !aspi_text_blank(pair.height)))
      return true;
  }
  return false;
}

/* Skips the header; its last lines are kept, the very last first. */
static asp_code skip_header(aspi_text *text, const aspi_profile_options *options,
                            column_layout *layout, aspi_header *header, asp_error *error) {
  for (bool found = true; found;) {
    char why[240] = "";
    if (finds_layout(text->text, options, header, layout, why, sizeof why))
      return *why ? aspi_text_fail(text, text->line, error, "%s", why) : ASP_OK;
    aspi_header_note(header, text->text);
    asp_code code = aspi_text_line(text, &found, error);
    if (code)
      return code;
  }
  return aspi_text_fail(
      text, text->line, error,
      options->step[0] > 0
          ? "the file ends without a line that begins with a number, a height"
          : "the file ends without a line of two numbers, position and height (heights "
            "alone need the step between them, reader: step_x)");
}

/* Cuts a line that is not blank into its fields and reads the data in them. */
static bool read_pair(aspi_text *text, const column_layout *layout, size_t index, char **fields,
                      int *count, column_pair *pair) {
  *count = aspi_text_split(text->text, layout->separator, fields, ASP_COLUMNS_MOST);
  return pair_of(fields, *count, layout, index, pair) != ASP_WORD_OTHER;
}

static asp_code note_pair(scan *s, const aspi_text *text, const column_layout *layout,
                          const column_pair *pair, aspi_raw *raw, asp_error *error) {
  const aspi_columns *c = &layout->columns;
  if (c->x >= 0)
    aspi_positions_precision(&s->positions, pair->position, layout->comma);
  aspi_positions_precision(&s->positions, pair->second, layout->comma);
  double z = aspi_missing_note(&s->missing, pair->z, text->line);
  double unit = c->are_depths ? -c->unit_z : c->unit_z;
  if (isnan(z) && raw->bad++ == 0)
    raw->bad_line = text->line;
  return aspi_positions_add(&s->positions, text, pair->x, pair->y, z * unit, error);
}

static asp_code fail_pair(const aspi_text *text, size_t line, const char *shown, asp_error *error) {
  return aspi_text_fail(
      text, line, error,
      "'%s' where position and height are expected as two numbers (or a height that "
      "is missing: nan, bad, --- or nothing)",
      shown);
}

/* A line that holds no data ends them, where none follow. */
static asp_code check_end(aspi_text *text, const column_layout *layout, size_t line,
                          const char *shown, asp_error *error) {
  bool found = true;
  asp_code code;
  while (!(code = aspi_text_line(text, &found, error)) && found) {
    char *fields[ASP_COLUMNS_MOST];
    int count;
    column_pair pair;
    if (!aspi_text_blank(text->text) && read_pair(text, layout, 0, fields, &count, &pair) &&
        !isnan(pair.z))
      return fail_pair(text, line, shown, error);
  }
  return code;
}

/* Decimal commas beside commas between the fields make lines of different length. */
static asp_code check_fields(scan *s, const aspi_text *text, const column_layout *layout, int used,
                             asp_error *error) {
  if (s->positions.points == 0)
    s->fields = used;
  if (layout->separator != ',' || used <= s->fields)
    return ASP_OK;
  return aspi_text_fail(text, text->line, error,
                        "%d fields, the first line of numbers has %d: are there decimal commas? "
                        "Separate columns by semicolons or tabs, or write decimal points",
                        used, s->fields);
}

static asp_code read_all(aspi_text *text, const column_layout *layout, scan *s, aspi_raw *raw,
                         asp_error *error) {
  asp_code code = ASP_OK;
  for (bool found = true; found && !code;) {
    char shown[48], *fields[ASP_COLUMNS_MOST];
    int count;
    column_pair pair;
    snprintf(shown, sizeof shown, "%.47s", text->text);
    if (!aspi_text_blank(text->text)) {
      if (!read_pair(text, layout, s->positions.points, fields, &count, &pair)) {
        if (s->positions.points < 3)
          return fail_pair(text, text->line, shown, error);
        s->end_line = text->line;
        return check_end(text, layout, text->line, shown, error);
      }
      code = check_fields(s, text, layout, used_of(fields, count), error);
      if (!code)
        code = note_pair(s, text, layout, &pair, raw, error);
    }
    if (!code)
      code = aspi_text_line(text, &found, error);
  }
  return code;
}

static asp_code read_data(aspi_text *text, const column_layout *layout,
                          const aspi_profile_options *options, scan *s, aspi_raw *raw,
                          asp_error *error) {
  const aspi_columns *c = &layout->columns;
  bool chosen =
      (options->x_column || options->x_number > 0) && (options->z_column || options->column > 0);
  if (c->y >= 0)
    s->positions.ratio = c->unit_y / c->unit_x;
  asp_code code = read_all(text, layout, s, raw, error);
  if (!code && !chosen)
    code = aspi_missing_check(&s->missing, text->path, error);
  if (!code)
    code = aspi_positions_space(&s->positions, text, options->resample, raw, error);
  const double *last = s->positions.plane.last;
  raw->column[0] = s->fields > 2 ? c->x + 1 : 0;
  raw->second_column = last[1] * last[1] > 0 ? c->y + 1 : 0;
  raw->column[1] = s->fields > 2 ? c->z + 1 : 0;
  raw->end_line = s->end_line;
  raw->were_depths = c->are_depths;
  raw->step_least *= c->unit_x;
  raw->step_most *= c->unit_x;
  raw->step[0] *= c->unit_x;
  return code;
}

asp_code aspi_read_columns(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                           asp_error *error) {
  aspi_header *header = calloc(1, sizeof *header);
  if (!header)
    return aspi_fail(error, ASP_ENOMEM, "%.200s: out of memory for its header", text->path);
  column_layout layout;
  asp_code code = skip_header(text, options, &layout, header, error);
  if (!code)
    code = aspi_find_units(text, options, header, &layout.columns, error);
  if (!code && (!(layout.columns.unit_y > 0) || options->unit_x > 0))
    layout.columns.unit_y = layout.columns.unit_x;
  free(header);
  if (code)
    return code;
  scan s = {.missing.stated = options->has_missing ? options->missing : NAN};
  aspi_positions_begin(&s.positions);
  code = read_data(text, &layout, options, &s, raw, error);
  free(s.positions.list);
  return code;
}
