/* Reads a command line of the `asperity` command: its options, words and files; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "cli/cli.h"
#include "description/description.h"

#include <ctype.h>
#include <getopt.h>
#include <libgen.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* The options whose files are written. */
enum { N_WRITTEN = 3 };
static const char *const written[N_WRITTEN] = {"output", "save", "plot"};

static bool is_file(const char *path, const struct stat *file) {
  struct stat found;
  return stat(path, &found) == 0 && found.st_dev == file->st_dev && found.st_ino == file->st_ino;
}

static const char *name_of(const char *path) {
  const char *slash = strrchr(path, '/');
  return slash ? slash + 1 : path;
}

/* True for one name in one folder: a link to a file is replaced, not followed. */
static bool is_same(const char *path, const char *other) {
  char *folder = cli_copy(path), *others = cli_copy(other);
  struct stat found;
  bool same = strcmp(name_of(path), name_of(other)) == 0 && stat(dirname(folder), &found) == 0 &&
              is_file(dirname(others), &found);
  free(folder);
  free(others);
  return same;
}

/* Exits if an option would overwrite an input file. */
static void keep_inputs(const cli_call *call) {
  for (int k = 0; k < N_WRITTEN; k++) {
    const char *path = cli_value(call, written[k]);
    struct stat file;
    if (!path || stat(path, &file) != 0 || !S_ISREG(file.st_mode))
      continue;
    for (int i = 0; i < call->n_words; i++)
      if (is_file(call->words[i], &file))
        cli_bad_usage("--%s is '%s', which is read; it must be another file", written[k], path);
  }
}

/* Exits if an output file cannot be written, or two outputs are the same file. */
static void check_files(const cli_call *call) {
  for (int k = 0; k < N_WRITTEN; k++) {
    const char *path = cli_value(call, written[k]);
    for (int m = 0; m < k && path && strncmp(path, "/dev/", 5) != 0; m++) {
      const char *other = cli_value(call, written[m]);
      if (other && is_same(path, other))
        cli_bad_usage("--%s and --%s are both '%s'", written[m], written[k], path);
    }
  }
  for (int k = 0; k < 2; k++)
    if (cli_value(call, written[k]) && strcmp(cli_value(call, written[k]), "-") != 0)
      cli_file_check(cli_value(call, written[k]));
  if (cli_value(call, "plot"))
    cli_plot_check(call);
}

/* The word that getopt has just refused. getopt may have refused one letter of a longer word; then
 * the word is still the next one. */
static const char *unknown_word(int argc, char **argv) {
  const char alone[] = {'-', (char)optopt, '\0'};
  bool done = optopt == 0 || optind >= argc || strcmp(argv[optind - 1], alone) == 0;
  return argv[done ? optind - 1 : optind];
}

void cli_list_options(cli_call *call) {
  const cli_option common[] = {
      {"output", "FILE", "write to FILE instead of the screen", NULL},
      {"plot", "FILE", call->command->picture, NULL},
  };
  cli_option *to = call->options;
  for (const cli_option *own = call->command->options; own->name; own++)
    *to++ = *own;
  for (int i = 0; i < (call->command->picture ? 2 : 1); i++)
    *to++ = common[i];
}

/* A word of the description that was given as an option, or an option that is like it. */
static void fail_option(const cli_call *call, const char *given) {
  const char *name = call->command->name, *word = given + strspn(given, "-");
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    if (strcmp(k->name, word) == 0)
      cli_bad_usage("%s: '%s' is a word of the description, before all options: %s%s%s %s", name,
                    given, k->within, *k->within ? " " : "", word, k->values);
  char list[400] = "", near[64], meant[90] = "";
  for (const cli_option *o = call->options; o->name; o++)
    aspi_append(list, sizeof list, " %s", o->name);
  if (aspi_nearest_name(word, list, near))
    snprintf(meant, sizeof meant, "; did you mean '--%s'?", near);
  cli_bad_usage("%s: option '%s' is unknown%s; options begin with --; see 'asperity %s --help'",
                name, given, meant, name);
}

/* The option that getopt found, or failed at. */
static cli_option *take_option(cli_call *call, int argc, char **argv, int found) {
  const char *name = call->command->name;
  if (found == CLI_OPTIONS_MOST || found == 'h') {
    cli_help_command(call->command, call->options);
    cli_file_close(stdout);
    exit(0);
  }
  if (found == ':')
    cli_bad_usage("%s: option '%s' needs a value", name, argv[optind - 1]);
  if (found == '?' && optopt > 0 && optopt < CLI_OPTIONS_MOST)
    cli_bad_usage("%s: option '--%s' takes no value", name, call->options[optopt].name);
  if (found == '?')
    fail_option(call, unknown_word(argc, argv));
  return found == 'o' ? (cli_option *)cli_get(call, "output") : &call->options[found];
}

static void read_options(cli_call *call, int argc, char **argv) {
  struct option table[CLI_OPTIONS_MOST + 2] = {{0}};
  int count = 0;
  for (const cli_option *o = call->options; o->name; o++, count++)
    table[count] =
        (struct option){o->name, o->argument ? required_argument : no_argument, NULL, count};
  table[count] = (struct option){"help", no_argument, NULL, CLI_OPTIONS_MOST};
  opterr = 0;
  optind = 1;
  for (int found; (found = getopt_long(argc, argv, ":o:h", table, NULL)) != -1;) {
    cli_option *option = take_option(call, argc, argv, found);
    option->value = option->argument ? optarg : "";
  }
}

int cli_count_words(int argc, char **argv) {
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
                   .n_words = before ? cli_count_words(argc, argv) : 0,
                   .words = argv + 1};
  char **rest = argv + call.n_words;
  argc -= call.n_words;
  cli_list_options(&call);
  read_options(&call, argc, rest);
  check_files(&call);
  if (command->takes_files) {
    call.words = argv + optind;
    call.n_words = argc - optind;
  } else if (optind < argc && !command->arguments) {
    cli_bad_usage("asperity %s takes no arguments", command->name);
  } else if (optind < argc) {
    cli_bad_usage("%s: argument '%s' is not expected behind an option; options begin with --, and "
                  "the words that describe a wall stand before them",
                  command->name, rest[optind]);
  }
  keep_inputs(&call);
  return call;
}
