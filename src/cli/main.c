/* The `asperity` command: a list of subcommands, one file each. */
#include "cli/cli.h"

#include <gsl/gsl_errno.h>
#include <string.h>

static const cli_command *const commands[] = {&cli_surface, &cli_doe,     &cli_spread,
                                              &cli_cor,     &cli_rebound, &cli_compare,
                                              &cli_trade,   &cli_fit,     &cli_materials};
enum { N_COMMANDS = sizeof commands / sizeof *commands };

static void print_help(void) {
  printf("asperity %s: rough walls for particle simulation\n\n"
         "Usage: asperity COMMAND [options]\n\nCommands:\n",
         asp_version());
  for (int i = 0; i < N_COMMANDS; i++)
    printf("  %-10s %s\n", commands[i]->name, commands[i]->summary);
  puts("\nasperity COMMAND --help tells the options. Results are CSV on standard output (-o FILE "
       "for\n"
       "a file); --plot FILE.png|svg|pdf draws them. Lengths take a unit (5um, 0.4mm) or are "
       "metres;\n"
       "angles are degrees from the wall plane. Exit status: 0 done, 1 failed, 2 bad usage.");
}

int main(int argc, char **argv) {
  gsl_set_error_handler_off();
  if (argc < 2)
    cli_bad_usage("a command is expected; see 'asperity --help'");
  if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 ||
      strcmp(argv[1], "help") == 0) {
    print_help();
    return 0;
  }
  if (strcmp(argv[1], "--version") == 0) {
    printf("asperity %s\n", asp_version());
    return 0;
  }
  for (int i = 0; i < N_COMMANDS; i++)
    if (strcmp(argv[1], commands[i]->name) == 0)
      return commands[i]->run(argc - 1, argv + 1);
  cli_bad_usage("command '%s' is unknown; see 'asperity --help'", argv[1]);
}
