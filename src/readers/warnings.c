/* Warnings about measured heights; see read.h: dust, quantized or clipped heights, too few points
 * per particle, too few correlation lengths.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/read.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "surface/heights.h"

#include <math.h>
#include <stdbool.h>

/* Heights are quantized if they have at most this many values, each many times. */
enum { LEVELS_MOST = 64, POINTS_PER_LEVEL = 10 };

/* Heights are clipped if this share of all points is at one end of their range, and this many times
 * the number of the points next to it: within this part of the range, and this many steps. */
#define CUT_PART 2e-3
#define CUT_TIMES 3
#define CUT_NEXT 1e-2
#define CUT_STEPS 3.5

/* A measured wall with fewer points per particle resolves little. */
#define POINTS_PER_PARTICLE 10.0

/* Adds a new value to the levels; false if there are too many. */
static bool add_level(double *level, size_t *count, double z) {
  for (size_t i = 0; i < *count; i++)
    if (!(level[i] < z) && !(level[i] > z))
      return true;
  if (*count == LEVELS_MOST)
    return false;
  level[(*count)++] = z;
  return true;
}

static void find_ends(const aspi_raw *raw, aspi_steps *s) {
  double level[LEVELS_MOST];
  bool few = true;
  aspi_raw_range(raw, &s->end[0], &s->end[1]);
  for (size_t i = 0; i < raw->points; i++) {
    double z = raw->z[i];
    s->points += !isnan(z);
    few = few && (isnan(z) || add_level(level, &s->levels, z));
  }
  if (!few || s->points < POINTS_PER_LEVEL * s->levels)
    s->levels = 0;
}

static void find_cut(const aspi_raw *raw, int end, aspi_steps *s) {
  double at = s->end[end], range = s->end[1] - s->end[0];
  double next = fmax(CUT_NEXT * range, s->quantum < range ? CUT_STEPS * s->quantum : 0);
  size_t there = 0, near = 0;
  bool before = false;
  for (size_t i = 0; i < raw->points; i++) {
    double off = fabs(raw->z[i] - at);
    bool is_there = off <= ASPI_ROUNDING_TEXT * range;
    there += is_there && before;
    near += !is_there && off <= next;
    before = is_there;
  }
  if ((double)there > CUT_PART * (double)s->points && there > CUT_TIMES * near)
    s->cut[end] = there;
}

aspi_steps aspi_steps_find(const aspi_raw *raw) {
  aspi_steps s = {.quantum = INFINITY};
  find_ends(raw, &s);
  double least = ASPI_ROUNDING_TEXT * (s.end[1] - s.end[0]);
  for (size_t i = 1; i < raw->points; i++) {
    double step = fabs(raw->z[i] - raw->z[i - 1]);
    if (step > least && step < s.quantum)
      s.quantum = step;
  }
  for (int end = 0; end < 2 && s.levels == 0; end++)
    find_cut(raw, end, &s);
  return s;
}

void aspi_warnings_write(const aspi_steps *s, size_t outliers, char *text, size_t size) {
  *text = '\0';
  if (outliers > 0 && s->cut[0] + s->cut[1] == 0) /* corners of clipped parts are not dust */
    aspi_append(text, size,
                "%zu of %zu points lie over %g robust standard deviations off their neighbors, as "
                "dust does; take them out (asperity surface --spikes 12 --gaps fill --save FILE)",
                outliers, s->points, ASP_SPIKES_CLEAR);
  if (s->levels > 0)
    aspi_append(text, size,
                "%sits heights are quantized, %zu levels of %.3g um: slopes at their steps pass "
                "for roughness; measure with a finer range",
                *text ? "; " : "", s->levels, s->quantum * 1e6);
  for (int end = 0; end < 2; end++)
    if (s->cut[end] > 0)
      aspi_append(text, size, "%sits heights are clipped: %zu of %zu points have the %s one",
                  *text ? "; " : "", s->cut[end], s->points, end ? "highest" : "lowest");
}

asp_code aspi_sampling_check(double d_p, double spacing, double length, double lambda,
                             asp_error *error) {
  char doubt[440] = "";
  if (d_p < POINTS_PER_PARTICLE * spacing)
    aspi_append(doubt, sizeof doubt,
                "a particle of d_p %g covers %.2g points of the measured wall; under %g the noise "
                "and the rounding of heights pass for roughness",
                d_p, d_p / spacing, POINTS_PER_PARTICLE);
  if (!(length >= ASPI_LENGTHS_LEAST * lambda))
    aspi_append(
        doubt, sizeof doubt,
        "%sthe measured wall is at its shortest only %.3g correlation lengths long; under %g its "
        "numbers "
        "carry a large sampling error; for a curved part, remove the form (asperity surface "
        "--form 2 --save FILE)",
        *doubt ? "; " : "", length / lambda, ASPI_LENGTHS_LEAST);
  return *doubt ? aspi_fail(error, ASP_ERANGE, "%s", doubt) : ASP_OK;
}
