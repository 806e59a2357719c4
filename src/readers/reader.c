/* The reader of measured profiles and maps, set and asked by name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/read.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct asp_reader {
  aspi_profile_options options;
  aspi_profile_report report;
};

asp_reader *asp_reader_create(asp_error *error) {
  asp_reader *reader = calloc(1, sizeof *reader);
  if (reader)
    reader->options = aspi_profile_options_default();
  else
    aspi_fail(error, ASP_ENOMEM, "out of memory for a reader of profiles");
  return reader;
}

void asp_reader_free(asp_reader *reader) {
  free(reader);
}

/* An option; one of the pointers names its variable. */
typedef struct option {
  const char *name;
  double *number;
  int *whole;
  bool *flag;
} option;

asp_code asp_reader_set(asp_reader *reader, const char *name, double value, asp_error *error) {
  aspi_profile_options o = reader->options;
  const option all[] = {
      {.name = "unit_x", .number = &o.unit_x},
      {.name = "unit_z", .number = &o.unit_z},
      {.name = "metre", .number = &o.metre},
      {.name = "form", .whole = &o.form},
      {.name = "spikes", .number = &o.spikes},
      {.name = "fill", .flag = &o.fill},
      {.name = "resample", .flag = &o.resample},
      {.name = "row", .whole = &o.row},
      {.name = "column", .whole = &o.column},
      {.name = "step_x", .number = &o.step[0]},
      {.name = "step_y", .number = &o.step[1]},
      {.name = "tip", .number = &o.filters.tip},
      {.name = "lambda_s", .number = &o.filters.lambda_s},
      {.name = "cutoff", .number = &o.filters.cutoff},
      {.name = "robust", .flag = &o.filters.robust},
      {.name = "x_column", .whole = &o.x_number},
      {.name = "missing", .number = &o.missing},
  };
  enum { COUNT = sizeof all / sizeof *all };
  int i = 0;
  name = aspi_word_or_empty(name);
  while (i < COUNT && strcmp(all[i].name, name) != 0)
    i++;
  if (i == COUNT)
    return aspi_fail(error, ASP_ENAME,
                     "option '%s' is unknown to a reader of profiles; there are: unit_x unit_z "
                     "metre form spikes fill resample row column step_x step_y tip lambda_s cutoff "
                     "robust x_column missing",
                     name);
  if (!all[i].number && !(fabs(value) < INT_MAX && !(value > floor(value))))
    return aspi_fail(error, ASP_EARG, "%s is %g; it must be a whole number", name, value);
  if (all[i].number)
    *all[i].number = value;
  else if (all[i].whole)
    *all[i].whole = (int)value;
  else
    *all[i].flag = value > 0;
  asp_code code = aspi_profile_check_options(&o, error);
  if (all[i].number == &o.missing)
    o.has_missing = !isnan(value);
  else if (!code && all[i].number)
    code = aspi_check_range(error, name, "", value, 0, INFINITY);
  if (code)
    return code;
  reader->options = o;
  return ASP_OK;
}

asp_profile *asp_reader_read(asp_reader *reader, const char *path, asp_error *error) {
  return aspi_profile_read(NULL, aspi_word_or_empty(path), &reader->options, &reader->report,
                           error);
}

asp_map *asp_reader_read_map(asp_reader *reader, const char *path, asp_error *error) {
  return aspi_map_read(NULL, aspi_word_or_empty(path), &reader->options, &reader->report, error);
}

asp_code asp_reader_check(const asp_reader *reader, asp_error *error) {
  return *reader->report.warnings ? aspi_fail(error, ASP_EDATA, "%s", reader->report.warnings)
                                  : ASP_OK;
}

const char *asp_reader_text(const asp_reader *reader) {
  return reader->report.text;
}
