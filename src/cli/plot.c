/* Pictures by gnuplot, from a temporary table that it has as standard input and a script, written
 * to its standard output; see cli.h. The title reaches gnuplot as an argument of the script, which
 * is never read as a command, and it reads no start-up files.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "base/error.h"

#include <ctype.h>
#include <errno.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

enum { PATH_MOST = 4096, TITLE_MOST = 600 };

extern char **environ;

/* png, svg or pdf. */
static const char *ending_of(const char *path) {
  static const char *const endings[] = {"png", "svg", "pdf"};
  const char *ending = strrchr(path, '.');
  for (int i = 0; ending && i < 3; i++)
    if (strcasecmp(ending + 1, endings[i]) == 0)
      return endings[i];
  cli_bad_usage("--plot is '%s'; the file must end in .png, .svg or .pdf", path);
}

/* Runs gnuplot; false if it fails. */
static bool run_gnuplot(char *const arguments[], FILE *in, FILE *out) {
  pid_t child;
  int status = -1;
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(in), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(out), STDOUT_FILENO);
  if (posix_spawnp(&child, arguments[0], &files, NULL, arguments, environ) == 0)
    waitpid(child, &status, 0);
  posix_spawn_file_actions_destroy(&files);
  return status == 0;
}

void cli_plot_check(const cli_call *call) {
  ending_of(cli_value(call, "plot"));
  cli_file_check(cli_value(call, "plot"));
  if (system("exec gnuplot --version > /dev/null 2>&1") != 0)
    cli_fail("cannot run gnuplot; is it installed? Debian: apt-get install gnuplot-nox");
}

/* The script in share/asperity/plot, found from where this program is. */
static void find_script(const char *name, char path[PATH_MOST]) {
  char program[PATH_MOST / 2];
  ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
  program[length > 0 ? length : 0] = '\0';
  char *slash = strrchr(program, '/');
  snprintf(path, PATH_MOST, "%.*s/" ASPERITY_PLOT "/%s.gp", slash ? (int)(slash - program) : 0,
           program, name);
  if (access(path, R_OK) != 0)
    cli_fail("cannot read the script '%s' that draws --plot: %s", path, strerror(errno));
}

/* The command as given, without the files that it writes; blanks for control characters. */
static void title_of(const cli_call *call, char title[TITLE_MOST]) {
  static const char left_out[] = "-o --output --plot --save";
  *title = '\0';
  for (int i = 0; i < call->argc; i++)
    if (aspi_word_index(left_out, call->argv[i], strlen(call->argv[i]), true) >= 0)
      i++;
    else
      aspi_append(title, TITLE_MOST, "%s%s", i ? " " : "", call->argv[i]);
  for (char *c = title; *c; c++)
    *c = iscntrl((unsigned char)*c) ? ' ' : *c;
}

FILE *cli_plot_open(const cli_call *call) {
  FILE *table = tmpfile();
  if (!table)
    cli_fail("cannot make a temporary file for --plot %s: %s", cli_value(call, "plot"),
             strerror(errno));
  return table;
}

void cli_plot_close(const cli_call *call, FILE *table, const char *name) {
  const char *path = cli_value(call, "plot");
  char script[PATH_MOST], title[TITLE_MOST], picture[8];
  find_script(name, script);
  title_of(call, title);
  snprintf(picture, sizeof picture, "-.%s", ending_of(path));
  if (fflush(table) != 0 || ferror(table))
    cli_fail("cannot write a temporary file for --plot %s: %s", path, strerror(errno));
  FILE *out = cli_file_open(path);
  char *const arguments[] = {"gnuplot", "-d", "-c", script, "/dev/stdin", picture, title, NULL};
  if (!run_gnuplot(arguments, table, out))
    cli_fail("gnuplot failed; no picture '%s' is drawn", path);
  cli_file_close(out);
  fclose(table);
  fprintf(stderr, "picture: %s\n", path);
}

FILE *cli_table_open(const cli_call *call, const char *description) {
  FILE *out =
      cli_value(call, "plot") ? cli_plot_open(call) : cli_file_open(cli_value(call, "output"));
  cli_print_heading(out, call, description);
  return out;
}

void cli_table_close(const cli_call *call, FILE *table, const char *script) {
  if (!cli_value(call, "plot")) {
    cli_file_close(table);
    return;
  }
  FILE *out = cli_file_open(cli_value(call, "output"));
  char block[65536];
  rewind(table);
  for (size_t size; (size = fread(block, 1, sizeof block, table)) > 0;)
    fwrite(block, 1, size, out);
  cli_file_close(out);
  cli_plot_close(call, table, script);
}
