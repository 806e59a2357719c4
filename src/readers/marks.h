/* Heights that may stand for missing ones: what instruments write where they have none, as -9999,
 * and values that recur far from all others.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SURFACE_MARKS_H
#define ASP_SURFACE_MARKS_H

#include "asperity.h"

enum { ASP_MARKS = 16 };

/* How often a value was met, and where first: a line, or the number of a point. */
typedef struct aspi_mark {
  size_t count, place;
} aspi_mark;

/* One end of the range of heights: the value there, and the one next to it. */
typedef struct aspi_range_end {
  double value, next;
  aspi_mark met;
} aspi_range_end;

/* Begins as {0}. */
typedef struct aspi_marks {
  size_t count; /* of heights that are none of the known marks */
  aspi_range_end low, high;
  aspi_mark known[ASP_MARKS];
  size_t near[ASP_MARKS]; /* heights within one hundredth of a mark */
} aspi_marks;

/* Takes in one height, as the file has it. */
void aspi_marks_note(aspi_marks *marks, double height, size_t place);

/* ASP_EDATA where a value most likely stands for a missing height: a known mark far out of the
 * range of the others, or that recurs more often than all that is near to it; any other value,
 * where it recurs, further off the others than they are from each other. */
asp_code aspi_marks_check(const aspi_marks *marks, const char *path, asp_error *error);

#endif
