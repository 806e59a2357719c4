/* Pictures by gnuplot: a pipe to it, a terminal chosen by the file's ending, and one look for all.
 * Nothing that a user wrote reaches gnuplot as a command: it draws to its standard output, which is
 * the file, so that no path is told to it; it reads no start-up files; and texts go through
 * cli_plot_label.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "base/number.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

enum { LABEL_MOST = 90 };

struct cli_plot {
  FILE *pipe;
  pid_t process;
  cli_file *file;
  const char *path;
  bool svg, titled;
  cli_label title;
  double range[2]; /* of the vertical axis; NAN where the picture has its own */
};

enum { SIDE_LEAST = 100, SIDE_MOST = 10000 };

/* What the options behind --plot say of a picture. */
static void read_look(const cli_option *option, cli_plot *plot, int size[2]) {
  plot->range[0] = plot->range[1] = NAN;
  if (!option[PLOT_TITLE].name || strcmp(option[PLOT_TITLE].name, "title") != 0)
    return;
  const char *sides = option[PLOT_SIZE].value, *range = option[PLOT_RANGE].value;
  char end;
  if (sides && (sscanf(sides, "%5dx%5d%c", &size[0], &size[1], &end) != 2 || size[0] < SIDE_LEAST ||
                size[1] < SIDE_LEAST || size[0] > SIDE_MOST || size[1] > SIDE_MOST))
    cli_bad_usage("--size is '%s'; it must be WIDTHxHEIGHT, each %d to %d pixels", sides,
                  SIDE_LEAST, SIDE_MOST);
  if (range) {
    char *colon, *last = NULL;
    plot->range[0] = aspi_number(range, &colon);
    plot->range[1] = *colon == ':' ? aspi_number(colon + 1, &last) : NAN;
    if (!last || *last || last == colon + 1 || !(plot->range[0] < plot->range[1]))
      cli_bad_usage("--range is '%s'; it must be FROM:TO, with FROM < TO", range);
  }
  plot->titled = option[PLOT_TITLE].value;
  if (plot->titled)
    plot->title = cli_plot_label(plot, option[PLOT_TITLE].value);
}

static const char *terminal_of(const cli_option *option) {
  const char *ending = strrchr(option->value, '.');
  if (ending && strcasecmp(ending, ".png") == 0)
    return "pngcairo size %d,%d font 'sans,11'";
  if (ending && strcasecmp(ending, ".svg") == 0)
    return "svg size %d,%d font 'sans,14' background 'white'";
  if (ending && strcasecmp(ending, ".pdf") == 0)
    return "pdfcairo size %d/96.,%d/96. font 'sans,11'";
  cli_bad_usage("--%s is '%s'; the file must end in .png, .svg or .pdf", option->name,
                option->value);
}

/* Gnuplot with one argument, its input and its output. */
static pid_t spawn(char *argument, int input, int output) {
  posix_spawn_file_actions_t actions;
  char *arguments[] = {"gnuplot", argument, NULL};
  pid_t process;
  if (posix_spawn_file_actions_init(&actions) != 0)
    cli_fail("cannot start gnuplot: %s", strerror(errno));
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  int status = posix_spawnp(&process, "gnuplot", &actions, NULL, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (status != 0)
    cli_fail("cannot start gnuplot: %s; is it installed? Debian: apt-get install gnuplot-nox",
             strerror(status));
  return process;
}

/* Waits for gnuplot, and exits where it failed. */
static void finish(pid_t process, const char *path) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (status != 0)
    cli_fail("gnuplot failed (status %d); no picture '%s' is drawn",
             WIFEXITED(status) ? WEXITSTATUS(status) : status, path);
}

/* A gnuplot that reads from the returned stream and writes to the plot's file. */
static FILE *start(cli_plot *plot) {
  int ends[2];
  if (pipe(ends) != 0 || fcntl(ends[1], F_SETFD, FD_CLOEXEC) != 0)
    cli_fail("cannot start gnuplot: %s", strerror(errno));
  plot->process = spawn("-d", ends[0], fileno(cli_file_stream(plot->file)));
  close(ends[0]);
  return fdopen(ends[1], "w");
}

void cli_plot_check(const cli_option *option) {
  cli_plot look = {.path = NULL};
  terminal_of(option);
  read_look(option, &look, (int[2]){0, 0});
  cli_file_check(option->value);
  int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing < 0)
    cli_fail("cannot open '/dev/null': %s", strerror(errno));
  finish(spawn("--version", nothing, nothing), option->value);
  close(nothing);
}

cli_plot *cli_plot_open(const cli_option *option, int width, int height) {
  const char *terminal = terminal_of(option);
  cli_plot *plot = cli_allocate(1, sizeof *plot);
  plot->path = option->value;
  plot->svg = strncmp(terminal, "svg", 3) == 0;
  int size[2] = {width, height};
  read_look(option, plot, size);
  plot->file = cli_file_open(option->value);
  signal(SIGPIPE, SIG_IGN);
  fflush(NULL);
  plot->pipe = start(plot);
  if (!plot->pipe)
    cli_fail("cannot start gnuplot: %s", strerror(errno));
  fputs("set term ", plot->pipe);
  fprintf(plot->pipe, terminal, size[0], size[1]);
  fputs("\nset grid lc rgb '#dddddd' lw 0.5\n"
        "set border lc rgb '#444444'\n"
        "set tics nomirror\n"
        "set key font ',10' spacing 1.1\n"
        /* Okabe & Ito's colours, which the colour-blind can tell apart; dashes for print. */
        "set style line 1 lc rgb '#0072b2' lw 2 dt 1\n"
        "set style line 2 lc rgb '#d55e00' lw 2 dt (12,3)\n"
        "set style line 3 lc rgb '#009e73' lw 2 dt (6,3)\n"
        "set style line 4 lc rgb '#cc79a7' lw 2 dt (12,3,3,3)\n"
        "set style line 5 lc rgb '#e69f00' lw 2 dt (3,3)\n"
        "set style line 6 lc rgb '#000000' lw 2 dt (18,3,3,3,3,3)\n",
        plot->pipe);
  return plot;
}

FILE *cli_plot_stream(cli_plot *plot) {
  return plot->pipe;
}

const char *cli_plot_title(const cli_plot *plot) {
  return plot->titled ? plot->title.text : NULL;
}

void cli_plot_range(const cli_plot *plot, double range[2]) {
  for (int i = 0; i < 2 && plot->range[1] > plot->range[0]; i++)
    range[i] = plot->range[i];
}

void cli_plot_set_range(const cli_plot *plot, double from, double to) {
  double range[2] = {from, to};
  cli_plot_range(plot, range);
  fputs("set yrange [", plot->pipe);
  for (int i = 0; i < 2; i++) {
    if (isfinite(range[i]))
      fprintf(plot->pipe, "%g", range[i]);
    else
      fputc('*', plot->pipe);
    fputs(i ? "]\n" : ":", plot->pipe);
  }
}

void cli_plot_close(cli_plot *plot) {
  fclose(plot->pipe);
  finish(plot->process, plot->path);
  cli_file_close(plot->file);
  fprintf(stderr, "picture: %s\n", plot->path);
  free(plot);
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

/* What stands for a character in a string of gnuplot's enhanced text in single quotes: its marks
 * get a backslash; quotes are written by their codes, so that no text can end the string. */
static const char *replacement(const cli_plot *plot, char c) {
  static const struct {
    char from;
    const char *to;
  } list[] = {{'\'', "\\047"}, {'`', "\\140"}, {'\\', "\\\\"}, {'^', "\\^"}, {'_', "\\_"},
              {'{', "\\{"},    {'}', "\\}"},   {'@', "\\@"},   {'~', "\\~"}};
  if (c == '&')
    return plot->svg ? "\\&amp;" : "\\&";
  for (size_t i = 0; i < sizeof list / sizeof *list; i++)
    if (list[i].from == c)
      return list[i].to;
  return NULL;
}

cli_label cli_plot_label(const cli_plot *plot, const char *text) {
  cli_label label = {""};
  char *out = label.text;
  const char *end = text + strlen(text), *cut = end - text > LABEL_MOST ? text + LABEL_MOST : end;
  while (text < cut) {
    size_t length = character_length(text);
    bool control = length == 1 && ((unsigned char)*text < 0x20 || *text == 0x7f);
    const char *other = length == 0 ? "?" : control ? " " : replacement(plot, *text);
    length += length == 0;
    size_t put = other ? strlen(other) : length;
    memcpy(out, other ? other : text, put);
    out += put;
    text += length;
  }
  strcpy(out, text < end ? "..." : "");
  return label;
}
