/* Files that are written whole or not at all, and the CSV output of the commands; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"
#include "cli/cli.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { SUFFIX_MOST = 40 };

/* The name of the file that is written; there is one at a time. */
static const char *written;

/* Its temporary file until it is complete; NULL: none. */
static char *partial;

/* True if a file cannot be replaced: a device, a pipe, standard output. */
static bool stays(const struct stat *found) {
  struct stat out;
  return !S_ISREG(found->st_mode) || (fstat(STDOUT_FILENO, &out) == 0 && S_ISREG(out.st_mode) &&
                                      out.st_dev == found->st_dev && out.st_ino == found->st_ino);
}

static FILE *open_partial(const char *path) {
  size_t size = strlen(path) + SUFFIX_MOST;
  char *name = cli_allocate(size, 1);
  snprintf(name, size, "%s.%ld.partial", path, (long)getpid());
  cli_remove_later(name); /* before it is there: a signal leaves nothing */
  FILE *stream = fopen(name, "wxe");
  partial = stream ? name : NULL;
  cli_remove_later(partial);
  return stream;
}

FILE *cli_file_open(const char *path) {
  struct stat found;
  written = path;
  if (!path || strcmp(path, "-") == 0)
    return stdout;
  bool direct = stat(path, &found) == 0 && stays(&found);
  FILE *stream = !direct ? open_partial(path) : S_ISREG(found.st_mode) ? stdout : fopen(path, "w");
  if (!stream)
    cli_fail("cannot write '%s': %s", path, strerror(errno));
  return stream;
}

void cli_file_check(const char *path) {
  struct stat found;
  bool direct = stat(path, &found) == 0 && stays(&found);
  if (direct && access(path, W_OK) != 0) /* a pipe may be opened once only */
    cli_fail("cannot write '%s': %s", path, strerror(errno));
  if (direct)
    return;
  fclose(cli_file_open(path));
  cli_clean_up();
  partial = NULL;
}

void cli_file_close(FILE *stream) {
  bool bad = fflush(stream) != 0 || ferror(stream);
  if (stream != stdout)
    bad = fclose(stream) != 0 || bad;
  if (bad || (partial && rename(partial, written) != 0))
    cli_fail("cannot write %s: %s", written ? written : "standard output", strerror(errno));
  partial = NULL;
  cli_remove_later(NULL);
}

void cli_print_comment(FILE *out, const char *text) {
  for (; *text; text++)
    if ((unsigned char)*text < 0x20 || *text == 0x7f)
      fprintf(out, "\\x%02x", (unsigned)*text);
    else
      fputc(*text, out);
}

void cli_print_quoted(FILE *out, const char *text) {
  fputc('"', out);
  for (; *text; text++) {
    if (*text == '"')
      fputc('"', out);
    fputc(*text, out);
  }
  fputc('"', out);
}

void cli_print_heading(FILE *out, const cli_call *call, const char *description) {
  fprintf(out, "# asperity %s;", asp_version());
  for (int i = 0; i < call->argc; i++) {
    fputc(' ', out);
    cli_print_comment(out, call->argv[i]);
  }
  if (description) {
    fputs("; ", out);
    cli_print_comment(out, description);
  }
  fputc('\n', out);
}

FILE *cli_output_open(const cli_call *call, const char *option, const char *description) {
  FILE *out = cli_file_open(cli_value(call, option));
  cli_print_heading(out, call, description);
  return out;
}

void cli_print_number(FILE *out, double value, int digits) {
  char text[ASPI_NUMBER_MOST];
  if (isfinite(value))
    fwrite(text, 1, (size_t)(aspi_number_format(value, digits, text) - text), out);
}

void cli_row(FILE *out, const char *format, ...) {
  va_list args;
  va_start(args, format);
  while (*format) {
    char one[64];
    size_t length = strcspn(format, ",\n");
    size_t kept = length < sizeof one ? length : sizeof one - 1;
    memcpy(one, format, kept);
    one[kept] = '\0';
    char kind = *one == '%' ? one[length - 1] : '\0';
    if (kind == 's') {
      const char *text = va_arg(args, const char *);
      if (strpbrk(text, ",;#\" \t"))
        cli_print_quoted(out, text);
      else
        fputs(text, out);
    } else if (kind == 'd') {
      fprintf(out, one, va_arg(args, int));
    } else if (kind == 'u') {
      fprintf(out, one, va_arg(args, size_t));
    } else if (kind) {
      double value = va_arg(args, double);
      if (length == 4 && strncmp(one, "%.6g", 4) == 0)
        cli_print_number(out, value, 6);
      else if (isfinite(value))
        fprintf(out, one, value);
    } else {
      fputs(one, out);
    }
    format += length;
    if (*format)
      fputc(*format++, out);
  }
  va_end(args);
}
