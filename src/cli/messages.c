/* Lines on stderr, exits with a message, memory or an exit, and progress; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/grow.h"
#include "cli/cli.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static void say(const char *kind, const char *format, va_list args) {
  fprintf(stderr, "asperity: %s", kind);
  vfprintf(stderr, format, args);
  fputc('\n', stderr);
}

void cli_bad_usage(const char *format, ...) {
  va_list args;
  va_start(args, format);
  say("", format, args);
  va_end(args);
  exit(2);
}

void cli_fail(const char *format, ...) {
  va_list args;
  va_start(args, format);
  say("", format, args);
  va_end(args);
  exit(1);
}

void *cli_allocate(size_t count, size_t size) {
  void *memory = calloc(count ? count : 1, size);
  if (!memory)
    cli_fail("out of memory for %zu numbers or rows of %zu bytes", count, size);
  return memory;
}

void *cli_grow(void *array, size_t count, size_t size) {
  array = aspi_grow(array, count, size);
  if (!array)
    cli_fail("out of memory for over %zu numbers or rows of %zu bytes", count, size);
  return array;
}

char *cli_copy(const char *text) {
  return strcpy(cli_allocate(strlen(text) + 1, 1), text);
}

asp_error cli_error;

void cli_must(bool good) {
  if (good)
    return;
  if (cli_error.code == ASP_ENOMEM)
    cli_fail("%s", cli_error.text);
  cli_bad_usage("%s", cli_error.text);
}

void *cli_made(void *thing) {
  cli_must(thing);
  return thing;
}

void cli_warn(const char *format, ...) {
  va_list args;
  va_start(args, format);
  say("warning: ", format, args);
  va_end(args);
}

/* Seconds on a monotonic clock. */
static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

cli_progress cli_progress_begin(const char *what, double total) {
  double now = seconds();
  return (cli_progress){what, total, now, isatty(STDERR_FILENO) ? now : INFINITY};
}

void cli_progress_show(void *of, double done) {
  cli_progress *progress = of;
  double now = seconds();
  if (now - progress->begun < 1 || now - progress->shown < 0.1)
    return;
  fprintf(stderr, "\r%s %3.0f %%", progress->what, 100 * fmin(1, done / progress->total));
  progress->shown = now;
}

void cli_progress_end(cli_progress *progress) {
  if (isfinite(progress->shown) && progress->shown > progress->begun)
    fprintf(stderr, "\r%*s\r", (int)strlen(progress->what) + 6, "");
}
