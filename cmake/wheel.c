/* The static GSL reaches stdout and stderr as the code of a program may, and that of a shared
 * library may not: in the wheel's library it has these in their place (cmake/wheel.cmake).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

FILE *asperity_stdout, *asperity_stderr;

__attribute__((constructor)) static void take_streams(void) {
  asperity_stdout = stdout;
  asperity_stderr = stderr;
}
