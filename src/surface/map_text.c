/* Maps as text: a matrix of heights, a line a row, or lines of x, y, z on a grid. Numbers are
 * parted by blanks, tabs, semicolons, or commas; lines that begin with # and a header of any kind
 * go before. What Gwyddion writes at the head of its matrices (`# Width: 100 um`, `# Height:`, `#
 * Value units:`) is understood; else the spacing and the unit must be told. Lines may be of any
 * length.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/number.h"
#include "base/text.h"
#include "base/units.h"
#include "surface/map_read.h"
#include "surface/profile.h"

#include <ctype.h>
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WORD_MOST = 64, HEAD_MOST = 256, COLUMNS_XYZ = 3 };

/* x and y of a point of a grid are off it by no more than this part of the spacing. */
#define OFF_GRID 0.2

/* One line, cut into fields as it is read. */
typedef struct scanner {
  FILE *stream;
  const char *path;
  size_t line;
  char text[HEAD_MOST]; /* the line's beginning, for the header */
  double *values;       /* its fields; NAN where one is bad or missing */
  size_t count, room;
  bool numbers; /* all of them are */
  bool ended;   /* at the end of the file */
} scanner;

static asp_code fail_at(const scanner *s, asp_error *error, const char *what) {
  return aspi_fail(error, ASP_EDATA, "%.200s:%zu: %s", s->path, s->line, what);
}

static asp_code keep(scanner *s, const char *word, asp_error *error) {
  if (s->count == s->room) {
    size_t room = s->room ? 2 * s->room : 1024;
    double *grown = room <= ASP_MAP_SIDE_MOST * 2 ? realloc(s->values, room * sizeof *grown) : NULL;
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM,
                       "%.200s:%zu: out of memory for a line of over %zu numbers", s->path, s->line,
                       s->count);
    s->values = grown;
    s->room = room;
  }
  double value = NAN;
  if (aspi_text_number(word, strchr(word, ',') != NULL, &value) == ASP_WORD_OTHER)
    s->numbers = false;
  s->values[s->count++] = value;
  return ASP_OK;
}

/* The separator of a file's numbers by its first line of data: a semicolon or tab before a comma,
 * which may be a decimal one; 0 for blanks. */
static char separator_of(const char *line) {
  if (strchr(line, ';'))
    return ';';
  if (strchr(line, '\t'))
    return '\t';
  return strchr(line, ',') && !strchr(line, ' ') ? ',' : strstr(line, ", ") ? ',' : 0;
}

enum { UNKNOWN = -1 };

/* Reads one line; one that begins with # or is no line of numbers has `numbers` false. The
 * separator is found where it is unknown. */
static asp_code read_line(scanner *s, int *separator, asp_error *error) {
  char word[WORD_MOST];
  size_t length = 0, known = 0;
  bool comment = false, any = false;
  asp_code code = ASP_OK;
  s->count = 0;
  s->numbers = true;
  s->line++;
  int c;
  if (*separator == UNKNOWN) { /* the line's beginning tells */
    long at = ftell(s->stream);
    char head[HEAD_MOST];
    size_t have = fread(head, 1, sizeof head - 1, s->stream);
    head[have] = '\0';
    head[strcspn(head, "\r\n")] = '\0';
    *separator = separator_of(head);
    if (at < 0 || fseek(s->stream, at, SEEK_SET) != 0)
      return aspi_fail(error, ASP_EFILE, "%.200s: cannot be read twice", s->path);
  }
  char by = (char)*separator;
  for (c = getc_unlocked(s->stream); c != EOF && c != '\n'; c = getc_unlocked(s->stream)) {
    if (c == '\0')
      return fail_at(s, error,
                     "a NUL byte: not a text file; Gwyddion reads most formats of "
                     "instruments and saves them as SDF or as a text matrix");
    if (known + 1 < sizeof s->text)
      s->text[known++] = (char)c;
    comment = comment || (!any && c == '#');
    any = any || !isspace(c);
    if (comment)
      continue;
    bool ends = by ? c == by : isspace(c) != 0;
    if (!ends && (length > 0 || !isspace(c)) && length + 1 < sizeof word) {
      word[length++] = (char)c;
    } else if (!ends && length + 1 >= sizeof word) {
      s->numbers = false;
    }
    if (ends && (length > 0 || by)) {
      word[length] = '\0';
      length = 0;
      if ((code = keep(s, word, error)))
        return code;
    }
  }
  s->text[known] = '\0';
  s->ended = c == EOF && !any;
  if (!comment && any) {
    word[length] = '\0';
    bool blank = word[strspn(word, " \t\r")] == '\0';
    if (!blank) /* a separator at the end of a line ends the last number */
      code = keep(s, word, error);
  }
  s->numbers = s->numbers && s->count > 0 && !comment;
  return code;
}

/* What a header says: lengths of the sides and the unit of heights, 0 where nothing. */
typedef struct head {
  double side[2], unit_z;
  double units[2]; /* of the first column and of the last */
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
  while (isspace((unsigned char)*end))
    end++;
  size_t length = strlen(end);
  while (length > 0 && isspace((unsigned char)end[length - 1]))
    length--;
  return value * aspi_unit_metres(end, length);
}

static void note_head(head *h, const char *line) {
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
static asp_code skip_head(scanner *s, int *separator, head *h, asp_error *error) {
  for (;;) {
    *separator = UNKNOWN;
    asp_code code = read_line(s, separator, error);
    if (code)
      return code;
    if (s->numbers && s->count > 1)
      return ASP_OK;
    if (s->ended)
      return fail_at(s, error, "the file ends without a line of two numbers or more");
    note_head(h, s->text);
  }
}

static asp_code add_row(const scanner *s, double unit, aspi_raw_map *raw, asp_error *error) {
  asp_code code = ASP_OK;
  for (size_t i = 0; i < s->count && !code; i++)
    code = aspi_raw_map_add(raw, unit * s->values[i], error);
  raw->rows++;
  return code;
}

static asp_code read_matrix(scanner *s, int separator, const head *h,
                            const aspi_map_options *options, aspi_raw_map *raw, asp_error *error) {
  double unit = options->read->unit_z > 0 ? options->read->unit_z : h->unit_z;
  if (!(unit > 0))
    unit = h->units[1];
  if (!(unit > 0))
    return fail_at(s, error,
                   "no unit of the heights is stated before the first numbers; say which "
                   "unit of length they are in");
  raw->columns = s->count;
  asp_code code = ASP_OK;
  for (; !s->ended && !code; code = code ? code : read_line(s, &separator, error)) {
    if (s->count == 0)
      continue;
    if (!s->numbers)
      return fail_at(s, error, "a word that is no number among the heights");
    if (s->count != raw->columns)
      return aspi_fail(error, ASP_EDATA, "%.200s:%zu: a row of %zu heights; the first one has %zu",
                       s->path, s->line, s->count, raw->columns);
    code = add_row(s, unit, raw, error);
  }
  if (code)
    return code;
  const size_t count[2] = {raw->columns, raw->rows};
  for (int k = 0; k < 2; k++)
    raw->step[k] = options->step[k] > 0 ? options->step[k] : h->side[k] / (double)count[k];
  if (!(raw->step[0] > 0))
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: a matrix of heights does not say how far apart its points are; tell "
                     "it (step_x, step_y)",
                     s->path);
  raw->step[1] = raw->step[1] > 0 ? raw->step[1] : raw->step[0];
  return ASP_OK;
}

/* ---- x, y, z ---- */

typedef struct triples {
  double (*at)[COLUMNS_XYZ];
  size_t count, room;
} triples;

static asp_code add_triple(triples *t, const double *values, asp_error *error) {
  if (t->count == t->room) {
    size_t room = t->room ? t->room + t->room / 2 : 65536;
    double(*grown)[COLUMNS_XYZ] =
        room <= SIZE_MAX / sizeof *grown ? realloc(t->at, room * sizeof *grown) : NULL;
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM, "out of memory for a map of over %zu points", t->count);
    t->at = grown;
    t->room = room;
  }
  memcpy(t->at[t->count++], values, sizeof *t->at);
  return ASP_OK;
}

/* A difference of two coordinates is one of the grid, not of rounding, from this part of the step
 * of a square grid of as many points on. */
#define GRID_PART (1 / 32.)

/* The grid along one axis: from the least to the greatest coordinate, by the mean of the steps
 * between neighbours. `room` is for all coordinates. */
static bool find_grid(const triples *t, int axis, double *room, double *first, double *step,
                      size_t *count) {
  for (size_t i = 0; i < t->count; i++)
    room[i] = t->at[i][axis];
  gsl_sort(room, 1, t->count);
  double range = room[t->count - 1] - room[0], small = INFINITY, sum = 0, used = 0;
  double none = GRID_PART * range / sqrt((double)t->count);
  for (size_t i = 1; i < t->count; i++)
    if (room[i] - room[i - 1] > none)
      small = fmin(small, room[i] - room[i - 1]);
  for (size_t i = 1; i < t->count; i++) {
    double d = room[i] - room[i - 1];
    if (d > none && d < 1.5 * small) {
      sum += d;
      used++;
    }
  }
  if (!(used > 0))
    return false;
  double steps = round(range / (sum / used));
  *first = room[0];
  *step = range / steps;
  *count = (size_t)fmin(steps, 1e9) + 1;
  return true;
}

static asp_code place(const scanner *s, const triples *t, double unit, double unit_z,
                      aspi_raw_map *raw, asp_error *error) {
  double first[2], step[2], *room = aspi_allocate(t->count);
  size_t side[2] = {0};
  if (!room)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a map of %zu points", t->count);
  bool found[2];
  for (int k = 0; k < 2; k++)
    found[k] = find_grid(t, k, room, &first[k], &step[k], &side[k]);
  free(room);
  for (int k = 0; k < 2; k++)
    if (!found[k] || side[k] > ASP_MAP_SIDE_MOST)
      return aspi_fail(error, ASP_EDATA,
                       "%.200s: the %s of its points are on no grid of 2 to %d equal steps",
                       s->path, k ? "y" : "x", ASP_MAP_SIDE_MOST);
  raw->columns = side[0];
  raw->rows = side[1];
  raw->step[0] = step[0] * unit;
  raw->step[1] = step[1] * unit;
  if ((double)side[0] * (double)side[1] > 4 * (double)t->count + 1e4)
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: its %zu points fill less than a quarter of their grid of %zu x %zu",
                     s->path, t->count, side[0], side[1]);
  size_t n = side[0] * side[1];
  raw->heights = aspi_map_room(side[0], side[1]);
  if (!raw->heights)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a map of %zu x %zu points", side[0],
                     side[1]);
  raw->points = raw->room = n;
  for (size_t i = 0; i < n; i++)
    raw->heights[i] = NAN;
  for (size_t i = 0; i < t->count; i++) {
    double u = (t->at[i][0] - first[0]) / step[0], v = (t->at[i][1] - first[1]) / step[1];
    double column = round(u), row = round(v);
    if (fabs(u - column) > OFF_GRID || fabs(v - row) > OFF_GRID)
      return aspi_fail(error, ASP_EDATA,
                       "%.200s: point %zu, at x %g, y %g, is off the grid of %g x %g that the "
                       "others are on",
                       s->path, i + 1, t->at[i][0], t->at[i][1], step[0], step[1]);
    double z = t->at[i][2];
    if (isfinite(z) && isnan(raw->zero))
      raw->zero = z * unit_z;
    raw->heights[(size_t)row * side[0] + (size_t)column] = (float)(z * unit_z - raw->zero);
  }
  for (size_t i = 0; i < n; i++)
    raw->bad += isnan(raw->heights[i]);
  return ASP_OK;
}

static asp_code read_triples(scanner *s, int separator, const head *h,
                             const aspi_map_options *options, aspi_raw_map *raw, asp_error *error) {
  double unit = options->read->unit_x, unit_z = options->read->unit_z;
  if (!(unit > 0))
    unit = h->units[0];
  if (!(unit_z > 0))
    unit_z = h->units[1];
  if (!(unit > 0 && unit_z > 0))
    return fail_at(s, error,
                   "no unit of length is stated before the first numbers; say which unit "
                   "of length the columns are in");
  triples t = {0};
  asp_code code = ASP_OK;
  for (; !s->ended && !code; code = code ? code : read_line(s, &separator, error)) {
    if (s->count == 0)
      continue;
    if (s->count != COLUMNS_XYZ || !s->numbers || !isfinite(s->values[0]) ||
        !isfinite(s->values[1]))
      code = fail_at(s, error, "three numbers are expected: x, y, z");
    else
      code = add_triple(&t, s->values, error);
  }
  if (!code)
    code = place(s, &t, unit, unit_z, raw, error);
  free(t.at);
  return code;
}

asp_code aspi_read_map_text(FILE *stream, const char *path, const aspi_map_options *options,
                            aspi_raw_map *raw, asp_error *error) {
  scanner s = {.stream = stream, .path = path};
  head h = {{0}, 0, {0}};
  int separator = UNKNOWN;
  asp_code code = skip_head(&s, &separator, &h, error);
  if (!code)
    code = s.count == COLUMNS_XYZ ? read_triples(&s, separator, &h, options, raw, error)
                                  : read_matrix(&s, separator, &h, options, raw, error);
  free(s.values);
  return code;
}
