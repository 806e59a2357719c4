/* The tests of a file, each listed by TEST(its_name) before main() begins; see check.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"

static struct CMUnitTest tests[64];
static size_t count;

void list_test(const char *name, CMUnitTestFunction run, CMFixtureFunction before,
               CMFixtureFunction after) {
  tests[count++] = (struct CMUnitTest){name, run, before, after ? after : tell_row, NULL};
}

int run_listed_tests(CMFixtureFunction before, CMFixtureFunction after) {
  return _cmocka_run_group_tests("tests", tests, count, before, after);
}
