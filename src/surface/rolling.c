/* The path of the centre of a disc over a smooth periodic profile that is known by its points. The
 * disc touches the curve through the points, not only the points: where it touches at x with slope
 * p, its centre is at x - r sin(atan p), z + r cos(atan p), and has the slope p. The path is the
 * upper envelope of these places. (Dilation, closing.c, takes the points as the whole profile: the
 * slopes that a disc of a few spacings meets then crowd at multiples of the spacing over its
 * radius.)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/closing.h"
#include "surface/profile.h"

#include <math.h>
#include <stdlib.h>

/* A place of the centre, in spacings, and the slope there. */
typedef struct place {
  double x, z, slope;
} place;

/* Slopes by differences of fourth order. */
static place place_at(const double *z, size_t n, double unit, double radius, size_t i) {
  double near = z[(i + 1) % n] - z[(i + n - 1) % n], far = z[(i + 2) % n] - z[(i + n - 2) % n];
  double p = (8 * near - far) / 12 * unit, cosine = 1 / sqrt(1 + p * p);
  return (place){(double)i - radius * p * cosine, z[i] * unit + radius * cosine, p};
}

/* Raises the path between two places to the arc that they are on. */
static void raise(double *path, size_t n, const place *from, const place *to) {
  double width = to->x - from->x, length = (double)n;
  for (double at = ceil(from->x); at <= to->x; at++) {
    double t = (at - from->x) / width;
    double z =
        from->z + t * (to->z - from->z) + 0.5 * width * t * (1 - t) * (from->slope - to->slope);
    size_t i = (size_t)(at - length * floor(at / length));
    path[i] = fmax(path[i], z);
  }
}

asp_profile *aspi_profile_rolled(const asp_profile *profile, double d_p, asp_error *error) {
  size_t n = asp_profile_points(profile);
  double spacing = asp_profile_spacing(profile), radius = 0.5 * d_p / spacing;
  const double *z = asp_profile_heights(profile);
  double *path = aspi_allocate(n);
  for (size_t i = 0; path && i < n; i++)
    path[i] = -INFINITY;
  for (size_t i = 0; path && i < n; i++) {
    place from = place_at(z, n, 1 / spacing, radius, i);
    place to = place_at(z, n, 1 / spacing, radius, (i + 1) % n);
    if (i + 1 == n)
      to.x += (double)n;
    if (to.x > from.x)
      raise(path, n, &from, &to);
  }
  for (size_t i = 0; path && i < n; i++)
    path[i] *= spacing;
  return aspi_profile_adopt(path, n, spacing, true, error);
}
