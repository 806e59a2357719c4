/* The help of the commands, made from their tables of options in three forms: text for a terminal,
 * a page of the manual (man 7 man), and a list of words for the shell's completion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "erosion/laws.h"
#include "cli/help.h"
#include "wall/description.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEFT = 26 }; /* width of the column of options */

static const char conventions[] =
    "Results are CSV on standard output (-o FILE for a file); --plot FILE.png|svg|pdf draws them.\n"
    "Numbers may carry a unit (5um, 100m/s, 200MPa, 30deg) or are SI; angles are degrees from the\n"
    "wall plane. A list is 5,10,20 or from:to:step, or both: 1:9:1,10:90:5; of sizes and speeds\n"
    "it may be a law, lognormal:min:max:median. DESCRIPTION stands for the words that describe\n"
    "the wall, as `surface sigma 10 rebound bons friction 0.4`; 'asperity help wall' has them.\n"
    "Exit status: 0 done, 1 failed, 2 bad usage or bad input.\n";

/* ---- text ---- */
static void text_of_command(const cli_command *command, const cli_option *options) {
  printf("asperity %s: %s\n\n%s\nOptions:\n", command->name, command->summary, command->detail);
  for (const cli_option *o = options; o->name; o++) {
    char left[64];
    snprintf(left, sizeof left, "--%s%s%s", o->name, o->argument ? " " : "",
             o->argument ? o->argument : "");
    if (strlen(left) > LEFT)
      printf("  %s\n  %-*s %s", left, LEFT, "", o->help);
    else
      printf("  %-*s %s", LEFT, left, o->help);
    if (o->argument && o->value)
      printf(" [%s]", o->value);
    putchar('\n');
  }
  printf("  %-*s %s\n", LEFT, "--help", "this text");
}

static void text_of_all(const cli_command *const *commands) {
  printf("asperity %s: rough walls for particle simulation\n\n"
         "Usage: asperity COMMAND [DESCRIPTION] [options]\n\nCommands:\n",
         asp_version());
  for (; *commands; commands++)
    printf("  %-10s %s\n", (*commands)->name, (*commands)->summary);
  printf(
      "\nasperity help COMMAND, or asperity COMMAND --help, tells the options; asperity help wall\n"
      "the words that describe a wall.\n%s",
      conventions);
}

/* ---- the words of a description ---- */

static void put_default(FILE *out, const aspi_keyword *k) {
  if (*k->standard)
    fprintf(out, " [%s]", k->standard);
  fputc('\n', out);
}

/* The words within one, and those within these. */
static void put_words(FILE *out, const char *within, int depth) {
  for (int i = 0; i < aspi_keyword_count(); i++) {
    const aspi_keyword *k = aspi_keyword_at(i);
    if (strcmp(k->within, within) != 0)
      continue;
    fprintf(out, "%s%*s%s %s\n%*s%s", depth ? "" : "\n", 2 * depth, "", k->name, k->values,
            2 * depth + 6, "", k->text);
    put_default(out, k);
    put_words(out, k->name, depth + 1);
  }
}

/* A law's name with its parameters: those that follow the name, and those with a word of their
 * own. */
static void put_law(FILE *out, const char *name, const asp_parameter *parameters, int count,
                    const char *summary) {
  const char *last = "";
  fprintf(out, "  %s", name);
  for (int i = 0; i < count; i++) {
    const asp_parameter *p = &parameters[i];
    const char *keyword = asp_parameter_keyword(p);
    if (strcmp(keyword, last) != 0)
      fprintf(out, "%s [%s", *last ? "]" : "", keyword);
    fputc(' ', out);
    for (const char *c = asp_parameter_name(p); *c; c++)
      fputc(toupper((unsigned char)*c), out);
    last = keyword;
  }
  fprintf(out, "%s\n      %s\n", *last ? "]" : "", summary);
}

static void put_wall(FILE *out) {
  fputs("A wall is described by clauses, each at most once and in any order, the same words in\n"
        "the command and in scripts. What has no effect on the wall at hand is refused. In a\n"
        "command particles fly along x over the wall z = 0, and an angle of the lay is from x.\n",
        out);
  put_words(out, "", 0);
  fputs("\nMODEL, as 'asperity spread --list' tells more of them:\n", out);
  for (int i = 0; i < asp_spread_count(); i++)
    fprintf(out, "  %s\n      %s\n", asp_spread_name(asp_spread_at(i)),
            asp_spread_summary(asp_spread_at(i)));
  fputs("\nLAW, as 'asperity rebound --list' tells more of them:\n", out);
  for (int i = 0; i < asp_rebound_count(); i++) {
    const asp_rebound_law *law = asp_rebound_at(i);
    put_law(out, law->needs_table ? "table FILE" : law->name, law->parameters, law->n_parameters,
            law->summary);
  }
  fputs("\nLAW of erosion:\n", out);
  for (int i = 0; i < aspi_erosion_count(); i++) {
    const aspi_erosion_law *law = aspi_erosion_at(i);
    put_law(out, law->name, law->parameters, law->n_parameters, law->summary);
    fprintf(out, "      %s\n", law->source);
  }
}

void cli_help_wall(void) {
  put_wall(stdout);
}

/* ---- page of the manual ---- */

/* A text as troff has it: backslashes and dashes are marked, and no line begins with a mark. */
static void print_troff(const char *text) {
  for (bool begins = true; *text; begins = *text == '\n', text++) {
    if (begins && (*text == '.' || *text == '\''))
      fputs("\\&", stdout);
    if (*text == '\\')
      fputs("\\e", stdout);
    else if (*text == '-')
      fputs("\\-", stdout);
    else
      putchar(*text);
  }
}

static void troff_line(const char *before, const char *text) {
  fputs(before, stdout);
  print_troff(text);
  if (!*text || text[strlen(text) - 1] != '\n')
    putchar('\n');
}

static void troff_of_option(const cli_option *option) {
  fputs(".TP\n\\fB\\-\\-", stdout);
  print_troff(option->name);
  fputs("\\fR", stdout);
  if (option->argument) {
    fputs(" \\fI", stdout);
    print_troff(option->argument);
    fputs("\\fR", stdout);
  }
  putchar('\n');
  print_troff(option->help);
  if (option->argument && option->value) {
    fputs(" [default: ", stdout);
    print_troff(option->value);
    putchar(']');
  }
  putchar('\n');
}

static void troff_of_command(const cli_command *command, const cli_option *options) {
  printf(".TH \"ASPERITY\\-%s\" 1 \"\" \"asperity %s\" \"User Commands\"\n.SH NAME\nasperity\\-%s "
         "\\- ",
         command->name, asp_version(), command->name);
  troff_line("", command->summary);
  printf(".SH SYNOPSIS\n\\fBasperity %s\\fR%s%s%s [\\fIoptions\\fR]\n", command->name,
         command->arguments ? " \\fI" : "", command->arguments ? command->arguments : "",
         command->arguments ? "\\fR" : "");
  troff_line(".SH DESCRIPTION\n.nf\n", command->detail);
  puts(".fi\n.SH OPTIONS");
  for (const cli_option *o = options; o->name; o++)
    troff_of_option(o);
  troff_line(".SH CONVENTIONS\n", conventions);
  puts(".SH SEE ALSO\n.BR asperity (1)");
}

static void troff_of_wall(void) {
  char *text = NULL;
  size_t size;
  FILE *out = open_memstream(&text, &size);
  if (!out)
    cli_fail("out of memory");
  put_wall(out);
  fclose(out);
  troff_line(".SH DESCRIPTION OF A WALL\n.nf\n", text);
  puts(".fi");
  free(text);
}

static void troff_of_all(const cli_command *const *commands) {
  printf(".TH ASPERITY 1 \"\" \"asperity %s\" \"User Commands\"\n.SH NAME\n"
         "asperity \\- rough walls for particle simulation\n"
         ".SH SYNOPSIS\n\\fBasperity\\fR \\fICOMMAND\\fR [\\fIoptions\\fR]\n.SH COMMANDS\n",
         asp_version());
  for (const cli_command *const *c = commands; *c; c++) {
    printf(".TP\n.BR asperity\\-%s (1)\n", (*c)->name);
    troff_line("", (*c)->summary);
  }
  troff_line(".SH CONVENTIONS\n", conventions);
  troff_of_wall();
}

/* ---- words for the shell ---- */
static void words_of_command(const cli_option *options) {
  for (const cli_option *o = options; o->name; o++)
    printf("--%s%s%s\n", o->name, o->argument ? " " : "", o->argument ? o->argument : "");
  puts("--help");
}

static void words_of_all(const cli_command *const *commands) {
  for (; *commands; commands++)
    puts((*commands)->name);
  puts("help\n--help\n--version");
}

void cli_help_command(const cli_command *command, const cli_option *options, const char *form) {
  if (!form)
    text_of_command(command, options);
  else if (strcmp(form, "man") == 0)
    troff_of_command(command, options);
  else if (strcmp(form, "words") == 0)
    words_of_command(options);
  else
    cli_bad_usage("%s: --help is '%s'; it must be man or words", command->name, form);
}

void cli_help_all(const cli_command *const *commands, const char *form) {
  if (!form)
    text_of_all(commands);
  else if (strcmp(form, "man") == 0)
    troff_of_all(commands);
  else if (strcmp(form, "words") == 0)
    words_of_all(commands);
  else
    cli_bad_usage("--help is '%s'; it must be man or words", form);
}
