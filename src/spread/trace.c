/* Particles over a profile, by geometry alone: the dilated profile is a chain of straight faces,
 * and a particle is a point that flies straight from one to the next. A path is followed with a
 * pyramid of block maxima, in steps that grow as long as nothing is in reach. A flight toward
 * smaller x is one toward larger x over the mirror image.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/trace.h"
#include "base/error.h"
#include "spread/line.h"

#include <math.h>
#include <stdlib.h>

enum { LEVELS_MAX = 48 };

/* Steeper flights are vertical. */
#define STEEPEST 1e12

/* The track in one direction of flight; its unit of length is the spacing. */
typedef struct side {
  double *level[LEVELS_MAX]; /* maxima of blocks of 2^k heights */
} side;

struct aspi_track {
  size_t n;
  int levels;
  double top, fall_least; /* highest point; least tan(alpha1) */
  side side[2];
  double *memory;
};

static void build_pyramid(const aspi_track *track, side *s) {
  size_t n = track->n;
  for (int k = 1; k < track->levels; k++) {
    const double *below = s->level[k - 1];
    size_t half = (n + 1) / 2;
    for (size_t i = 0; i < half; i++)
      s->level[k][i] = 2 * i + 1 < n ? fmax(below[2 * i], below[2 * i + 1]) : below[2 * i];
    n = half;
  }
}

/* Memory for both pyramids, one after the other. */
static bool allot(aspi_track *track) {
  size_t total = 0, size = track->n;
  for (track->levels = 1; size > 1; track->levels++) {
    total += size;
    size = (size + 1) / 2;
  }
  total += 1;
  double *next = track->memory = malloc(2 * total * sizeof *next);
  for (int s = 0; next && s < 2; s++) {
    size = track->n;
    for (int k = 0; k < track->levels; k++) {
      track->side[s].level[k] = next;
      next += size;
      size = (size + 1) / 2;
    }
  }
  return track->memory;
}

aspi_track *aspi_track_create(const asp_profile *profile, double d_p, asp_error *error) {
  aspi_line line;
  if (aspi_line_over_profile(&line, profile, d_p, error))
    return NULL;
  aspi_track *track = calloc(1, sizeof *track);
  if (track) {
    track->n = line.n;
    track->fall_least = line.fall_least;
  }
  if (!track || !allot(track)) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for a track of %zu points", line.n);
    aspi_line_free(&line);
    free(track);
    return NULL;
  }
  track->top = line.end_z[0];
  for (size_t i = 0; i < track->n; i++) {
    double z = line.end_z[i > 0 ? i - 1 : track->n - 1];
    track->side[0].level[0][i] = track->side[1].level[0][track->n - 1 - i] = z;
    track->top = fmax(track->top, z);
  }
  aspi_line_free(&line);
  build_pyramid(track, &track->side[0]);
  build_pyramid(track, &track->side[1]);
  return track;
}

void aspi_track_free(aspi_track *track) {
  if (track)
    free(track->memory);
  free(track);
}

static double face_slope(const aspi_track *track, int on, size_t face) {
  const double *z = track->side[on].level[0];
  return z[face + 1 < track->n ? face + 1 : 0] - z[face];
}

void aspi_track_enter(const aspi_track *track, double u, aspi_path *path) {
  *path = (aspi_path){.begun = true, .x = u * (double)track->n, .z = track->top};
  path->face = (size_t)path->x < track->n ? (size_t)path->x : track->n - 1;
}

/* The first point, from `from` on, at which the track is as high as a ray that is at z at x and
 * climbs by m a point. False when there is none within a period: a ray that sinks always has one,
 * at the highest point if not before. Points count on beyond the period. */
static bool next_point(const aspi_track *track, int on, double x, double z, double m, size_t from,
                       size_t *point) {
  double *const *level = track->side[on].level;
  size_t n = track->n, i = from % n;
  int k = 0;
  for (size_t at = from; at <= from + n;) {
    size_t size = (size_t)1 << k, count = i + size < n ? size : n - i;
    double begin = z + m * ((double)at - x), end = begin + m * (double)(count - 1);
    if (level[k][i >> k] < fmin(begin, end)) {
      if (m >= 0 && end > track->top)
        return false;
      at += count;
      i = i + count < n ? i + count : 0;
      if (k + 1 < track->levels && (i & (((size_t)2 << k) - 1)) == 0)
        k++;
    } else if (k > 0) {
      k--;
    } else {
      *point = at;
      return true;
    }
  }
  return false;
}

/* Converts place and face between the track and its mirror image, either way. */
static void mirror(const aspi_track *track, double *x, size_t *face) {
  double last = (double)track->n - 1;
  *x = *x <= last ? last - *x : last - *x + (double)track->n;
  *face = (2 * track->n - 2 - *face) % track->n;
}

bool aspi_track_next(const aspi_track *track, double alpha1, aspi_path *path, double *delta) {
  size_t n = track->n, face = path->face, point;
  double x = path->x, m = fmin(fmax(-tan(alpha1), -STEEPEST), STEEPEST);
  if (path->hits == 0)
    m = fmin(m, -track->fall_least);
  if (path->back)
    mirror(track, &x, &face);
  if (!next_point(track, path->back, x, path->z, m, face + 1 + (path->hits > 0), &point))
    return false;
  face = (point - 1) % n;
  double low = track->side[path->back].level[0][face], p = face_slope(track, path->back, face);
  double above = path->z + m * ((double)(point - 1) - x) - low;
  double share = p > m ? fmin(fmax(above / (p - m), 0), 1) : 0;
  path->x = (double)face + share;
  path->z = low + p * share;
  path->face = face;
  path->hits++;
  if (path->back)
    mirror(track, &path->x, &path->face);
  *delta = atan(p);
  return true;
}
