/* Lists of numbers; see list.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/list.h"
#include "base/error.h"
#include "base/number.h"
#include "base/quantity.h"
#include "base/tolerances.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LAW "lognormal:"

/* A range with more steps is taken for a typing error. */
#define STEPS_MOST 1e6

enum { WORD_MOST = 80 };

typedef struct reader {
  const char *name, *text, *kind; /* the text of the whole list */
  const asp_units *units;
  double least, most;
  asp_error *error;
} reader;

static asp_code fail_form(const reader *r, const char *why) {
  return aspi_fail(r->error, ASP_EARG,
                   "%s is '%.100s'; %s: a list is a,b,c or from:to:step, a log-normal law "
                   "lognormal:min:max:median",
                   r->name, r->text, why);
}

/* Reads the number in the first `length` characters. A step is not checked against the list's
 * limits. */
static asp_code read_one(const reader *r, const char *text, size_t length, bool is_step,
                         double *value) {
  char word[WORD_MOST];
  if (length == 0 || length >= sizeof word)
    return fail_form(r, length == 0 ? "a number is missing" : "a number is too long");
  memcpy(word, text, length);
  word[length] = '\0';
  char *end;
  aspi_number(word, &end);
  if (end > word && *end == '-')
    return fail_form(r, "a range has colons");
  asp_code code = aspi_quantity_read(r->name, word, r->kind, r->units, value, r->error);
  return code || is_step ? code
                         : aspi_quantity_check(r->name, word, r->kind, *value, r->least, r->most,
                                               false, r->error);
}

/* Reads up to three numbers with colons between them, up to a comma or the end; *count is their
 * number. */
static asp_code read_item(const reader *r, const char **at, double values[3], int *count) {
  asp_code code = ASP_OK;
  for (*count = 0; !code; (*at)++) {
    size_t length = strcspn(*at, ":,");
    if (*count == 3)
      return fail_form(r, "a range has three numbers");
    code = read_one(r, *at, length, *count == 2, &values[*count]);
    *at += length;
    (*count)++;
    if (**at != ':')
      break;
  }
  return code;
}

static asp_code append(const reader *r, aspi_list *list, double from, double step, size_t count) {
  double *grown = realloc(list->values, (list->count + count) * sizeof *grown);
  if (!grown)
    return aspi_fail(r->error, ASP_ENOMEM, "out of memory for the list %s", r->name);
  list->values = grown;
  for (size_t i = 0; i < count; i++)
    list->values[list->count++] = from + (double)i * step;
  return ASP_OK;
}

static asp_code append_range(const reader *r, aspi_list *list, const double range[3]) {
  double steps = floor((range[1] - range[0]) / range[2] + ASPI_ROUNDING_TEXT);
  if (!(range[2] > 0) || !(range[1] >= range[0]) || !(steps <= STEPS_MOST))
    return fail_form(r, "a range has from <= to, a step > 0, and at most 1e6 steps");
  return append(r, list, range[0], range[2], (size_t)steps + 1);
}

static asp_code read_values(const reader *r, aspi_list *list) {
  const char *at = r->text;
  asp_code code = ASP_OK;
  for (bool more = true; more && !code; at++) {
    double values[3];
    int count;
    code = read_item(r, &at, values, &count);
    if (code)
      return code;
    code = count == 1   ? append(r, list, values[0], 0, 1)
           : count == 3 ? append_range(r, list, values)
                        : fail_form(r, "a range has three numbers");
    more = *at == ',';
  }
  if (code)
    return code;
  list->least = list->most = list->values[0];
  for (size_t i = 1; i < list->count; i++) {
    list->least = fmin(list->least, list->values[i]);
    list->most = fmax(list->most, list->values[i]);
  }
  return ASP_OK;
}

static asp_code read_law(const reader *r, aspi_list *list) {
  double *const to[3] = {&list->least, &list->most, &list->median};
  const char *at = r->text + strlen(LAW);
  for (int i = 0; i < 3; i++) {
    size_t length = strcspn(at, ":");
    asp_code code = read_one(r, at, length, false, to[i]);
    if (code)
      return code;
    at += length;
    if ((*at == ':') != (i < 2))
      return fail_form(r, "a log-normal law has three numbers");
    at += i < 2;
  }
  return list->least > 0 && list->least < list->median && list->median < list->most
             ? ASP_OK
             : fail_form(r, "a log-normal law has 0 < min < median < max");
}

asp_code aspi_list_read(const char *name, const char *text, const char *kind,
                        const asp_units *units, double least, double most, aspi_list *list,
                        asp_error *error) {
  const reader r = {name, text, kind, units, least, most, error};
  *list = (aspi_list){.values = NULL};
  asp_code code = strncmp(text, LAW, strlen(LAW)) == 0 ? read_law(&r, list) : read_values(&r, list);
  if (code)
    aspi_list_free(list);
  return code;
}

void aspi_list_free(aspi_list *list) {
  free(list->values);
  *list = (aspi_list){.values = NULL};
}
