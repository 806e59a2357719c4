/* What the unit tests share: cmocka's headers in the order it wants, and a comparison of doubles
 * (its own is of floats).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_TEST_CHECK_H
#define ASP_TEST_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

#include "asperity_internal.h"

/* Fails unless |is - should| <= tolerance; prints both. */
static inline void check_near(double is, double should, double tolerance, const char *file,
                              int line) {
  if (fabs(is - should) <= tolerance)
    return;
  print_error("%.17g is not within %g of %.17g\n", is, tolerance, should);
  _fail(file, line);
}
#define assert_near(is, should, tolerance) check_near(is, should, tolerance, __FILE__, __LINE__)

#endif
