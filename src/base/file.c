/* Files that are read; see file.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/file.h"
#include "base/error.h"

#include <errno.h>
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

FILE *aspi_file_open(const char *path, asp_error *error) {
  struct stat found;
  FILE *stream = strcmp(path, "-") == 0 ? fdopen(dup(STDIN_FILENO), "rb") : fopen(path, "rbe");
  int reason = !stream || fstat(fileno(stream), &found) != 0 ? errno
               : S_ISDIR(found.st_mode)                      ? EISDIR
                                                             : 0;
  if (!reason)
    return S_ISREG(found.st_mode) ? stream : copy_of(stream, path, error);
  if (stream)
    fclose(stream);
  return refuse(path, reason, error);
}
