/* The reader of measured profiles and maps, set and asked by name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "asperity_internal.h"
#include "readers/read.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>
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

typedef enum kind { NUMBER, WHOLE, FLAG } kind;

/* The options by name: the type and place of a member, and its range. */
#define AT(member) offsetof(aspi_profile_options, member)
static const struct option {
  const char *name;
  kind kind;
  size_t at;
  double least, most;
} options[] = {{"unit_x", NUMBER, AT(unit_x), 0, INFINITY},
               {"unit_z", NUMBER, AT(unit_z), 0, INFINITY},
               {"meter", NUMBER, AT(meter), 1e-12, 1e12},
               {"form", WHOLE, AT(form), -1, ASP_FORM_MAX},
               {"spikes", NUMBER, AT(spikes), 0, INFINITY},
               {"fill", FLAG, AT(fill), 0, 1},
               {"resample", FLAG, AT(resample), 0, 1},
               {"row", WHOLE, AT(row), 1, INT_MAX},
               {"column", WHOLE, AT(column), 0, INT_MAX},
               {"x_column", WHOLE, AT(x_number), 0, INT_MAX},
               {"step_x", NUMBER, AT(step[0]), 0, INFINITY},
               {"step_y", NUMBER, AT(step[1]), 0, INFINITY},
               {"missing", NUMBER, AT(missing), -INFINITY, INFINITY},
               {"tip", NUMBER, AT(filters.tip), 0, INFINITY},
               {"lambda_s", NUMBER, AT(filters.lambda_s), 0, INFINITY},
               {"cutoff", NUMBER, AT(filters.cutoff), 0, INFINITY}};

static const char *name_at(int index) {
  return options[index].name;
}

asp_code aspi_profile_options_set(aspi_profile_options *to, const char *name, double value,
                                  asp_error *error) {
  int i = aspi_find_name("option of a reader", name, (int)(sizeof options / sizeof *options),
                         name_at, error);
  if (i < 0)
    return ASP_ENAME;
  const struct option *o = &options[i];
  void *member = (char *)to + o->at;
  bool is_missing = member == (void *)&to->missing;
  if (is_missing && isnan(value)) {
    to->has_missing = false;
    return ASP_OK;
  }
  if (aspi_check_range(error, o->name, "", value, o->least, o->most))
    return ASP_EARG;
  if (o->kind != NUMBER && value > floor(value))
    return aspi_fail(error, ASP_EARG, "%s is %g; it must be a whole number", o->name, value);
  if (o->kind == NUMBER)
    *(double *)member = value;
  else if (o->kind == WHOLE)
    *(int *)member = (int)value;
  else
    *(bool *)member = value > 0;
  to->has_missing = to->has_missing || is_missing;
  return ASP_OK;
}

asp_code asp_reader_set(asp_reader *reader, const char *name, double value, asp_error *error) {
  return aspi_profile_options_set(&reader->options, name, value, error);
}

asp_heights *asp_reader_read(asp_reader *reader, const char *path, bool is_map, asp_error *error) {
  return aspi_read(NULL, aspi_word_or_empty(path), is_map, &reader->options, &reader->report,
                   error);
}

const char *asp_reader_advice(const char *message) {
  return strstr(message, "reader: ")
             ? "; the command 'asperity surface' does so, and saves the file"
             : "";
}

asp_code asp_reader_check(const asp_reader *reader, asp_error *error) {
  return *reader->report.warnings ? aspi_fail(error, ASP_EDATA, "%s", reader->report.warnings)
                                  : ASP_OK;
}

const char *asp_reader_text(const asp_reader *reader) {
  return reader->report.text;
}
