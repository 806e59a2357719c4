/* What is done to the heights of a measured map before it is one, as to those of a profile: a
 * polynomial taken out as form (least squares on products of Legendre polynomials), spikes marked
 * (far off the median of their neighbours), gaps filled by straight lines or refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "surface/map_read.h"

#include <gsl/gsl_linalg.h>
#include <gsl/gsl_rstat.h>
#include <gsl/gsl_sf_legendre.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

enum { TERMS_MOST = (ASP_FORM_MAX + 1) * (ASP_FORM_MAX + 2) / 2, RING = 2 };

#define MAD_TO_SD 1.4826

/* Equations whose triangle has a diagonal of this range fix no polynomial. */
#define SINGULAR 1e-13

/* Less than this part of the heights in the file is rounding: they are single precision. */
#define ROUNDING 1e-7

/* Heights beyond this (m) are no surface, and could overflow. */
#define LENGTH_MOST 1e9

/* A polynomial's coefficients, and the normal equations a c = b of its fit. */
typedef struct fit {
  int degree;
  size_t terms;
  double a[TERMS_MOST * TERMS_MOST], b[TERMS_MOST];
} fit;

/* The Legendre polynomials at index i of n points, between -1 and 1. */
static void legendre(int degree, size_t i, size_t n, double *p) {
  gsl_sf_legendre_Pl_array(degree, 2 * (double)i / (double)(n - 1) - 1, p);
}

/* The products of total degree up to that of the fit. */
static void products(const fit *f, const double *px, const double *py, double *out) {
  size_t k = 0;
  for (int i = 0; i <= f->degree; i++)
    for (int j = 0; i + j <= f->degree; j++)
      out[k++] = px[i] * py[j];
}

/* Goes over the good heights: with `subtract` takes the polynomial out of them, else sums the
 * normal equations. */
static void pass(aspi_raw_map *raw, fit *f, bool subtract) {
  double px[ASP_FORM_MAX + 1], py[ASP_FORM_MAX + 1], t[TERMS_MOST];
  for (size_t j = 0; j < raw->rows; j++) {
    legendre(f->degree, j, raw->rows, py);
    for (size_t i = 0; i < raw->columns; i++) {
      float *z = &raw->heights[j * raw->columns + i];
      if (isnan(*z))
        continue;
      legendre(f->degree, i, raw->columns, px);
      products(f, px, py, t);
      double out = 0;
      for (size_t k = 0; k < f->terms; k++) {
        if (subtract) {
          out += f->b[k] * t[k];
          continue;
        }
        f->b[k] += t[k] * *z;
        for (size_t m = 0; m < f->terms; m++)
          f->a[k * f->terms + m] += t[k] * t[m];
      }
      if (subtract)
        *z = (float)(*z - out);
    }
  }
}

/* Turns b into the coefficients; false where the heights do not fix them. */
static bool solve(fit *f) {
  double tau_of[TERMS_MOST], most = 0, least = INFINITY;
  gsl_matrix_view a = gsl_matrix_view_array(f->a, f->terms, f->terms);
  gsl_vector_view b = gsl_vector_view_array(f->b, f->terms);
  gsl_vector_view tau = gsl_vector_view_array(tau_of, f->terms);
  gsl_linalg_QR_decomp(&a.matrix, &tau.vector);
  for (size_t j = 0; j < f->terms; j++) {
    double diagonal = fabs(f->a[j * (f->terms + 1)]);
    most = fmax(most, diagonal);
    least = fmin(least, diagonal);
  }
  if (!(least > SINGULAR * most))
    return false;
  gsl_linalg_QR_svx(&a.matrix, &tau.vector, &b.vector);
  return true;
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
  fit f = {.degree = degree, .terms = (size_t)((degree + 1) * (degree + 2) / 2)};
  pass(raw, &f, false);
  if (!solve(&f))
    return aspi_fail(error, ASP_EDATA, "%.200s: no polynomial of degree %d fits the map", path,
                     degree);
  pass(raw, &f, true);
  return ASP_OK;
}

/* A good point's distance from the median of its neighbours, taken in pairs opposite to each other
 * that are both good, so that a slope does not count; 0 where there is no pair. */
static double off_neighbours(const aspi_raw_map *raw, size_t at) {
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
  if (count == 0)
    return 0;
  gsl_sort(window, 1, count);
  return fabs(raw->heights[at] - gsl_stats_median_from_sorted_data(window, 1, count));
}

/* Makes spikes bad, in two passes: the usual distance, then what is far beyond it. */
static asp_code mark_spikes(aspi_raw_map *raw, double times, size_t *spikes, asp_error *error) {
  bool *is_spike = calloc(raw->points, sizeof *is_spike);
  if (!is_spike)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a map");
  gsl_rstat_quantile_workspace median = {.p = 0.5};
  gsl_rstat_quantile_reset(&median);
  for (size_t i = 0; i < raw->points; i++)
    if (!isnan(raw->heights[i]))
      gsl_rstat_quantile_add(off_neighbours(raw, i), &median);
  double most = times * MAD_TO_SD * gsl_rstat_quantile_get(&median);
  for (size_t i = 0; i < raw->points; i++)
    is_spike[i] = !isnan(raw->heights[i]) && off_neighbours(raw, i) > most;
  for (size_t i = 0; i < raw->points; i++)
    if (is_spike[i]) {
      raw->heights[i] = NAN;
      ++*spikes;
    }
  free(is_spike);
  return ASP_OK;
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
    if (!(raw->step[k] >= 1e-15 && raw->step[k] <= LENGTH_MOST) || !(most <= LENGTH_MOST))
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
  if (!code)
    code = take_out_form(raw, path, options->form, error);
  if (!code && options->spikes > 0) {
    code = mark_spikes(raw, options->spikes, &report->spikes, error);
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
