/* Preloaded into the launcher, makes the core's memory run out: of the allocations that the program
 * itself and GSL ask for, that of number FAIL_MEMORY_AT fails, and all after it. At the end their
 * number goes to the file FAIL_MEMORY_COUNT. Those of the engine, of MPI and of C++ go on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE
#include <errno.h>
#include <link.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);

/* Where the code of the program and of GSL lies. */
static struct { uintptr_t begin, end; } watched[2];
static int n_watched;
static long seen, fail_at;

static int note(struct dl_phdr_info *info, size_t size, void *data) {
  (void)size;
  (void)data;
  if (n_watched == 2 || (*info->dlpi_name && !strstr(info->dlpi_name, "libgsl.")))
    return 0;
  uintptr_t begin = UINTPTR_MAX, end = 0;
  for (int i = 0; i < info->dlpi_phnum; i++) {
    uintptr_t at = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
    if (info->dlpi_phdr[i].p_type != PT_LOAD)
      continue;
    begin = at < begin ? at : begin;
    end = at + info->dlpi_phdr[i].p_memsz > end ? at + info->dlpi_phdr[i].p_memsz : end;
  }
  watched[n_watched].begin = begin;
  watched[n_watched++].end = end;
  return 0;
}

__attribute__((constructor)) static void start(void) {
  const char *at = getenv("FAIL_MEMORY_AT");
  if (strcmp(program_invocation_short_name, "liggghts-asperity") != 0)
    return; /* a helper of MPI */
  fail_at = at ? atol(at) : 0;
  dl_iterate_phdr(note, NULL);
}

__attribute__((destructor)) static void report(void) {
  const char *path = getenv("FAIL_MEMORY_COUNT");
  FILE *file = path && n_watched > 0 ? fopen(path, "w") : NULL;
  if (file) {
    fprintf(file, "%ld\n", seen);
    fclose(file);
  }
}

static int fails(void *caller) {
  uintptr_t at = (uintptr_t)caller;
  for (int i = 0; i < n_watched; i++)
    if (at >= watched[i].begin && at < watched[i].end && ++seen >= fail_at && fail_at > 0) {
      errno = ENOMEM;
      return 1;
    }
  return 0;
}

void *malloc(size_t size) {
  return fails(__builtin_return_address(0)) ? NULL : __libc_malloc(size);
}

void *calloc(size_t count, size_t size) {
  return fails(__builtin_return_address(0)) ? NULL : __libc_calloc(count, size);
}

void *realloc(void *memory, size_t size) {
  return fails(__builtin_return_address(0)) ? NULL : __libc_realloc(memory, size);
}
