/* Positions of a profile's points; see positions.h. Instruments round positions (to 0.1 um at a
 * spacing of 0.156 um), so that the spacing comes from a line fitted to all of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/positions.h"
#include "base/error.h"
#include "base/number.h"
#include "base/tolerances.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>

/* Positions are equally spaced when they are off a line by no more than rounding can be, and this
 * part of the spacing. */
#define UNEVEN_RMS 0.01
#define UNEVEN_STEP 0.05

/* A step over this many usual ones is a gap. */
#define GAP_STEPS 2.5

/* Points in X and Y are on a straight line where they scatter about it by no more than this part of
 * what they scatter along it. */
#define STRAIGHT 0.01

void aspi_positions_begin(aspi_positions *p) {
  *p = (aspi_positions){.step_least = INFINITY};
  p->median.p = 0.5;
  gsl_rstat_quantile_reset(&p->median);
}

void aspi_positions_precision(aspi_positions *p, const char *written) {
  int decimals = 0, digits = 0;
  bool point = false;
  for (; *written && *written != 'e' && *written != 'E'; written++) {
    bool digit = isdigit((unsigned char)*written);
    digits += digit && (digits > 0 || *written != '0');
    decimals += digit && point;
    point = point || *written == '.' || *written == ',';
  }
  if (*written)
    decimals -= (int)fmax(-400, fmin(400, aspi_number(written + 1, NULL)));
  p->decimals = decimals > p->decimals ? decimals : p->decimals;
  p->digits = digits > p->digits ? digits : p->digits;
}

/* The step in which the largest position can be written. */
static double rounding(const aspi_positions *p) {
  double by_digits = p->most > 0 ? pow(10, floor(log10(p->most)) - p->digits + 1) : 0;
  return fmax(pow(10, -p->decimals), by_digits);
}

/* ---- one point after the other ---- */

/* The distance from the first point. */
static double distance(aspi_positions *positions, double x, double y) {
  aspi_plane *p = &positions->plane;
  if (positions->points == 0) {
    p->first[0] = x;
    p->first[1] = y;
  }
  double n = (double)positions->points + 1;
  p->last[0] = x - p->first[0];
  p->last[1] = positions->ratio * (y - p->first[1]);
  double dx = p->last[0] - p->mean[0], dy = p->last[1] - p->mean[1];
  p->mean[0] += dx / n;
  p->mean[1] += dy / n;
  p->c_xx += dx * (p->last[0] - p->mean[0]);
  p->c_xy += dx * (p->last[1] - p->mean[1]);
  p->c_yy += dy * (p->last[1] - p->mean[1]);
  return hypot(p->last[0], p->last[1]);
}

static asp_code add_step(aspi_positions *p, const aspi_text *text, double x, asp_error *error) {
  double last = p->list[p->points - 1].x, step = fabs(x - last);
  if (p->sign * (x - last) < 0)
    return aspi_text_fail(text, text->line, error,
                          "position %.10g comes after %.10g; positions must all increase, or all "
                          "decrease",
                          x, last);
  p->step_least = fmin(p->step_least, step);
  if (!(step > 0)) {
    p->repeats++;
    return ASP_OK;
  }
  p->step_most = fmax(p->step_most, step);
  gsl_rstat_quantile_add(step, &p->median);
  if (step <= GAP_STEPS * gsl_rstat_quantile_get(&p->median)) {
    p->usual_count++;
    p->usual += (step - p->usual) / (double)p->usual_count;
  }
  return ASP_OK;
}

static asp_code append(aspi_positions *p, aspi_point point, asp_error *error) {
  if (p->points == p->room) {
    size_t room = p->room ? p->room + p->room / 2 : 1024;
    aspi_point *grown =
        room <= SIZE_MAX / sizeof *grown ? realloc(p->list, room * sizeof *grown) : NULL;
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM, "out of memory for a profile of over %zu points",
                       p->points);
    p->list = grown;
    p->room = room;
  }
  p->list[p->points++] = point;
  return ASP_OK;
}

asp_code aspi_positions_add(aspi_positions *p, const aspi_text *text, double x, double y, double z,
                            asp_error *error) {
  p->most = fmax(p->most, fmax(fabs(x), fabs(y)));
  if (p->ratio > 0)
    x = distance(p, x, y);
  if (p->points > 0) {
    double last = p->list[p->points - 1].x;
    if (!(fabs(p->sign) > 0)) /* the first step other than 0 decides */
      p->sign = x < last ? -1 : x > last;
    asp_code code = add_step(p, text, x, error);
    if (code)
      return code;
  }
  double i = (double)p->points, n = i + 1, di = i - p->mean_i, dx = x - p->mean_x;
  p->mean_i += di / n;
  p->mean_x += dx / n;
  p->c_ii += di * (i - p->mean_i);
  p->c_ix += di * (x - p->mean_x);
  p->c_xx += dx * (x - p->mean_x);
  return append(p, (aspi_point){x, z, text->line}, error);
}

/* ---- all of them ---- */

/* By the axes of the ellipse of their covariance. */
static asp_code check_straight(const aspi_text *text, const aspi_plane *p, asp_error *error) {
  double middle = (p->c_xx + p->c_yy) / 2, half = hypot((p->c_xx - p->c_yy) / 2, p->c_xy);
  double off = sqrt(fmax(0, middle - half) / (middle + half));
  if (!(off > STRAIGHT))
    return ASP_OK;
  return aspi_text_fail(text, text->line, error,
                        "the points in X and Y scatter across a line by %.2g of what they do along "
                        "it: no profile; a map is read as one, and x_column takes one column alone "
                        "for positions",
                        off);
}

/* True if the positions are equally spaced but for rounding; *spacing is that of the line through
 * them. */
static bool is_even(const aspi_positions *p, double *spacing) {
  double q = rounding(p), slope = p->sign * p->c_ix / p->c_ii;
  double rms = sqrt(fmax(0, p->c_xx - p->sign * slope * p->c_ix) / (double)p->points);
  *spacing = slope;
  return rms <= 0.5 * q + UNEVEN_RMS * slope &&
         fmax(p->step_most - slope, slope - p->step_least) <= q + UNEVEN_STEP * slope;
}

static asp_code check_resampling(const aspi_positions *p, const aspi_text *text, bool allowed,
                                 asp_error *error) {
  double first = p->list[0].x, last = p->list[p->points - 1].x;
  if (!allowed)
    return aspi_text_fail(text, text->line, error,
                          "the spacing is not equal: %g to %g in the file's unit", p->step_least,
                          p->step_most);
  if (fabs(last - first) / p->usual > 2 * (double)p->points)
    return aspi_text_fail(text, text->line, error,
                          "more than half of the profile is gaps: %zu points from %g to %g, most "
                          "of them %g apart",
                          p->points, first, last, p->usual);
  return ASP_OK;
}

/* Points at one position become one of their mean height; those that fall are turned round. */
static void merge_repeats(aspi_positions *p) {
  size_t kept = 0;
  for (size_t i = 0; i < p->points;) {
    double x = p->list[i].x, sum = 0;
    size_t good = 0;
    for (; i < p->points && !(p->sign * (p->list[i].x - x) > 0); i++)
      if (!isnan(p->list[i].z)) {
        sum += p->list[i].z;
        good++;
      }
    double z = good > 0 ? sum / (double)good : NAN;
    p->list[kept++] = (aspi_point){p->sign * x, z, p->list[i - 1].line};
  }
  p->points = kept;
}

/* Heights on the lines between the points; NAN across a gap. */
static asp_code interpolate(aspi_positions *p, aspi_raw *raw, asp_error *error) {
  merge_repeats(p);
  asp_code code = aspi_raw_add(raw, p->list[0].z, error);
  for (size_t i = 1; i < p->points && !code; i++) {
    const aspi_point *a = &p->list[i - 1], *b = &p->list[i];
    bool gap = b->x - a->x > GAP_STEPS * p->usual;
    if (gap && !raw->bad_line)
      raw->bad_line = b->line;
    for (double x; !code && (x = p->list[0].x + (double)raw->points * p->usual) <= b->x;) {
      double part = (x - a->x) / (b->x - a->x);
      double z = part > 1 - ASPI_ROUNDING_TEXT ? b->z : gap ? NAN : a->z + part * (b->z - a->z);
      code = aspi_raw_add(raw, z, error);
    }
  }
  return code;
}

static void reverse(aspi_raw *raw) {
  for (size_t i = 0, j = raw->points; i + 1 < j; i++) {
    j--;
    double height = raw->z[i];
    raw->z[i] = raw->z[j];
    raw->z[j] = height;
  }
}

asp_code aspi_positions_space(aspi_positions *p, const aspi_text *text, bool resample,
                              aspi_raw *raw, asp_error *error) {
  double range = p->points > 0 ? p->list[p->points - 1].x - p->list[0].x : 0;
  asp_code code = ASP_OK;
  if (p->points < 3 || !(fabs(range) > 0) || !isfinite(range))
    return aspi_text_fail(text, text->line, error,
                          "the file ends after %zu point%s, from %g to %g; a profile has at least "
                          "3 at increasing positions",
                          p->points, p->points == 1 ? "" : "s", p->points ? p->list[0].x : 0,
                          p->points ? p->list[p->points - 1].x : 0);
  if (p->ratio > 0 && (code = check_straight(text, &p->plane, error)))
    return code;
  const double *last = p->plane.last;
  raw->falls = p->sign < 0 || last[fabs(last[1]) > fabs(last[0])] < 0;
  raw->read = p->points;
  raw->repeats = p->repeats;
  raw->step_least = p->step_least;
  raw->step_most = p->step_most;
  raw->resampled = !is_even(p, &raw->step[0]);
  if (raw->resampled) {
    raw->step[0] = p->usual;
    code = check_resampling(p, text, resample, error);
    code = code ? code : interpolate(p, raw, error);
  } else {
    for (size_t i = 0; i < p->points && !code; i++)
      code = aspi_raw_add(raw, p->list[i].z, error);
  }
  if (raw->falls)
    reverse(raw);
  return code;
}
