/* The help of the commands; see help.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_HELP_H
#define ASP_CLI_HELP_H

#include "cli/cli.h"

/* Prints the help on one command, or on all (a list that ends with NULL). */
void cli_help_command(const cli_command *command, const cli_option *options);
void cli_help_all(const cli_command *const *commands);

/* Prints the words that describe a wall, from their table. */
void cli_help_wall(void);

#endif
