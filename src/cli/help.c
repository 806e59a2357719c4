/* The help of the commands, made from their tables of options, in the form that help2man makes a
 * page of the manual from.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "erosion/laws.h"
#include "cli/cli.h"
#include "description/description.h"
#include "rebound/laws.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LEFT = 26, WIDTH = 100 }; /* of the column of options, and of a line */

static const char conventions[] =
    "Results are CSV on standard output (-o FILE for a file); --plot FILE.png|svg|pdf draws them.\n"
    "Numbers may carry a unit (5um, 100m/s, 200MPa, 30deg) or are SI; angles are degrees from the\n"
    "wall plane. A list is 5,10,20 or from:to:step, or both: 1:9:1,10:90:5; of sizes and speeds\n"
    "it may be a distribution, lognormal:min:max:median. DESCRIPTION stands for the words that\n"
    "describe the wall, such as `surface sigma 10 rebound bons friction 0.4`; 'asperity help\n"
    "wall' lists them.\n"
    "Exit status: 0 done, 1 failed, 2 bad usage or bad input.\n";

/* Prints the help of an option in lines of at most WIDTH characters, aligned with the first one.
 */
static void print_meaning(const cli_option *option) {
  char text[600];
  bool has_default = option->argument && option->value;
  snprintf(text, sizeof text, "%s%s%s%s", option->help, has_default ? " [" : "",
           has_default ? option->value : "", has_default ? "]" : "");
  const char *line = text;
  while (strlen(line) > WIDTH - LEFT - 3) {
    const char *end = line + WIDTH - LEFT - 3;
    while (*end != ' ')
      end--;
    printf(" %.*s\n  %-*s", (int)(end - line), line, LEFT, "");
    line = end + 1;
  }
  printf(" %s\n", line);
}

void cli_help_command(const cli_command *command, const cli_option *options) {
  printf("Usage: asperity %s%s%s [options]\n\n%c%s.\n\n%s\nOptions:\n", command->name,
         command->arguments ? " " : "", command->arguments ? command->arguments : "",
         toupper((unsigned char)*command->summary), command->summary + 1, command->detail);
  for (const cli_option *o = options; o->name; o++) {
    char left[64];
    snprintf(left, sizeof left, "--%s%s%s", o->name, o->argument ? " " : "",
             o->argument ? o->argument : "");
    if (strlen(left) > LEFT)
      printf("  %s\n  %-*s", left, LEFT, "");
    else
      printf("  %-*s", LEFT, left);
    print_meaning(o);
  }
  printf("  %-*s %s\n", LEFT, "--help", "this text");
  if (command->examples)
    printf("\nExamples:\n%s", command->examples);
}

void cli_help_all(const cli_command *const *commands) {
  puts("Usage: asperity COMMAND [DESCRIPTION] [options]\n\n"
       "Rough walls for particle simulation.\n\nCommands:");
  for (; *commands; commands++)
    printf("  %-10s %s\n", (*commands)->name, (*commands)->summary);
  printf("\n'asperity help COMMAND' or 'asperity COMMAND --help' lists the options of a command,\n"
         "'asperity help wall' the words that describe a wall, 'asperity help bons' a law or "
         "model.\n\n"
         "%s\nExamples:\n"
         "  $ asperity help cor\n"
         "  $ asperity cor surface rq 5um lambda_c 40um --dp 10um --plot cor.png -o cor.csv\n",
         conventions);
}

static void put_words(const char *within, int depth);

/* A keyword, and the words within it. */
static void put_keyword(const aspi_keyword *k, int depth) {
  printf("%*s%s %s\n%*s%s", 2 * depth, "", k->name, k->values, 2 * depth + 6, "", k->text);
  printf(*k->default_text ? " [%s]\n" : "\n", k->default_text);
  put_words(k->name, depth + 1);
}

static void put_words(const char *within, int depth) {
  for (const aspi_keyword *k = aspi_keywords; k->name; k++) {
    if (strcmp(k->within, within) != 0 || !k->text)
      continue;
    fputs(depth ? "" : "\n", stdout);
    put_keyword(k, depth);
  }
}

static void put_upper(const char *name) {
  for (; *name; name++)
    putchar(toupper((unsigned char)*name));
}

/* Parameters that must be given have no default. */
static void put_parameter(const aspi_keyword *p) {
  fputs("        ", stdout);
  put_upper(p->name);
  if (p->values)
    printf(" (%s): %s\n", p->values, p->text);
  else
    printf(" (%g to %g%s%s): %s", p->least, p->most, *p->unit ? " " : "", p->unit, p->text);
  if (!p->values)
    printf(isnan(p->default_value) || !*aspi_keyword_word(p) ? "\n" : " [%.10g]\n",
           p->default_value);
}

/* A law with its parameters, those behind a word of their own in brackets. */
static void put_law(const char *name, const aspi_keyword *parameters, int count,
                    const char *summary, const char *source) {
  const char *last = "";
  printf("  %s", name);
  for (int i = 0; i < count; i++) {
    const char *word = aspi_keyword_word(&parameters[i]);
    if (strcmp(word, last) != 0)
      printf("%s [%s", *last ? "]" : "", word);
    putchar(' ');
    put_upper(parameters[i].name);
    last = word;
  }
  printf("%s\n      %s; source: %s\n", *last ? "]" : "", summary, source);
  for (int i = 0; i < count; i++)
    put_parameter(&parameters[i]);
}

static void put_model(const asp_spread_model *model) {
  put_law(model->name, NULL, 0, model->summary, model->source);
}

static void put_rebound(const asp_rebound_law *law) {
  char summary[200];
  snprintf(summary, sizeof summary, law->d_most > 0 ? "%s, for particles of %g to %g um" : "%s",
           law->summary, 1e6 * law->d_least, 1e6 * law->d_most);
  put_law(law->needs_table ? "table FILE" : law->name, law->parameters, law->n_parameters, summary,
          law->source);
}

static void put_erosion(const aspi_erosion_law *law) {
  put_law(law->name, law->parameters, law->n_parameters, law->summary, law->source);
}

static void put_curve(const aspi_curve_form *f) {
  put_law(f->n_parameters ? f->name : "table FILE", f->parameters, f->n_parameters, f->summary,
          f->source);
}

bool cli_help_word(const char *name) {
  const asp_spread_model *model = asp_spread_find(name, NULL);
  const asp_rebound_law *rebound = asp_rebound_find(name, NULL);
  const aspi_erosion_law *erosion = aspi_erosion_find(name, NULL);
  bool found = model || rebound || erosion;
  for (const aspi_keyword *k = aspi_keywords; k->name; k++) {
    if (strcmp(k->name, name) != 0 || !k->text)
      continue;
    printf(*k->within ? "behind %s:\n" : "", k->within);
    put_keyword(k, 1);
    found = true;
  }
  printf(model ? "behind spread:\n" : "");
  if (model)
    put_model(model);
  printf(rebound ? "behind rebound:\n" : "");
  if (rebound)
    put_rebound(rebound);
  printf(erosion ? "behind erosion:\n" : "");
  if (erosion)
    put_erosion(erosion);
  for (const aspi_curve_form *f = aspi_curve_forms; f->name; f++)
    if (strcmp(f->name, name) == 0) {
      printf("behind %s:\n", f->keywords);
      put_curve(f);
      found = true;
    }
  return found;
}

void cli_help_wall(void) {
  fputs("These words describe a wall, in the command and in scripts. Each keyword appears at most\n"
        "once, in any order. A word that has no effect on the wall is an error. Defaults are in\n"
        "[brackets]. In a command particles fly along x over the wall z = 0, and an\n"
        "angle of the lay counts from x; without `materials` all but `calibrate` take Arizona\n"
        "Road Dust on Hastelloy X (materials ard hastelloy-x). 'asperity help WORD' shows one\n"
        "keyword, model or law.\n",
        stdout);
  put_words("", 0);
  fputs("\nMODEL:\n", stdout);
  for (int i = 1; i < asp_spread_count(); i++) /* 0 is that of smooth walls */
    put_model(asp_spread_at(i));
  fputs("\nLAW, with the ranges and [defaults] of its parameters:\n", stdout);
  for (int i = 0; i < asp_rebound_count(); i++)
    put_rebound(asp_rebound_at(i));
  fputs("\nLAW of erosion:\n", stdout);
  for (int i = 0; i < aspi_erosion_count(); i++)
    put_erosion(aspi_erosion_at(i));
  fputs("\nCurves of viscosity and of soften_modulus:\n", stdout);
  for (const aspi_curve_form *f = aspi_curve_forms; f->name; f++)
    put_curve(f);
}
