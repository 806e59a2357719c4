/* Pictures by gnuplot: a pipe to it, a terminal chosen by the file's ending, and one look for all.
 */
#include "cli/cli.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

struct cli_plot {
  FILE *pipe;
  char *path;
};

static const char *terminal_of(const cli_option *option) {
  const char *ending = strrchr(option->value, '.');
  if (ending && strcmp(ending, ".png") == 0)
    return "pngcairo size %d,%d font 'sans,11'";
  if (ending && strcmp(ending, ".svg") == 0)
    return "svg size %d,%d font 'sans,14' background 'white'";
  if (ending && strcmp(ending, ".pdf") == 0)
    return "pdfcairo size %d/96.,%d/96. font 'sans,11'";
  cli_bad_usage("--%s is '%s'; the file must end in .png, .svg or .pdf", option->name,
                option->value);
}

cli_plot *cli_plot_open(const cli_option *option, int width, int height) {
  const char *terminal = terminal_of(option);
  FILE *probe = fopen(option->value, "ab");
  if (!probe)
    cli_fail("cannot write '%s': %s", option->value, strerror(errno));
  fclose(probe);
  cli_plot *plot = malloc(sizeof *plot);
  if (!plot || !(plot->path = strdup(option->value)))
    cli_fail("out of memory");
  signal(SIGPIPE, SIG_IGN);
  fflush(NULL);
  plot->pipe = popen("gnuplot", "w");
  if (!plot->pipe)
    cli_fail("cannot start gnuplot: %s", strerror(errno));
  fputs("set term ", plot->pipe);
  fprintf(plot->pipe, terminal, width, height);
  fprintf(plot->pipe,
          "\nset output '%s'\n"
          "set grid lc rgb '#dddddd' lw 0.5\n"
          "set border lc rgb '#444444'\n"
          "set tics nomirror\n"
          "set key font ',10' spacing 1.1\n"
          "set style line 1 lc rgb '#1f5fa8' lw 2\n"
          "set style line 2 lc rgb '#c8501e' lw 2\n"
          "set style line 3 lc rgb '#2a8c4a' lw 2\n"
          "set style line 4 lc rgb '#7a3fa0' lw 2\n"
          "set style line 5 lc rgb '#8a6d1b' lw 2\n"
          "set style line 6 lc rgb '#444444' lw 2\n",
          plot->path);
  return plot;
}

FILE *cli_plot_stream(cli_plot *plot) {
  return plot->pipe;
}

void cli_plot_close(cli_plot *plot) {
  int status = pclose(plot->pipe);
  if (status != 0)
    cli_fail("gnuplot failed (status %d); is it installed? Debian: apt-get install gnuplot-nox",
             WIFEXITED(status) ? WEXITSTATUS(status) : status);
  fprintf(stderr, "picture: %s\n", plot->path);
  free(plot->path);
  free(plot);
}
