/* What the benchmarks share: a clock, and a line of the table that tests/bench/run prints. */
#ifndef ASP_BENCH_H
#define ASP_BENCH_H

#include <stdio.h>
#include <time.h>

static inline double bench_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* One line: what, the number and its unit, and what is wanted: at most (or at least) the limit. */
static inline void bench_row(const char *what, double value, const char *unit, const char *wanted,
                             double limit) {
  int good = *wanted == '<' ? value <= limit : value >= limit;
  printf("%s\t%.3g %s\t%s %g\t%s\n", what, value, unit, wanted, limit, good ? "yes" : "NO");
}

#endif
