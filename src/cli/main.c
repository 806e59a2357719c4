/* The `asperity` command: a list of subcommands, one file each.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "base/error.h"

#include <gsl/gsl_errno.h>
#include <string.h>

static const cli_command *const commands[] = {
    &cli_surface,   &cli_spread,      &cli_cor,     &cli_compare,
    &cli_calibrate, &cli_map_command, &cli_erosion, &cli_sensitivity,
    &cli_trade,     &cli_materials,   NULL};

enum { COMMANDS = sizeof commands / sizeof *commands - 1 };

static const cli_command *find(const char *name) {
  int index = aspi_find_name("command", name, COMMANDS, commands, &cli_error);
  cli_must(index >= 0);
  return commands[index];
}

/* `asperity help` with words behind it. */
static void help(int count, char **words) {
  char *arguments[] = {words[0], "--help", NULL};
  if (strcmp(words[0], "--words") == 0)
    cli_complete(commands, count - 1, words + 1);
  else if (strcmp(words[0], "wall") == 0)
    cli_help_wall();
  else if (aspi_find_name("", words[0], COMMANDS, commands, NULL) >= 0 || !cli_help_word(words[0]))
    cli_parse(find(words[0]), 2, arguments);
  cli_file_close(stdout);
}

int main(int argc, char **argv) {
  gsl_set_error_handler_off();
  if (argc < 2)
    cli_bad_usage("a command is expected; see 'asperity --help'");
  const char *word = argv[1];
  if (strcmp(word, "help") == 0 && argc > 2) {
    help(argc - 2, argv + 2);
    return 0;
  }
  if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0 || strcmp(word, "help") == 0) {
    cli_help_all(commands);
    cli_file_close(stdout);
    return 0;
  }
  if (strcmp(word, "--version") == 0) {
    printf("asperity %s\n", asp_version());
    cli_file_close(stdout);
    return 0;
  }
  cli_call call = cli_parse(find(word), argc - 1, argv + 1);
  call.command->run(&call);
  return 0;
}
