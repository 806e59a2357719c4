/* Runs the tests of a file that has no main() of its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"

int main(void) {
  return run_listed_tests(NULL, NULL);
}
