/* The help of the commands; see help.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_HELP_H
#define ASP_CLI_HELP_H

#include "cli/cli.h"

/* Prints the help on one command, or on all (a list that ends with NULL). The form is NULL for
 * text, "words" for the shell's completion; another one exits with 2. */
void cli_help_command(const cli_command *command, const cli_option *options, const char *form);
void cli_help_all(const cli_command *const *commands, const char *form);

/* Prints the words that describe a wall, from their table. */
void cli_help_wall(void);

#endif
