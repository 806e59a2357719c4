/* Pictures by gnuplot: the scripts of share/asperity/plot read the table that a command prints.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_PLOT_H
#define ASP_CLI_PLOT_H

#include "cli/cli.h"

/* Opens the table of a command: a temporary file with --plot, else the output. cli_table_close
 * draws it by a script, "cor" for plot/cor.gp, and copies it to the output. */
FILE *cli_table_open(const cli_call *call, const char *description);
void cli_table_close(const cli_call *call, FILE *table, const char *script);

/* The same for a table that is drawn and not printed. */
FILE *cli_plot_open(const cli_call *call);
void cli_plot_close(const cli_call *call, FILE *table, const char *script);

#endif
