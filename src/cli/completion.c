/* Words that may follow on a command line, for the shell's completion (asperity.bash); see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "description/words.h"

#include <string.h>

/* Prints the values of an option that takes any; false: the word is no such option. */
static bool put_values(const cli_option *options, const char *word) {
  const char *name = strcmp(word, "-o") == 0 ? "output" : word + strspn(word, "-");
  for (const cli_option *o = options; o->name; o++) {
    if (*word != '-' || strcmp(name, o->name) != 0 || !o->argument)
      continue;
    for (const char *c = strchr(o->argument, '|') ? o->argument : ""; *c; c++)
      putchar(*c == '|' ? ' ' : *c);
    puts(strstr(o->argument, "FILE") ? "FILE" : "");
    return true;
  }
  return false;
}

/* Prints the words that may follow the arguments; true if options may. */
static bool put_arguments(const cli_command *command, int count, char **words) {
  const char *argument = command->arguments ? command->arguments : "";
  int files = 0; /* before the description, or in place of it */
  for (; *argument && !strstr("[DESCRIPTION] WALL", argument); files++)
    argument += strcspn(argument, " ") + (strchr(argument, ' ') != NULL);
  if (command->takes_files || count < files) {
    puts("FILE");
    return command->takes_files;
  }
  aspi_completions completions = {.at_end = false};
  bool may_end = !*argument || aspi_description_complete(&completions, count - files,
                                                         (const char *const *)words + files);
  puts(completions.list);
  return may_end;
}

void cli_complete(const cli_command *const *commands, int count, char **words) {
  if (count < 2 && (count == 0 || strcmp(words[0], "help") == 0)) {
    static const char *const clauses[] = {"surface", "spread", "rebound", "erosion"};
    aspi_completions completions = {.at_end = false};
    for (size_t i = 0; i < sizeof clauses / sizeof *clauses; i++)
      aspi_description_complete(&completions, 1, &clauses[i]);
    printf(count == 0 ? "help\n" : "wall %s\n", completions.list);
    for (; *commands; commands++)
      puts((*commands)->name);
    return;
  }
  while (*commands && strcmp((*commands)->name, words[0]) != 0)
    commands++;
  if (!*commands)
    return;
  cli_call call = {.command = *commands};
  cli_list_options(&call);
  if (put_values(call.options, words[count - 1]))
    return;
  int n = cli_count_words(count, words);
  bool behind_options = n < count - 1 && !call.command->takes_files;
  if (behind_options || put_arguments(call.command, n, words + 1))
    for (const cli_option *o = call.options; o->name; o++)
      printf("--%s\n", o->name);
}
