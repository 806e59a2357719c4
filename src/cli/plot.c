/* Pictures by gnuplot: the table in a temporary folder, the script that draws it, and a copy of the
 * picture; see cli.h. The title reaches gnuplot as an argument of the script, which is
 * never read as a command, and it reads no start-up files.
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

/* The folder with the table and the picture. */
static char folder[PATH_MOST], table_path[PATH_MOST + 20], picture_path[PATH_MOST + 20];

/* png, svg or pdf. */
static const char *ending_of(const char *path) {
  static const char *const endings[] = {"png", "svg", "pdf"};
  const char *ending = strrchr(path, '.');
  for (int i = 0; ending && i < 3; i++)
    if (strcasecmp(ending + 1, endings[i]) == 0)
      return endings[i];
  cli_bad_usage("--plot is '%s'; the file must end in .png, .svg or .pdf", path);
}

/* The exit status of a program; -1 if it cannot be run. */
static int run_program(char *const arguments[]) {
  pid_t child;
  int status;
  if ((errno = posix_spawnp(&child, arguments[0], NULL, NULL, arguments, environ)) != 0 ||
      waitpid(child, &status, 0) != child)
    return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
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
  const char *parent = getenv("TMPDIR");
  snprintf(folder, sizeof folder, "%s/asperity.XXXXXX", parent && *parent ? parent : "/tmp");
  if (!mkdtemp(folder))
    cli_fail("cannot make a temporary folder '%s': %s", folder, strerror(errno));
  cli_remove_later(CLI_FOLDER, folder);
  snprintf(table_path, sizeof table_path, "%s/table.csv", folder);
  snprintf(picture_path, sizeof picture_path, "%s/picture.%s", folder,
           ending_of(cli_value(call, "plot")));
  cli_remove_later(CLI_TABLE, table_path);
  cli_remove_later(CLI_PICTURE, picture_path);
  FILE *table = fopen(table_path, "w+");
  if (!table)
    cli_fail("cannot write '%s': %s", table_path, strerror(errno));
  return table;
}

static void copy(FILE *from, FILE *to) {
  char block[65536];
  for (size_t size; (size = fread(block, 1, sizeof block, from)) > 0;)
    fwrite(block, 1, size, to);
}

/* Draws the table at its path. */
static void draw(const cli_call *call, const char *name) {
  char script[PATH_MOST], title[TITLE_MOST];
  find_script(name, script);
  title_of(call, title);
  char *const arguments[] = {"gnuplot", "-d", "-c", script, table_path, picture_path, title, NULL};
  int status = run_program(arguments);
  FILE *picture = status == 0 ? fopen(picture_path, "rb") : NULL;
  if (!picture)
    cli_fail("gnuplot failed; no picture '%s' is drawn", cli_value(call, "plot"));
  FILE *out = cli_file_open(cli_value(call, "plot"));
  copy(picture, out);
  fclose(picture);
  cli_file_close(out);
  fprintf(stderr, "picture: %s\n", cli_value(call, "plot"));
}

void cli_plot_close(const cli_call *call, FILE *table, const char *script) {
  if (fflush(table) != 0 || ferror(table))
    cli_fail("cannot write '%s': %s", table_path, strerror(errno));
  draw(call, script);
  fclose(table);
  cli_clean_up();
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
  fflush(table);
  rewind(table);
  copy(table, out);
  cli_file_close(out);
  cli_plot_close(call, table, script);
}
