/* A program in both C and C++ that links all that the library needs: prints its version and the
 * slope of a wall. SPDX-License-Identifier: GPL-3.0-or-later */
#include <asperity.h>
#include <stdio.h>

int main(void) {
  asp_error error;
  asp_wall *wall =
      asp_wall_from_text("surface rq 5um lambda_c 40um materials quartz 304-ss", 0, 0, &error);
  if (!wall) {
    fprintf(stderr, "%s\n", error.text);
    return 1;
  }
  printf("asperity %s: slope %.3f\n", asp_version(), asp_wall_slope(wall, 1e-5));
  asp_wall_free(wall);
  return 0;
}
