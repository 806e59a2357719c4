/* The table of the ledger's columns in the pages of the fix, row by row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/ledger_columns.h"

#include <setjmp.h>
#include <stdbool.h>
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

/* Each row in a form of its own: Markdown, or a table of comma-separated values. */
static void has_rows(const char *variable, const char *heading, bool markdown) {
  const char *path = getenv(variable);
  assert_non_null(path);
  FILE *page = fopen(path, "r");
  assert_non_null(page);
  static char line[1 << 14];
  char expected[400];
  while (fgets(line, sizeof line, page) && strncmp(line, heading, strlen(heading)) != 0)
    ;
  assert_non_null(fgets(line, sizeof line, page)); /* under the heading */
  for (int i = 0; i < LEDGER_N_FULL; i++) {
    if (markdown)
      snprintf(expected, sizeof expected, "| %d | `%s` | %s |\n", i + 1, columns[i].name,
               columns[i].text);
    else
      snprintf(expected, sizeof expected, "   %d, ``%s``, \"%s\"\n", i + 1, columns[i].name,
               columns[i].text);
    assert_non_null(fgets(line, sizeof line, page));
    assert_string_equal(line, expected);
  }
  assert_non_null(fgets(line, sizeof line, page));
  assert_string_equal(line, "\n");
  fclose(page);
}

static void pages_have_them(void **state) {
  (void)state;
  has_rows("ASPERITY_TEST_PAGE", "| column | name |", true);
  has_rows("ASPERITY_TEST_RST", "   :header: \"column\", \"name\"", false);
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
  const struct CMUnitTest tests[] = {cmocka_unit_test(pages_have_them),
                                     cmocka_unit_test(places_stay)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
