/* Pictures by gnuplot: the table in a temporary folder, the script that draws it, and a copy of the
 * picture; see plot.h. Names and titles of users reach gnuplot as arguments of the script, which
 * are never read as commands, and it reads no start-up files.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/plot.h"
#include "base/number.h"

#include <errno.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SIDE_LEAST = 100, SIDE_MOST = 10000, PATH_MOST = 4096, TITLE_MOST = 600 };

extern char **environ;

/* The folder with the table and the picture, "" where there is none. */
static char folder[PATH_MOST], table_path[PATH_MOST + 20], picture_path[PATH_MOST + 20];

static void remove_folder(void) {
  unlink(table_path);
  unlink(picture_path);
  rmdir(folder);
}

/* png, svg or pdf. */
static const char *ending_of(const char *path) {
  static const char *const endings[] = {"png", "svg", "pdf"};
  const char *ending = strrchr(path, '.');
  for (int i = 0; ending && i < 3; i++)
    if (strcasecmp(ending + 1, endings[i]) == 0)
      return endings[i];
  cli_bad_usage("--plot is '%s'; the file must end in .png, .svg or .pdf", path);
}

/* Exits if --size or --range cannot be read. */
static void check_look(const cli_call *call) {
  const char *size = cli_value(call, "size"), *range = cli_value(call, "range");
  int width = 0, height = 0;
  char end, *colon, *last = NULL;
  if (size && (sscanf(size, "%5dx%5d%c", &width, &height, &end) != 2 || width < SIDE_LEAST ||
               height < SIDE_LEAST || width > SIDE_MOST || height > SIDE_MOST))
    cli_bad_usage("--size is '%s'; it must be WIDTHxHEIGHT, each %d to %d pixels", size, SIDE_LEAST,
                  SIDE_MOST);
  if (!range)
    return;
  double from = aspi_number(range, &colon), to = 0;
  if (*colon == ':')
    to = aspi_number(colon + 1, &last);
  if (!last || *last || last == colon + 1 || !(from < to))
    cli_bad_usage("--range is '%s'; it must be FROM:TO, with FROM < TO", range);
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
  check_look(call);
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

/* The bytes of the UTF-8 character that a text begins with; 0 where it is none. */
static size_t character_length(const char *text) {
  const unsigned char *c = (const unsigned char *)text;
  size_t length = *c < 0x80 ? 1 : *c >= 0xc2 && *c < 0xe0 ? 2 : (*c & 0xf0) == 0xe0 ? 3 : 4;
  if (length == 4 && !(*c >= 0xf0 && *c < 0xf5))
    return 0;
  for (size_t i = 1; i < length; i++)
    if ((c[i] & 0xc0) != 0x80)
      return 0;
  return length;
}

/* Appends a word to a title: blanks for control characters, ? for bytes that are no text. */
static void add_word(char title[TITLE_MOST], const char *text) {
  size_t used = strlen(title);
  if (used)
    title[used++] = ' ';
  while (*text && used + 8 < TITLE_MOST) {
    size_t length = character_length(text);
    bool control = (unsigned char)*text < 0x20 || *text == 0x7f;
    if (length == 0 || control)
      title[used++] = control ? ' ' : '?';
    else
      memcpy(title + used, text, length);
    used += length > 0 && !control ? length : 0;
    text += length ? length : 1;
  }
  strcpy(title + used, *text ? "..." : "");
}

/* --title, or the command as given, without the files that it writes. */
static void title_of(const cli_call *call, char title[TITLE_MOST]) {
  static const char *const left_out[] = {"-o", "--output", "--plot", "--save", "--size", "--range"};
  *title = '\0';
  if (cli_value(call, "title")) {
    add_word(title, cli_value(call, "title"));
    return;
  }
  for (int i = 0; i < call->argc; i++) {
    bool shown = true;
    for (size_t k = 0; k < sizeof left_out / sizeof *left_out; k++)
      shown = shown && strcmp(call->argv[i], left_out[k]) != 0;
    if (shown)
      add_word(title, call->argv[i]);
    else
      i++;
  }
}

FILE *cli_plot_open(const cli_call *call) {
  const char *parent = getenv("TMPDIR");
  snprintf(folder, sizeof folder, "%s/asperity.XXXXXX", parent && *parent ? parent : "/tmp");
  if (!mkdtemp(folder))
    cli_fail("cannot make a temporary folder '%s': %s", folder, strerror(errno));
  snprintf(table_path, sizeof table_path, "%s/table.csv", folder);
  snprintf(picture_path, sizeof picture_path, "%s/picture.%s", folder,
           ending_of(cli_value(call, "plot")));
  atexit(remove_folder);
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
  const char *size = cli_value(call, "size"), *range = cli_value(call, "range");
  find_script(name, script);
  title_of(call, title);
  char *const arguments[] = {"gnuplot",
                             "-d",
                             "-c",
                             script,
                             table_path,
                             picture_path,
                             title,
                             (char *)(size ? size : ""),
                             (char *)(range ? range : ""),
                             NULL};
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
  remove_folder();
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
