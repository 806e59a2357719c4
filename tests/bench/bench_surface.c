/* What a profile costs: a disc that rolls over it, over the diameter; the law of the first hit over
 * points and angle; what `traced` makes of a profile.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"
#include "bench.h"
#include "spread/flight.h"
#include "spread/models.h"
#include "surface/rolling.h"
#include "surface/heights.h"

#include <math.h>

enum { ROUNDS = 11, MILLION = 1000000 };

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

/* ---- rolling ---- */

typedef struct disc {
  const asp_heights *profile;
  double d_p;
} disc;

static void roll(void *context, size_t n) {
  disc *d = context;
  for (size_t i = 0; i < n; i++) {
    asp_heights *path = aspi_profile_rolled(d->profile, d->d_p, 1, NULL);
    if (!path)
      abort();
    asp_heights_free(path);
  }
}

static void compare_discs(void) {
  asp_heights *million = wall_of(MILLION);
  disc d[] = {{million, 8}, {million, 800}};
  bench_work w[2];
  for (int k = 0; k < 2; k++)
    w[k] = (bench_work){.run = roll, .context = &d[k], .each = MILLION};
  bench_run(w, 2, ROUNDS);
  bench_ratio_row("disc over 1e6 points, d_p/dx 800 over 8, a point", &w[1], &w[0], "<=", 3);
  asp_heights_free(million);
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
  const aspi_height_field of = {.heights = context};
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
  compare_discs();
  compare_first_hits();
  time_set_up();
  return 0;
}
