/* Closing of a million points: whether its time depends on the diameter, and how it compares with
 * dilation and erosion by their definition (timed on fewer points, whose time per point is the
 * same). */
#include "asperity.h"
#include "bench.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 1000000, DIRECT_POINTS = 50000, ROUNDS = 5, SMALL = 8, LARGE = 800 };

/* top(i) = max of z(i + k) + rise(|k|), as it is written. */
static void by_definition(const double *z, ptrdiff_t n, ptrdiff_t reach, const double *rise,
                          double *top) {
  for (ptrdiff_t i = 0; i < n; i++) {
    ptrdiff_t first = i > reach ? -reach : -i, last = i + reach < n ? reach : n - 1 - i;
    double most = z[i] + rise[0];
    for (ptrdiff_t k = first; k <= last; k++) {
      double here = z[i + k] + rise[k < 0 ? -k : k];
      most = here > most ? here : most;
    }
    top[i] = most;
  }
}

/* The same with the loops turned round, which a compiler can make vectors of. */
static void by_shifts(const double *z, ptrdiff_t n, ptrdiff_t reach, const double *rise,
                      double *top) {
  for (ptrdiff_t i = 0; i < n; i++)
    top[i] = z[i] + rise[0];
  for (ptrdiff_t k = 1; k <= reach; k++) {
    for (ptrdiff_t i = k; i < n; i++)
      top[i] = top[i] > z[i - k] + rise[k] ? top[i] : z[i - k] + rise[k];
    for (ptrdiff_t i = 0; i + k < n; i++)
      top[i] = top[i] > z[i + k] + rise[k] ? top[i] : z[i + k] + rise[k];
  }
}

typedef void (*dilation)(const double *, ptrdiff_t, ptrdiff_t, const double *, double *);

/* Seconds per point of dilation and erosion at d_p/dx = 800. */
static double time_direct(dilation dilate, const double *z, double *work, double *out) {
  double rise[LARGE / 2 + 1], r = LARGE / 2.;
  for (ptrdiff_t k = 0; k <= LARGE / 2; k++)
    rise[k] = sqrt(r * r - (double)(k * k));
  double begun = bench_seconds();
  dilate(z, DIRECT_POINTS, LARGE / 2, rise, work);
  for (ptrdiff_t i = 0; i < DIRECT_POINTS; i++)
    work[i] = -work[i];
  dilate(work, DIRECT_POINTS, LARGE / 2, rise, out);
  return (bench_seconds() - begun) / DIRECT_POINTS;
}

static double time_closing(const asp_profile *profile, double d_p, double *out) {
  double best = INFINITY;
  for (int i = 0; i < ROUNDS; i++) {
    double begun = bench_seconds();
    if (asp_profile_close(profile, d_p, out, NULL))
      abort();
    best = fmin(best, bench_seconds() - begun);
  }
  return best / POINTS;
}

int main(void) {
  asp_profile *profile = asp_profile_create(10, 100, 1, POINTS, 1, NULL);
  double *work = malloc(POINTS * sizeof *work), *out = malloc(POINTS * sizeof *out);
  if (!profile || !work || !out)
    return 1;
  double small = time_closing(profile, SMALL, out), large = time_closing(profile, LARGE, out);
  double direct = time_direct(by_definition, asp_profile_heights(profile), work, out);
  double shifts = time_direct(by_shifts, asp_profile_heights(profile), work, out);
  bench_row("closing of 1e6 points: time at d_p/dx = 800 over time at 8", large / small, "x",
            "<=", 2);
  bench_row("closing at d_p/dx = 800: direct dilation and erosion over ours", direct / large, "x",
            ">=", 50);
  bench_row("the same against direct loops that the compiler makes vectors of", shifts / large, "x",
            ">=", 1);
  bench_row("closing of 1e6 points at d_p/dx = 800, per point", large * 1e9, "ns", "<=", 200);
  free(work);
  free(out);
  asp_profile_free(profile);
  return 0;
}
