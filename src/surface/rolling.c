/* The path of the center of a disc over the smooth curve through a profile's points. The disc
 * touches the curve, not only the points: where it touches at x with slope p, its center is at
 * x - r sin(atan p), z + r cos(atan p), and has the slope p. The path is the upper envelope of
 * these places. (A dilation that takes the points as the whole profile has slopes that crowd at
 * multiples of the spacing over the radius.)
 *
 * Between two points the curve is a cubic (Hermite), with slopes by differences of fourth order. A
 * point at which the chords make a sharp bend, as at dust or the edge of a pore, is a corner: no
 * curve is laid through it, and the disc turns about it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/rolling.h"
#include "base/error.h"
#include "base/grow.h"

#include <math.h>
#include <stdlib.h>

/* The bend of two chords that is sharp: difference of slopes. None of the roughest generated
 * profiles has one. */
#define SHARP 0.75

/* The arc between two places of the center is a parabola if its width times the square of its bend,
 * in points of the path, is below this: the error is a tenth of it. */
#define SLIGHT 1e-3

/* If slopes of fourth and second order differ by more than this, the curve is not smooth and second
 * order is used. */
#define UNSMOOTH 0.05

/* A cubic is divided until the slope at its middle is this close to the mean of its ends. */
#define EVEN 0.01
enum { PIECES_MOST = 64 };

/* Arcs over more points than this are compared before the path is raised to them, so that the cost
 * does not grow with the disc's width; a range of few points is not divided further. */
enum { WIDE = 128, SHORT = 16 };

/* The path between two places of the center, u behind the first of them:
 * z + u (tilt - fall u), and on a circle + radius sqrt(1 - (sine - u/radius)^2). */
typedef struct arc {
  double from, to, z, tilt, fall, sine, radius;
  bool round;
} arc;

/* A curve and a disc; the path has `parts` points a spacing. */
typedef struct curve {
  const double *z;
  size_t points,
      n; /* n: of the period; a profile that is not periodic continues as its mirror image */
  double spacing, parts, radius; /* the radius is in points of the path */
  double *path;                  /* NULL: out of memory */
  ptrdiff_t length;              /* of the path, in its points */
  arc *wide;
  size_t count; /* of wide arcs */
} curve;

/* A place of the center, in points of the path, and the slope there. */
typedef struct place {
  double x, z, slope, cosine;
} place;

/* The cubic from one point to the next; heights and lengths in spacings. */
typedef struct cubic {
  double x, z[2], slope[2];
} cubic;

/* Five heights around point i. */
static const double *around(const curve *c, size_t i, double room[5]) {
  if (i >= 2 && i + 2 < c->points)
    return c->z + i - 2;
  for (size_t k = 0; k < 5; k++) {
    size_t at = (i + c->n - 2 + k) % c->n;
    room[k] = c->z[at < c->points ? at : c->n - at];
  }
  return room;
}

/* The slopes before and behind a point; they differ at a corner only. */
static void find_slopes(const double z[5], double unit, double slope[2]) {
  slope[0] = (z[2] - z[1]) * unit;
  slope[1] = (z[3] - z[2]) * unit;
  if (fabs(slope[1] - slope[0]) > SHARP)
    return;
  double mean = 0.5 * (slope[0] + slope[1]),
         fine = (8 * (z[3] - z[1]) - (z[4] - z[0])) * (1 / 12. * unit);
  slope[0] = slope[1] = fabs(fine - mean) > UNSMOOTH ? mean : fine;
}

static place center(const curve *c, double x, double z, double slope) {
  double cosine = 1 / sqrt(1 + slope * slope);
  return (place){x * c->parts - c->radius * slope * cosine, z * c->parts + c->radius * cosine,
                 slope, cosine};
}

/* The arc through two places; for a slight bend the first term of its series. */
static arc arc_between(const place *from, const place *to) {
  double width = to->x - from->x, bend = from->slope - to->slope, part = 1 / width;
  arc a = {.from = from->x, .to = to->x, .z = from->z, .tilt = part * (to->z - from->z)};
  if (width * bend * bend <= SLIGHT) {
    a.tilt += 0.5 * bend;
    a.fall = 0.5 * bend * part;
    return a;
  }
  a.sine = from->slope * from->cosine;
  double turn = a.sine - to->slope * to->cosine;
  a.round = fabs(turn) >= 1e-9; /* else two walls nearly upright */
  if (a.round) {
    a.radius = width / turn;
    a.z -= a.radius * from->cosine;
    a.tilt += a.radius * part * (from->cosine - to->cosine);
  }
  return a;
}

static double sine_at(const arc *a, double u) {
  return a->sine - u / a->radius;
}

static double height_at(const arc *a, double u) {
  double sine = a->round ? sine_at(a, u) : 0;
  return a->z + u * (a->tilt - a->fall * u) +
         (a->round ? a->radius * sqrt(fmax(0, 1 - sine * sine)) : 0);
}

static double slope_at(const arc *a, double u) {
  double sine = a->round ? sine_at(a, u) : 0;
  return a->tilt - 2 * a->fall * u + sine / sqrt(fmax(0, 1 - sine * sine));
}

static ptrdiff_t point_from(double x) {
  ptrdiff_t i = (ptrdiff_t)x;
  return i + ((double)i < x);
}

static ptrdiff_t wrapped(const curve *c, ptrdiff_t i) {
  if (i >= 0 && i < c->length)
    return i;
  i %= c->length;
  return i < 0 ? i + c->length : i;
}

/* Raises the path to an arc, from a point on until a place. */
static inline void lift(const curve *c, const arc *a, ptrdiff_t first, double until) {
  double u = (double)first - a->from;
  int left = (int)(until - (double)first) + 1;
  for (ptrdiff_t i = wrapped(c, first); left > 0; i = 0) {
    int run = left < c->length - i ? left : (int)(c->length - i);
    double *path = c->path + i;
    for (int k = 0; k < run; k++) {
      double z = height_at(a, u + k);
      path[k] = z > path[k] ? z : path[k];
    }
    left -= run;
    u += run;
  }
}

/* Keeps a wide arc for later. */
static void keep(curve *c, arc a, ptrdiff_t first) {
  ptrdiff_t shift = first - wrapped(c, first);
  for (; (double)shift <= a.to && c->path; shift += c->length) {
    arc *more = aspi_grow(c->wide, c->count, sizeof *more);
    if (!more) {
      free(c->path);
      c->path = NULL;
      return;
    }
    c->wide = more;
    arc *kept = &c->wide[c->count++];
    *kept = a;
    kept->from -= (double)shift;
    kept->to -= (double)shift;
  }
}

/* Raises the path to the arc through two places. */
static void join(curve *c, const place *from, const place *to) {
  ptrdiff_t first = point_from(from->x);
  double width = to->x - from->x;
  if (!(width > 0) || (double)first > to->x)
    return;
  arc a = arc_between(from, to);
  if (width > WIDE && from->slope > to->slope)
    keep(c, a, first);
  else if (c->path)
    lift(c, &a, first, to->x);
}

/* True if between begin and end an arc, which bends down, is below the line from `low` on; it is
 * below its own tangent. */
static bool is_hidden(const arc *a, double begin, double end, double low, double slope) {
  double from = fmax(begin, a->from), to = fmin(end, a->to), middle = 0.5 * (from + to);
  if (from > to)
    return true;
  double z = height_at(a, middle - a->from) - low, tangent = slope_at(a, middle - a->from);
  return z + tangent * (from - middle) < slope * (from - begin) &&
         z + tangent * (to - middle) < slope * (to - begin);
}

static void swap(arc *a, arc *b) {
  arc kept = *a;
  *a = *b;
  *b = kept;
}

/* Raises the path between two points to the highest of wide arcs. Arcs below the chord of an arc
 * that is high in the middle are dropped, which reorders the arcs; the rest are tried in both
 * halves. */
static void raise_to_highest(const curve *c, arc *arcs, size_t count, ptrdiff_t first,
                             ptrdiff_t last) {
  double begin = (double)first, end = (double)last, most = -INFINITY, slope = 0;
  for (size_t i = 0; i < count; i++)
    if (arcs[i].from <= begin && end <= arcs[i].to) {
      double z = height_at(&arcs[i], 0.5 * (begin + end) - arcs[i].from);
      if (z > most) {
        swap(&arcs[0], &arcs[i]);
        most = z;
      }
    }
  if (most > -INFINITY) {
    most = height_at(&arcs[0], begin - arcs[0].from);
    slope = (height_at(&arcs[0], end - arcs[0].from) - most) / (end - begin);
  }
  for (size_t i = most > -INFINITY; i < count;)
    if (is_hidden(&arcs[i], begin, end, most, slope))
      swap(&arcs[i], &arcs[--count]);
    else
      i++;
  if (count > 1 && last - first > SHORT) {
    ptrdiff_t middle = first + (last - first) / 2;
    raise_to_highest(c, arcs, count, first, middle);
    raise_to_highest(c, arcs, count, middle + 1, last);
    return;
  }
  for (const arc *a = arcs; a < arcs + count; a++) {
    ptrdiff_t from = point_from(a->from);
    lift(c, a, from > first ? from : first, fmin(a->to, end));
  }
}

/* Rolls over a cubic in equal pieces. Halving a piece brings the slope in its middle four times
 * closer to the mean of its ends. */
static void roll(curve *c, const cubic *over, const place *from, const place *to) {
  double up = over->z[1] - over->z[0], bow = over->slope[0] + over->slope[1] - 2 * up;
  const double *p = over->slope;
  int pieces = 1;
  for (double off = fabs(0.75 * bow); off > EVEN && pieces < PIECES_MOST; off /= 4)
    pieces *= 2;
  place middle;
  for (int k = 1; k < pieces; k++) {
    double m = (double)k / pieces, w = 1 - m;
    double slope = p[0] * w * (1 - 3 * m) + p[1] * m * (3 * m - 2) + 6 * m * w * up;
    double z = over->z[0] + m * m * (3 - 2 * m) * up + m * w * (w * p[0] - m * p[1]);
    place next = center(c, over->x + m, z, slope);
    join(c, from, &next);
    middle = next;
    from = &middle;
  }
  join(c, from, to);
}

static void roll_over_all(curve *c) {
  double unit = 1 / c->spacing, room[5], slope[2];
  const double *z = around(c, 0, room);
  find_slopes(z, unit, slope);
  place from = center(c, 0, z[2] * unit, slope[1]);
  cubic over = {.z = {0, z[2] * unit}};
  for (size_t i = 0; i < c->n; i++) {
    z = around(c, i + 1, room);
    over = (cubic){(double)i, {over.z[1], z[2] * unit}, {slope[1], 0}};
    find_slopes(z, unit, slope);
    over.slope[1] = slope[0];
    place to = center(c, over.x + 1, over.z[1], slope[0]);
    roll(c, &over, &from, &to);
    from = to;
    if (fabs(slope[1] - slope[0]) > SHARP) {
      from = center(c, over.x + 1, over.z[1], slope[1]);
      join(c, &to, &from);
    }
  }
  if (c->count && c->path)
    raise_to_highest(c, c->wide, c->count, 0, c->length - 1);
}

asp_heights *aspi_profile_rolled(const asp_heights *profile, double d_p, int parts,
                                 asp_error *error) {
  size_t points = profile->columns, fine = (size_t)parts;
  bool periodic = profile->periodic;
  double step = profile->step[0] / parts;
  curve c = {.z = profile->z,
             .points = points,
             .n = periodic ? points : 2 * points - 2,
             .spacing = profile->step[0],
             .parts = parts,
             .radius = 0.5 * d_p / step};
  c.length = (ptrdiff_t)(c.n * fine);
  c.path = aspi_allocate(c.n * fine);
  for (ptrdiff_t i = 0; c.path && i < c.length; i++)
    c.path[i] = -INFINITY;
  if (c.path)
    roll_over_all(&c);
  free(c.wide);
  size_t kept = periodic ? points * fine : (points - 1) * fine + 1;
  for (size_t i = 0; c.path && i < kept; i++)
    c.path[i] *= step;
  return aspi_profile_adopt(c.path, kept, step, periodic, error);
}

/* Points of a path across the disc, up to the limit of points. */
#define ACROSS 128.0

asp_heights *aspi_profile_path(const asp_heights *profile, double d_p, size_t most,
                               asp_error *error) {
  double length = aspi_profile_length(profile);
  if (!(d_p > 0 && d_p <= length))
    return aspi_fail_null(error, ASP_EARG,
                          "d_p is %g; it must be > 0 and at most the profile's length of %g", d_p,
                          length);
  double parts = fmin(ceil(ACROSS * profile->step[0] / d_p), (double)(most / profile->columns));
  return aspi_profile_rolled(profile, d_p, (int)fmax(1, parts), error);
}

static void turn_over(asp_heights *profile) {
  for (size_t i = 0; i < profile->columns; i++)
    profile->z[i] *= -1;
}

asp_heights *aspi_profile_closed(const asp_heights *profile, double d_p, asp_error *error) {
  asp_heights *path = aspi_profile_rolled(profile, d_p, 1, error);
  if (path)
    turn_over(path);
  asp_heights *closed = path ? aspi_profile_rolled(path, d_p, 1, error) : NULL;
  if (closed)
    turn_over(closed);
  asp_heights_free(path);
  return closed;
}
