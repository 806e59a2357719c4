/* Profiles as text in columns: a header of any kind, then lines of position and height, or of
 * heights alone, then lines of any other kind. The file is read once, and only its heights are
 * kept: whether the positions are equally spaced, and how far apart, comes from a line fitted to
 * all of them, since instruments round them (to 0.1 um at a spacing of 0.156 um). Where they are
 * not, a second pass interpolates between them. Positions that fall are read from the other end.
 * Where there are X, Y and a height, the position is the distance from the first point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/number.h"
#include "readers/header.h"
#include "readers/marks.h"

#include <ctype.h>
#include <gsl/gsl_rstat.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Positions are equally spaced when they are off a line by no more than rounding can be, and this
 * part of the spacing. */
#define UNEVEN_RMS 0.01
#define UNEVEN_STEP 0.05

/* A step over this many usual ones is a gap. */
#define GAP_STEPS 2.5

/* Points in X and Y are on a straight line where they scatter about it by no more than this part of
 * what they scatter along it. */
#define STRAIGHT 0.01

typedef struct column_layout {
  char separator; /* , ; tab, or a blank for any white space */
  bool comma;     /* decimal */
  aspi_columns columns;
  double missing; /* a height that stands for none; NAN: no such */
  double step;    /* of heights alone, in units of x */
} column_layout;

/* Points in X and Y: the first one, the last one from there, and their running covariance. */
typedef struct plane_scan {
  double first[2], last[2], mean[2], c_xx, c_xy, c_yy;
} plane_scan;

/* What is known of the positions after one pass. */
typedef struct scan {
  size_t points;
  plane_scan plane;
  double first, last;
  double step_least, step_most, usual; /* usual: mean of the steps that are not gaps */
  size_t usual_count;
  double sign;     /* -1: positions fall; 0: not known yet */
  size_t repeats;  /* positions that repeat the one before */
  size_t end_line; /* where the data end before the file does; 0: never */
  int fields;      /* of the first line, without empty ones at its end */
  aspi_marks marks;
  double mean_i, mean_x, c_ii, c_ix, c_xx; /* running regression on the index */
  int decimals, digits;                    /* the most that any position is written with */
  double most;                             /* the largest coordinate that is written */
  gsl_rstat_quantile_workspace median;     /* of the steps */
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
  aspi_word word = aspi_text_number(pair->height, layout->comma, &pair->z);
  if (word == ASP_WORD_NUMBER && fabs(pair->z - layout->missing) <= 1e-9 * fabs(layout->missing)) {
    pair->z = NAN;
    word = ASP_WORD_MISSING;
  }
  return word;
}

/* Fields without the empty ones at the line's end. */
static int used_of(char **fields, int count) {
  while (count > 0 && !*fields[count - 1])
    count--;
  return count;
}

/* Whether a line is one of data, and in which layout; *why is not empty where it is, and which
 * columns are meant cannot be told. */
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
                             .missing = options->has_missing ? options->missing : NAN,
                             .step = options->step > 0 ? options->step : 1};
    if (count == 0)
      continue;
    *why = '\0';
    if (!aspi_choose_columns(header, layouts[i].separator, count, used_of(fields, count), options,
                             &found->columns, why, size))
      found->columns = (aspi_columns){
          .x = options->step > 0 ? -1 : 0, .y = -1, .z = options->step > 0 || count < 2 ? 0 : 1};
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
      options->step > 0
          ? "the file ends without a line that begins with a number, a height"
          : "the file ends without a line of two numbers, position and height (heights "
            "alone need the step between them: step)");
}

/* How finely positions are written: the most decimals and the most digits of any. */
static void note_precision(scan *s, const char *position, bool comma) {
  int decimals = 0, digits = 0;
  bool point = false;
  for (; *position && *position != 'e' && *position != 'E'; position++) {
    bool digit = isdigit((unsigned char)*position);
    digits += digit && (digits > 0 || *position != '0');
    decimals += digit && point;
    point = point || *position == '.' || (comma && *position == ',');
  }
  if (*position)
    decimals -= (int)fmax(-400, fmin(400, aspi_number(position + 1, NULL)));
  s->decimals = decimals > s->decimals ? decimals : s->decimals;
  s->digits = digits > s->digits ? digits : s->digits;
}

/* The step in which the largest position can be written. */
static double rounding(const scan *s) {
  double by_digits = s->most > 0 ? pow(10, floor(log10(s->most)) - s->digits + 1) : 0;
  return fmax(pow(10, -s->decimals), by_digits);
}

static asp_code note_step(scan *s, const aspi_text *text, double x, asp_error *error) {
  double step = x - s->last;
  if (step < 0)
    return aspi_text_fail(text, text->line, error,
                          "position %.10g comes after %.10g; positions must all increase, or all "
                          "decrease",
                          s->sign * x, s->sign * s->last);
  s->step_least = fmin(s->step_least, step);
  if (!(step > 0)) {
    s->repeats++;
    return ASP_OK;
  }
  s->step_most = fmax(s->step_most, step);
  gsl_rstat_quantile_add(step, &s->median);
  if (step <= GAP_STEPS * gsl_rstat_quantile_get(&s->median)) {
    s->usual_count++;
    s->usual += (step - s->usual) / (double)s->usual_count;
  }
  return ASP_OK;
}

/* The first step that is none of zero says whether positions rise or fall; those that fall are
 * taken with the other sign. */
static double directed(scan *s, double x) {
  if (s->sign < 0 || s->sign > 0 || s->points == 0)
    return s->sign < 0 ? -x : x;
  if (x < s->last) {
    s->sign = -1;
    s->first = -s->first;
    s->last = -s->last;
    s->mean_x = -s->mean_x;
    return -x;
  }
  s->sign = x > s->last ? 1 : 0;
  return x;
}

static asp_code note_position(scan *s, const aspi_text *text, double x, asp_error *error) {
  x = directed(s, x);
  if (s->points > 0) {
    asp_code code = note_step(s, text, x, error);
    if (code)
      return code;
  } else {
    s->first = x;
  }
  double i = (double)s->points, n = i + 1, di = i - s->mean_i, dx = x - s->mean_x;
  s->mean_i += di / n;
  s->mean_x += dx / n;
  s->c_ii += di * (i - s->mean_i);
  s->c_ix += di * (x - s->mean_x);
  s->c_xx += dx * (x - s->mean_x);
  s->last = x;
  s->points++;
  return ASP_OK;
}

/* The position of a pair: x, or the distance from the first point in X and Y. */
static double position_of(const scan *s, const column_layout *layout, const column_pair *pair) {
  if (layout->columns.y < 0)
    return pair->x;
  double ratio = layout->columns.unit_y / layout->columns.unit_x;
  return hypot(pair->x - s->plane.first[0], ratio * (pair->y - s->plane.first[1]));
}

static void note_place(scan *s, const column_layout *layout, const column_pair *pair) {
  plane_scan *p = &s->plane;
  if (s->points == 0) {
    p->first[0] = pair->x;
    p->first[1] = pair->y;
  }
  double x = pair->x - p->first[0], n = (double)s->points + 1;
  double y = layout->columns.unit_y / layout->columns.unit_x * (pair->y - p->first[1]);
  double dx = x - p->mean[0], dy = y - p->mean[1];
  p->last[0] = x;
  p->last[1] = y;
  p->mean[0] += dx / n;
  p->mean[1] += dy / n;
  p->c_xx += dx * (x - p->mean[0]);
  p->c_xy += dx * (y - p->mean[1]);
  p->c_yy += dy * (y - p->mean[1]);
}

/* By the axes of the ellipse of their covariance. */
static asp_code check_straight(const aspi_text *text, const plane_scan *p, asp_error *error) {
  double middle = (p->c_xx + p->c_yy) / 2, half = hypot((p->c_xx - p->c_yy) / 2, p->c_xy);
  double off = sqrt(fmax(0, middle - half) / (middle + half));
  if (!(off > STRAIGHT))
    return ASP_OK;
  return aspi_text_fail(text, text->line, error,
                        "the points in X and Y scatter across a line by %.2g of what they do along "
                        "it: no profile; a map is read as one, and x-column takes one column alone "
                        "for positions",
                        off);
}

/* Cuts a line that is not blank into its fields and reads the data in them. */
static bool read_pair(aspi_text *text, const column_layout *layout, size_t index, char **fields,
                      int *count, column_pair *pair) {
  *count = aspi_text_split(text->text, layout->separator, fields, ASP_COLUMNS_MOST);
  return pair_of(fields, *count, layout, index, pair) != ASP_WORD_OTHER;
}

static asp_code note_pair(scan *s, aspi_text *text, const column_layout *layout,
                          const column_pair *pair, aspi_raw *raw, asp_error *error) {
  if (layout->columns.y >= 0)
    note_place(s, layout, pair);
  asp_code code = note_position(s, text, position_of(s, layout, pair), error);
  if (code)
    return code;
  s->most = fmax(s->most, fmax(fabs(pair->x), fabs(pair->y)));
  if (layout->columns.x >= 0)
    note_precision(s, pair->position, layout->comma);
  note_precision(s, pair->second, layout->comma);
  if (isnan(pair->z) && raw->bad++ == 0)
    raw->bad_line = text->line;
  if (!isnan(pair->z))
    aspi_marks_note(&s->marks, pair->z, text->line);
  return aspi_raw_add(raw, pair->z * layout->columns.unit_z, error);
}

static asp_code fail_pair(const aspi_text *text, size_t line, const char *shown, asp_error *error) {
  return aspi_text_fail(text, line, error,
                        "'%s' where position and height are expected as two numbers", shown);
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
  if (s->points == 0)
    s->fields = used;
  if (layout->separator != ',' || used <= s->fields)
    return ASP_OK;
  return aspi_text_fail(text, text->line, error,
                        "%d fields, the first line of numbers has %d: are there decimal commas? "
                        "Separate columns by semicolons or tabs, or write decimal points",
                        used, s->fields);
}

/* The first pass: heights as they come, and what the positions are like. */
static asp_code read_all(aspi_text *text, const column_layout *layout, scan *s, aspi_raw *raw,
                         asp_error *error) {
  asp_code code = ASP_OK;
  for (bool found = true; found && !code;) {
    char shown[48], *fields[ASP_COLUMNS_MOST];
    int count;
    column_pair pair;
    snprintf(shown, sizeof shown, "%.47s", text->text);
    if (!aspi_text_blank(text->text)) {
      if (!read_pair(text, layout, s->points, fields, &count, &pair)) {
        if (s->points < 3)
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

/* Whether the positions are equally spaced but for rounding; *spacing is that of the line through
 * them. */
static bool is_even(const scan *s, double *spacing) {
  double q = rounding(s), slope = s->c_ix / s->c_ii;
  double rms = sqrt(fmax(0, s->c_xx - slope * s->c_ix) / (double)s->points);
  *spacing = slope;
  return rms <= 0.5 * q + UNEVEN_RMS * slope &&
         fmax(s->step_most - slope, slope - s->step_least) <= q + UNEVEN_STEP * slope;
}

/* Heights at the grid's points up to the next pair, on the line from the pair before; NAN across a
 * gap. */
static asp_code interpolate(aspi_raw *raw, const scan *s, const column_pair *before,
                            const column_pair *next, double unit_z, asp_error *error) {
  double apart = next->x - before->x;
  bool gap = apart > GAP_STEPS * s->usual;
  asp_code code = ASP_OK;
  for (double at; !code && (at = s->first + (double)raw->points * s->usual) <= next->x;) {
    double part = (at - before->x) / apart;
    double z = part > 1 - 1e-9 ? next->z : gap ? NAN : before->z + part * (next->z - before->z);
    code = aspi_raw_add(raw, unit_z * z, error);
  }
  return code;
}

static asp_code check_resampling(const aspi_text *text, const scan *s, bool allowed,
                                 asp_error *error) {
  if (!allowed)
    return aspi_text_fail(text, text->line, error,
                          "the spacing is not equal: %g to %g in the file's unit", s->step_least,
                          s->step_most);
  if ((s->last - s->first) / s->usual > 2 * (double)s->points)
    return aspi_text_fail(
        text, text->line, error,
        "more than half of the profile is gaps: %zu points from %g to %g, most of "
        "them %g apart",
        s->points, s->first, s->last, s->usual);
  return ASP_OK;
}

/* The next pair whose position is another one, with the mean height of all pairs at that position;
 * what is read too far is kept in *ahead. *found is false at the end of the data. */
typedef struct repeats {
  column_pair ahead;
  bool has_ahead;
  size_t index, line;
} repeats;

static asp_code next_pair(aspi_text *text, size_t data_line, const column_layout *layout,
                          const scan *s, repeats *r, column_pair *pair, bool *found,
                          asp_error *error) {
  double sum = 0;
  size_t good = 0, all = 0;
  for (;;) {
    while (!r->has_ahead) {
      char *fields[ASP_COLUMNS_MOST];
      int count;
      asp_code code = aspi_text_line(text, found, error);
      if (code)
        return code;
      *found = *found && (!s->end_line || text->line < s->end_line);
      if (!*found)
        break;
      if (text->line < data_line || aspi_text_blank(text->text))
        continue;
      read_pair(text, layout, r->index++, fields, &count, &r->ahead);
      r->ahead.x = (s->sign < 0 ? -1 : 1) * position_of(s, layout, &r->ahead);
      r->has_ahead = true;
    }
    if (!r->has_ahead || (all > 0 && r->ahead.x > pair->x))
      break;
    pair->x = r->ahead.x;
    r->line = text->line;
    r->has_ahead = false;
    all++;
    if (!isnan(r->ahead.z)) {
      sum += r->ahead.z;
      good++;
    }
  }
  *found = all > 0;
  pair->z = good > 0 ? sum / (double)good : NAN;
  return ASP_OK;
}

/* The second pass, for positions that are not equally spaced. */
static asp_code resample(aspi_text *text, size_t data_line, const column_layout *layout,
                         const scan *s, aspi_raw *raw, asp_error *error) {
  asp_code code = aspi_text_rewind(text, error);
  column_pair before = {.x = s->first, .z = NAN}, next = {.x = 0};
  double unit_z = layout->columns.unit_z;
  repeats r = {.has_ahead = false};
  bool found = true;
  raw->points = 0;
  raw->resampled = true;
  while (!code) {
    bool first = raw->points == 0;
    code = next_pair(text, data_line, layout, s, &r, &next, &found, error);
    if (code || !found)
      break;
    if (!first && !raw->bad_line && next.x - before.x > GAP_STEPS * s->usual)
      raw->bad_line = r.line;
    code = first ? aspi_raw_add(raw, unit_z * next.z, error)
                 : interpolate(raw, s, &before, &next, unit_z, error);
    before = next;
  }
  return code;
}

static void reverse(aspi_raw *raw) {
  for (size_t i = 0, j = raw->points; i + 1 < j; i++) {
    j--;
    double height = aspi_raw_at(raw, i);
    aspi_raw_put(raw, i, aspi_raw_at(raw, j));
    aspi_raw_put(raw, j, height);
  }
}

static asp_code read_data(aspi_text *text, const column_layout *layout, bool allowed, bool chosen,
                          scan *s, aspi_raw *raw, asp_error *error) {
  size_t data_line = text->line;
  double unit_x = layout->columns.unit_x;
  asp_code code = read_all(text, layout, s, raw, error);
  if (!code && !chosen)
    code = aspi_marks_check(&s->marks, text->path, error);
  if (code)
    return code;
  raw->read = s->points;
  raw->repeats = s->repeats;
  const double *last = s->plane.last;
  raw->falls = s->sign < 0 || last[fabs(last[1]) > fabs(last[0])] < 0;
  raw->column[0] = s->fields > 2 ? layout->columns.x + 1 : 0;
  raw->second_column = last[1] * last[1] > 0 ? layout->columns.y + 1 : 0;
  raw->column[1] = s->fields > 2 ? layout->columns.z + 1 : 0;
  raw->end_line = s->end_line;
  raw->step_least = s->step_least * unit_x;
  raw->step_most = s->step_most * unit_x;
  if (s->points < 3 || !(s->last > s->first) || !isfinite(s->last - s->first))
    return aspi_text_fail(
        text, text->line, error,
        "the file ends after %zu point%s, from %g to %g; a profile has at least 3 "
        "at increasing positions",
        s->points, s->points == 1 ? "" : "s", s->first, s->last);
  if (layout->columns.y >= 0 && (code = check_straight(text, &s->plane, error)))
    return code;
  if (!is_even(s, &raw->step[0])) {
    raw->step[0] = s->usual;
    code = check_resampling(text, s, allowed, error);
    if (!code)
      code = resample(text, data_line, layout, s, raw, error);
  }
  if (raw->falls)
    reverse(raw);
  raw->step[0] *= unit_x;
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
  scan s = {.step_least = INFINITY};
  s.median.p = 0.5;
  gsl_rstat_quantile_reset(&s.median);
  bool chosen =
      (options->x_column || options->x_number > 0) && (options->z_column || options->column > 0);
  return read_data(text, &layout, options->resample, chosen, &s, raw, error);
}
