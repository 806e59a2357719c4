/* The table of the ledger's columns on the page of the fix, row by row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/ledger_columns.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#define COLUMN(ID, name, type, text) {name, text},
static const struct {
  const char *name, *text;
} columns[] = {LEDGER_COLUMNS(COLUMN) LEDGER_MORE_COLUMNS(COLUMN)};

static void page_has_them(void **state) {
  (void)state;
  static const char heading[] = "| column | name |";
  const char *path = getenv("ASPERITY_TEST_PAGE");
  assert_non_null(path);
  FILE *page = fopen(path, "r");
  assert_non_null(page);
  static char line[1 << 14];
  char expected[400];
  while (fgets(line, sizeof line, page) && strncmp(line, heading, strlen(heading)) != 0)
    ;
  assert_non_null(fgets(line, sizeof line, page)); /* under the heading */
  for (int i = 0; i < LEDGER_N_FULL; i++) {
    snprintf(expected, sizeof expected, "| %d | `%s` | %s |\n", i + 1, columns[i].name,
             columns[i].text);
    assert_non_null(fgets(line, sizeof line, page));
    assert_string_equal(line, expected);
  }
  assert_non_null(fgets(line, sizeof line, page));
  assert_string_equal(line, "\n");
  fclose(page);
}

/* The places that scripts, dumps and measurements of years rely on. */
static void places_stay(void **state) {
  (void)state;
  assert_int_equal(LEDGER_N_COLUMNS, 19);
  assert_int_equal(LEDGER_ALPHA1, 10);
  assert_int_equal(LEDGER_COR_N, 16);
  assert_int_equal(LEDGER_OUTCOME, 18);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(page_has_them),
                                     cmocka_unit_test(places_stay)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
