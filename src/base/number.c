/* Numbers in text; see number.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"

#include <locale.h>
#include <stdlib.h>

/* The locale is that of the thread for the length of the call; glibc's "C" takes no memory. */
double aspi_number(const char *text, char **end) {
  locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  locale_t before = plain ? uselocale(plain) : (locale_t)0;
  double value = strtod(text, end);
  if (plain) {
    uselocale(before);
    freelocale(plain);
  }
  return value;
}
