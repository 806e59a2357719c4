/* Particles over a profile, by geometry alone: the dilated profile is a chain of straight faces,
 * and a particle a point that flies straight from one to the next.
 *
 * The law of the first hit takes one pass: with g = D + x tan alpha1 each path is a constant value
 * of g and touches where g passes its running maximum, so each face weighs what it adds to that
 * maximum (the second of two periods, when the maximum of the first is known). A single path is
 * followed with a pyramid of block maxima, in steps that grow as long as nothing is in reach. A
 * flight towards smaller x is one towards larger x over the mirror image.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/trace.h"
#include "base/error.h"
#include "surface/closing.h"
#include "surface/profile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEVELS_MAX = 48 };

/* Rms heights that a beam must pass over a period, so that its first hits lie on many peaks. */
#define RISE_LEAST 16

/* Flights steeper than this are vertical for the track. */
#define STEEPEST 1e12

/* The track as it is seen in one direction of flight; its unit of length is the spacing. */
typedef struct side {
  double *level[LEVELS_MAX]; /* maxima of blocks of 2^k heights */
} side;

struct aspi_track {
  size_t n;
  int levels;
  double top, least; /* highest point; smallest tan alpha1 */
  double slope_rms;
  side side[2];
  double *memory;
};

/* The path of the centre, in units of its spacing; what is not periodic goes on as its mirror
 * image.
 */
static double *heights_of(const asp_profile *path, size_t *n, asp_error *error) {
  size_t points = asp_profile_points(path);
  *n = aspi_profile_periodic(path) ? points : 2 * points - 2;
  double *heights = aspi_allocate(*n), unit = 1 / asp_profile_spacing(path);
  if (!heights)
    aspi_fail(error, ASP_ENOMEM, "out of memory for a track of %zu points", *n);
  for (size_t i = 0; heights && i < *n; i++)
    heights[i] = asp_profile_heights(path)[i < points ? i : 2 * points - 2 - i] * unit;
  return heights;
}

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

static void measure(aspi_track *track) {
  const double *z = track->side[0].level[0];
  size_t n = track->n;
  double mean = 0, height = 0, slope = 0;
  track->top = z[0];
  for (size_t i = 0; i < n; i++) {
    double step = z[i + 1 < n ? i + 1 : 0] - z[i];
    mean += z[i] / (double)n;
    slope += step * step / (double)n;
    track->top = fmax(track->top, z[i]);
  }
  for (size_t i = 0; i < n; i++)
    height += (z[i] - mean) * (z[i] - mean) / (double)n;
  track->slope_rms = sqrt(slope);
  track->least = RISE_LEAST * sqrt(height) / (double)n;
}

aspi_track *aspi_track_create(const asp_profile *profile, double d_p, asp_error *error) {
  if (aspi_check_range(error, "d_p", "", d_p, 0, INFINITY))
    return NULL;
  asp_profile *path = d_p > 0 ? aspi_profile_path(profile, d_p, ASP_TRACK_MOST, error) : NULL;
  if (d_p > 0 && !path)
    return NULL;
  aspi_track *track = calloc(1, sizeof *track);
  double *heights = track ? heights_of(path ? path : profile, &track->n, error) : NULL;
  asp_profile_free(path);
  if (!heights || !allot(track)) {
    if (!track || heights)
      aspi_fail(error, ASP_ENOMEM, "out of memory for a track");
    free(heights);
    aspi_track_free(track);
    return NULL;
  }
  for (size_t i = 0; i < track->n; i++) {
    track->side[0].level[0][i] = heights[i];
    track->side[1].level[0][i] = heights[track->n - 1 - i];
  }
  free(heights);
  build_pyramid(track, &track->side[0]);
  build_pyramid(track, &track->side[1]);
  measure(track);
  return track;
}

void aspi_track_free(aspi_track *track) {
  if (track)
    free(track->memory);
  free(track);
}

size_t aspi_track_faces(const aspi_track *track) {
  return track->n;
}

double aspi_track_slope_rms(const aspi_track *track) {
  return track->slope_rms;
}

static double face_slope(const aspi_track *track, int on, size_t face) {
  const double *z = track->side[on].level[0];
  return z[face + 1 < track->n ? face + 1 : 0] - z[face];
}

double aspi_track_face_slope(const aspi_track *track, size_t face) {
  return face_slope(track, 0, face);
}

double aspi_track_alpha_least(const aspi_track *track) {
  return atan(track->least);
}

static double descent(const aspi_track *track, double alpha1) {
  return fmin(fmax(tan(alpha1), track->least), STEEPEST);
}

void aspi_track_first_hit(const aspi_track *track, double alpha1, double *weight) {
  const double *z = track->side[0].level[0];
  size_t n = track->n;
  double fall = descent(track, alpha1), highest = z[0];
  for (size_t i = 0; i < n; i++)
    highest = fmax(highest, z[i] + fall * ((double)i - (double)n));
  for (size_t i = 0; i < n; i++) {
    double g = (i + 1 < n ? z[i + 1] : z[0]) + fall * (double)(i + 1);
    weight[i] = fmax(0, g - highest) / (fall * (double)n);
    highest = fmax(highest, g);
  }
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
    m = fmin(m, -track->least);
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

double aspi_sizes_at(const aspi_sizes *sizes, int bin) {
  double span = log(sizes->most / sizes->least);
  return sizes->least * exp(span * (sizes->bins > 1 ? bin / (sizes->bins - 1.) : 0.5));
}

int aspi_sizes_nearest(const aspi_sizes *sizes, double d_p) {
  if (sizes->bins < 2 || !(d_p > sizes->least))
    return 0;
  double at = log(d_p / sizes->least) / log(sizes->most / sizes->least) * (sizes->bins - 1);
  return (int)fmin(at + 0.5, sizes->bins - 1);
}

asp_code aspi_sizes_check(const aspi_sizes *sizes, asp_error *error) {
  asp_code code = aspi_check_length(error, "least d_p", sizes->least);
  if (!code)
    code = aspi_check_length(error, "largest d_p", sizes->most);
  if (!code)
    code = aspi_check_range(error, "largest d_p", "", sizes->most, sizes->least, INFINITY);
  if (!code && !(sizes->bins >= 1 && sizes->bins <= ASP_BINS_MAX))
    code = aspi_fail(error, ASP_EARG, "bins of d_p are %d; they must be 1 to %d", sizes->bins,
                     (int)ASP_BINS_MAX);
  return code;
}
