/* What is done to the heights of a measured map before it is one, as to those of a profile: a
 * polynomial taken out as form (least squares on products of Legendre polynomials), spikes marked
 * (far off the median of their neighbours), gaps filled by straight lines or refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/map_read.h"
#include "readers/mend.h"

#include <gsl/gsl_sf_legendre.h>
#include <math.h>
#include <stdlib.h>

enum { RING = 2 }; /* of neighbours, for spikes */

/* Less than this part of the heights in the file is rounding: they are single precision. */
#define ROUNDING 1e-7

/* The Legendre polynomials at index i of n points, between -1 and 1. */
static void legendre(int degree, size_t i, size_t n, double *p) {
  gsl_sf_legendre_Pl_array(degree, 2 * (double)i / (double)(n - 1) - 1, p);
}

/* The products of total degree up to `degree`. */
static void products(int degree, const double *px, const double *py, double *out) {
  size_t k = 0;
  for (int i = 0; i <= degree; i++)
    for (int j = 0; i + j <= degree; j++)
      out[k++] = px[i] * py[j];
}

/* Goes over the good heights: with `subtract` takes the polynomial out of them, else sums the
 * normal equations. */
static void pass(aspi_raw_map *raw, int degree, aspi_fit *fit, bool subtract) {
  double px[ASP_FORM_MAX + 1], py[ASP_FORM_MAX + 1], t[ASP_FORM_TERMS];
  for (size_t j = 0; j < raw->rows; j++) {
    legendre(degree, j, raw->rows, py);
    for (size_t i = 0; i < raw->columns; i++) {
      float *z = &raw->heights[j * raw->columns + i];
      if (isnan(*z))
        continue;
      legendre(degree, i, raw->columns, px);
      products(degree, px, py, t);
      if (subtract)
        *z = (float)(*z - aspi_fit_value(fit, t));
      else
        aspi_fit_add(fit, t, *z);
    }
  }
}

static size_t count_bad(const aspi_raw_map *raw) {
  size_t count = 0;
  for (size_t i = 0; i < raw->points; i++)
    count += isnan(raw->heights[i]);
  return count;
}

static asp_code take_out_form(aspi_raw_map *raw, const char *path, int degree, asp_error *error) {
  if (degree < 0)
    return ASP_OK;
  aspi_fit fit = {.terms = (size_t)((degree + 1) * (degree + 2) / 2)};
  pass(raw, degree, &fit, false);
  if (!aspi_fit_solve(&fit))
    return aspi_fail(error, ASP_EDATA, "%.200s: no polynomial of degree %d fits the map", path,
                     degree);
  pass(raw, degree, &fit, true);
  return ASP_OK;
}

/* A good point's distance from the median of its neighbours, taken in pairs opposite to each other
 * that are both good, so that a slope does not count; 0 where there is no pair. */
static double off_neighbours(const void *map, size_t at) {
  const aspi_raw_map *raw = map;
  if (isnan(raw->heights[at]))
    return NAN;
  double window[(2 * RING + 1) * (2 * RING + 1)];
  long columns = (long)raw->columns, rows = (long)raw->rows;
  long i = (long)(at % raw->columns), j = (long)(at / raw->columns);
  size_t count = 0;
  for (long b = 0; b <= RING; b++)
    for (long a = b ? -RING : 1; a <= RING; a++) {
      if (i - labs(a) < 0 || i + labs(a) >= columns || j - b < 0 || j + b >= rows)
        continue;
      float one = raw->heights[(j + b) * columns + i + a];
      float two = raw->heights[(j - b) * columns + i - a];
      if (isnan(one) || isnan(two))
        continue;
      window[count++] = one;
      window[count++] = two;
    }
  return aspi_off_median(raw->heights[at], window, count);
}

/* Makes spikes bad. */
static asp_code mark_spikes(aspi_raw_map *raw, const aspi_steps *steps, double times,
                            size_t *spikes, asp_error *error) {
  bool *is_spike = aspi_spikes(raw, steps, raw->points, off_neighbours, times, error);
  if (!is_spike)
    return ASP_ENOMEM;
  for (size_t i = 0; i < raw->points; i++)
    if (is_spike[i]) {
      raw->heights[i] = NAN;
      ++*spikes;
    }
  free(is_spike);
  return ASP_OK;
}

static double height_of(const void *map, size_t at) {
  return (double)((const aspi_raw_map *)map)->heights[at];
}

/* Adds what a line of `n` heights, `stride` apart, says about its gaps: between two good points
 * those on a straight line, beyond the last one its height; a short gap counts more. */
static void bridge(const float *z, size_t n, size_t stride, float *sum, float *weight) {
  size_t before = n; /* the last good point; n: none */
  for (size_t i = 0; i <= n; i++) {
    if (i < n && isnan(z[i * stride]))
      continue;
    size_t first = before < n ? before + 1 : 0;
    for (size_t k = first; k < i && (before < n || i < n); k++) {
      double low = before < n ? z[before * stride] : z[i * stride];
      double high = i < n ? z[i * stride] : low;
      double share = before < n && i < n ? (double)(k - before) / (double)(i - before) : 0;
      float w = (float)(1 / (double)(i - first + (before < n && i < n ? 0 : n)));
      sum[k * stride] += w * (float)(low + share * (high - low));
      weight[k * stride] += w;
    }
    before = i;
  }
}

static asp_code fill_gaps(aspi_raw_map *raw, aspi_profile_report *report, asp_error *error) {
  float *sum = calloc(raw->points, sizeof *sum), *weight = calloc(raw->points, sizeof *weight);
  if (sum && weight) {
    for (size_t j = 0; j < raw->rows; j++) {
      size_t at = j * raw->columns;
      bridge(raw->heights + at, raw->columns, 1, sum + at, weight + at);
    }
    for (size_t i = 0; i < raw->columns; i++)
      bridge(raw->heights + i, raw->rows, raw->columns, sum + i, weight + i);
    for (size_t i = 0; i < raw->points; i++)
      if (isnan(raw->heights[i])) {
        raw->heights[i] = weight[i] > 0 ? sum[i] / weight[i] : 0;
        report->filled++;
      }
  }
  bool made = sum && weight;
  free(sum);
  free(weight);
  return made ? ASP_OK : aspi_fail(error, ASP_ENOMEM, "out of memory for the gaps of a map");
}

static asp_code check(const aspi_raw_map *raw, const char *path, asp_error *error) {
  double most = 0;
  for (size_t i = 0; i < raw->points; i++)
    if (!isnan(raw->heights[i]))
      most = fmax(most, fabs(raw->heights[i]));
  for (int k = 0; k < 2; k++)
    if (!(raw->step[k] >= ASP_SPACING_LEAST && raw->step[k] <= ASP_LENGTH_MOST) ||
        !(most <= ASP_LENGTH_MOST))
      return aspi_fail(
          error, ASP_EDATA,
          "%.200s: heights up to %g m at a spacing of %g m are no surface; is the unit "
          "right?",
          path, most, raw->step[k]);
  if (raw->columns < ASP_MAP_SIDE_LEAST || raw->rows < ASP_MAP_SIDE_LEAST ||
      raw->columns > ASP_MAP_SIDE_MOST || raw->rows > ASP_MAP_SIDE_MOST)
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: a map of %zu x %zu points; its sides must have %d to %d", path,
                     raw->columns, raw->rows, ASP_MAP_SIDE_LEAST, ASP_MAP_SIDE_MOST);
  return ASP_OK;
}

/* Bad points and spikes, of which there may be some only where they are to be filled. */
static asp_code check_bad(const aspi_raw_map *raw, const char *path, size_t spikes, bool fill,
                          asp_error *error) {
  size_t bad = count_bad(raw);
  if (bad > 0 && !fill)
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: %zu of %zu points are bad, missing, or one of %zu spikes; fill the "
                     "gaps, or mend the file",
                     path, bad, raw->points, spikes);
  if (2 * bad > raw->points)
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: %zu of %zu points are bad, missing, or one of %zu spikes; more than "
                     "half cannot be filled",
                     path, bad, raw->points, spikes);
  return ASP_OK;
}

static bool is_constant(const aspi_raw_map *raw, double before) {
  double lo = INFINITY, hi = -INFINITY;
  for (size_t i = 0; i < raw->points; i++) {
    lo = fmin(lo, raw->heights[i]);
    hi = fmax(hi, raw->heights[i]);
  }
  return !(hi - lo > ROUNDING * before);
}

static double largest(const aspi_raw_map *raw) {
  double most = 0;
  for (size_t i = 0; i < raw->points; i++)
    most = fmax(most, isnan(raw->heights[i]) ? 0 : fabs(raw->heights[i]));
  return most;
}

asp_code aspi_map_mend(aspi_raw_map *raw, const char *path, const aspi_profile_options *options,
                       aspi_profile_report *report, asp_error *error) {
  report->points = raw->points;
  report->bad = raw->bad;
  report->step_least = raw->step[0] * options->metre;
  report->step_most = raw->step[1] * options->metre;
  asp_code code = check(raw, path, error);
  if (!code)
    code = check_bad(raw, path, 0, options->fill, error);
  double before = code ? 0 : largest(raw);
  aspi_steps steps = {.points = 0};
  if (!code) {
    steps = aspi_steps_find(raw, raw->points, height_of);
    code = take_out_form(raw, path, options->form, error);
  }
  if (!code && !(options->spikes > 0))
    code = aspi_count_spikes(raw, &steps, raw->points, off_neighbours, ASP_SPIKES_CLEAR,
                             &report->outliers, error);
  aspi_doubts_tell(&steps, report->outliers, report->doubts, sizeof report->doubts);
  if (!code && options->spikes > 0) {
    code = mark_spikes(raw, &steps, options->spikes, &report->spikes, error);
    if (!code)
      code = check_bad(raw, path, report->spikes, options->fill, error);
    if (!code && report->spikes > 0)
      code = take_out_form(raw, path, options->form, error);
  }
  if (!code && count_bad(raw) > 0)
    code = fill_gaps(raw, report, error);
  if (!code && is_constant(raw, before))
    code = aspi_fail(error, ASP_EDATA, "%.200s: the map is constant%s", path,
                     options->form > 0 ? " but for its form" : "");
  if (code)
    return code;
  char form[64] = "form left in", spikes[48] = "", gaps[64] = "";
  if (options->form >= 0)
    snprintf(form, sizeof form, "polynomial of degree %d taken out", options->form);
  if (report->spikes)
    snprintf(spikes, sizeof spikes, ", %zu spikes", report->spikes);
  if (report->filled)
    snprintf(gaps, sizeof gaps, ", %zu points filled in", report->filled);
  snprintf(report->text, sizeof report->text, "%zu x %zu points read, %zu bad%s%s, %s",
           raw->columns, raw->rows, report->bad, spikes, gaps, form);
  return ASP_OK;
}
