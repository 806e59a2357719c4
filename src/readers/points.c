/* Points of a measured wall, put on a line or on the grid that they are on; see points.h.
 * Instruments round positions (to 0.1 um at a spacing of 0.156 um), so that the spacing comes from
 * all of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/points.h"
#include "base/error.h"
#include "base/grow.h"
#include "base/number.h"
#include "base/tolerances.h"
#include "surface/heights.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <ctype.h>
#include <math.h>
#include <stdlib.h>

/* Positions are equally spaced if they are off a line by at most their rounding plus this part of
 * the spacing. */
#define UNEVEN_RMS 0.01
#define UNEVEN_STEP 0.05

/* A step over this many usual ones is a gap. */
#define GAP_STEPS 2.5

/* Points in x and y are on a straight line if they are off it by no more than this part of its
 * length. */
#define STRAIGHT 0.01

/* Points of a grid are off it by no more than this part of the spacing. Differences of two
 * coordinates below this part of the step of a square grid with the same number of points are
 * rounding, not a step of the grid. */
#define OFF_GRID 0.2
#define GRID_PART (1 / 32.)

asp_code aspi_points_add(aspi_points *p, aspi_xyz point, asp_error *error) {
  aspi_xyz *grown = aspi_grow(p->list, p->count, sizeof *grown);
  if (!grown)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for over %zu points", p->count);
  p->list = grown;
  p->list[p->count++] = point;
  return ASP_OK;
}

void aspi_points_precision(aspi_points *p, const char *written) {
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

/* The mean step between sorted coordinates, without gaps and repeats; 0 if there is no step.
 * Overwrites the coordinates. */
static double usual_step(double *at, size_t count) {
  size_t steps = 0, used = 0;
  double sum = 0, last = at[0];
  for (size_t i = 1; i < count; i++) {
    double step = at[i] - last;
    last = at[i];
    if (step > 0)
      at[steps++] = step;
  }
  if (steps == 0)
    return 0;
  gsl_sort(at, 1, steps);
  double most = GAP_STEPS * gsl_stats_median_from_sorted_data(at, 1, steps);
  for (; used < steps && at[used] <= most; used++)
    sum += at[used];
  return sum / (double)used;
}

/* ---- on a line ---- */

/* The step in which the largest position can be written. */
static double rounding(const aspi_points *p) {
  double most = fmax(fabs(p->list[0].x), fabs(p->list[p->count - 1].x));
  double by_digits = most > 0 ? pow(10, floor(log10(most)) - p->digits + 1) : 0;
  return fmax(pow(10, -p->decimals), by_digits);
}

/* Makes x the distance from the first point, which grows or falls as the longer axis does. ratio:
 * of the units of y and x. */
static asp_code measure_along(aspi_points *p, double ratio, const aspi_raw *raw, asp_error *error) {
  aspi_xyz first = p->list[0], last = p->list[p->count - 1];
  double dx = last.x - first.x, dy = ratio * (last.y - first.y), length = hypot(dx, dy), off = 0;
  double sign = (fabs(dy) > fabs(dx) ? dy : dx) < 0 ? -1 : 1;
  for (size_t i = 0; i < p->count && length > 0; i++) {
    double x = p->list[i].x - first.x, y = ratio * (p->list[i].y - first.y);
    off = fmax(off, fabs(x * dy - y * dx) / (length * length));
    p->list[i].x = sign * (x * dx + y * dy) / length;
  }
  if (off <= STRAIGHT)
    return ASP_OK;
  return aspi_file_fail(raw->path, 0, error,
                        "the X, Y points are not on a line (off by %.0f %% of its length); read "
                        "them as a map, or name one column of positions with --x-column",
                        100 * off);
}

/* Reverses falling positions, and checks that all increase; finds the least and the largest step.
 */
static asp_code put_in_order(aspi_points *p, double steps[2], aspi_raw *raw, asp_error *error) {
  aspi_xyz *list = p->list;
  size_t n = p->count, repeats = 0;
  double sign = n > 0 && list[n - 1].x < list[0].x ? -1 : 1;
  steps[0] = INFINITY;
  steps[1] = 0;
  for (size_t i = 1; i < n; i++) {
    double step = sign * (list[i].x - list[i - 1].x);
    if (step < 0)
      return aspi_file_fail(raw->path, list[i].line, error,
                            "position %.10g comes after %.10g; positions must all increase, "
                            "or all decrease",
                            list[i].x, list[i - 1].x);
    steps[0] = fmin(steps[0], step);
    steps[1] = fmax(steps[1], step);
    repeats += !(step > 0);
  }
  if (n < ASP_SIDE_LEAST || !(steps[1] > 0) || !isfinite(list[n - 1].x - list[0].x))
    return aspi_file_fail(raw->path, 0, error,
                          "the file ends after %zu point%s, from %g to %g; a profile has at "
                          "least 3 at increasing positions",
                          n, n == 1 ? "" : "s", n ? list[0].x : 0, n ? list[n - 1].x : 0);
  if (repeats > 0)
    aspi_append(raw->text, sizeof raw->text, ", %zu repeated positions averaged", repeats);
  if (sign < 0)
    aspi_append(raw->text, sizeof raw->text, ", positions fall and are reversed");
  for (size_t i = 0, j = n - 1; sign < 0 && i < j; i++, j--) {
    aspi_xyz other = list[i];
    list[i] = list[j];
    list[j] = other;
  }
  return ASP_OK;
}

/* True if the positions are equally spaced but for rounding; *spacing by a least-squares line. */
static bool is_even(const aspi_points *p, const double steps[2], double q, double *spacing) {
  double n = (double)p->count, middle = (n - 1) / 2, mean = 0, product = 0, square = 0;
  for (size_t i = 0; i < p->count; i++)
    mean += p->list[i].x / n;
  for (size_t i = 0; i < p->count; i++)
    product += ((double)i - middle) * (p->list[i].x - mean);
  double slope = product / (n * (n * n - 1) / 12);
  for (size_t i = 0; i < p->count; i++) {
    double off = p->list[i].x - mean - slope * ((double)i - middle);
    square += off * off / n;
  }
  *spacing = slope;
  return sqrt(square) <= 0.5 * q + UNEVEN_RMS * slope &&
         fmax(steps[1] - slope, slope - steps[0]) <= q + UNEVEN_STEP * slope;
}

/* Merges points at one position, with their mean height. */
static void merge_repeats(aspi_points *p) {
  size_t kept = 0;
  for (size_t i = 0; i < p->count;) {
    aspi_xyz point = p->list[i];
    double sum = 0, good = 0;
    for (; i < p->count && !(p->list[i].x > point.x); i++)
      if (!isnan(p->list[i].z)) {
        sum += p->list[i].z;
        good++;
      }
    point.z = good > 0 ? sum / good : NAN;
    p->list[kept++] = point;
  }
  p->count = kept;
}

/* Heights on the lines between the points, `spacing` apart; NAN across a gap. */
static asp_code interpolate(const aspi_points *p, double spacing, aspi_raw *raw, asp_error *error) {
  asp_code code = aspi_raw_add(raw, p->list[0].z, error);
  for (size_t i = 1; i < p->count && !code; i++) {
    const aspi_xyz *a = &p->list[i - 1], *b = &p->list[i];
    bool gap = b->x - a->x > GAP_STEPS * spacing;
    if (gap && !raw->bad_line)
      raw->bad_line = b->line;
    for (double x; !code && (x = p->list[0].x + (double)raw->points * spacing) <= b->x;) {
      double part = (x - a->x) / (b->x - a->x);
      double z = part > 1 - ASPI_ROUNDING_TEXT ? b->z : gap ? NAN : a->z + part * (b->z - a->z);
      code = aspi_raw_add(raw, z, error);
    }
  }
  return code;
}

static asp_code resample(aspi_points *p, aspi_raw *raw, asp_error *error) {
  double range = p->list[p->count - 1].x - p->list[0].x;
  double *at = aspi_allocate(p->count);
  if (!at)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu points", p->count);
  for (size_t i = 0; i < p->count; i++)
    at[i] = p->list[i].x;
  raw->step[0] = usual_step(at, p->count);
  free(at);
  if (range / raw->step[0] > 2 * (double)p->count)
    return aspi_file_fail(raw->path, 0, error,
                          "more than half of the profile is gaps: %zu points over %g, most of "
                          "them %g apart",
                          p->count, range, raw->step[0]);
  merge_repeats(p);
  return interpolate(p, raw->step[0], raw, error);
}

asp_code aspi_points_line(aspi_points *p, const double unit[2], bool in_plane, aspi_raw *raw,
                          asp_error *error) {
  double q = p->count > 0 ? rounding(p) : 0, steps[2];
  asp_code code = in_plane ? measure_along(p, unit[1] / unit[0], raw, error) : ASP_OK;
  if (!code)
    code = put_in_order(p, steps, raw, error);
  if (code)
    return code;
  raw->read = p->count;
  bool even = is_even(p, steps, q, &raw->step[0]);
  if (!even)
    code = resample(p, raw, error);
  for (size_t i = 0; i < p->count && !code && even; i++)
    code = aspi_raw_add(raw, p->list[i].z, error);
  raw->step[0] *= unit[0];
  if (!even)
    aspi_append(raw->text, sizeof raw->text,
                ", unequal spacing of %.4g to %.4g m resampled to %.4g m", steps[0] * unit[0],
                steps[1] * unit[0], raw->step[0]);
  return code;
}

/* ---- on a grid ---- */

/* The grid along one axis. */
typedef struct grid {
  double first, step;
  size_t count;
} grid;

/* Merges sorted coordinates that differ by rounding; returns how many are left. */
static size_t merge_near(double *at, size_t count) {
  double near = GRID_PART * (at[count - 1] - at[0]) / sqrt((double)count);
  size_t kept = 0;
  for (size_t i = 0; i < count;) {
    size_t first = i;
    double sum = 0, last = at[i];
    for (; i < count && at[i] - last <= near; i++)
      sum += last = at[i];
    at[kept++] = sum / (double)(i - first);
  }
  return kept;
}

/* `room` is for all coordinates. */
static bool find_grid(const aspi_points *p, bool along_y, double *room, grid *g) {
  for (size_t i = 0; i < p->count; i++)
    room[i] = along_y ? p->list[i].y : p->list[i].x;
  gsl_sort(room, 1, p->count);
  size_t lines = merge_near(room, p->count);
  double first = room[0], range = room[lines - 1] - first, step = usual_step(room, lines);
  if (!(step > 0))
    return false;
  double steps = round(range / step);
  *g = (grid){first, range / steps, (size_t)fmin(steps, 1e9) + 1};
  return true;
}

/* Allocates the grid; all heights are missing at first. */
static asp_code make_room(size_t points, aspi_raw *raw, asp_error *error) {
  if ((double)raw->columns * (double)raw->rows > 4 * (double)points + 1e4)
    return aspi_file_fail(raw->path, 0, error,
                          "its %zu points fill less than a quarter of their grid of %zu x %zu",
                          points, raw->columns, raw->rows);
  asp_code code = ASP_OK;
  while (raw->points < raw->columns * raw->rows && !code)
    code = aspi_raw_add(raw, NAN, error);
  return code;
}

asp_code aspi_points_grid(const aspi_points *p, const double unit[2], aspi_raw *raw,
                          asp_error *error) {
  grid g[2] = {{0}};
  double *room = aspi_allocate(p->count);
  if (!room)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a map of %zu points", p->count);
  int found = 0;
  while (found < 2 && find_grid(p, found, room, &g[found]))
    found++;
  free(room);
  if (found < 2)
    return aspi_file_fail(raw->path, 0, error, "the %s of its points are on no grid of equal steps",
                          found ? "y" : "x");
  raw->columns = g[0].count;
  raw->rows = g[1].count;
  raw->step[0] = g[0].step * unit[0];
  raw->step[1] = g[1].step * unit[1];
  asp_code code = make_room(p->count, raw, error);
  for (size_t i = 0; i < p->count && !code; i++) {
    const aspi_xyz *at = &p->list[i];
    double u = (at->x - g[0].first) / g[0].step, v = (at->y - g[1].first) / g[1].step;
    double column = round(u), row = round(v);
    if (fabs(u - column) > OFF_GRID || fabs(v - row) > OFF_GRID)
      return aspi_file_fail(raw->path, at->line, error,
                            "the point at x %g, y %g is off the grid of %g x %g that the "
                            "others are on",
                            at->x, at->y, g[0].step, g[1].step);
    raw->z[(size_t)row * raw->columns + (size_t)column] = at->z;
  }
  return code;
}
