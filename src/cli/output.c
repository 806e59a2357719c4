/* Files that are written whole or not at all, and the CSV output of the commands; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LINKS_MOST = 40, SUFFIX_MOST = 40 };

typedef struct file {
  FILE *stream;     /* NULL: closed */
  const char *path; /* as given */
  char *target;     /* what is replaced */
  char *partial;    /* NULL where the stream is written to directly, or once it is closed */
  struct file *next;
} file;

/* All, so that an exit can remove their partial files. */
static file *files;

static void remove_partials(void) {
  for (file *f = files; f; f = f->next)
    if (f->partial)
      unlink(f->partial);
}

/* Target of a symbolic link, through any chain of links, even if nothing exists there yet. */
static char *follow_links(const char *path) {
  char *at = cli_copy(path), link[4096];
  for (int i = 0; i < LINKS_MOST; i++) {
    ssize_t length = readlink(at, link, sizeof link - 1);
    if (length < 0)
      return at;
    link[length] = '\0';
    const char *slash = strrchr(at, '/');
    int folder = *link == '/' || !slash ? 0 : (int)(slash + 1 - at);
    size_t size = (size_t)folder + (size_t)length + 1;
    char *next = cli_allocate(size, 1);
    snprintf(next, size, "%.*s%s", folder, at, link);
    free(at);
    at = next;
  }
  cli_fail("cannot write '%s': %s", path, strerror(ELOOP));
}

/* True if a file must not be replaced by another one: a device, a pipe, standard output. */
static bool stays(const struct stat *found) {
  struct stat out;
  return !S_ISREG(found->st_mode) || (fstat(STDOUT_FILENO, &out) == 0 && S_ISREG(out.st_mode) &&
                                      out.st_dev == found->st_dev && out.st_ino == found->st_ino);
}

static FILE *open_partial(file *f, mode_t mode) {
  size_t size = strlen(f->target) + SUFFIX_MOST;
  char *partial = cli_allocate(size, 1);
  snprintf(partial, size, "%s.%ld.partial", f->target, (long)getpid());
  int handle = open(partial, O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (handle < 0)
    return NULL;
  f->partial = partial;
  if (mode)
    fchmod(handle, mode);
  return fdopen(handle, "w");
}

FILE *cli_file_open(const char *path) {
  if (!path || strcmp(path, "-") == 0)
    return stdout;
  if (!files)
    atexit(remove_partials);
  struct stat found;
  bool exists = stat(path, &found) == 0;
  file *f = cli_allocate(1, sizeof *f);
  *f = (file){.path = path, .target = follow_links(path), .next = files};
  if (exists && stays(&found))
    f->stream = S_ISREG(found.st_mode) ? stdout : fopen(path, "w");
  else
    f->stream = open_partial(f, exists ? found.st_mode & 0777 : 0);
  if (!f->stream)
    cli_fail("cannot write '%s': %s", path, strerror(errno));
  return (files = f)->stream;
}

void cli_file_check(const char *path) {
  struct stat found;
  bool direct = stat(path, &found) == 0 && stays(&found);
  if (direct && access(path, W_OK) != 0) /* a pipe may be opened once only */
    cli_fail("cannot write '%s': %s", path, strerror(errno));
  if (direct)
    return;
  fclose(cli_file_open(path));
  unlink(files->partial);
  files->stream = NULL;
  files->partial = NULL;
}

void cli_file_close(FILE *stream) {
  file *f = files;
  while (f && f->stream != stream)
    f = f->next;
  bool bad = fflush(stream) != 0 || ferror(stream);
  if (stream != stdout)
    bad = fclose(stream) != 0 || bad;
  bad = bad || (f && f->partial && rename(f->partial, f->target) != 0);
  if (bad && !f)
    cli_fail("cannot write standard output: %s", strerror(errno));
  if (bad)
    cli_fail("cannot write '%s': %s", f->path, strerror(errno));
  if (f)
    f->stream = NULL, f->partial = NULL;
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

FILE *cli_output_open(const cli_call *call, const char *option, const char *description) {
  FILE *out = cli_file_open(cli_value(call, option));
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
  return out;
}

/* Texts of numbers, longer than any of them. */
enum { NUMBER_MOST = 40 };

/* Writes a number as printf's %.*g does, where that has no exponent; 0: it may have one, or the
 * last digit is too near a tie to be sure of. The digits come from one multiplication, which is
 * right to 1e-16 of the number. */
static size_t print_plainly(char *to, double value, int digits) {
  static const double power[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6, 1e7,
                                 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14};
  double size = fabs(value);
  int exponent = digits - 1;
  if (!(size >= 1e-4 && size < power[digits - 1]) || digits > 10)
    return 0;
  while (exponent > 0 && size < power[exponent])
    exponent--;
  while (exponent > -4 && size * power[-(exponent < 0 ? exponent : 0)] < 1)
    exponent--;
  double scaled = size * power[digits - 1 - exponent], whole = floor(scaled);
  double rest = scaled - whole;
  unsigned long long number = (unsigned long long)whole + (rest > 0.5);
  if (fabs(rest - 0.5) < 1e-4 || number >= (unsigned long long)power[digits])
    return 0;
  char text[NUMBER_MOST];
  int last = digits;
  for (int i = digits - 1; i >= 0; i--, number /= 10)
    text[i] = (char)('0' + number % 10);
  while (last > 1 && last > exponent + 1 && text[last - 1] == '0')
    last--;
  char *at = to;
  if (value < 0)
    *at++ = '-';
  for (int i = exponent < 0 ? exponent : 0; i < last; i++) {
    if (i == exponent + 1 && at > to && at[-1] != '-')
      *at++ = '.';
    *at++ = i < 0 ? '0' : text[i];
  }
  return (size_t)(at - to);
}

void cli_print_number(FILE *out, double value, int digits) {
  char text[NUMBER_MOST];
  if (!isfinite(value))
    return;
  size_t length = print_plainly(text, value, digits);
  if (length > 0)
    fwrite(text, 1, length, out);
  else
    fprintf(out, "%.*g", digits, value);
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
