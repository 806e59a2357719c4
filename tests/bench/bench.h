/* What the benchmarks share: works that take turns, so that whatever else the machine does slows
 * all of them alike, and lines of the table that tests/bench/run prints. C11, and C++.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { BENCH_ROUNDS = 101 }; /* for works of a fraction of a second in all */

/* The length of one run that is aimed at, in seconds: short against the turns that an operating
 * system gives to programs, so that most runs are not interrupted and keep their caches. */
#define BENCH_SLICE 5e-4

/* Something to be timed: run does n items, each of which counts as so many (the points of a
 * profile, or 1). */
typedef struct bench_work {
  void (*run)(void *context, size_t n);
  void *context;
  double each;
  int rounds;                   /* timed so far */
  double seconds[BENCH_ROUNDS]; /* for one of what is counted, by round */
} bench_work;

/* The thread's own time: waiting for other programs does not count. */
static inline double bench_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static inline double bench_time_of(const bench_work *work, size_t n) {
  double begun = bench_seconds();
  work->run(work->context, n);
  return bench_seconds() - begun;
}

/* How many items fill the slice, by the first of three times: one alone may have been interrupted,
 * unless it is very long. Asking warms the work up. */
static inline size_t bench_items(const bench_work *work) {
  size_t n = 1;
  for (int slow = 0; slow < 3;) {
    double seconds = bench_time_of(work, n);
    if (seconds > 20 * BENCH_SLICE)
      return n;
    slow = seconds < BENCH_SLICE / 2 ? 0 : slow + 1;
    n = slow ? n : 2 * n;
  }
  return n;
}

/* Runs the works in turn, at most BENCH_ROUNDS times, each round in another order, so that none
 * always has the same one before it. Takes about count * rounds * BENCH_SLICE seconds, or longer
 * where one item does. */
static inline void bench_run(bench_work *works, int count, int rounds) {
  size_t *n = (size_t *)malloc((size_t)count * sizeof *n);
  int *order = (int *)malloc((size_t)count * sizeof *order);
  if (!n || !order)
    abort();
  for (int i = 0; i < count; i++) {
    n[i] = bench_items(&works[i]);
    order[i] = i;
    works[i].rounds = rounds;
  }
  unsigned shuffle = 1;
  for (int round = 0; round < rounds; round++)
    for (int i = count - 1; i >= 0; i--) {
      shuffle = shuffle * 1664525u + 1013904223u;
      int k = (int)((shuffle >> 8) % (unsigned)(i + 1)), next = order[k];
      order[k] = order[i];
      order[i] = next;
      works[next].seconds[round] =
          bench_time_of(&works[next], n[next]) / ((double)n[next] * works[next].each);
    }
  free(n);
  free(order);
}

static inline int bench_compare(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* The median of at most BENCH_ROUNDS values. */
static inline double bench_median(const double *values, int count) {
  double sorted[BENCH_ROUNDS];
  for (int i = 0; i < count; i++)
    sorted[i] = values[i];
  qsort(sorted, (size_t)count, sizeof *sorted, bench_compare);
  return (sorted[(count - 1) / 2] + sorted[count / 2]) / 2;
}

/* Seconds for one of what is counted. */
static inline double bench_time(const bench_work *work) {
  return bench_median(work->seconds, work->rounds);
}

/* The same at best: for limits in seconds, which mean a machine without neighbors. */
static inline double bench_least(const bench_work *work) {
  double least = work->seconds[0];
  for (int i = 1; i < work->rounds; i++)
    least = work->seconds[i] < least ? work->seconds[i] : least;
  return least;
}

/* What a work costs in units of another one of the same bench_run: the median of the ratios of
 * every round, whose runs are milliseconds apart and have met the same neighbors. In sixty repeats
 * beside three busy programs on two cores its sd was 3.0 %, that of the ratio of medians 3.5 %;
 * with wall-clock time it was 9 and 10 %. */
static inline double bench_ratio(const bench_work *work, const bench_work *unit) {
  double ratio[BENCH_ROUNDS];
  for (int i = 0; i < work->rounds; i++)
    ratio[i] = work->seconds[i] / unit->seconds[i];
  return bench_median(ratio, work->rounds);
}

/* A line: what, the number and its unit, and what is wanted: at most (or at least) the limit. */
static inline void bench_row(const char *what, double value, const char *unit, const char *wanted,
                             double limit) {
  int good = *wanted == '<' ? value <= limit : value >= limit;
  printf("%s\t%.3g %s\t%s %g\t%s\n", what, value, unit, wanted, limit, good ? "yes" : "NO");
}

/* A line about a ratio, with both times; wanted NULL: no limit. */
static inline void bench_ratio_row(const char *what, const bench_work *work, const bench_work *unit,
                                   const char *wanted, double limit) {
  char times[80];
  snprintf(times, sizeof times, "x (%.3g / %.3g ns)", 1e9 * bench_time(work),
           1e9 * bench_time(unit));
  if (wanted)
    bench_row(what, bench_ratio(work, unit), times, wanted, limit);
  else
    printf("%s\t%.3g %s\t-\t-\n", what, bench_ratio(work, unit), times);
}
