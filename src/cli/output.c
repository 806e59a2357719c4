/* Files that are written whole or not at all, and the CSV output of the commands; see cli.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LINKS_MOST = 40, SUFFIX_MOST = 40 };

struct cli_file {
  FILE *stream;
  char *path;    /* as given */
  char *target;  /* what is replaced */
  char *partial; /* NULL where the stream is written to directly */
  cli_file *next;
};

/* Those that are open, so that an exit can remove their partial files. */
static cli_file *open_files;

static void remove_partials(void) {
  for (cli_file *file = open_files; file; file = file->next)
    if (file->partial)
      unlink(file->partial);
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

static FILE *open_partial(cli_file *file, mode_t mode) {
  size_t size = strlen(file->target) + SUFFIX_MOST;
  char *partial = cli_allocate(size, 1);
  snprintf(partial, size, "%s.%ld.partial", file->target, (long)getpid());
  int handle = open(partial, O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (handle < 0)
    return NULL;
  file->partial = partial;
  if (mode)
    fchmod(handle, mode);
  return fdopen(handle, "w");
}

cli_file *cli_file_open(const char *path) {
  static bool registered;
  if (!registered)
    registered = atexit(remove_partials) == 0;
  cli_file *file = cli_allocate(1, sizeof *file);
  struct stat found;
  bool exists = stat(path, &found) == 0;
  file->path = cli_copy(path);
  file->target = follow_links(path);
  if (exists && stays(&found))
    file->stream = S_ISREG(found.st_mode) ? stdout : fopen(path, "w");
  else
    file->stream = open_partial(file, exists ? found.st_mode & 0777 : 0);
  if (!file->stream)
    cli_fail("cannot write '%s': %s", path, strerror(errno));
  file->next = open_files;
  open_files = file;
  return file;
}

void cli_file_check(const char *path) {
  struct stat found;
  if (stat(path, &found) != 0 || !stays(&found)) {
    cli_file_drop(cli_file_open(path));
    return;
  }
  if (access(path, W_OK) != 0) /* a pipe may be opened once only */
    cli_fail("cannot write '%s': %s", path, strerror(errno));
}

void cli_keep_input(const cli_option *options, const char *input) {
  struct stat in, out;
  for (const cli_option *o = options; o->name; o++) {
    bool written = strcmp(o->name, "output") == 0 || strcmp(o->name, "plot") == 0;
    if (written && o->value && stat(input, &in) == 0 && S_ISREG(in.st_mode) &&
        stat(o->value, &out) == 0 && in.st_dev == out.st_dev && in.st_ino == out.st_ino)
      cli_bad_usage("--%s is '%s', which is read; it must be another file", o->name, o->value);
  }
}

FILE *cli_file_stream(const cli_file *file) {
  return file->stream;
}

static void forget(cli_file *file) {
  for (cli_file **at = &open_files; *at; at = &(*at)->next)
    if (*at == file) {
      *at = file->next;
      break;
    }
  free(file->path);
  free(file->target);
  free(file->partial);
  free(file);
}

void cli_file_close(cli_file *file) {
  bool bad = fflush(file->stream) != 0 || ferror(file->stream);
  if (file->stream != stdout)
    bad = fclose(file->stream) != 0 || bad;
  bad = bad || (file->partial && rename(file->partial, file->target) != 0);
  if (bad)
    cli_fail("cannot write '%s': %s", file->path, strerror(errno));
  forget(file);
}

void cli_file_drop(cli_file *file) {
  if (file->stream != stdout)
    fclose(file->stream);
  if (file->partial)
    unlink(file->partial);
  forget(file);
}

struct cli_output {
  cli_file *file; /* NULL: standard output */
  FILE *stream;
};

void cli_print_comment(FILE *out, const char *text) {
  for (; *text; text++)
    if ((unsigned char)*text < 0x20 || *text == 0x7f)
      fprintf(out, "\\x%02x", (unsigned)*text);
    else
      fputc(*text, out);
}

void cli_print_field(FILE *out, const char *text) {
  if (!strpbrk(text, ",;#\" \t")) {
    fputs(text, out);
    return;
  }
  fputc('"', out);
  for (; *text; text++) {
    if (*text == '"')
      fputc('"', out);
    fputc(*text, out);
  }
  fputc('"', out);
}

cli_output *cli_output_open(const char *path, int argc, char **argv, const char *description) {
  cli_output *output = cli_allocate(1, sizeof *output);
  if (path && strcmp(path, "-") != 0)
    output->file = cli_file_open(path);
  FILE *out = output->stream = output->file ? cli_file_stream(output->file) : stdout;
  fprintf(out, "# asperity %s;", asp_version());
  for (int i = 0; i < argc; i++) {
    fputc(' ', out);
    cli_print_comment(out, argv[i]);
  }
  if (description) {
    fputs("; ", out);
    cli_print_comment(out, description);
  }
  fputc('\n', out);
  return output;
}

FILE *cli_output_stream(cli_output *output) {
  return output->stream;
}

void cli_output_close(cli_output *output) {
  if (output->file)
    cli_file_close(output->file);
  else if (fflush(stdout) != 0 || ferror(stdout))
    cli_fail("cannot write standard output: %s", strerror(errno));
  free(output);
}
