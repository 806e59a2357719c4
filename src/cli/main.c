/* The `asperity` command: a list of subcommands, one file each.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "base/error.h"

#include <gsl/gsl_errno.h>
#include <string.h>

static const cli_command *const commands[] = {
    &cli_surface, &cli_spread,      &cli_cor,   &cli_compare,   &cli_calibrate,
    &cli_erosion, &cli_sensitivity, &cli_trade, &cli_materials, NULL};

enum { COMMANDS = sizeof commands / sizeof *commands - 1 };

static const char *name_at(int index) {
  return commands[index]->name;
}

static const cli_command *find(const char *name) {
  int index = aspi_find_name("command", name, COMMANDS, name_at, &cli_error);
  cli_must(index >= 0);
  return commands[index];
}

int main(int argc, char **argv) {
  gsl_set_error_handler_off();
  if (argc < 2)
    cli_bad_usage("a command is expected; see 'asperity --help'");
  const char *word = argv[1];
  if (strcmp(word, "help") == 0 && argc > 2 && strcmp(argv[2], "wall") == 0) {
    cli_help_wall();
    cli_file_close(stdout);
    return 0;
  }
  if (strcmp(word, "help") == 0 && argc > 2 && strcmp(argv[2], "--words") == 0) {
    cli_complete(commands, argc - 3, argv + 3);
    cli_file_close(stdout);
    return 0;
  }
  if (strcmp(word, "help") == 0 && argc > 2) {
    char *arguments[] = {argv[2], "--help", NULL};
    cli_parse(find(argv[2]), 2, arguments);
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
