/* Options, numbers with units, output and progress of the `asperity` command; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/help.h"
#include "base/number.h"
#include "base/units.h"

#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { OPTIONS_MAX = 48 };

/* A longer length (m) without a unit is more likely one whose unit was forgotten. */
#define LENGTH_WITHOUT_UNIT 1e-3

double cli_degrees(double radians) {
  return radians * (180 / ASP_PI);
}

double cli_radians(double degrees) {
  return degrees * (ASP_PI / 180);
}

static void say(const char *format, va_list args) {
  fputs("asperity: ", stderr);
  vfprintf(stderr, format, args);
  fputc('\n', stderr);
}

void cli_bad_usage(const char *format, ...) {
  va_list args;
  va_start(args, format);
  say(format, args);
  va_end(args);
  exit(2);
}

void cli_fail(const char *format, ...) {
  va_list args;
  va_start(args, format);
  say(format, args);
  va_end(args);
  exit(1);
}

void *cli_allocate(size_t count, size_t size) {
  void *memory = calloc(count ? count : 1, size);
  if (!memory)
    cli_fail("out of memory for %zu numbers or rows of %zu bytes", count, size);
  return memory;
}

char *cli_copy(const char *text) {
  return strcpy(cli_allocate(strlen(text) + 1, 1), text);
}

void cli_bad_file(const cli_option *option, const asp_error *error) {
  bool unreadable = error->code == ASP_EFILE || error->code == ASP_ENOMEM;
  fputs("asperity: ", stderr);
  if (option)
    fprintf(stderr, "--%s: ", option->name);
  fprintf(stderr, "%s\n", error->text);
  exit(unreadable ? 1 : 2);
}

void cli_warn(const char *format, ...) {
  va_list args;
  va_start(args, format);
  fputs("asperity: warning: ", stderr);
  vfprintf(stderr, format, args);
  fputc('\n', stderr);
  va_end(args);
}

static int count_options(const cli_option *options) {
  int count = 0;
  while (options[count].name)
    count++;
  return count;
}

/* Exits where a file that is to be written cannot be, or two are to be the same. */
static void check_files(const cli_option *options, int count) {
  static const char *const written[] = {"output", "save", "plot"};
  const cli_option *given[3] = {NULL, NULL, NULL};
  for (int i = 0; i < count; i++)
    for (int k = 0; k < 3; k++)
      if (strcmp(options[i].name, written[k]) == 0 && options[i].value)
        given[k] = &options[i];
  for (int k = 0; k < 3; k++)
    for (int m = 0; m < k; m++)
      if (given[k] && given[m] && strcmp(given[k]->value, given[m]->value) == 0 &&
          strncmp(given[k]->value, "/dev/", 5) != 0)
        cli_bad_usage("--%s and --%s are both '%s'", given[m]->name, given[k]->name,
                      given[k]->value);
  for (int k = 0; k < 2; k++)
    if (given[k] && strcmp(given[k]->value, "-") != 0)
      cli_file_check(given[k]->value);
  if (given[2])
    cli_plot_check(given[2]);
}

/* The word that getopt has just refused. It is still to come where it has more letters than the
 * one behind a single dash that getopt looked at. */
static const char *unknown_word(int argc, char **argv) {
  const char alone[] = {'-', (char)optopt, '\0'};
  bool done = optopt == 0 || optind >= argc || strcmp(argv[optind - 1], alone) == 0;
  return argv[done ? optind - 1 : optind];
}

int cli_parse(const cli_command *command, int argc, char **argv, cli_option *options,
              bool arguments) {
  struct option table[OPTIONS_MAX + 2] = {{0}};
  int count = count_options(options);
  for (int i = 0; i < count; i++)
    table[i] = (struct option){options[i].name,
                               options[i].argument ? required_argument : no_argument, NULL, i};
  table[count] = (struct option){"help", optional_argument, NULL, OPTIONS_MAX};
  opterr = 0;
  optind = 1;
  for (int found; (found = getopt_long(argc, argv, ":o:h", table, NULL)) != -1;) {
    if (found == OPTIONS_MAX || found == 'h') {
      cli_help_command(command, options, found == 'h' ? NULL : optarg);
      exit(0);
    }
    if (found == ':')
      cli_bad_usage("%s: option '%s' needs a value", command->name, argv[optind - 1]);
    if (found == '?')
      cli_bad_usage("%s: option '%s' is unknown; options begin with --; see 'asperity %s --help'",
                    command->name, unknown_word(argc, argv), command->name);
    if (found == 'o') {
      found = 0;
      while (found < count && strcmp(options[found].name, "output") != 0)
        found++;
      if (found == count)
        cli_bad_usage("%s: option '-o' is unknown; see 'asperity %s --help'", command->name,
                      command->name);
    }
    options[found].value = options[found].argument ? optarg : "";
  }
  check_files(options, count);
  if (!arguments && optind < argc)
    cli_bad_usage("%s: argument '%s' is not expected; options begin with --", command->name,
                  argv[optind]);
  return optind;
}

static const char *given(const cli_option *option) {
  if (!option->value)
    cli_bad_usage("--%s %s is missing (%s)", option->name, option->argument, option->help);
  return option->value;
}

static double number_of(const cli_option *option, const char *text, double least, double most) {
  char *end;
  double value = aspi_number(text, &end);
  if (end == text || *end)
    cli_bad_usage("--%s is '%s'; a number is expected", option->name, text);
  if (!(value >= least && value <= most) || !isfinite(value))
    cli_bad_usage("--%s is %s; it must be %g to %g", option->name, text, least, most);
  return value;
}

double cli_number(const cli_option *option, double least, double most) {
  return number_of(option, given(option), least, most);
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

int cli_choice(const cli_option *option, const char *first, const char *second) {
  if (strcmp(option->value, first) == 0)
    return 0;
  if (strcmp(option->value, second) == 0)
    return 1;
  cli_bad_usage("--%s is '%s'; it must be %s or %s", option->name, option->value, first, second);
}

double cli_length_of(const cli_option *option, const char *text) {
  char *end;
  double value = aspi_number(text, &end);
  if (end == text)
    cli_bad_usage("--%s is '%s'; a length such as 5um is expected", option->name, text);
  double unit = *end ? aspi_unit_metres(end, strlen(end)) : 1;
  if (!(unit > 0))
    cli_bad_usage("--%s is '%s'; units of length are m cm mm um nm, and no unit means m",
                  option->name, text);
  if (!(value > 0) || !isfinite(value))
    cli_bad_usage("--%s is '%s'; it must be a length > 0", option->name, text);
  if (!*end && value > LENGTH_WITHOUT_UNIT)
    cli_bad_usage("--%s is '%s' without a unit; that would be %g m: say %sm, or %sum", option->name,
                  text, value, text, text);
  return value * unit;
}

static void append(cli_list *list, double value) {
  double *grown = realloc(list->values, (list->count + 1) * sizeof *grown);
  if (!grown)
    cli_fail("out of memory");
  list->values = grown;
  list->values[list->count++] = value;
}

typedef double (*reader)(const cli_option *option, const char *text, double least, double most);

static double read_length(const cli_option *option, const char *text, double least, double most) {
  (void)least;
  (void)most;
  return cli_length_of(option, text);
}

/* Appends from:to:step, both ends included. */
static void append_range(cli_list *list, const cli_option *option, char *text, reader read,
                         double least, double most) {
  char *second = strchr(text, ':'), *third = strchr(second + 1, ':');
  if (!third || strchr(third + 1, ':'))
    cli_bad_usage("--%s is '%s'; a range is from:to:step", option->name, given(option));
  *second = *third = '\0';
  double from = read(option, text, least, most), to = read(option, second + 1, least, most);
  double step = read(option, third + 1, 0, INFINITY), steps = floor((to - from) / step + 1e-9);
  if (!(step > 0) || to < from || steps > 1e6)
    cli_bad_usage(
        "--%s is '%s'; a range from:to:step has to >= from, step > 0 and at most 1e6 steps",
        option->name, given(option));
  for (double i = 0; i <= steps; i++)
    append(list, from + i * step);
}

/* Numbers and ranges, separated by commas. */
static cli_list list_of(const cli_option *option, reader read, double least, double most) {
  char *text = cli_copy(given(option));
  cli_list list = {NULL, 0};
  for (char *rest = text, *item; rest;) {
    item = rest;
    rest = strchr(rest, ',');
    if (rest)
      *rest++ = '\0';
    if (strchr(item, ':'))
      append_range(&list, option, item, read, least, most);
    else
      append(&list, read(option, item, least, most));
  }
  free(text);
  return list;
}

double cli_length(const cli_option *option) {
  return cli_length_of(option, given(option));
}

cli_list cli_numbers(const cli_option *option, double least, double most) {
  return list_of(option, number_of, least, most);
}

cli_list cli_lengths(const cli_option *option) {
  return list_of(option, read_length, 0, INFINITY);
}

cli_list cli_angles(const cli_option *option) {
  return list_of(option, number_of, 0, 90);
}

double cli_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

cli_progress cli_progress_begin(const char *what, double total) {
  double now = cli_seconds();
  return (cli_progress){what, total, now, isatty(STDERR_FILENO) ? now : INFINITY};
}

void cli_progress_show(cli_progress *progress, double done) {
  double now = cli_seconds();
  if (now - progress->begun < 1 || now - progress->shown < 0.1)
    return;
  enum { WIDTH = 40 };
  int filled = (int)(WIDTH * fmin(1, done / progress->total));
  fprintf(stderr, "\r%s [%.*s%*s] %3.0f %%", progress->what, filled,
          "########################################", WIDTH - filled, "",
          100 * fmin(1, done / progress->total));
  progress->shown = now;
}

void cli_progress_end(cli_progress *progress) {
  if (isfinite(progress->shown) && progress->shown > progress->begun)
    fprintf(stderr, "\r%*s\r", (int)strlen(progress->what) + 50, "");
}
