/* Measured profiles: which reader a file needs, and a report of what was read and done to it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/read.h"
#include "base/error.h"
#include "base/file.h"
#include "readers/mend.h"
#include "surface/profile.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

aspi_profile_options aspi_profile_options_default(void) {
  return (aspi_profile_options){.metre = 1, .form = 1, .resample = true, .row = 1};
}

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
append(aspi_profile_report *r, const char *format, ...) {
  size_t used = strlen(r->text);
  va_list args;
  va_start(args, format);
  vsnprintf(r->text + used, sizeof r->text - used, format, args);
  va_end(args);
}

void aspi_report(aspi_profile_report *r, const aspi_raw *raw, const aspi_profile_options *options) {
  const aspi_filters *f = &options->filters;
  *r->text = '\0';
  r->points = raw->read;
  r->bad = raw->bad;
  r->resampled = raw->resampled;
  r->repeats = raw->repeats;
  r->step_least = raw->step_least * options->metre;
  r->step_most = raw->step_most * options->metre;
  if (raw->is_map)
    append(r, "%zu x %zu", raw->columns, raw->rows);
  else
    append(r, "%zu", r->points);
  append(r, " points read, %zu bad", r->bad);
  if (r->spikes)
    append(r, ", %zu spikes", r->spikes);
  if (r->filled)
    append(r, ", %zu points filled in (longest gap %zu)", r->filled, r->longest_gap);
  if (r->resampled)
    append(r, ", unequal spacing of %.4g to %.4g m resampled to %.4g m", raw->step_least,
           raw->step_most, raw->step[0]);
  if (raw->second_column > 0)
    append(r, ", distances in columns %d and %d, heights of column %d", raw->column[0],
           raw->second_column, raw->column[1]);
  else if (raw->column[0] > 0)
    append(r, ", of columns %d and %d", raw->column[0], raw->column[1]);
  else if (raw->column[1] > 0)
    append(r, ", of column %d", raw->column[1]);
  if (raw->repeats)
    append(r, ", %zu repeated positions averaged", raw->repeats);
  if (raw->falls)
    append(r, ", positions fall and are reversed");
  if (raw->end_line)
    append(r, ", data end before line %zu", raw->end_line);
  if (f->tip > 0)
    append(r, ", tip %g m", f->tip);
  if (f->lambda_s > 0)
    append(r, ", lambda_s %g m", f->lambda_s);
  if (f->cutoff > 0)
    append(r, ", cutoff %g m%s", f->cutoff, f->robust ? " (robust)" : "");
  if (options->form >= 0)
    append(r, ", polynomial of degree %d taken out", options->form);
  else
    append(r, ", form left in");
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
  } while (!code && found && aspi_text_blank(text->text));
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
  if (read_raw(&text, options, &raw, error) || aspi_mend(&raw, path, options, report, error)) {
    free(raw.heights);
    return NULL;
  }
  aspi_report(report, &raw, options);
  for (size_t i = 0; i < raw.points; i++)
    aspi_raw_put(&raw, i, aspi_raw_at(&raw, i) * options->metre);
  return aspi_profile_adopt(raw.heights, raw.points, raw.step[0] * options->metre, false, error);
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
