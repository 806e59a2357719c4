/* Heights that may stand for missing ones: what instruments write where they have none, as -9999,
 * and values that recur far from all others.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_MISSING_H
#define ASP_READERS_MISSING_H

#include "asperity.h"

enum { ASP_MISSING_KNOWN = 16 };

/* How often a value was met, and where first: a line, or the number of a point. */
typedef struct aspi_missing_value {
  size_t count, place;
} aspi_missing_value;

/* One end of the range of heights: the value there, and the one next to it. */
typedef struct aspi_range_end {
  double value, next;
  aspi_missing_value met;
} aspi_range_end;

/* Begins as {.stated = NAN}, or a height that the user says stands for none. */
typedef struct aspi_missing {
  double stated;
  size_t count; /* of heights that are none of the known marks */
  aspi_range_end low, high;
  aspi_missing_value known[ASP_MISSING_KNOWN];
  size_t near[ASP_MISSING_KNOWN]; /* heights within one hundredth of a mark */
} aspi_missing;

/* Takes in one height, as the file has it, and returns it; NAN where it is the stated one. */
double aspi_missing_note(aspi_missing *marks, double height, size_t place);

/* ASP_EDATA where a value most likely stands for a missing height: a known mark far out of the
 * range of the others, or that recurs more often than all that is near to it; any other value,
 * where it recurs, further off the others than they are from each other. */
asp_code aspi_missing_check(const aspi_missing *marks, const char *path, asp_error *error);

#endif
