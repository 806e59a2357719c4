/* Files that are read; see file.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/file.h"
#include "base/error.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static FILE *refuse(const char *path, int reason, asp_error *error) {
  aspi_fail(error, reason == ENOMEM ? ASP_ENOMEM : ASP_EFILE, "cannot open '%.200s': %s", path,
            strerror(reason));
  return NULL;
}

/* All that comes out of a pipe, in a temporary file. */
static FILE *copy_of(FILE *pipe, const char *path, asp_error *error) {
  FILE *copy = tmpfile();
  char block[4096];
  size_t size;
  while (copy && (size = fread(block, 1, sizeof block, pipe)) > 0)
    if (fwrite(block, 1, size, copy) != size)
      break;
  if (!copy || ferror(pipe) || ferror(copy) || fseek(copy, 0, SEEK_SET) != 0) {
    refuse(path, errno, error);
    if (copy)
      fclose(copy);
    copy = NULL;
  }
  fclose(pipe);
  return copy;
}

/* A pipe opened without waiting: at its end already where nothing has it open for writing. */
static FILE *open_pipe(int handle, const char *path, asp_error *error) {
  char first;
  ssize_t got = read(handle, &first, 1);
  if (got == 0) {
    close(handle);
    aspi_fail(error, ASP_EFILE, "cannot read '%.200s': it is a pipe that nothing writes to", path);
    return NULL;
  }
  fcntl(handle, F_SETFL, fcntl(handle, F_GETFL) & ~O_NONBLOCK);
  FILE *stream = fdopen(handle, "rb");
  if (!stream) {
    int reason = errno;
    close(handle);
    return refuse(path, reason, error);
  }
  if (got > 0)
    ungetc((unsigned char)first, stream);
  return copy_of(stream, path, error);
}

/* Standard input as a file that can be read twice. */
static FILE *open_standard_input(asp_error *error) {
  struct stat found;
  int handle = dup(STDIN_FILENO);
  FILE *stream = handle < 0 ? NULL : fdopen(handle, "rb");
  if (!stream)
    return refuse("-", errno, error);
  bool is_file = fstat(handle, &found) == 0 && S_ISREG(found.st_mode);
  return is_file ? stream : copy_of(stream, "-", error);
}

FILE *aspi_file_open(const char *path, asp_error *error) {
  struct stat found;
  if (strcmp(path, "-") == 0)
    return open_standard_input(error);
  int handle = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (handle < 0)
    return refuse(path, errno, error);
  int reason = fstat(handle, &found) != 0 ? errno : S_ISDIR(found.st_mode) ? EISDIR : 0;
  if (!reason && S_ISFIFO(found.st_mode))
    return open_pipe(handle, path, error);
  FILE *stream = reason ? NULL : fdopen(handle, "rb");
  if (stream)
    return stream;
  reason = reason ? reason : errno;
  close(handle);
  return refuse(path, reason, error);
}
