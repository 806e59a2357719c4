/* Numbers in text; see number.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct locales {
  locale_t plain, before;
} locales;

/* Sets the "C" locale for this thread, for the length of one call. glibc's "C" allocates no
 * memory. */
static locales be_plain(void) {
  locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  return (locales){plain, plain ? uselocale(plain) : (locale_t)0};
}

static void be_as_before(locales l) {
  if (!l.plain)
    return;
  uselocale(l.before);
  freelocale(l.plain);
}

double aspi_number(const char *text, char **end) {
  locales l = be_plain();
  double value = strtod(text, end);
  be_as_before(l);
  return value;
}

void aspi_number_print(double value, char text[32]) {
  locales l = be_plain();
  char printed[32];
  for (int digits = 15; digits <= 17; digits++) {
    snprintf(printed, sizeof printed, "%.*g", digits, value);
    double read = strtod(printed, NULL);
    if (read >= value && read <= value)
      break;
  }
  memcpy(text, printed, sizeof printed);
  be_as_before(l);
}
