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
enum { DIVISIONS_MOST = 6 };

/* A curve and a disc; the path has `parts` points a spacing. */
typedef struct curve {
  const double *z;
  size_t points,
      n; /* n: of the period; a profile that is not periodic continues as its mirror image */
  double spacing, parts, radius; /* the radius is in points of the path */
  double *path;
} curve;

/* A place of the center, in points of the path, and the slope there. */
typedef struct place {
  double x, z, slope;
} place;

/* The cubic from one point to the next; heights and lengths in spacings. */
typedef struct cubic {
  double x, z[2], slope[2];
} cubic;

static double height(const curve *c, size_t i) {
  i %= c->n;
  return c->z[i < c->points ? i : c->n - i];
}

/* The slopes before and behind point i; they differ at a corner only. */
static void find_slopes(const curve *c, size_t i, double slope[2]) {
  double here = height(c, i), last = height(c, i + c->n - 1), next = height(c, i + 1);
  double near = next - last, far = height(c, i + 2) - height(c, i + c->n - 2);
  slope[0] = (here - last) / c->spacing;
  slope[1] = (next - here) / c->spacing;
  if (fabs(slope[1] - slope[0]) > SHARP)
    return;
  double mean = 0.5 * (slope[0] + slope[1]), fine = (8 * near - far) / 12 * (1 / c->spacing);
  slope[0] = slope[1] = fabs(fine - mean) > UNSMOOTH ? mean : fine;
}

static place center(const curve *c, double x, double z, double slope) {
  double cosine = 1 / sqrt(1 + slope * slope);
  return (place){x * c->parts - c->radius * slope * cosine, z * c->parts + c->radius * cosine,
                 slope};
}

/* Height of the circular arc between two places above their chord at the part t of its width; for a
 * slight bend the first term of its series. */
static double rise(double t, const place *from, const place *to) {
  double width = to->x - from->x, bend = from->slope - to->slope;
  if (width * bend * bend <= SLIGHT)
    return 0.5 * width * t * (1 - t) * bend;
  double first = 1 / sqrt(1 + from->slope * from->slope),
         last = 1 / sqrt(1 + to->slope * to->slope);
  double sine = from->slope * first, turn = to->slope * last - sine, at = sine + t * turn;
  if (fabs(turn) < 1e-9) /* two walls nearly upright */
    return 0;
  return width / turn * ((1 - t) * first + t * last - sqrt(fmax(0, 1 - at * at)));
}

/* Raises the path between two places to the arc through them. */
static void raise(const curve *c, const place *from, const place *to) {
  if (!(to->x > from->x))
    return;
  double width = to->x - from->x, length = (double)c->n * c->parts;
  for (double at = ceil(from->x); at <= to->x; at++) {
    double t = (at - from->x) / width;
    double z = from->z + t * (to->z - from->z) + rise(t, from, to);
    size_t i = (size_t)(at - length * floor(at / length));
    c->path[i] = fmax(c->path[i], z);
  }
}

/* Rolls over the part t of a cubic, from one place to another. */
static void roll(const curve *c, const cubic *over, const double t[2], const place *from,
                 const place *to, int divisions) {
  double m = 0.5 * (t[0] + t[1]), w = 1 - m, up = over->z[1] - over->z[0];
  const double *p = over->slope;
  double slope = p[0] * w * (1 - 3 * m) + p[1] * m * (3 * m - 2) + 6 * m * w * up;
  if (divisions == 0 || fabs(slope - 0.5 * (from->slope + to->slope)) <= EVEN) {
    raise(c, from, to);
    return;
  }
  double z = over->z[0] + m * m * (3 - 2 * m) * up + m * w * (w * p[0] - m * p[1]);
  place middle = center(c, over->x + m, z, slope);
  roll(c, over, (const double[]){t[0], m}, from, &middle, divisions - 1);
  roll(c, over, (const double[]){m, t[1]}, &middle, to, divisions - 1);
}

static void roll_over_all(const curve *c) {
  double unit = 1 / c->spacing, here[2], next[2];
  find_slopes(c, 0, here);
  for (size_t i = 0; i < c->n; i++) {
    find_slopes(c, i + 1, next);
    cubic over = {(double)i, {height(c, i) * unit, height(c, i + 1) * unit}, {here[1], next[0]}};
    place before = center(c, over.x, over.z[0], here[0]);
    place from = center(c, over.x, over.z[0], here[1]);
    place to = center(c, over.x + 1, over.z[1], next[0]);
    raise(c, &before, &from);
    roll(c, &over, (const double[]){0, 1}, &from, &to, DIVISIONS_MOST);
    here[0] = next[0];
    here[1] = next[1];
  }
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
  c.path = aspi_allocate(c.n * fine);
  for (size_t i = 0; c.path && i < c.n * fine; i++)
    c.path[i] = -INFINITY;
  if (c.path)
    roll_over_all(&c);
  size_t kept = periodic ? points * fine : (points - 1) * fine + 1;
  for (size_t i = 0; c.path && i < kept; i++)
    c.path[i] *= step;
  return aspi_profile_adopt(c.path, kept, step, periodic, error);
}

/* Points of a path across the disc, up to the limit of points. */
#define ACROSS 128.0

asp_heights *aspi_profile_path(const asp_heights *profile, double d_p, size_t most,
                               asp_error *error) {
  double length = aspi_heights_extent(profile).length;
  if (aspi_check_positive(error, "d_p", "", d_p))
    return NULL;
  if (d_p > length) {
    aspi_fail(error, ASP_EARG, "d_p is %g; it must be at most the profile's length of %g", d_p,
              length);
    return NULL;
  }
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
