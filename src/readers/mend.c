/* Mending of measured heights, a profile being a map of one row: a polynomial taken out as form
 * (least squares on products of Legendre polynomials), spikes marked (far off their neighbors in
 * every direction), gaps filled by straight lines or refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/read.h"
#include "base/error.h"
#include "base/least_squares.h"
#include "surface/heights.h"
#include "base/tolerances.h"

#include <gsl/gsl_rstat.h>
#include <gsl/gsl_sf_legendre.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Heights and spacings beyond these (m) have a wrong unit, and could overflow. */
#define LENGTH_MOST 1e9
#define SPACING_LEAST 1e-15

/* Neighbors on each side for spikes, of a profile and of a map. */
enum { REACH = 3, REACH_MAP = 2 };

/* From the median absolute deviation to the sd of a normal distribution. */
#define MAD_TO_SD 1.4826

_Static_assert((ASP_FORM_MAX + 1) * (ASP_FORM_MAX + 2) / 2 <= ASP_TERMS_MOST,
               "the largest form has more terms than a fit");

/* ---- form ---- */

/* The Legendre polynomials at index i of n points, between -1 and 1. */
static void legendre(int degree, size_t i, size_t n, double *p) {
  gsl_sf_legendre_Pl_array(degree, n > 1 ? 2 * (double)i / (double)(n - 1) - 1 : 0, p);
}

/* Over the good heights: with `subtract` takes the polynomial out of them, else adds them to the
 * normal equations. The terms are all products of that total degree. */
static void pass(aspi_raw *raw, int degree, aspi_least_squares *fit, bool subtract) {
  double px[ASP_FORM_MAX + 1], py[ASP_FORM_MAX + 1], t[ASP_TERMS_MOST];
  int most_y = raw->is_map ? degree : 0;
  for (size_t at = 0; at < raw->points; at++) {
    double z = raw->z[at];
    if (at % raw->columns == 0)
      legendre(degree, at / raw->columns, raw->rows, py);
    if (isnan(z))
      continue;
    legendre(degree, at % raw->columns, raw->columns, px);
    size_t k = 0;
    for (int i = 0; i <= degree; i++)
      for (int j = 0; j <= most_y && i + j <= degree; j++)
        t[k++] = px[i] * py[j];
    if (subtract)
      raw->z[at] = z - aspi_least_squares_value(fit, t);
    else
      aspi_least_squares_add(fit, t, z);
  }
}

static asp_code take_out_form(aspi_raw *raw, int degree, asp_error *error) {
  if (degree < 0)
    return ASP_OK;
  size_t n = (size_t)degree + 1, good = raw->points - aspi_raw_count_bad(raw);
  aspi_least_squares fit = {.terms = raw->is_map ? n * (n + 1) / 2 : n};
  if (good <= fit.terms)
    return aspi_file_fail(raw->path, 0, error,
                          "%zu points are too few for a polynomial of degree %d as form", good,
                          degree);
  pass(raw, degree, &fit, false);
  if (!aspi_least_squares_solve(&fit))
    return aspi_file_fail(raw->path, 0, error, "no polynomial of degree %d fits the %s", degree,
                          aspi_kind_of_rows(raw->rows));
  pass(raw, degree, &fit, true);
  return ASP_OK;
}

/* ---- spikes ---- */

/* Distance of a height from the median of its neighbors along one direction. Neighbors come in
 * opposite pairs that are both good, so slopes and edges of gaps have no effect. INFINITY if there
 * is no pair. */
static double off_line(const aspi_raw *raw, size_t at, const long direction[2]) {
  double line[2 * REACH];
  size_t count = 0;
  long reach = raw->is_map ? REACH_MAP : REACH;
  long columns = (long)raw->columns, rows = (long)raw->rows;
  long i = (long)at % columns, j = (long)at / columns;
  for (long k = 1; k <= reach; k++) {
    long a = k * direction[0], b = k * direction[1];
    if (i - labs(a) < 0 || i + labs(a) >= columns || j - b < 0 || j + b >= rows)
      break;
    double one = raw->z[(size_t)((j + b) * columns + i + a)];
    double two = raw->z[(size_t)((j - b) * columns + i - a)];
    if (isnan(one) || isnan(two))
      continue;
    line[count++] = one;
    line[count++] = two;
  }
  if (count == 0)
    return INFINITY;
  gsl_sort(line, 1, count);
  return fabs(raw->z[at] - gsl_stats_median_from_sorted_data(line, 1, count));
}

/* A good point's distances from its neighbors over all directions: the least, since a point on the
 * ridge of a groove agrees with those along it, and the mean; 0 where it has no neighbors, NAN
 * where the point is bad. */
typedef struct offsets {
  double least, mean;
} offsets;

static offsets off_neighbors(const aspi_raw *raw, size_t at) {
  static const long directions[][2] = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}};
  double least = INFINITY, sum = 0;
  int count = 0;
  if (isnan(raw->z[at]))
    return (offsets){NAN, NAN};
  for (size_t k = 0; k < (raw->is_map ? sizeof directions / sizeof *directions : 1); k++) {
    double off = off_line(raw, at, directions[k]);
    if (!isfinite(off))
      continue;
    least = fmin(least, off);
    sum += off;
    count++;
  }
  return count ? (offsets){least, sum / count} : (offsets){0, 0};
}

/* The points over `times` robust standard deviations off their neighbors in every direction, *first
 * of them first, which `mark` makes bad. The deviation comes from the mean over the directions; at
 * least half the step in which heights are given, since most points of heights in steps are off by
 * nothing. */
static asp_code find_spikes(aspi_raw *raw, const aspi_steps *steps, double times, bool mark,
                            size_t *count, size_t *first, asp_error *error) {
  bool *is_spike = malloc(raw->points * sizeof *is_spike);
  if (!is_spike)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for the spikes of %zu points", raw->points);
  gsl_rstat_quantile_workspace median = {.p = 0.5};
  gsl_rstat_quantile_reset(&median);
  for (size_t i = 0; i < raw->points; i++) {
    double off = off_neighbors(raw, i).mean;
    if (!isnan(off))
      gsl_rstat_quantile_add(off, &median);
  }
  double sd = MAD_TO_SD * gsl_rstat_quantile_get(&median);
  double most = times * fmax(sd, isfinite(steps->quantum) ? steps->quantum / 2 : 0);
  for (size_t i = 0; i < raw->points; i++)
    is_spike[i] = off_neighbors(raw, i).least > most;
  *count = 0;
  for (size_t i = 0; i < raw->points; i++)
    if (is_spike[i]) {
      *first = *count ? *first : i;
      ++*count;
      if (mark)
        raw->z[i] = NAN;
    }
  free(is_spike);
  return ASP_OK;
}

/* ---- gaps ---- */

/* Bad points are filled if they are at most half of all; spikes count as bad. */
static asp_code check_bad(const aspi_raw *raw, size_t spikes, size_t first, bool fill,
                          asp_error *error) {
  size_t bad = aspi_raw_count_bad(raw);
  char must[100] = "fill the gaps (asperity surface --gaps fill --save FILE), or mend the file";
  if (fill ? 2 * bad <= raw->points : bad == 0)
    return ASP_OK;
  if (fill)
    snprintf(must, sizeof must, "more than half of %zu points cannot be filled", raw->points);
  if (spikes > 0)
    return aspi_file_fail(raw->path, 0, error, "point %zu is the first of %zu spikes; %s",
                          first + 1, spikes, must);
  if (raw->bad_line > 0)
    return aspi_file_fail(raw->path, raw->bad_line, error,
                          "the first of %zu bad or missing points; %s", bad, must);
  return aspi_file_fail(raw->path, 0, error, "%zu of %zu points are bad or missing; %s", bad,
                        raw->points, must);
}

/* Cuts the bad ends of a profile off. */
static void cut_ends(aspi_raw *raw) {
  double *z = raw->z;
  size_t first = 0;
  while (raw->points > 0 && isnan(z[raw->points - 1]))
    raw->points--;
  while (first < raw->points && isnan(z[first]))
    first++;
  raw->columns = raw->points -= first;
  memmove(z, z + first, raw->points * sizeof *z);
}

/* Sums that fill the gaps: a weighted mean over the lines through a point. */
typedef struct filling {
  double *sum, *weight;
  size_t longest;
} filling;

/* Adds the estimates of a line of `n` heights, `stride` apart, for its gaps: a straight line
 * between two good points, the last good height beyond them. A short gap has a larger weight. */
static void bridge(const aspi_raw *raw, size_t from, size_t n, size_t stride, filling *f) {
  size_t before = n; /* the last good point; n: none */
  for (size_t i = 0; i <= n; i++) {
    double z = i < n ? raw->z[from + i * stride] : NAN;
    if (i < n && isnan(z))
      continue;
    size_t first = before < n ? before + 1 : 0;
    bool inside = before < n && i < n;
    double low = before < n ? raw->z[from + before * stride] : z, high = i < n ? z : low;
    double weight = 1 / (double)(i - first + (inside ? 0 : n));
    for (size_t k = first; k < i && (before < n || i < n); k++) {
      double share = inside ? (double)(k - before) / (double)(i - before) : 0;
      f->sum[from + k * stride] += weight * (low + share * (high - low));
      f->weight[from + k * stride] += weight;
    }
    f->longest = i - first > f->longest ? i - first : f->longest;
    before = i;
  }
}

static asp_code fill_gaps(aspi_raw *raw, aspi_profile_report *report, asp_error *error) {
  if (!raw->is_map)
    cut_ends(raw);
  if (aspi_raw_count_bad(raw) == 0)
    return ASP_OK;
  filling f = {calloc(raw->points, sizeof *f.sum), calloc(raw->points, sizeof *f.weight), 0};
  bool made = f.sum && f.weight;
  for (size_t j = 0; made && j < raw->rows; j++)
    bridge(raw, j * raw->columns, raw->columns, 1, &f);
  for (size_t i = 0; made && raw->is_map && i < raw->columns; i++)
    bridge(raw, i, raw->rows, raw->columns, &f);
  for (size_t i = 0; made && i < raw->points; i++)
    if (isnan(raw->z[i])) {
      raw->z[i] = f.weight[i] > 0 ? f.sum[i] / f.weight[i] : 0;
      report->filled++;
    }
  report->longest_gap = f.longest;
  free(f.sum);
  free(f.weight);
  return made ? ASP_OK
              : aspi_fail(error, ASP_ENOMEM, "out of memory for the gaps of a %s",
                          aspi_kind_of_rows(raw->rows));
}

/* ---- mending ---- */

static double largest(const aspi_raw *raw) {
  double least, most;
  aspi_raw_range(raw, &least, &most);
  return least <= most ? fmax(fabs(least), fabs(most)) : 0;
}

static asp_code check_lengths(const aspi_raw *raw, asp_error *error) {
  double most = largest(raw);
  for (int k = 0; k < 1 + raw->is_map; k++)
    if (!(raw->step[k] >= SPACING_LEAST && raw->step[k] <= LENGTH_MOST && most <= LENGTH_MOST))
      return aspi_file_fail(raw->path, 0, error, "heights to %g m at %g m spacing: check the unit",
                            most, raw->step[k]);
  if (raw->columns >= ASP_SIDE_LEAST && raw->points <= ASP_POINTS_MOST &&
      (!raw->is_map || raw->rows >= ASP_SIDE_LEAST))
    return ASP_OK;
  return aspi_file_fail(raw->path, 0, error,
                        "a %s of %zu x %zu points; its sides must have at least %d, and all "
                        "together at most %zu",
                        aspi_kind_of_rows(raw->rows), raw->columns, raw->rows, ASP_SIDE_LEAST,
                        ASP_POINTS_MOST);
}

/* Subtracts the form; again if spikes were found. */
static asp_code level(aspi_raw *raw, const aspi_profile_options *options,
                      aspi_profile_report *report, asp_error *error) {
  bool mark = options->spikes > 0;
  size_t first = 0;
  aspi_steps steps = aspi_steps_find(raw);
  asp_code code = take_out_form(raw, options->form, error);
  if (!code)
    code = find_spikes(raw, &steps, mark ? options->spikes : ASP_SPIKES_CLEAR, mark,
                       mark ? &report->spikes : &report->outliers, &first, error);
  aspi_warnings_write(&steps, report->outliers, report->warnings, sizeof report->warnings);
  if (code || report->spikes == 0 ||
      (code = check_bad(raw, report->spikes, first, options->fill, error)))
    return code;
  return take_out_form(raw, options->form, error);
}

asp_code aspi_mend(aspi_raw *raw, const aspi_profile_options *options, aspi_profile_report *report,
                   asp_error *error) {
  if (!raw->is_map) {
    raw->columns = raw->points;
    raw->rows = 1;
  }
  asp_code code = check_lengths(raw, error);
  if (!code)
    code = check_bad(raw, 0, 0, options->fill, error);
  double least, most, rounding = ASPI_ROUNDING_DOUBLE * largest(raw);
  if (!code)
    code = level(raw, options, report, error);
  if (!code)
    code = fill_gaps(raw, report, error);
  if (!code && !raw->is_map && options->lambda_s > 0)
    code = aspi_filter(raw->z, raw->points, raw->step[0], options->lambda_s, error);
  if (code)
    return code;
  aspi_raw_range(raw, &least, &most);
  if (raw->points >= ASP_SIDE_LEAST && most - least > rounding)
    return ASP_OK;
  return aspi_file_fail(raw->path, 0, error, "the %s is constant%s", aspi_kind_of_rows(raw->rows),
                        options->form > 0 ? " but for its form" : "");
}
