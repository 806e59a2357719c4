/* Shared by the unit tests: cmocka's headers in the order it wants, behind all others, as it has a
 * macro `fail`; a list of the tests of a file, each by TEST(its_name); a comparison of doubles
 * (cmocka's own is of floats); and walls from words.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#ifdef __cplusplus
extern "C" {
#endif
#include <cmocka.h>

/* Lists a test, and runs those of the file between two functions or NULL, which main.c does where
 * there is no other main(). */
void list_test(const char *name, CMUnitTestFunction run, CMFixtureFunction before,
               CMFixtureFunction after);
int run_listed_tests(CMFixtureFunction before, CMFixtureFunction after);

/* Calls a function with each row of a section of a table of data/. There '[name] remark' begins a
 * section, and fields are parted by '@'; one that is not there is empty. CHECK_ROWS does so with
 * the section that has the test's name. */
enum { FIELDS = 5 };
void each_row(const char *table, const char *section, void (*check)(char *fields[FIELDS]));
int tell_row(void **state); /* after a test: the row where it failed, if in one */
#ifdef __cplusplus
}
#endif
#define CHECK_ROWS(table, check) each_row(table, __func__, check)

/* Defines a test and adds it to the list; TEST_BETWEEN runs it between two functions that set up
 * and clean up. */
#define TEST_BETWEEN(name, before, after)                                                          \
  static void name(void **nothing);                                                                \
  __attribute__((constructor)) static void list_##name(void) {                                     \
    list_test(#name, name, before, after);                                                         \
  }                                                                                                \
  static void name(__attribute__((unused)) void **nothing)
#define TEST(name) TEST_BETWEEN(name, NULL, NULL)

/* Fails unless |is - should| <= tolerance; prints both. */
static inline void check_near(double is, double should, double tolerance, const char *file,
                              int line) {
  if (fabs(is - should) <= tolerance)
    return;
  print_error("%.17g is not within %g of %.17g\n", is, tolerance, should);
  _fail(file, line);
}
#define assert_near(is, should, tolerance) check_near(is, should, tolerance, __FILE__, __LINE__)

/* Fails unless the text has these words. */
static inline void check_says(const char *text, const char *words, const char *file, int line) {
  if (strstr(text, words))
    return;
  print_error("'%s' is not in '%s'\n", words, text);
  _fail(file, line);
}
#ifdef __cplusplus
#include <string>
static inline void check_says(const std::string &text, const std::string &words, const char *file,
                              int line) {
  check_says(text.c_str(), words.c_str(), file, line);
}
#endif
#define assert_says(text, words) check_says(text, words, __FILE__, __LINE__)

static inline asp_wall *wall_from(const char *text, double d_p) {
  asp_error error;
  asp_wall *wall = asp_wall_from_text(text, d_p, d_p, &error);
  if (!wall)
    fail_msg("'%s': %s", text, error.text);
  return wall;
}
