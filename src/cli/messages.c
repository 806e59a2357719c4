/* Lines on stderr, exits with a message, and memory or an exit; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/grow.h"
#include "cli/cli.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void print_message(const char *kind, const char *format, va_list args) {
  const char *plain = getenv("NO_COLOR");
  bool color = *kind && isatty(STDERR_FILENO) && !(plain && *plain);
  cli_erase_progress();
  fprintf(stderr, color ? "asperity: \033[33m%s\033[0m" : "asperity: %s", kind);
  vfprintf(stderr, format, args);
  fputc('\n', stderr);
}

void cli_bad_usage(const char *format, ...) {
  va_list args;
  va_start(args, format);
  print_message("", format, args);
  va_end(args);
  exit(2);
}

void cli_fail(const char *format, ...) {
  va_list args;
  va_start(args, format);
  print_message("", format, args);
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
  print_message("warning: ", format, args);
  va_end(args);
}
