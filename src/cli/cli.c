/* Options, numbers with units, output and progress of the `asperity` command; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/help.h"
#include "base/number.h"
#include "base/quantity.h"

#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

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

void cli_must(bool good, const asp_error *error) {
  if (good)
    return;
  fprintf(stderr, "asperity: %s\n", error->text);
  exit(error->code == ASP_ENOMEM ? 1 : 2);
}

void cli_say(const char *format, ...) {
  va_list args;
  va_start(args, format);
  say(format, args);
  va_end(args);
}

void cli_warn(const char *format, ...) {
  va_list args;
  va_start(args, format);
  fputs("asperity: warning: ", stderr);
  vfprintf(stderr, format, args);
  fputc('\n', stderr);
  va_end(args);
}

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

/* A table goes to no file whose name promises an array. */
static void check_written(const cli_option *option) {
  const char *ending = strrchr(option->value, '.');
  if (ending && strcasecmp(ending, ".npy") == 0)
    cli_bad_usage("--%s is '%s'; it is written as CSV, which numpy.genfromtxt reads: end the name "
                  "in .csv",
                  option->name, option->value);
  cli_file_check(option->value);
}

/* The options whose files are written. */
enum { N_WRITTEN = 3 };
static const char *const written[N_WRITTEN] = {"output", "save", "plot"};

static bool is_file(const char *path, const struct stat *file) {
  struct stat found;
  return path && stat(path, &found) == 0 && found.st_dev == file->st_dev &&
         found.st_ino == file->st_ino;
}

/* Exits where an option would replace a file that is read: an argument, or that of --materials. */
static void keep_inputs(const cli_call *call) {
  for (int k = 0; k < N_WRITTEN; k++) {
    const char *path = cli_value(call, written[k]);
    struct stat file;
    if (!path || stat(path, &file) != 0 || !S_ISREG(file.st_mode))
      continue;
    bool is_read = is_file(cli_value(call, "materials"), &file);
    for (int i = 0; i < call->n_words; i++)
      is_read = is_read || is_file(call->words[i], &file);
    if (is_read)
      cli_bad_usage("--%s is '%s', which is read; it must be another file", written[k], path);
  }
}

/* Exits where a file that is to be written cannot be, or two are to be the same. */
static void check_files(const cli_call *call) {
  static const char *const look[] = {"title", "size", "range"};
  for (int k = 0; k < N_WRITTEN; k++) {
    const char *path = cli_value(call, written[k]);
    for (int m = 0; m < k && path && strncmp(path, "/dev/", 5) != 0; m++) {
      const char *other = cli_value(call, written[m]);
      if (other && strcmp(path, other) == 0)
        cli_bad_usage("--%s and --%s are both '%s'", written[m], written[k], path);
    }
  }
  for (int k = 0; k < 2; k++)
    if (cli_value(call, written[k]) && strcmp(cli_value(call, written[k]), "-") != 0)
      check_written(cli_get(call, written[k]));
  if (cli_value(call, "plot"))
    cli_plot_check(call);
  for (int k = 0; k < 3 && !cli_value(call, "plot"); k++)
    if (cli_value(call, look[k]))
      cli_bad_usage("--%s is given without --plot", look[k]);
}

/* The word that getopt has just refused. getopt may have refused one letter of a longer word; then
 * the word is still the next one. */
static const char *unknown_word(int argc, char **argv) {
  const char alone[] = {'-', (char)optopt, '\0'};
  bool done = optopt == 0 || optind >= argc || strcmp(argv[optind - 1], alone) == 0;
  return argv[done ? optind - 1 : optind];
}

/* The options of a command: its own, and those of all. */
static void list_options(cli_call *call) {
  const cli_option common[] = {
      {"output", "FILE", "write to FILE instead of the screen", NULL},
      {"plot", "FILE", call->command->picture, NULL},
      {"title", "TEXT", "title of the picture", NULL},
      {"size", "WIDTHxHEIGHT", "size of the picture, in pixels", NULL},
      {"range", "FROM:TO", "range of the vertical axis", NULL},
  };
  cli_option *to = call->options;
  for (const cli_option *own = call->command->options; own->name; own++)
    *to++ = *own;
  for (int i = 0; i < (call->command->picture ? 5 : 1); i++)
    *to++ = common[i];
}

/* The option that getopt found, or failed at. */
static cli_option *take_option(cli_call *call, int argc, char **argv, int found) {
  const char *name = call->command->name;
  if (found == CLI_OPTIONS_MOST || found == 'h') {
    cli_help_command(call->command, call->options, found == 'h' ? NULL : optarg);
    exit(0);
  }
  if (found == ':')
    cli_bad_usage("%s: option '%s' needs a value", name, argv[optind - 1]);
  if (found == '?' && optopt > 0 && optopt < CLI_OPTIONS_MOST)
    cli_bad_usage("%s: option '--%s' takes no value", name, call->options[optopt].name);
  if (found == '?')
    cli_bad_usage("%s: option '%s' is unknown; options begin with --; see 'asperity %s --help'",
                  name, unknown_word(argc, argv), name);
  return found == 'o' ? (cli_option *)cli_get(call, "output") : &call->options[found];
}

static void read_options(cli_call *call, int argc, char **argv) {
  struct option table[CLI_OPTIONS_MOST + 2] = {{0}};
  int count = 0;
  for (const cli_option *o = call->options; o->name; o++, count++)
    table[count] =
        (struct option){o->name, o->argument ? required_argument : no_argument, NULL, count};
  table[count] = (struct option){"help", optional_argument, NULL, CLI_OPTIONS_MOST};
  opterr = 0;
  optind = 1;
  for (int found; (found = getopt_long(argc, argv, ":o:h", table, NULL)) != -1;) {
    cli_option *option = take_option(call, argc, argv, found);
    option->value = option->argument ? optarg : "";
  }
}

/* Number of words before the first option; `-0.5` is a number and no option. */
static int count_words(int argc, char **argv) {
  int count = 1;
  while (count < argc && !(argv[count][0] == '-' &&
                           (isalpha((unsigned char)argv[count][1]) || argv[count][1] == '-')))
    count++;
  return count - 1;
}

cli_call cli_parse(const cli_command *command, int argc, char **argv) {
  bool before = command->arguments && !command->takes_files;
  cli_call call = {.command = command,
                   .argc = argc,
                   .argv = argv,
                   .n_words = before ? count_words(argc, argv) : 0,
                   .words = argv + 1};
  char **rest = argv + call.n_words;
  argc -= call.n_words;
  list_options(&call);
  read_options(&call, argc, rest);
  check_files(&call);
  if (command->takes_files) {
    call.words = argv + optind;
    call.n_words = argc - optind;
  } else if (optind < argc) {
    cli_bad_usage("%s: argument '%s' is not expected behind an option; options begin with --, and "
                  "the words that describe a wall stand before them",
                  command->name, rest[optind]);
  }
  keep_inputs(&call);
  return call;
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
    size_t length = strcspn(word, "|"), used = strlen(list);
    if (strlen(option->value) == length && strncmp(option->value, word, length) == 0)
      return index;
    snprintf(list + used, sizeof list - used, "%s%.*s",
             index == 0     ? ""
             : word[length] ? ", "
                            : " or ",
             (int)length, word);
    word += length + (word[length] == '|');
  }
  cli_bad_usage("--%s is '%s'; it must be %s", option->name, option->value, list);
}

void cli_check_unit(const char *name, const char *list) {
  for (const char *at = list; *at;) {
    char *end;
    int length = (int)strcspn(at, ",:");
    double value = aspi_number(at, &end);
    if (value > LENGTH_WITHOUT_UNIT && end == at + length)
      cli_bad_usage("%s is '%s' without a unit; '%.*s' would be %g m: say %.*sm, or %.*sum", name,
                    list, length, at, value, length, at, length, at);
    at += length + (at[length] != '\0');
  }
}

static void check_option_unit(const cli_option *option) {
  char name[64];
  snprintf(name, sizeof name, "--%s", option->name);
  cli_check_unit(name, option->value);
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

cli_list cli_speeds(const cli_option *option, double least, double most) {
  return without_law(option, "speed", least, most);
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

/* Seconds on a monotonic clock. */
static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

cli_progress cli_progress_begin(const char *what, double total) {
  double now = seconds();
  return (cli_progress){what, total, now, isatty(STDERR_FILENO) ? now : INFINITY};
}

void cli_progress_show(void *of, double done) {
  cli_progress *progress = of;
  double now = seconds();
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
