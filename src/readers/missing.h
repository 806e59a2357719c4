/* Heights that may stand for missing ones: what instruments write where they have none, as -9999,
 * and values that recur far from all others.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_MISSING_H
#define ASP_READERS_MISSING_H

#include "asperity.h"

enum { ASP_MISSING_KNOWN = 16 };

/* A value, its number of occurrences, and the first place: a line, or the number of a point. */
typedef struct aspi_missing_value {
  size_t count, place;
} aspi_missing_value;

/* One end of the range of heights: the value there, and the one next to it. */
typedef struct aspi_range_end {
  double value, next;
  aspi_missing_value met;
} aspi_range_end;

/* Starts as {.stated = NAN}, or with the height that the user declares as missing. */
typedef struct aspi_missing {
  double stated;
  size_t count; /* of heights that are none of the known marks */
  aspi_range_end low, high;
  aspi_missing_value known[ASP_MISSING_KNOWN];
  size_t near[ASP_MISSING_KNOWN]; /* heights within one hundredth of a mark */
} aspi_missing;

/* Takes in one height, as the file has it, and returns it; NAN where it is the stated one. */
double aspi_missing_note(aspi_missing *marks, double height, size_t place);

/* ASP_EDATA if a value most likely marks missing heights. A known mark does if it is far outside
 * the range of the others, or recurs more often than all values near it. Any other value does if it
 * recurs and is farther from the others than they are from each other. */
asp_code aspi_missing_check(const aspi_missing *marks, const char *path, asp_error *error);

#endif
