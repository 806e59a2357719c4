/* The line of progress, and the file that an early exit removes; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

static volatile sig_atomic_t line_shown;

void cli_erase_progress(void) {
  static const char blank[] = "\r                                        \r";
  if (line_shown && write(STDERR_FILENO, blank, sizeof blank - 1) > 0)
    line_shown = false;
}

/* Seconds on a monotonic clock. */
static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static char *volatile unfinished; /* a file, or NULL */

void cli_clean_up(void) {
  cli_erase_progress();
  if (unfinished)
    unlink(unfinished);
  unfinished = NULL;
}

static void end_by_signal(int number) {
  cli_clean_up();
  raise(number); /* the handler is gone */
}

void cli_remove_later(char *path) {
  static const int signals[] = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU, SIGXFSZ};
  static bool is_set_up;
  for (size_t i = 0; i < sizeof signals / sizeof *signals && !is_set_up; i++) {
    struct sigaction now, clean = {.sa_handler = end_by_signal, .sa_flags = (int)SA_RESETHAND};
    if (sigaction(signals[i], NULL, &now) == 0 && now.sa_handler != SIG_IGN)
      sigaction(signals[i], &clean, NULL);
  }
  is_set_up = is_set_up || atexit(cli_clean_up) == 0;
  unfinished = path;
}

cli_progress cli_progress_begin(const char *what, double total) {
  double now = seconds();
  cli_progress progress = {what, total, now, isatty(STDERR_FILENO) ? now - 1 : INFINITY};
  cli_remove_later(unfinished);
  cli_progress_show(&progress, 0);
  return progress;
}

void cli_progress_show(void *of, double done) {
  cli_progress *progress = of;
  double now = seconds(), share = fmin(1, done / progress->total);
  if (now - progress->shown < 0.1)
    return;
  char left[32] = "";
  double rest = share > 0 ? ceil((now - progress->begun) * (1 - share) / share) : INFINITY;
  if (rest < 60)
    snprintf(left, sizeof left, ", %.0f s left", rest);
  else if (rest < 6000)
    snprintf(left, sizeof left, ", %.0f min left", ceil(rest / 60));
  else if (share > 0)
    snprintf(left, sizeof left, ", %.1f h left", rest / 3600);
  line_shown = true;
  fprintf(stderr, "\r%.16s %3.0f %%%-16.16s", progress->what, 100 * share, left);
  progress->shown = now;
}

void cli_progress_end(cli_progress *progress) {
  progress->shown = INFINITY;
  cli_erase_progress();
}
