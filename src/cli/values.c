/* Values of options: words, numbers with units, lists; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/number.h"
#include "base/quantity.h"
#include "cli/cli.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A longer length (m) without a unit is more likely one whose unit was forgotten. */
#define LENGTH_WITHOUT_UNIT 1e-3

/* And so is a lower stress (Pa). */
#define STRESS_WITHOUT_UNIT 1e6

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

static const asp_units si = {"SI", 1, 1, 1};

/* One number that may have a unit of its kind behind it. */
static double read_one(const cli_option *option, const char *kind) {
  char name[80];
  double value;
  asp_error error;
  snprintf(name, sizeof name, "--%s", option->name);
  cli_must(!aspi_quantity_read(name, given(option), kind, &si, &value, &error), &error);
  return value;
}

double cli_quantity(const cli_option *option, const char *kind, double least, double most) {
  double value = read_one(option, kind);
  if (!(value >= least && value <= most) || !isfinite(value))
    cli_bad_usage("--%s is %s; it must be %g to %g", option->name, option->value, least, most);
  return value;
}

double cli_number(const cli_option *option, double least, double most) {
  return cli_quantity(option, "", least, most);
}

unsigned long cli_whole(const cli_option *option, unsigned long least, unsigned long most) {
  const char *text = given(option);
  char *end;
  errno = 0;
  unsigned long value = strtoul(text, &end, 10);
  bool bad = end == text || *text == '-' || errno == ERANGE;
  if (!bad && *end) { /* 1e6, 2.5e3: doubles hold whole numbers up to 2^53 */
    double number = aspi_number(text, &end);
    bad = *end || !(number >= 0 && number <= 0x1p53) || number != floor(number);
    value = bad ? 0 : (unsigned long)number;
  }
  if (bad || value < least || value > most)
    cli_bad_usage("--%s is '%s'; it must be a whole number, %lu to %lu", option->name, text, least,
                  most);
  return value;
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

void cli_check_unit(const char *name, const char *list, const char *kind) {
  bool stress = strcmp(kind, "stress") == 0;
  const char *unit = stress ? "Pa" : "m", *usual = stress ? "MPa" : "um";
  for (const char *at = list; *at;) {
    char *end;
    int length = (int)strcspn(at, ",:");
    double value = aspi_number(at, &end);
    bool odd = stress ? value > 0 && value < STRESS_WITHOUT_UNIT : value > LENGTH_WITHOUT_UNIT;
    if (odd && end == at + length)
      cli_bad_usage("%s is '%s' without a unit; '%.*s' would be %g %s: say %.*s%s, or %.*s%s", name,
                    list, length, at, value, unit, length, at, unit, length, at, usual);
    at += length + (at[length] != '\0');
  }
}

static void check_option_unit(const cli_option *option) {
  char name[64];
  snprintf(name, sizeof name, "--%s", option->name);
  cli_check_unit(name, option->value, "length");
}

double cli_length(const cli_option *option) {
  double value = read_one(option, "length");
  if (!(value > 0) || !isfinite(value))
    cli_bad_usage("--%s is '%s'; it must be a length > 0", option->name, option->value);
  check_option_unit(option);
  return value;
}

cli_list cli_values(const cli_option *option, const char *kind, double least, double most) {
  char name[80];
  cli_list list;
  asp_error error;
  snprintf(name, sizeof name, "--%s", option->name);
  cli_must(!aspi_list_read(name, given(option), kind, &si, least, most, &list, &error), &error);
  if (strcmp(kind, "length") == 0 && !(list.least > 0))
    cli_bad_usage("--%s is '%s'; all of it must be > 0", option->name, option->value);
  if (strcmp(kind, "length") == 0)
    check_option_unit(option);
  return list;
}

static cli_list without_law(const cli_option *option, const char *kind, double least, double most) {
  cli_list list = cli_values(option, kind, least, most);
  if (list.count == 0)
    cli_bad_usage("--%s is '%s', a log-normal law; it must be a list: a,b,c or from:to:step",
                  option->name, option->value);
  return list;
}

cli_list cli_numbers(const cli_option *option, double least, double most) {
  return without_law(option, "", least, most);
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
  cli_list list = cli_numbers(option, least, most);
  if (list.count > n)
    cli_bad_usage("--%s is '%s'; it must be %s", option->name, option->value, option->argument);
  memcpy(values, list.values, list.count * sizeof *values);
  return list.count;
}
