/* Preloaded into the launcher: allocations of FAIL_FROM to FAIL_TO bytes fail.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <stdlib.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);

static int fails(size_t size) {
  const char *from = getenv("FAIL_FROM"), *to = getenv("FAIL_TO");
  if (!from || !to || size < strtoul(from, NULL, 10) || size > strtoul(to, NULL, 10))
    return 0;
  errno = ENOMEM;
  return 1;
}

void *malloc(size_t size) {
  return fails(size) ? NULL : __libc_malloc(size);
}

void *calloc(size_t count, size_t size) {
  return fails(count * size) ? NULL : __libc_calloc(count, size);
}

void *realloc(void *memory, size_t size) {
  return fails(size) ? NULL : __libc_realloc(memory, size);
}
