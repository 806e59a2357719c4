/* Shared by the subcommands of `asperity`: options with help from one table, numbers with units,
 * CSV output that is written whole or not at all, progress, and pictures by gnuplot.
 *
 * Everything here exits on bad input: status 2 for bad usage, 1 for a failure, with one line on
 * stderr that names the option, its value and what it must be.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"
#include "base/error.h"
#include "base/units.h"

#include <stdio.h>

/* One option of a command. A table of them ends with a NULL name. */
typedef struct cli_option {
  const char *name;     /* without the dashes */
  const char *argument; /* value, for the help; NULL for a flag */
  const char *help;
  const char *value; /* the default, then what the user gave; NULL: not given. A flag: "" */
} cli_option;

typedef struct cli_call cli_call;

typedef struct cli_command {
  const char *name;
  const char *summary;       /* one line, for the list of commands */
  const char *detail;        /* more, for --help */
  const char *arguments;     /* besides options; NULL: none */
  bool takes_files;          /* arguments are files, anywhere; else words before the options */
  const char *examples;      /* command lines, each behind "  $ " */
  const cli_option *options; /* its own; --output and those of a picture follow them */
  const char *picture;       /* help of --plot; NULL: there is no picture */
  void (*run)(cli_call *call);
} cli_command;

extern const cli_command cli_calibrate, cli_compare, cli_cor, cli_erosion, cli_map_command,
    cli_materials, cli_sensitivity, cli_spread, cli_surface, cli_trade;

/* A command as it is called, once in a process: what it reads and makes stays until the end. */
enum { CLI_OPTIONS_MOST = 24 };
struct cli_call {
  const cli_command *command;
  int argc;
  char **argv; /* the command's name and all that follows */
  int n_words;
  char **words; /* its arguments */
  cli_option options[CLI_OPTIONS_MOST];
};

/* Reads the options and the arguments of a command; prints help and exits on --help, and where a
 * file that is to be written cannot be. */
cli_call cli_parse(const cli_command *command, int argc, char **argv);

/* Lists the options of a command: its own, and those of all. */
void cli_list_options(cli_call *call);

/* Number of words between the first one and the first option; `-0.5` is a number and no option. */
int cli_count_words(int argc, char **argv);

/* An option of the command by name; its value; true if the value is not the default. */
const cli_option *cli_get(const cli_call *call, const char *name);
const char *cli_value(const cli_call *call, const char *name);
void cli_default(cli_call *call, const char *name, const char *value); /* where none is given */
bool cli_is_set(const cli_call *call, const char *name);

ASPI_FORMAT(1, 2) _Noreturn void cli_bad_usage(const char *format, ...); /* exit 2 */
ASPI_FORMAT(1, 2) _Noreturn void cli_fail(const char *format, ...);      /* exit 1 */

/* Zeroed memory, and a copy of a text, to be freed; exit 1 if out of memory. */
void *cli_allocate(size_t count, size_t size);
char *cli_copy(const char *text);

/* See aspi_grow; exit 1 if out of memory. */
void *cli_grow(void *array, size_t count, size_t size);

/* The error of the last library call that failed. */
extern asp_error cli_error;

/* Exit with that error if a call failed or made nothing: status 2, or 1 if out of memory. */
void cli_must(bool good);
void *cli_made(void *thing);

/* A list of values, or a truncated log-normal law if count is 0. The values live as long as the
 * command. */
typedef struct cli_list {
  double *values;
  size_t count;
  double least, most; /* of the values, or where the law ends */
  double median;
} cli_list;

/* Bad usage if a length is over 1 mm, or a stress under 1 MPa, and has no unit: `5` would be 5 m or
 * 5 Pa, and its unit was forgotten. */
void cli_check_unit(const char *name, const char *text, const char *kind);

/* The value of a given option: a number of a kind (see base/units.h) with or without a unit; a
 * number without unit; a length > 0; a whole number, which may be written as 1e6. */
double cli_quantity(const cli_option *option, const char *kind, double least, double most);
double cli_number(const cli_option *option, double least, double most);
double cli_length(const cli_option *option);
unsigned long cli_whole(const cli_option *option, unsigned long least, unsigned long most);

/* Values of lists, `a,b,c`, where each may be `from:to:step` with both ends included; cli_values
 * takes `lognormal:min:max:median`, too.
 * Angles are in degrees, 0 to 90. */
cli_list cli_values(const cli_option *option, const char *kind, double least, double most);
cli_list cli_lengths(const cli_option *option);
cli_list cli_angles(const cli_option *option);
cli_list cli_impact_angles(const cli_call *call); /* of the option `angles`; over 0 */

/* Takes one to n numbers; those that are not given stay as they are. Returns their count. */
size_t cli_few(const cli_option *option, double least, double most, size_t n, double *values);

/* Index of the value among the words of the option's argument, `own|ledger`. */
int cli_choice(const cli_option *option);

/* A warning on stderr. */
ASPI_FORMAT(1, 2) void cli_warn(const char *format, ...);

/* Written to a temporary file and renamed on close; an early exit leaves the old file. A symbolic
 * link is replaced. Devices, pipes and standard output ("-" or NULL) are written directly. One file
 * is open at a time. */
FILE *cli_file_open(const char *path);
void cli_file_close(FILE *stream);

/* cli_clean_up erases the line of progress and removes an incomplete file; exits and signals call
 * it. cli_remove_later sets that file; NULL: none.
 */
void cli_clean_up(void);
void cli_remove_later(char *path);

/* Exits if the file cannot be written. cli_parse checks the options `output` and `save`. */
void cli_file_check(const char *path);

/* Prints the comment line of a table: version, command line, and the description of the wall if
 * any. cli_output_open opens the file of an option and prints this line. */
void cli_print_heading(FILE *out, const cli_call *call, const char *description);
FILE *cli_output_open(const cli_call *call, const char *option, const char *description);

/* Prints CSV fields by a printf format of text, %s, %d, %zu or doubles between commas. NAN gives an
 * empty field; text is quoted if necessary. */
ASPI_FORMAT(2, 3) void cli_row(FILE *out, const char *format, ...);

/* Prints a number like printf's %.*g, but faster; nothing for NAN. */
void cli_print_number(FILE *out, double value, int digits);

/* A user's text within a comment line: control characters as \xNN. */
void cli_print_comment(FILE *out, const char *text);

/* A text in quotes, with quotes inside it doubled. */
void cli_print_quoted(FILE *out, const char *text);

/* Percents and the time left at the mean rate, on stderr when that is a terminal; done counts up to
 * total. cli_erase_progress may be called by a signal. */
typedef struct cli_progress {
  const char *what;
  double total;
  double begun, shown;
} cli_progress;
cli_progress cli_progress_begin(const char *what, double total);
void cli_progress_show(void *progress, double done); /* a cli_progress */
void cli_progress_end(cli_progress *progress);
void cli_erase_progress(void);

/* Exits if a picture cannot be drawn: wrong ending (.png, .svg, .pdf), no gnuplot, unwritable file.
 * cli_parse calls it before any work is done. */
void cli_plot_check(const cli_call *call);

/* Opens the table of a command: a temporary file with --plot, else the output. cli_table_close
 * draws it by a script, "cor" for plot/cor.gp, and copies it to the output. */
FILE *cli_table_open(const cli_call *call, const char *description);
void cli_table_close(const cli_call *call, FILE *table, const char *script);

/* The same for a table that is drawn and not printed. */
FILE *cli_plot_open(const cli_call *call);
void cli_plot_close(const cli_call *call, FILE *table, const char *script);

/* Prints the help on one command, or on all (a list that ends with NULL). */
void cli_help_command(const cli_command *command, const cli_option *options);
void cli_help_all(const cli_command *const *commands);

/* Prints the words that describe a wall; or one keyword, law or model (false: there is none). */
void cli_help_wall(void);
bool cli_help_word(const char *name);

/* Prints the words that may follow these of a command line, FILE for the name of a file: for the
 * shell's completion. */
void cli_complete(const cli_command *const *commands, int count, char **words);
