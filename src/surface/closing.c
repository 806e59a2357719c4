/* Closing of a sampled profile by a disc (Serra & Vincent 1992): dilation, the path of the disc's
 * centre, is the upper envelope of arcs of one radius, each about one point of the profile; erosion
 * is the same upside down. Two such arcs cross at most once, so the envelope of all comes from a
 * stack of arcs, left to right, as the lower envelope of parabolas does in Felzenszwalb &
 * Huttenlocher 2012: O(n), whatever the radius. */
#include "error.h"
#include "surface/profile.h"

#include <math.h>
#include <stdlib.h>

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

/* top(i) = max over j of z(j) + rise(|i - j|), for all n points. The stack holds arcs and the point
 * from which each of them is the highest so far. */
static void envelope(const disc *shape, const double *z, ptrdiff_t n, ptrdiff_t *arc,
                     ptrdiff_t *from, double *top) {
  ptrdiff_t depth = 1;
  arc[0] = from[0] = 0;
  for (ptrdiff_t b = 1; b < n; b++) {
    ptrdiff_t start = crossing(shape, z, arc[depth - 1], b);
    while (depth > 1 && start <= from[depth - 1])
      start = crossing(shape, z, arc[--depth - 1], b);
    if (start <= 0)
      depth = 0;
    if (start >= n)
      continue;
    arc[depth] = b;
    from[depth++] = start > 0 ? start : 0;
  }
  for (ptrdiff_t k = 0; k < depth; k++) {
    ptrdiff_t end = k + 1 < depth ? from[k + 1] : n;
    for (ptrdiff_t i = from[k]; i < end; i++)
      top[i] = z[arc[k]] + shape->rise[i < arc[k] ? arc[k] - i : i - arc[k]];
  }
}

/* Room for one profile and what continues it at both ends. */
typedef struct bench {
  disc disc;
  double *rise, *padded, *top;
  ptrdiff_t *arc, *from;
  ptrdiff_t points, pad;
} bench;

static void bench_free(bench *b) {
  free(b->rise);
  free(b->padded);
  free(b->top);
  free(b->arc);
  free(b->from);
}

static asp_code bench_create(bench *b, size_t points, double radius, asp_error *error) {
  ptrdiff_t reach = (ptrdiff_t)floor(radius);
  size_t all = points + 2 * (size_t)reach;
  *b = (bench){.rise = asp_allocate((size_t)reach + 1),
               .padded = asp_allocate(all),
               .top = asp_allocate(all),
               .arc = malloc(all * sizeof *b->arc),
               .from = malloc(all * sizeof *b->from),
               .points = (ptrdiff_t)points,
               .pad = reach};
  if (!b->rise || !b->padded || !b->top || !b->arc || !b->from) {
    bench_free(b);
    return asp_fail(error, ASP_ENOMEM, "out of memory for a profile of %zu points", points);
  }
  b->disc = (disc){radius, reach, b->rise};
  for (ptrdiff_t i = 0; i <= reach; i++)
    b->rise[i] = sqrt((radius - (double)i) * (radius + (double)i));
  return ASP_OK;
}

/* The point of the profile that continues it at index i, one length beyond its ends at most. */
static ptrdiff_t continued(ptrdiff_t i, ptrdiff_t n, bool periodic) {
  if (i < 0)
    return periodic ? i + n : -i;
  if (i >= n)
    return periodic ? i - n : 2 * n - 2 - i;
  return i;
}

/* out(i) := sign * envelope of scale * z, whose ends are continued. */
static void roll(bench *b, const double *z, double scale, bool periodic, double *out) {
  for (ptrdiff_t i = -b->pad; i < b->points + b->pad; i++)
    b->padded[i + b->pad] = scale * z[continued(i, b->points, periodic)];
  envelope(&b->disc, b->padded, b->points + 2 * b->pad, b->arc, b->from, b->top);
  for (ptrdiff_t i = 0; i < b->points; i++)
    out[i] = b->top[i + b->pad] / scale;
}

static asp_code filter(const asp_profile *profile, double d_p, bool close, double *out,
                       asp_error *error) {
  size_t points = asp_profile_points(profile);
  double spacing = asp_profile_spacing(profile), length = (double)points * spacing;
  if (asp_check_positive(error, "d_p", "", d_p))
    return ASP_EARG;
  if (d_p > length)
    return asp_fail(error, ASP_EARG, "d_p is %g; allowed is at most the profile's length of %g",
                    d_p, length);
  bench b;
  asp_code code = bench_create(&b, points, 0.5 * d_p / spacing, error);
  if (code)
    return code;
  bool periodic = asp_profile_periodic(profile);
  roll(&b, asp_profile_heights(profile), 1 / spacing, periodic, out);
  if (close)
    roll(&b, out, -1 / spacing, periodic, out);
  bench_free(&b);
  return ASP_OK;
}

asp_code asp_profile_dilate(const asp_profile *profile, double d_p, double *out, asp_error *error) {
  return filter(profile, d_p, false, out, error);
}

asp_code asp_profile_close(const asp_profile *profile, double d_p, double *out, asp_error *error) {
  return filter(profile, d_p, true, out, error);
}
