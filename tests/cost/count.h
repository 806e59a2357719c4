/* Counts the instructions of a part of a program that valgrind's callgrind runs, with
 * --instr-atstart=no and --collect-atstart=no; without valgrind nothing is counted. C11, and C++.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdio.h>
#include <valgrind/callgrind.h>

/* Before the steps of a case, only some of whose instructions count. */
static inline void count_begin(void) {
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
}

/* Around those that count. */
static inline void count_on(void) {
  CALLGRIND_TOGGLE_COLLECT;
}
static inline void count_off(void) {
  CALLGRIND_TOGGLE_COLLECT;
}

/* Behind the steps: what was counted, and how many items. */
static inline void count_end(const char *what, double items) {
  char text[120];
  snprintf(text, sizeof text, "%.0f %s", items, what);
  CALLGRIND_DUMP_STATS_AT(text);
  CALLGRIND_STOP_INSTRUMENTATION;
}

/* A number of another kind, for the table. */
static inline void count_other(const char *what, const char *kind, double number) {
  printf("\nCOUNT %.0f\t%s: %s\n", number, what, kind);
  fflush(stdout);
}
