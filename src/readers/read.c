/* Measured profiles and maps: which reader a file needs, and a report of what was read and done to
 * it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/read.h"
#include "base/error.h"
#include "base/text.h"
#include "surface/heights.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

aspi_profile_options aspi_profile_options_default(void) {
  return (aspi_profile_options){.meter = 1, .form = 1, .row = 1, .missing = NAN};
}

/* Adds what was read to what was mended. */
static void write_report(aspi_profile_report *r, const aspi_raw *raw,
                         const aspi_profile_options *options) {
  *r->text = '\0';
  if (raw->is_map)
    aspi_append(r->text, sizeof r->text, "%zu x ", raw->columns);
  aspi_append(r->text, sizeof r->text, "%zu points read, %zu bad%s",
              raw->is_map ? raw->rows : raw->read, raw->bad, raw->text);
  if (r->spikes)
    aspi_append(r->text, sizeof r->text, ", %zu spikes", r->spikes);
  if (r->filled)
    aspi_append(r->text, sizeof r->text, ", %zu points filled in (longest gap %zu)", r->filled,
                r->longest_gap);
  if (options->lambda_s > 0)
    aspi_append(r->text, sizeof r->text, ", lambda_s %g m", options->lambda_s);
  if (options->form >= 0)
    aspi_append(r->text, sizeof r->text, ", polynomial of degree %d taken out", options->form);
  else
    aspi_append(r->text, sizeof r->text, ", form left in");
}

static asp_code read_raw(aspi_text *text, const aspi_profile_options *o, aspi_raw *raw,
                         asp_error *error) {
  aspi_format format = ASP_FORMAT_TEXT;
  asp_code code = aspi_format_find(text, &format, error);
  const char *stated = o->unit_x > 0        ? "unit"
                       : o->step[0] > 0     ? "step"
                       : !isnan(o->missing) ? "missing"
                       : o->x_column        ? "x-column"
                                            : NULL;
  if (!code && format != ASP_FORMAT_TEXT && stated)
    code =
        aspi_fail(error, ASP_EARG,
                  "%.200s: %s is given; SDF, SUR and X3P state their units, spacing and bad points",
                  text->path, stated);
  if (code)
    return code;
  return format == ASP_FORMAT_TEXT  ? aspi_read_columns(text, o, raw, error)
         : format == ASP_FORMAT_ZIP ? aspi_read_x3p(text, o, raw, error)
         : format == ASP_FORMAT_SUR
             ? aspi_read_sur(text, o, raw, error)
             : aspi_read_sdf(text, format == ASP_FORMAT_SDF_BINARY, o, raw, error);
}

static asp_heights *read_one(FILE *stream, const char *path, bool is_map,
                             const aspi_profile_options *options, aspi_profile_report *report,
                             asp_error *error) {
  aspi_raw raw = {.path = path, .is_map = is_map};
  *report = (aspi_profile_report){0};
  FILE *file = stream ? stream : aspi_file_open(path, error);
  if (!file)
    return NULL;
  aspi_text text = aspi_text_create(file, path);
  asp_code code = read_raw(&text, options, &raw, error);
  if (is_map) {
    raw.read = raw.points;
    raw.bad = aspi_raw_count_bad(&raw);
  }
  if (!code)
    code = aspi_mend(&raw, options, report, error);
  aspi_text_close(&text);
  if (file != stream)
    fclose(file);
  if (code) {
    free(raw.z);
    return NULL;
  }
  if (*raw.note)
    aspi_append(report->warnings, sizeof report->warnings, "%s%s", *report->warnings ? "; " : "",
                raw.note);
  write_report(report, &raw, options);
  for (size_t i = 0; i < raw.points; i++)
    raw.z[i] *= options->meter;
  const double step[] = {raw.step[0] * options->meter, raw.step[is_map] * options->meter};
  return aspi_heights_adopt(raw.z, raw.columns, raw.rows, step, false, error);
}

/* Adds the texts of a file's report, with its name. */
static void add_report(aspi_profile_report *all, const char *name, const aspi_profile_report *one) {
  const char *between = *all->text ? "; " : "";
  aspi_append(all->text, sizeof all->text, "%s%s: %s", between, name, one->text);
  between = *all->warnings ? "; " : "";
  if (*one->warnings)
    aspi_append(all->warnings, sizeof all->warnings, "%s%s: %s", between, name, one->warnings);
}

/* A chain of the profiles of several files; `names` is cut. */
static asp_heights *read_list(char *names, const aspi_profile_options *options,
                              aspi_profile_report *report, asp_error *error) {
  asp_heights *first = NULL, **end = &first;
  asp_error wrong = {.code = ASP_OK};
  *report = (aspi_profile_report){0};
  for (char *name; !wrong.code && (name = aspi_text_field(&names, ','));
       end = *end ? &(*end)->next : end) {
    aspi_profile_report one;
    if (!*name || strcmp(name, "-") == 0)
      aspi_fail(&wrong, ASP_EARG, "one of several profiles is '%s'; it must be the name of a file",
                name);
    else if ((*end = read_one(NULL, name, false, options, &one, &wrong)))
      add_report(report, name, &one);
  }
  if (!wrong.code)
    return first;
  const char *hint = wrong.code == ASP_EFILE
                         ? "; commas separate names of profiles, unless a name is in quotes"
                         : "";
  aspi_fail(error, wrong.code, "%s%s", wrong.text, hint);
  asp_heights_free(first);
  return NULL;
}

asp_heights *aspi_read(FILE *stream, const char *path, bool is_map,
                       const aspi_profile_options *options, aspi_profile_report *report,
                       asp_error *error) {
  aspi_profile_options defaults = aspi_profile_options_default();
  aspi_profile_report own;
  options = options ? options : &defaults;
  report = report ? report : &own;
  if (stream || is_map || !strchr(path, ',') || access(path, F_OK) == 0)
    return read_one(stream, path, is_map, options, report, error);
  char *names = strdup(path);
  asp_heights *heights = names ? read_list(names, options, report, error) : NULL;
  if (!names)
    aspi_fail(error, ASP_ENOMEM, "out of memory for the names of profiles");
  free(names);
  return heights;
}

asp_heights *asp_heights_read(const char *path, bool is_map, double meter, char *text, size_t size,
                              asp_error *doubt, asp_error *error) {
  aspi_profile_options options = aspi_profile_options_default();
  aspi_profile_report report;
  options.meter = meter;
  asp_heights *heights =
      aspi_read(NULL, aspi_word_or_empty(path), is_map, &options, &report, error);
  if (doubt)
    *doubt = (asp_error){.code = ASP_OK};
  if (*report.warnings)
    aspi_fail(doubt, ASP_EDATA, "%s", report.warnings);
  if (text)
    snprintf(text, size, "%s", report.text);
  return heights;
}
