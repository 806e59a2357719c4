/* Closing of a sampled profile by a disc (Serra & Vincent 1992): dilation, the path of the disc's
 * center, is the upper envelope of arcs of one radius, each about one point of the profile; erosion
 * is the same upside down. Two such arcs cross at most once, so the envelope of all comes from a
 * stack of arcs, left to right, as the lower envelope of parabolas does in Felzenszwalb &
 * Huttenlocher 2012: O(n), whatever the radius.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/closing.h"
#include "base/error.h"
#include "surface/heights.h"

#include <math.h>
#include <stdlib.h>

/* Indices are 32-bit numbers, with the points that continue the profile at both ends. */
#define POINTS_MOST ((size_t)1 << 30)

/* The arcs of one radius over points one unit apart; heights are in that unit, too. */
typedef struct disc {
  double radius;
  ptrdiff_t reach;    /* the whole part of the radius */
  const double *rise; /* of the arc at 0 to reach points from its middle */
} disc;

/* The first point at which the arc about b > a is above the arc about a, if the envelope has it:
 * behind the upper point where the two circles meet, or, where they meet below the middle of the
 * higher one or not at all, where the higher arc begins or ends. */
static ptrdiff_t crossing(const disc *arc, const double *z, ptrdiff_t a, ptrdiff_t b) {
  ptrdiff_t first = b - arc->reach, last = a + arc->reach + 1;
  if (first >= last)
    return last;
  double apart = (double)(b - a), up = z[b] - z[a], square = apart * apart + up * up;
  if (square >= 2 * arc->radius * apart)
    return up > 0 ? first : last;
  double x = (double)a + 0.5 * apart - up * sqrt(arc->radius * arc->radius / square - 0.25);
  if (x < (double)first)
    return first;
  return x < (double)last ? (ptrdiff_t)floor(x) + 1 : last;
}

/* The arc about j, at a point that it reaches. */
static double height(const disc *arc, const double *z, ptrdiff_t j, ptrdiff_t i) {
  return z[j] + arc->rise[i < j ? j - i : i - j];
}

/* True if the arc about b is above the arc about a where a enters the envelope: then a has no part
 * of it. */
static bool hides(const disc *arc, const double *z, ptrdiff_t b, ptrdiff_t a, ptrdiff_t from) {
  return from >= b - arc->reach && height(arc, z, b, from) > height(arc, z, a, from);
}

/* An arc of the envelope, and the point from which it is the highest. */
typedef struct piece {
  uint32_t arc, from;
} piece;

/* The envelope of z(j) + rise(|i - j|) over all j, from left to right; returns the number of its
 * pieces. */
static ptrdiff_t envelope(const disc *shape, const double *z, ptrdiff_t n, piece *pieces) {
  ptrdiff_t depth = 0;
  for (ptrdiff_t b = 0; b < n; b++) {
    while (depth > 0 && hides(shape, z, b, pieces[depth - 1].arc, pieces[depth - 1].from))
      depth--;
    ptrdiff_t start = 0;
    if (depth > 0) {
      start = crossing(shape, z, pieces[depth - 1].arc, b);
      start = start > pieces[depth - 1].from ? start : pieces[depth - 1].from; /* rounding */
    }
    if (start < n)
      pieces[depth++] = (piece){(uint32_t)b, (uint32_t)start};
  }
  return depth;
}

/* Memory for one profile and its continuation at both ends. */
typedef struct workspace {
  disc disc;
  double *rise, *padded;
  piece *pieces;
  ptrdiff_t points, pad;
} workspace;

static void workspace_free(workspace *b) {
  free(b->rise);
  free(b->padded);
  free(b->pieces);
}

static asp_code workspace_create(workspace *b, size_t points, double radius, bool periodic,
                                 asp_error *error) {
  ptrdiff_t reach = (ptrdiff_t)floor(radius), pad = periodic ? reach : 0;
  size_t all = points + 2 * (size_t)pad;
  *b = (workspace){.rise = aspi_allocate((size_t)reach + 1),
                   .padded = aspi_allocate(all),
                   .pieces = malloc(all * sizeof *b->pieces),
                   .points = (ptrdiff_t)points,
                   .pad = pad};
  if (!b->rise || !b->padded || !b->pieces) {
    workspace_free(b);
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a profile of %zu points", points);
  }
  b->disc = (disc){radius, reach, b->rise};
  for (ptrdiff_t i = 0; i <= reach; i++)
    b->rise[i] = sqrt((radius - (double)i) * (radius + (double)i));
  return ASP_OK;
}

/* out(i) := the envelope of scale * z, over scale. A periodic profile is continued at both ends by
 * the reach of an arc. The mirror image of other profiles has no effect: its points are never
 * nearer than their originals. */
static void roll(workspace *b, const double *z, double scale, double *out) {
  ptrdiff_t all = b->points + 2 * b->pad;
  for (ptrdiff_t i = 0; i < all; i++)
    b->padded[i] = scale * z[(i - b->pad + b->points) % b->points];
  ptrdiff_t count = envelope(&b->disc, b->padded, all, b->pieces);
  for (ptrdiff_t k = 0; k < count; k++) {
    ptrdiff_t first = b->pieces[k].from, end = k + 1 < count ? b->pieces[k + 1].from : all;
    first = first > b->pad ? first : b->pad;
    end = end < b->points + b->pad ? end : b->points + b->pad;
    for (ptrdiff_t i = first; i < end; i++)
      out[i - b->pad] = height(&b->disc, b->padded, b->pieces[k].arc, i) / scale;
  }
}

asp_code aspi_profile_check_disc(const asp_heights *profile, double d_p, asp_error *error) {
  double length = (double)profile->columns * profile->step[0];
  if (aspi_check_positive(error, "d_p", "", d_p))
    return ASP_EARG;
  if (d_p > length)
    return aspi_fail(error, ASP_EARG, "d_p is %g; it must be at most the profile's length of %g",
                     d_p, length);
  return ASP_OK;
}

static asp_code filter(const asp_heights *profile, double d_p, bool close, double *out,
                       asp_error *error) {
  size_t points = profile->columns;
  double spacing = profile->step[0];
  if (aspi_profile_check_disc(profile, d_p, error))
    return ASP_EARG;
  if (points > POINTS_MOST)
    return aspi_fail(error, ASP_EARG, "a profile has %zu points; it must have at most %zu", points,
                     POINTS_MOST);
  workspace b;
  asp_code code = workspace_create(&b, points, 0.5 * d_p / spacing, profile->periodic, error);
  if (code)
    return code;
  roll(&b, profile->z, 1 / spacing, out);
  if (close)
    roll(&b, out, -1 / spacing, out);
  workspace_free(&b);
  return ASP_OK;
}

asp_code aspi_profile_dilate(const asp_heights *profile, double d_p, double *out,
                             asp_error *error) {
  return filter(profile, d_p, false, out, error);
}

asp_code aspi_profile_close(const asp_heights *profile, double d_p, double *out, asp_error *error) {
  return filter(profile, d_p, true, out, error);
}
