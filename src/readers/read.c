/* Measured profiles: which reader a file needs, and what is done to its heights before they are a
 * profile: a polynomial taken out as form (least squares on Legendre polynomials), spikes marked
 * (far off the median of their neighbours), gaps filled by straight lines or refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/read.h"
#include "base/error.h"
#include "base/file.h"
#include "readers/mend.h"
#include "surface/profile.h"

#include <gsl/gsl_sf_legendre.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NEIGHBOURS = 3 }; /* on each side, for spikes */

/* Less than this part of the heights in the file is rounding. */
#define ROUNDING 1e-12

aspi_profile_options aspi_profile_options_default(void) {
  return (aspi_profile_options){.metre = 1, .form = 1, .resample = true, .row = 1};
}

asp_code aspi_raw_add(aspi_raw *raw, double height, asp_error *error) {
  if (raw->points == raw->room) {
    size_t room = raw->room ? raw->room + raw->room / 2 : 4096;
    double *grown =
        room <= SIZE_MAX / sizeof *grown ? realloc(raw->heights, room * sizeof *grown) : NULL;
    if (!grown)
      return aspi_fail(error, ASP_ENOMEM, "out of memory for a profile of over %zu points",
                       raw->points);
    raw->heights = grown;
    raw->room = room;
  }
  raw->heights[raw->points++] = height;
  return ASP_OK;
}

/* The position of a point between -1 and 1, where Legendre polynomials are at home. */
static double place(const aspi_raw *raw, size_t i) {
  return 2 * (double)i / (double)(raw->points - 1) - 1;
}

/* With `subtract` takes the polynomial out of the heights, else sums the normal equations of those
 * that are good. */
static void pass(aspi_raw *raw, aspi_fit *fit, bool subtract) {
  double p[ASP_FORM_MAX + 1];
  for (size_t i = 0; i < raw->points; i++) {
    if (isnan(raw->heights[i]))
      continue;
    gsl_sf_legendre_Pl_array((int)fit->terms - 1, place(raw, i), p);
    if (subtract)
      raw->heights[i] -= aspi_fit_value(fit, p);
    else
      aspi_fit_add(fit, p, raw->heights[i]);
  }
}

static size_t count_good(const aspi_raw *raw) {
  size_t count = 0;
  for (size_t i = 0; i < raw->points; i++)
    count += !isnan(raw->heights[i]);
  return count;
}

static asp_code take_out_form(aspi_raw *raw, const char *path, int degree, asp_error *error) {
  if (degree < 0)
    return ASP_OK;
  if (count_good(raw) < (size_t)degree + 2)
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: %zu points are too few for a polynomial of degree %d as form", path,
                     count_good(raw), degree);
  aspi_fit fit = {.terms = (size_t)degree + 1};
  pass(raw, &fit, false);
  if (!aspi_fit_solve(&fit))
    return aspi_fail(error, ASP_EDATA, "%.200s: no polynomial of degree %d fits the profile", path,
                     degree);
  pass(raw, &fit, true);
  return ASP_OK;
}

/* A good point's distance from the median of its neighbours, taken in pairs that are good on both
 * sides, so that a slope does not count, nor does the edge of a gap; 0 where there is no pair. */
static double off_neighbours(const void *profile, size_t i) {
  const aspi_raw *raw = profile;
  double window[2 * NEIGHBOURS];
  size_t count = 0;
  if (isnan(raw->heights[i]))
    return NAN;
  for (size_t k = 1; k <= NEIGHBOURS && k <= i && i + k < raw->points; k++)
    if (!isnan(raw->heights[i - k]) && !isnan(raw->heights[i + k])) {
      window[count++] = raw->heights[i - k];
      window[count++] = raw->heights[i + k];
    }
  return aspi_off_median(raw->heights[i], window, count);
}

/* Makes spikes bad. */
static asp_code mark_spikes(aspi_raw *raw, const aspi_steps *steps, double times, size_t *spikes,
                            asp_error *error) {
  bool *is_spike = aspi_spikes(raw, steps, raw->points, off_neighbours, times, error);
  if (!is_spike)
    return ASP_ENOMEM;
  for (size_t i = 0; i < raw->points; i++)
    if (is_spike[i]) {
      raw->heights[i] = NAN;
      raw->first_spike = *spikes ? raw->first_spike : i + 1;
      ++*spikes;
    }
  free(is_spike);
  return ASP_OK;
}

/* Cuts bad ends off, and puts straight lines across the gaps that are left. */
static void fill_gaps(aspi_raw *raw, aspi_profile_report *report) {
  double *z = raw->heights;
  while (raw->points > 0 && isnan(z[raw->points - 1]))
    raw->points--;
  size_t first = 0;
  while (first < raw->points && isnan(z[first]))
    first++;
  raw->points -= first;
  memmove(z, z + first, raw->points * sizeof *z);
  for (size_t i = 1; i < raw->points; i++) {
    if (!isnan(z[i]))
      continue;
    size_t end = i;
    while (isnan(z[end]))
      end++;
    double before = z[i - 1], rise = (z[end] - before) / (double)(end - i + 1);
    for (size_t k = i; k < end; k++)
      z[k] = before + rise * (double)(k - i + 1);
    report->filled += end - i;
    report->longest_gap = end - i > report->longest_gap ? end - i : report->longest_gap;
    i = end;
  }
}

static double largest(const aspi_raw *raw) {
  double most = 0;
  for (size_t i = 0; i < raw->points; i++)
    most = fmax(most, fabs(raw->heights[i]));
  return most;
}

static bool is_constant(const aspi_raw *raw, double rounding) {
  double lo = INFINITY, hi = -INFINITY;
  for (size_t i = 0; i < raw->points; i++) {
    lo = fmin(lo, raw->heights[i]);
    hi = fmax(hi, raw->heights[i]);
  }
  return !(hi - lo > rounding);
}

static asp_code check_lengths(const aspi_raw *raw, const char *path, asp_error *error) {
  if (largest(raw) <= ASP_LENGTH_MOST && raw->spacing <= ASP_LENGTH_MOST &&
      raw->spacing >= ASP_SPACING_LEAST)
    return ASP_OK;
  return aspi_fail(error, ASP_EDATA,
                   "%.200s: heights up to %g m at a spacing of %g m are no surface; is the unit "
                   "right?",
                   path, largest(raw), raw->spacing);
}

static asp_code check_gaps(const aspi_raw *raw, const aspi_text *text, bool fill,
                           asp_error *error) {
  size_t bad = raw->points - count_good(raw);
  if (bad > 0 && !fill)
    return aspi_text_fail(text, raw->bad_line, error,
                          "the first of %zu bad or missing points; fill the gaps, or mend the file",
                          bad);
  if (2 * bad > raw->points)
    return aspi_text_fail(text, raw->bad_line, error,
                          "the first of %zu bad or missing points of %zu; more than half cannot be "
                          "filled",
                          bad, raw->points);
  return ASP_OK;
}

/* Spikes become bad points, and are refused or filled in as those are. */
static asp_code check_spikes(const aspi_raw *raw, const char *path, size_t spikes, bool fill,
                             asp_error *error) {
  size_t bad = raw->points - count_good(raw);
  if (spikes > 0 && !fill)
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: point %zu is the first of %zu spikes; fill the gaps that they leave, "
                     "or mend the file",
                     path, raw->first_spike, spikes);
  if (2 * bad > raw->points)
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: %zu of %zu points are bad, missing, or one of %zu spikes; more than "
                     "half cannot be filled",
                     path, bad, raw->points, spikes);
  return ASP_OK;
}

static double height_of(const void *profile, size_t i) {
  return ((const aspi_raw *)profile)->heights[i];
}

static asp_code level(aspi_raw *raw, const char *path, const aspi_profile_options *options,
                      aspi_profile_report *report, asp_error *error) {
  size_t *spikes = &report->spikes;
  aspi_steps steps = aspi_steps_find(raw, raw->points, height_of);
  asp_code code = take_out_form(raw, path, options->form, error);
  if (!code && !(options->spikes > 0))
    code = aspi_count_spikes(raw, &steps, raw->points, off_neighbours, ASP_SPIKES_CLEAR,
                             &report->outliers, error);
  aspi_doubts_tell(&steps, report->outliers, report->doubts, sizeof report->doubts);
  if (code || !(options->spikes > 0))
    return code;
  if ((code = mark_spikes(raw, &steps, options->spikes, spikes, error)) || *spikes == 0 ||
      (code = check_spikes(raw, path, *spikes, options->fill, error)))
    return code;
  return take_out_form(raw, path, options->form, error);
}

static asp_code prepare(aspi_raw *raw, const aspi_text *text, const aspi_profile_options *options,
                        aspi_profile_report *report, asp_error *error) {
  asp_code code = check_gaps(raw, text, options->fill, error);
  if (!code)
    code = check_lengths(raw, text->path, error);
  double before = largest(raw);
  if (!code)
    code = level(raw, text->path, options, report, error);
  if (code)
    return code;
  fill_gaps(raw, report);
  code = aspi_filter(raw->heights, raw->points, raw->spacing, &options->filters, error);
  if (code)
    return code;
  if (raw->points < ASP_POINTS_LEAST || is_constant(raw, ROUNDING * before))
    return aspi_fail(error, ASP_EDATA, "%.200s: the profile is constant%s", text->path,
                     options->form > 0 ? " but for its form" : "");
  return ASP_OK;
}

/* The report's sentence. */
static void tell(aspi_profile_report *r, const aspi_raw *raw, const aspi_profile_options *options) {
  char form[64] = "form left in", gaps[96] = "", spacing[96] = "", spikes[48] = "";
  if (options->form >= 0)
    snprintf(form, sizeof form, "polynomial of degree %d taken out", options->form);
  if (r->filled)
    snprintf(gaps, sizeof gaps, ", %zu points filled in (longest gap %zu)", r->filled,
             r->longest_gap);
  if (r->spikes)
    snprintf(spikes, sizeof spikes, ", %zu spikes", r->spikes);
  if (r->resampled)
    snprintf(spacing, sizeof spacing, ", unequal spacing of %.4g to %.4g m resampled to %.4g m",
             raw->step_least, raw->step_most, raw->spacing);
  char other[260] = "";
  const aspi_filters *f = &options->filters;
  size_t used = 0;
  if (raw->second_column > 0)
    used += (size_t)snprintf(other, sizeof other,
                             ", distances in columns %d and %d, heights of column %d",
                             raw->column[0], raw->second_column, raw->column[1]);
  else if (raw->column[0] > 0)
    used += (size_t)snprintf(other, sizeof other, ", of columns %d and %d", raw->column[0],
                             raw->column[1]);
  else if (raw->column[1] > 0)
    used += (size_t)snprintf(other, sizeof other, ", of column %d", raw->column[1]);
  if (raw->repeats)
    used += (size_t)snprintf(other + used, sizeof other - used, ", %zu repeated positions averaged",
                             raw->repeats);
  if (raw->falls)
    used +=
        (size_t)snprintf(other + used, sizeof other - used, ", positions fall and are reversed");
  if (raw->end_line)
    used += (size_t)snprintf(other + used, sizeof other - used, ", data end before line %zu",
                             raw->end_line);
  if (f->tip > 0)
    used += (size_t)snprintf(other + used, sizeof other - used, ", tip %g m", f->tip);
  if (f->lambda_s > 0)
    used += (size_t)snprintf(other + used, sizeof other - used, ", lambda_s %g m", f->lambda_s);
  if (f->cutoff > 0)
    snprintf(other + used, sizeof other - used, ", cutoff %g m%s", f->cutoff,
             f->robust ? " (robust)" : "");
  snprintf(r->text, sizeof r->text, "%zu points read, %zu bad%s%s%s%s, %s", r->points, r->bad,
           spikes, gaps, spacing, other, form);
}

static asp_code read_raw(aspi_text *text, const aspi_profile_options *options, aspi_raw *raw,
                         asp_error *error) {
  bool found = true;
  aspi_format format;
  asp_code code = aspi_format_find(text->stream, text->path, &format, error);
  if (code)
    return code;
  if (format == ASP_FORMAT_SDF_BINARY)
    return aspi_fail(error, ASP_EDATA,
                     "%.200s: this is SDF in binary, which is read as a map, not as a profile",
                     text->path);
  do {
    code = aspi_text_line(text, &found, error);
  } while (!code && found && text->text[strspn(text->text, " \t\v\f")] == '\0');
  if (code)
    return code;
  if (!found)
    return aspi_text_fail(text, text->line, error, "the file is empty");
  if (format == ASP_FORMAT_SDF_TEXT) {
    code = aspi_sdf_check_options(text->path, options, options->step, error);
    return code ? code : aspi_read_sdf(text, options, raw, error);
  }
  if (options->row != 1)
    return aspi_fail(error, ASP_EARG, "%.200s: row %d is asked for; text in columns has no rows",
                     text->path, options->row);
  return aspi_read_columns(text, options, raw, error);
}

asp_code aspi_profile_check_options(const aspi_profile_options *options, asp_error *error) {
  if (options->form < -1 || options->form > ASP_FORM_MAX)
    return aspi_fail(error, ASP_EARG, "form is %d; it must be a degree of 0 to %d, or -1 for none",
                     options->form, ASP_FORM_MAX);
  if (options->row < 1 || options->column < 0 || options->x_number < 0)
    return aspi_fail(error, ASP_EARG,
                     "row is %d, column %d and x_column %d; rows and columns count from 1",
                     options->row, options->column, options->x_number);
  if (aspi_check_range(error, "spikes", "", options->spikes, 0, INFINITY) ||
      aspi_check_range(error, "unit_x", "m", options->unit_x, 0, INFINITY) ||
      aspi_check_range(error, "unit_z", "m", options->unit_z, 0, INFINITY) ||
      aspi_check_range(error, "step", "m", options->step, 0, INFINITY))
    return ASP_EARG;
  return aspi_check_range(error, "metre", "", options->metre, 1e-12, 1e12);
}

asp_profile *aspi_profile_read_stream(FILE *stream, const char *path,
                                      const aspi_profile_options *options,
                                      aspi_profile_report *report, asp_error *error) {
  aspi_profile_options defaults = aspi_profile_options_default();
  aspi_profile_report own;
  options = options ? options : &defaults;
  report = report ? report : &own;
  *report = (aspi_profile_report){0};
  if (aspi_profile_check_options(options, error))
    return NULL;
  aspi_text text = aspi_text_create(stream, path);
  aspi_raw raw = {0};
  if (read_raw(&text, options, &raw, error) || prepare(&raw, &text, options, report, error)) {
    free(raw.heights);
    return NULL;
  }
  report->points = raw.read;
  report->bad = raw.bad;
  report->resampled = raw.resampled;
  report->repeats = raw.repeats;
  tell(report, &raw, options);
  report->step_least = raw.step_least * options->metre;
  report->step_most = raw.step_most * options->metre;
  for (size_t i = 0; i < raw.points; i++)
    raw.heights[i] *= options->metre;
  return aspi_profile_adopt(raw.heights, raw.points, raw.spacing * options->metre, false, error);
}

asp_profile *aspi_profile_read(const char *path, const aspi_profile_options *options,
                               aspi_profile_report *report, asp_error *error) {
  FILE *stream = aspi_file_open(path, error);
  if (!stream)
    return NULL;
  asp_profile *profile = aspi_profile_read_stream(stream, path, options, report, error);
  fclose(stream);
  return profile;
}
