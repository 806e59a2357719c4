/* What a profile costs: closing over points and diameter, and against dilation and erosion by their
 * definition (on fewer points, whose time per point is the same); the law of the first hit over
 * points and angle; what `traced` makes of a profile.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"
#include "bench.h"
#include "spread/flight.h"
#include "spread/models.h"
#include "surface/closing.h"
#include "surface/heights.h"

#include <math.h>

enum { ROUNDS = 11, MILLION = 1000000, DIRECT_POINTS = 50000, REACH = 400 };

/* Heights over points at a spacing of 1. */
static asp_heights *wall_of(size_t points) {
  asp_heights *profile = aspi_profile_generate(10, 100, 1, points, 1, NULL);
  if (!profile)
    abort();
  return profile;
}

static double *room_for(size_t points) {
  double *room = malloc(points * sizeof *room);
  if (!room)
    abort();
  return room;
}

/* ---- closing ---- */

typedef struct closing {
  const asp_heights *profile;
  double d_p, *out;
} closing;

static void closings(void *context, size_t n) {
  closing *c = context;
  for (size_t i = 0; i < n; i++)
    if (aspi_profile_close(c->profile, c->d_p, c->out, NULL))
      abort();
}

static bench_work close_with(closing *c) {
  return (bench_work){.run = closings, .context = c, .each = (double)c->profile->columns};
}

/* top(i) = max of z(i + k) + rise(|k|), as it is written. */
static void by_definition(const double *z, ptrdiff_t n, const double *rise, double *top) {
  for (ptrdiff_t i = 0; i < n; i++) {
    ptrdiff_t first = i > REACH ? -REACH : -i, last = i + REACH < n ? REACH : n - 1 - i;
    double most = z[i] + rise[0];
    for (ptrdiff_t k = first; k <= last; k++) {
      double here = z[i + k] + rise[k < 0 ? -k : k];
      most = here > most ? here : most;
    }
    top[i] = most;
  }
}

/* The same with the loops turned round, which a compiler can make vectors of. */
static void by_shifts(const double *z, ptrdiff_t n, const double *rise, double *top) {
  for (ptrdiff_t i = 0; i < n; i++)
    top[i] = z[i] + rise[0];
  for (ptrdiff_t k = 1; k <= REACH; k++) {
    for (ptrdiff_t i = k; i < n; i++)
      top[i] = top[i] > z[i - k] + rise[k] ? top[i] : z[i - k] + rise[k];
    for (ptrdiff_t i = 0; i + k < n; i++)
      top[i] = top[i] > z[i + k] + rise[k] ? top[i] : z[i + k] + rise[k];
  }
}

typedef struct direct {
  void (*dilate)(const double *z, ptrdiff_t n, const double *rise, double *top);
  const double *z;
  double *work, *out, rise[REACH + 1]; /* of a disc of radius REACH */
} direct;

static void direct_closings(void *context, size_t n) {
  direct *d = context;
  for (size_t i = 0; i < n; i++) {
    d->dilate(d->z, DIRECT_POINTS, d->rise, d->work);
    for (int k = 0; k < DIRECT_POINTS; k++)
      d->work[k] = -d->work[k];
    d->dilate(d->work, DIRECT_POINTS, d->rise, d->out);
  }
}

static bench_work close_directly(direct *d) {
  for (int k = 0; k <= REACH; k++)
    d->rise[k] = sqrt((double)REACH * REACH - (double)k * k);
  return (bench_work){.run = direct_closings, .context = d, .each = DIRECT_POINTS};
}

static void compare_closings(void) {
  asp_heights *million = wall_of(MILLION), *some = wall_of(MILLION / 10);
  double *out = room_for(MILLION), *work = room_for(MILLION);
  closing c[] = {{million, 8, out}, {million, 80, out}, {million, 2 * REACH, out}, {some, 80, out}};
  direct d[] = {{by_definition, million->z, work, out, {0}},
                {by_shifts, million->z, work, out, {0}}};
  bench_work w[] = {close_with(&c[0]), close_with(&c[1]),     close_with(&c[2]),
                    close_with(&c[3]), close_directly(&d[0]), close_directly(&d[1])};
  bench_run(w, 6, ROUNDS);
  bench_ratio_row("closing of 1e6 points, d_p/dx 800 over 8, a point", &w[2], &w[0], "<=", 2);
  bench_ratio_row("closing at d_p/dx 80, 1e6 over 1e5 points, a point", &w[1], &w[3], "<=", 2);
  bench_ratio_row("direct dilation and erosion over closing, d_p/dx 800", &w[4], &w[2], ">=", 50);
  bench_ratio_row("... in loops that the compiler makes vectors of", &w[5], &w[2], ">=", 1);
  free(out);
  free(work);
  asp_heights_free(million);
  asp_heights_free(some);
}

/* ---- first hit ---- */

typedef struct first_hit {
  aspi_field *line;
  double alpha1, *weight;
} first_hit;

static void first_hits(void *context, size_t n) {
  first_hit *f = context;
  for (size_t i = 0; i < n; i++)
    aspi_field_first_hits(f->line, aspi_field_fall(f->line, f->alpha1), f->weight);
}

static void compare_first_hits(void) {
  enum { SMALL = 1 << 16, LARGE = 1 << 20, ANGLES = 3 };
  const double degrees[ANGLES] = {2, 20, 80};
  asp_heights *profiles[] = {wall_of(SMALL), wall_of(LARGE)};
  double *weight = room_for(LARGE);
  aspi_field line[2];
  first_hit f[2][ANGLES];
  bench_work w[2][ANGLES];
  for (int i = 0; i < 2; i++) {
    if (aspi_field_create(&line[i], profiles[i], 80, NULL, NULL))
      abort();
    for (int k = 0; k < ANGLES; k++) {
      f[i][k] = (first_hit){&line[i], degrees[k] * ASP_PI / 180, weight};
      w[i][k] =
          (bench_work){.run = first_hits, .context = &f[i][k], .each = (double)line[i].columns};
    }
  }
  bench_run(w[0], 2 * ANGLES, 5 * ROUNDS);
  for (int k = 0; k < ANGLES; k++) {
    char what[80];
    snprintf(what, sizeof what, "first-hit law at %g deg, 2^20 over 2^16 points, a point",
             degrees[k]);
    bench_ratio_row(what, &w[1][k], &w[0][k], "<=", 2);
  }
  bench_ratio_row("first-hit law of 2^20 points, 2 over 80 deg, a point", &w[1][0], &w[1][2],
                  "<=", 2);
  for (int i = 0; i < 2; i++) {
    aspi_field_free(&line[i]);
    asp_heights_free(profiles[i]);
  }
  free(weight);
}

/* ---- what `traced` makes of a profile ---- */

static void set_ups(void *context, size_t n) {
  const asp_spread_model *model = asp_spread_find("traced", NULL);
  const aspi_relief of = {.heights = context};
  aspi_sizes sizes = {0.1, 1, 16};
  for (size_t i = 0; i < n; i++) {
    void *data = model->prepare(&of, &sizes, NULL);
    if (!data)
      abort();
    model->release(data);
  }
}

static void time_set_up(void) {
  asp_heights *profile = aspi_profile_generate(0.125, 1, 1 / 128., 1 << 17, 1, NULL);
  if (!profile)
    abort();
  bench_work work = {.run = set_ups, .context = profile, .each = 1};
  bench_run(&work, 1, 5);
  bench_row("set-up of `traced`: 16 sizes of 2^17 points, at best", bench_least(&work), "s",
            "<=", 2);
  asp_heights_free(profile);
}

int main(void) {
  compare_closings();
  compare_first_hits();
  time_set_up();
  return 0;
}
