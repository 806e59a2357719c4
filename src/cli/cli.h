/* Shared by the subcommands of `asperity`: options with help from one table, numbers with units,
 * CSV output that is written whole or not at all, a progress bar, and pictures by gnuplot.
 *
 * Everything here exits on bad input: status 2 for bad usage, 1 for a failure, with one line on
 * stderr that names the option, its value and what it must be.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_H
#define ASP_CLI_H

#include "asperity.h"
#include "base/list.h"

#include <stdio.h>

typedef struct cli_command {
  const char *name;
  const char *summary;   /* one line, for the list of commands */
  const char *detail;    /* more, for --help */
  const char *arguments; /* besides options; NULL: none */
  const char *examples;  /* command lines, each behind "  $ " */
  int (*run)(int argc, char **argv);
} cli_command;

extern const cli_command cli_calibrate, cli_compare, cli_cor, cli_erosion, cli_materials,
    cli_rebound, cli_spread, cli_surface, cli_trade;

/* One option of a command. A table of them ends with a NULL name. */
typedef struct cli_option {
  const char *name;     /* without the dashes */
  const char *argument; /* what its value is, for the help; NULL for a flag */
  const char *help;
  const char *value; /* the default, then what the user gave; NULL: not given. A flag: "" */
} cli_option;

#define CLI_OUTPUT_OPTION                                                                          \
  { "output", "FILE", "write there instead of to the screen", NULL }

/* Reads the options of a command into the table; prints help and exits on --help, and where a file
 * that is to be written cannot be. Returns the index
 * of the first argument that is not an option; with `arguments` false there must be none. */
int cli_parse(const cli_command *command, int argc, char **argv, cli_option *options,
              bool arguments);

#if defined(__GNUC__)
#define CLI_FORMAT(text, first) __attribute__((format(printf, text, first)))
#else
#define CLI_FORMAT(text, first)
#endif
CLI_FORMAT(1, 2) _Noreturn void cli_bad_usage(const char *format, ...); /* exit 2 */
CLI_FORMAT(1, 2) _Noreturn void cli_fail(const char *format, ...);      /* exit 1 */

/* Room for some things, all zero, and a copy of a text, to be freed; exit 1 where there is none. */
void *cli_allocate(size_t count, size_t size);
char *cli_copy(const char *text);

/* Tells what is wrong with the file that an option (NULL: an argument) names: exit 2, 1 where there
 * is no memory for it. */
_Noreturn void cli_bad_file(const cli_option *option, const asp_error *error);

/* Many numbers, or a log-normal law: see base/list.h. The values live as long as the command. */
typedef aspi_list cli_list;

/* Bad usage if a length (m) over 1 mm has no unit: `5` would be 5 m, and its unit was forgotten. */
void cli_check_unit(const char *name, const char *text, double most);

/* The option's value, which must have been given, as a number of a kind (see base/quantity.h) with
 * or without a unit; one without any; a length > 0; a whole number, which may be written as 1e6. */
double cli_quantity(const cli_option *option, const char *kind, double least, double most);
double cli_number(const cli_option *option, double least, double most);
double cli_length(const cli_option *option);
unsigned long cli_whole(const cli_option *option, unsigned long least, unsigned long most);

/* The same of lists, `a,b,c` and `from:to:step`; cli_values takes `lognormal:min:max:median`, too.
 * Angles are in degrees, 0 to 90. */
cli_list cli_values(const cli_option *option, const char *kind, double least, double most);
cli_list cli_numbers(const cli_option *option, double least, double most);
cli_list cli_speeds(const cli_option *option, double least, double most);
cli_list cli_lengths(const cli_option *option);
cli_list cli_angles(const cli_option *option);

/* 0 or 1: which of two words the value is. */
int cli_choice(const cli_option *option, const char *first, const char *second);

/* A line on stderr; and one that something may not be what is wanted. */
CLI_FORMAT(1, 2) void cli_say(const char *format, ...);
CLI_FORMAT(1, 2) void cli_warn(const char *format, ...);

/* A file that appears under its name, whole, when it is closed; an exit before that leaves what was
 * there. A symbolic link is followed and its target replaced. A device or a pipe is written to as
 * it is, and so is the file that is standard output. */
typedef struct cli_file cli_file;
cli_file *cli_file_open(const char *path);

/* Exits where the file cannot be written. cli_parse asks for the options `output` and `save`. */
void cli_file_check(const char *path);

/* Exits where --output or --plot would replace a file that is read. */
void cli_keep_input(const cli_option *options, const char *input);
FILE *cli_file_stream(const cli_file *file);
void cli_file_close(cli_file *file);
void cli_file_drop(cli_file *file); /* closes it and leaves what was there */

/* The stream to write CSV to: a file, or stdout where path is NULL or "-". Writes the comment line:
 * version, the command as given, and the description of the wall where there is one. */
typedef struct cli_output cli_output;
cli_output *cli_output_open(const char *path, int argc, char **argv, const char *description);
FILE *cli_output_stream(cli_output *output);
void cli_output_close(cli_output *output);

/* A user's text within a comment line: control characters as \xNN. */
void cli_print_comment(FILE *out, const char *text);

/* A user's text as a field of CSV: in quotes where it holds a comma, a quote or a #. */
void cli_print_field(FILE *out, const char *text);

/* Seconds on a monotonic clock. */
double cli_seconds(void);

/* A bar on stderr when that is a terminal and the work takes over a second; done counts up to
 * total. */
typedef struct cli_progress {
  const char *what;
  double total;
  double begun, shown;
} cli_progress;
cli_progress cli_progress_begin(const char *what, double total);
void cli_progress_show(cli_progress *progress, double done);
void cli_progress_end(cli_progress *progress);

/* Exits where a picture could not be drawn: another ending than .png, .svg or .pdf, no gnuplot, a
 * file that cannot be written. cli_parse asks for the option `plot`, before any work is done. */
void cli_plot_check(const cli_option *option);

/* The options of a picture, in a row in a command's table; see plot.h. */
enum { PLOT_FILE, PLOT_TITLE, PLOT_SIZE, PLOT_RANGE, PLOT_OPTIONS };
#define CLI_PLOT_OPTIONS(first, text)                                                              \
  [(first) + PLOT_FILE] = {"plot", "FILE", text, NULL},                                            \
             [(first) +                                                                            \
                 PLOT_TITLE] = {"title", "TEXT", "of the picture, instead of its own", NULL},      \
             [(first) + PLOT_SIZE] = {"size", "WIDTHxHEIGHT", "of the picture, in pixels", NULL},  \
             [(first) + PLOT_RANGE] = {"range", "FROM:TO", "of the vertical axis", NULL}

double cli_degrees(double radians);
double cli_radians(double degrees);

#endif
