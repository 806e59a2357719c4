/* Values of options: words, numbers with units, lists; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/number.h"
#include "base/units.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "cli/cli.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <string.h>

/* A longer length (m) without a unit is more likely one whose unit was forgotten. */
#define LENGTH_WITHOUT_UNIT 1e-3

/* And so is a lower stress (Pa). */
#define STRESS_WITHOUT_UNIT 1e6

/* A range with more steps is refused as a typing error. */
#define STEPS_MOST 1e6

#define LAW "lognormal:"

const cli_option *cli_get(const cli_call *call, const char *name) {
  for (const cli_option *o = call->options; o->name; o++)
    if (strcmp(o->name, name) == 0)
      return o;
  return NULL;
}

const char *cli_value(const cli_call *call, const char *name) {
  const cli_option *option = cli_get(call, name);
  return option ? option->value : NULL;
}

void cli_default(cli_call *call, const char *name, const char *value) {
  cli_option *option = (cli_option *)cli_get(call, name);
  option->value = option->value ? option->value : value;
}

bool cli_is_set(const cli_call *call, const char *name) {
  const cli_option *option = cli_get(call, name);
  return option->value != call->command->options[option - call->options].value;
}

static const char *given(const cli_option *option) {
  if (!option->value)
    cli_bad_usage("--%s %s is missing (%s)", option->name, option->argument, option->help);
  return option->value;
}

void cli_check_unit(const char *name, const char *text, const char *kind) {
  bool stress = strcmp(kind, "stress") == 0;
  const char *unit = stress ? "Pa" : "m";
  const char *usual = strcmp(name, "oka") == 0 ? "GPa" : stress ? "MPa" : "um"; /* a hardness */
  char *end;
  double value = aspi_number(text, &end);
  bool odd = stress ? value > 0 && value < STRESS_WITHOUT_UNIT : value > LENGTH_WITHOUT_UNIT;
  if (odd && !*end)
    cli_bad_usage("%s is '%s', i.e. %g %s; did you mean %s%s? (or %s%s)", name, text, value, unit,
                  text, usual, text, unit);
}

/* A number of an option, which may have a unit of its kind behind it; a length is more than
 * `least`. */
static double read_number(const cli_option *option, const char *text, const char *kind,
                          double least, double most) {
  bool is_length = strcmp(kind, "length") == 0;
  char name[80];
  double value;
  snprintf(name, sizeof name, "--%s", option->name);
  cli_must(!aspi_quantity_read(name, text, kind, &aspi_si, &value, &cli_error) &&
           !aspi_quantity_check(name, text, kind, value, least, most, is_length, &cli_error));
  if (is_length)
    cli_check_unit(name, text, kind);
  return value;
}

double cli_quantity(const cli_option *option, const char *kind, double least, double most) {
  return read_number(option, given(option), kind, least, most);
}

double cli_number(const cli_option *option, double least, double most) {
  return cli_quantity(option, "", least, most);
}

double cli_length(const cli_option *option) {
  return cli_quantity(option, "length", 0, INFINITY);
}

unsigned long cli_whole(const cli_option *option, unsigned long least, unsigned long most) {
  char *end;
  const char *text = given(option);
  double value = aspi_number(text, &end); /* exact up to 2^53 */
  if (end == text || *end || !(value >= (double)least && value <= (double)most) ||
      value > floor(value))
    cli_bad_usage("--%s is '%s'; it must be a whole number, %lu to %lu", option->name, text, least,
                  most);
  return (unsigned long)value;
}

int cli_choice(const cli_option *option) {
  char list[80] = "";
  int index = 0;
  for (const char *word = option->argument; *word; index++) {
    size_t length = strcspn(word, "|");
    if (strlen(option->value) == length && strncmp(option->value, word, length) == 0)
      return index;
    aspi_append(list, sizeof list, "%s%.*s",
                index == 0     ? ""
                : word[length] ? ", "
                               : " or ",
                (int)length, word);
    word += length + (word[length] == '|');
  }
  cli_bad_usage("--%s is '%s'; it must be %s", option->name, option->value, list);
}

static _Noreturn void fail_form(const cli_option *option, const char *why) {
  cli_bad_usage("--%s is '%.100s'; %s: a list is a,b,c or from:to:step, a log-normal law "
                "lognormal:min:max:median",
                option->name, option->value, why);
}

/* Up to three numbers with colons between them; their count. A step may be less than a value. */
static int read_parts(const cli_option *option, char *text, const char *kind, double least,
                      double most, double values[3]) {
  char *part;
  int count = 0;
  for (; (part = aspi_text_field(&text, ':')) != NULL; count++) {
    if (count == 3)
      fail_form(option, "a range has three numbers");
    values[count] = read_number(option, part, kind, count < 2 ? least : 0, most);
  }
  return count;
}

static cli_list read_law(const cli_option *option, const char *kind, double least, double most) {
  double v[3];
  char *text = cli_copy(option->value + strlen(LAW));
  if (read_parts(option, text, kind, least, most, v) != 3 ||
      !(v[0] > 0 && v[0] < v[2] && v[2] < v[1]))
    fail_form(option, "a log-normal law has 0 < min < median < max");
  return (cli_list){.least = v[0], .most = v[1], .median = v[2]};
}

cli_list cli_values(const cli_option *option, const char *kind, double least, double most) {
  if (strncmp(given(option), LAW, strlen(LAW)) == 0)
    return read_law(option, kind, least, most);
  cli_list list = {.count = 0};
  char *text = cli_copy(option->value), *item;
  while ((item = aspi_text_field(&text, ',')) != NULL) {
    double v[3] = {0, 0, 0};
    int parts = read_parts(option, item, kind, least, most, v);
    double steps = parts == 1 ? 0 : floor((v[1] - v[0]) / v[2] + ASPI_ROUNDING_TEXT);
    if (parts == 2 || !(v[2] > 0 || parts == 1) || !(steps >= 0 && steps <= STEPS_MOST))
      fail_form(option, "a range has from <= to, a step > 0, and at most 1e6 steps");
    for (size_t i = 0; i <= (size_t)steps; i++) {
      list.values = cli_grow(list.values, list.count, sizeof *list.values);
      list.values[list.count++] = parts == 1 ? v[0] : fmin(v[0] + (double)i * v[2], v[1]);
    }
  }
  gsl_stats_minmax(&list.least, &list.most, list.values, 1, list.count);
  return list;
}

static cli_list without_law(const cli_option *option, const char *kind, double least, double most) {
  cli_list list = cli_values(option, kind, least, most);
  if (list.count == 0)
    cli_bad_usage("--%s is '%s', a log-normal law; it must be a list: a,b,c or from:to:step",
                  option->name, option->value);
  return list;
}

cli_list cli_lengths(const cli_option *option) {
  return without_law(option, "length", 0, INFINITY);
}

cli_list cli_angles(const cli_option *option) {
  return without_law(option, "degrees", 0, 90);
}

cli_list cli_impact_angles(const cli_call *call) {
  cli_list angles = cli_angles(cli_get(call, "angles"));
  if (!(angles.least > 0))
    cli_bad_usage("--angles is '%s'; it must be more than 0 and at most 90",
                  cli_value(call, "angles"));
  return angles;
}

size_t cli_few(const cli_option *option, double least, double most, size_t n, double *values) {
  cli_list list = without_law(option, "", least, most);
  if (list.count > n)
    cli_bad_usage("--%s is '%s'; it must be %s", option->name, option->value, option->argument);
  memcpy(values, list.values, list.count * sizeof *values);
  return list.count;
}
