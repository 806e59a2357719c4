/* Profiles as text in columns: a header of any kind, then lines of position and height. The file is
 * read once, and only its heights are kept: whether the positions are equally spaced, and how far
 * apart, comes from a line fitted to all of them, since instruments round them (to 0.1 um at a
 * spacing of 0.156 um). Where they are not, a second pass interpolates between them. */
#include "base/error.h"
#include "base/number.h"
#include "base/units.h"
#include "surface/read.h"

#include <ctype.h>
#include <gsl/gsl_rstat.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FIELDS_MOST = 64, HEADER_KEPT = 3 };

/* Positions are equally spaced when they are off a line by no more than rounding can be, and this
 * part of the spacing. */
#define UNEVEN_RMS 0.01
#define UNEVEN_STEP 0.05

/* A step over this many usual ones is a gap. */
#define GAP_STEPS 2.5

typedef struct column_layout {
  char separator; /* , ; tab, or a blank for any white space */
  bool comma;     /* decimal */
  int column;     /* of the heights, from 0 */
} column_layout;

/* What is known of the positions after one pass. */
typedef struct scan {
  size_t points;
  double first, last;
  double step_least, step_most, usual; /* usual: mean of the steps that are not gaps */
  size_t usual_count;
  size_t still_line;                       /* where a position first repeats the one before */
  double mean_i, mean_x, c_ii, c_ix, c_xx; /* running regression on the index */
  int decimals, digits;                    /* the most that any position is written with */
  gsl_rstat_quantile_workspace median;     /* of the steps */
} scan;

/* Position and height of a line, as written and as numbers; a missing height is NAN. */
typedef struct column_pair {
  const char *position, *height;
  double x, z;
} column_pair;

static aspi_word pair_of(char *line, const column_layout *layout, column_pair *pair) {
  char *fields[FIELDS_MOST];
  int count = aspi_text_split(line, layout->separator, fields, FIELDS_MOST);
  if (count <= layout->column)
    return ASP_WORD_OTHER;
  pair->position = fields[0];
  pair->height = fields[layout->column];
  if (aspi_text_number(pair->position, layout->comma, &pair->x) != ASP_WORD_NUMBER)
    return ASP_WORD_OTHER;
  return aspi_text_number(pair->height, layout->comma, &pair->z);
}

static bool is_blank(const char *line) {
  return line[strspn(line, " \t\v\f")] == '\0';
}

/* Whether a line is one of data, and in which layout. */
static bool finds_layout(const char *line, int column, column_layout *found) {
  static const column_layout layouts[] = {
      {';', true, 0}, {'\t', true, 0}, {',', false, 0}, {' ', false, 0}, {' ', true, 0}};
  char copy[ASP_TEXT_MOST];
  for (size_t i = 0; i < sizeof layouts / sizeof *layouts; i++) {
    if (layouts[i].separator != ' ' && !strchr(line, layouts[i].separator))
      continue;
    column_pair pair;
    strcpy(copy, line);
    *found = layouts[i];
    found->column = column;
    aspi_word word = pair_of(copy, found, &pair);
    if (word == ASP_WORD_NUMBER || (word == ASP_WORD_MISSING && !is_blank(pair.height)))
      return true;
  }
  return false;
}

/* Skips the header; its last lines are kept, the very last first. */
static asp_code skip_header(aspi_text *text, int column, column_layout *layout,
                            char kept[HEADER_KEPT][ASP_TEXT_MOST], asp_error *error) {
  for (bool found = true; found;) {
    if (finds_layout(text->text, column, layout))
      return ASP_OK;
    if (!is_blank(text->text)) {
      memmove(kept[1], kept[0], (HEADER_KEPT - 1) * sizeof *kept);
      strcpy(kept[0], text->text);
    }
    asp_code code = aspi_text_line(text, &found, error);
    if (code)
      return code;
  }
  return aspi_text_fail(text, text->line, error,
                        "the file ends without a line of two numbers, position and height");
}

static asp_code find_units(const aspi_text *text, const aspi_profile_options *options,
                           char kept[HEADER_KEPT][ASP_TEXT_MOST], double unit[2],
                           asp_error *error) {
  double stated[2] = {0, 0};
  int count = 0;
  for (int i = 0; i < HEADER_KEPT && count == 0; i++)
    count = aspi_header_units(kept[i], stated);
  unit[0] = options->unit_x > 0 ? options->unit_x : count == 2 ? stated[0] : 0;
  unit[1] = options->unit_z > 0 ? options->unit_z : count == 2 ? stated[1] : 0;
  if (unit[0] > 0 && unit[1] > 0)
    return ASP_OK;
  return aspi_text_fail(text, text->line, error,
                        "%s before the first numbers; say which unit of length the columns are in",
                        count == 0   ? "no unit of length is stated"
                        : count == 1 ? "one unit is stated for two columns"
                                     : "more than two units are stated");
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
  double most = fmax(fabs(s->first), fabs(s->last));
  double by_digits = most > 0 ? pow(10, floor(log10(most)) - s->digits + 1) : 0;
  return fmax(pow(10, -s->decimals), by_digits);
}

static asp_code note_step(scan *s, const aspi_text *text, double x, asp_error *error) {
  double step = x - s->last;
  if (step < 0)
    return aspi_text_fail(text, text->line, error,
                          "position %.10g comes after %.10g; positions must increase", x, s->last);
  if (!(step > 0) && !s->still_line)
    s->still_line = text->line;
  s->step_least = fmin(s->step_least, step);
  s->step_most = fmax(s->step_most, step);
  gsl_rstat_quantile_add(step, &s->median);
  if (step <= GAP_STEPS * gsl_rstat_quantile_get(&s->median)) {
    s->usual_count++;
    s->usual += (step - s->usual) / (double)s->usual_count;
  }
  return ASP_OK;
}

static asp_code note_position(scan *s, const aspi_text *text, double x, asp_error *error) {
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

/* The data in a line that is not blank. */
static asp_code read_pair(aspi_text *text, const column_layout *layout, column_pair *pair,
                          asp_error *error) {
  char shown[48];
  snprintf(shown, sizeof shown, "%.47s", text->text);
  if (pair_of(text->text, layout, pair) != ASP_WORD_OTHER)
    return ASP_OK;
  return aspi_text_fail(text, text->line, error,
                        "'%s' where position and height are expected as two numbers", shown);
}

static asp_code note_pair(scan *s, aspi_text *text, const column_layout *layout, double unit_z,
                          aspi_raw *raw, asp_error *error) {
  column_pair pair;
  asp_code code = read_pair(text, layout, &pair, error);
  if (!code)
    code = note_position(s, text, pair.x, error);
  if (code)
    return code;
  note_precision(s, pair.position, layout->comma);
  if (isnan(pair.z) && raw->bad++ == 0)
    raw->bad_line = text->line;
  return aspi_raw_add(raw, pair.z * unit_z, error);
}

/* The first pass: heights as they come, and what the positions are like. */
static asp_code read_all(aspi_text *text, const column_layout *layout, double unit_z, scan *s,
                         aspi_raw *raw, asp_error *error) {
  asp_code code = ASP_OK;
  for (bool found = true; found && !code;) {
    if (!is_blank(text->text))
      code = note_pair(s, text, layout, unit_z, raw, error);
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
  if (s->still_line)
    return aspi_text_fail(text, s->still_line, error,
                          "a position repeats the one before; positions must increase");
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

/* The second pass, for positions that are not equally spaced. */
static asp_code resample(aspi_text *text, size_t data_line, const column_layout *layout,
                         double unit_z, const scan *s, aspi_raw *raw, asp_error *error) {
  asp_code code = aspi_text_rewind(text, error);
  column_pair before = {.x = s->first, .z = NAN}, next;
  bool found = true;
  raw->points = 0;
  raw->resampled = true;
  while (!code && !(code = aspi_text_line(text, &found, error)) && found) {
    if (text->line < data_line || is_blank(text->text))
      continue;
    code = read_pair(text, layout, &next, error);
    if (code)
      break;
    if (!raw->bad_line && next.x - before.x > GAP_STEPS * s->usual)
      raw->bad_line = text->line;
    code = text->line == data_line ? aspi_raw_add(raw, unit_z * next.z, error)
                                   : interpolate(raw, s, &before, &next, unit_z, error);
    before = next;
  }
  return code;
}

static asp_code read_data(aspi_text *text, const column_layout *layout, const double unit[2],
                          bool allowed, scan *s, aspi_raw *raw, asp_error *error) {
  size_t data_line = text->line;
  asp_code code = read_all(text, layout, unit[1], s, raw, error);
  if (code)
    return code;
  raw->read = s->points;
  raw->step_least = s->step_least * unit[0];
  raw->step_most = s->step_most * unit[0];
  if (s->points < 3 || !(s->last > s->first) || !isfinite(s->last - s->first))
    return aspi_text_fail(
        text, text->line, error,
        "the file ends after %zu point%s, from %g to %g; a profile has at least 3 "
        "at increasing positions",
        s->points, s->points == 1 ? "" : "s", s->first, s->last);
  if (!is_even(s, &raw->spacing)) {
    raw->spacing = s->usual;
    code = check_resampling(text, s, allowed, error);
    if (!code)
      code = resample(text, data_line, layout, unit[1], s, raw, error);
  }
  raw->spacing *= unit[0];
  return code;
}

asp_code aspi_read_columns(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                           asp_error *error) {
  char kept[HEADER_KEPT][ASP_TEXT_MOST] = {"", "", ""};
  column_layout layout;
  double unit[2];
  int column = options->column > 0 ? options->column - 1 : 1;
  asp_code code = skip_header(text, column, &layout, kept, error);
  if (!code)
    code = find_units(text, options, kept, unit, error);
  if (code)
    return code;
  scan s = {.step_least = INFINITY, .median = {.p = 0.5}};
  gsl_rstat_quantile_reset(&s.median);
  return read_data(text, &layout, unit, options->resample, &s, raw, error);
}
