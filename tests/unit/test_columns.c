/* Tables on the pages of the fix: the ledger's columns, row by row, and the ranges of keywords.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/ledger_columns.h"
#include "description/description.h"

#include <stdlib.h>

#include "check.h"

#define COLUMN(ID, name, type, text) {name, text},
static const struct {
  const char *name, *text;
} columns[] = {LEDGER_COLUMNS(COLUMN) LEDGER_MORE_COLUMNS(COLUMN)};

TEST(page_has_them) {
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

/* True if a range stands on the page, not far behind the name. */
static bool has_range(const char *page, const char *name, const char *range) {
  for (const char *at = page; (at = strstr(at, name)) != NULL; at++) {
    const char *found = strstr(at, range);
    if (found && found - at < 400)
      return true;
  }
  return false;
}

TEST(pages_have_the_ranges) {
  static char page[1 << 17];
  for (int of_lammps = 0; of_lammps < 2; of_lammps++) {
    char path[4096], range[40];
    snprintf(path, sizeof path - 60, "%s", getenv("ASPERITY_TEST_PAGE"));
    if (of_lammps) /* beside the folder of the first page */
      snprintf(strstr(path, "/dem/fix.md"), 60, "/lammps/fix_wall_rebound.rst");
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    page[fread(page, 1, sizeof page - 1, file)] = '\0';
    fclose(file);
    for (const aspi_keyword *k = aspi_keywords; k->name; k++) {
      snprintf(range, sizeof range, k->most < 1e5 || k->whole ? "to %.10g" : "to 1e%.0f",
               k->most < 1e5 || k->whole ? k->most : log10(k->most));
      if (k->number && isfinite(k->most) && !has_range(page, k->name, range))
        fail_msg("%s: %s %s", path, k->name, range);
    }
  }
}

/* The places that scripts, dumps and measurements of years rely on. */
TEST(places_stay) {
  assert_int_equal(LEDGER_N_COLUMNS, 19);
  assert_int_equal(LEDGER_ALPHA1, 10);
  assert_int_equal(LEDGER_COR_N, 16);
  assert_int_equal(LEDGER_OUTCOME, 18);
}
