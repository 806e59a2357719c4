/* Flights over a dilated map. The center of the particle flies straight; the dilated wall is
 * bilinear between four points. The gradient at a hit is that of the contact at the nearest corner
 * that faces the particle. A flight skips blocks of cells whose maximum lies below it, in growing
 * steps while nothing is in reach.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dilated_map.h"
#include "base/error.h"

#include <math.h>
#include <stdlib.h>

/* A flight that has passed this many blocks is lost; a sinking flight passes far fewer. */
enum { BLOCKS_MOST = 1000000 };

/* The gradient of a contact differs from that of the surface between the points, so a face may send
 * a particle slightly into its neighbor. After 2 cells below the surface it counts as a hit. */
enum { UNDER_MOST = 2 };

asp_code aspi_dilated_map_create(aspi_dilated_map *f, const asp_map *map, asp_error *error) {
  size_t n = map->columns * map->rows;
  *f = (aspi_dilated_map){.columns = map->columns,
                          .rows = map->rows,
                          .step = {map->step[0], map->step[1]},
                          .memory = malloc(4 * n * sizeof *f->memory)};
  if (!f->memory || !aspi_pyramid_create(&f->pyramid, f->memory + 3 * n, f->columns, f->rows)) {
    free(f->memory);
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a dilated map of %zu x %zu points",
                     map->columns, map->rows);
  }
  f->z = f->memory;
  f->p = f->z + n;
  f->q = f->p + n;
  f->cells = f->q + n;
  return ASP_OK;
}

void aspi_dilated_map_free(aspi_dilated_map *f) {
  free(f->memory);
  free(f->pyramid.memory);
}

void aspi_dilated_map_finish(aspi_dilated_map *f) {
  size_t columns = f->columns, rows = f->rows;
  for (size_t j = 0; j < rows; j++) {
    const float *one = f->z + j * columns, *two = f->z + (j + 1 < rows ? j + 1 : 0) * columns;
    for (size_t i = 0; i < columns; i++) {
      size_t k = i + 1 < columns ? i + 1 : 0;
      f->cells[j * columns + i] =
          aspi_larger_float(aspi_larger_float(one[i], one[k]), aspi_larger_float(two[i], two[k]));
    }
  }
  aspi_pyramid_fill(&f->pyramid);
}

static void reverse(float *values, size_t n, float sign) {
  for (size_t i = 0; i < n - 1 - i; i++) {
    float keep = sign * values[i];
    values[i] = sign * values[n - 1 - i];
    values[n - 1 - i] = keep;
  }
  if (n % 2)
    values[n / 2] *= sign;
}

void aspi_dilated_map_turn(aspi_dilated_map *f) {
  size_t n = f->columns * f->rows;
  reverse(f->z, n, 1);
  reverse(f->p, n, -1);
  reverse(f->q, n, -1);
  aspi_dilated_map_finish(f);
}

/* A cell and its corners. */
typedef struct cell {
  size_t i[2], j[2]; /* columns and rows */
  double z[4];
} cell;

static cell cell_at(const aspi_dilated_map *f, size_t i, size_t j) {
  cell c = {{i, i + 1 < f->columns ? i + 1 : 0}, {j, j + 1 < f->rows ? j + 1 : 0}, {0}};
  for (int k = 0; k < 4; k++)
    c.z[k] = f->z[c.j[k / 2] * f->columns + c.i[k % 2]];
  return c;
}

static double bilinear(const cell *c, double u, double v) {
  return (1 - v) * ((1 - u) * c->z[0] + u * c->z[1]) + v * ((1 - u) * c->z[2] + u * c->z[3]);
}

/* A flight in units of cells along the map: its parameter is the time t. */
typedef struct ray {
  double x[3], v[3];
} ray;

static double along(const ray *r, int axis, double t) {
  return r->x[axis] + t * r->v[axis];
}

/* Height of the flight over the surface of a cell whose corner is (i, j) on the unwrapped map. */
static double over(const ray *r, const cell *c, double i, double j, double t) {
  return along(r, 2, t) - bilinear(c, along(r, 0, t) - i, along(r, 1, t) - j);
}

/* The exact time between t[0] and t[1] at which the flight meets the surface of a cell: over() is a
 * parabola. False if it does not come from above. */
static bool meets(const ray *r, const cell *c, double i, double j, const double t[2], double *at) {
  double a = over(r, c, i, j, t[0]), b = over(r, c, i, j, t[1]);
  double m = over(r, c, i, j, 0.5 * (t[0] + t[1]));
  double curve = 2 * (a + b - 2 * m), slope = b - a - curve;
  if (a <= 0) { /* below the surface already: a hit at the edge if it still sinks */
    *at = t[0];
    return slope < 0;
  }
  /* a + slope s + curve s^2 = 0, the smaller root between 0 and 1. */
  double square = slope * slope - 4 * a * curve;
  if (b > 0 && !(curve > 0 && slope < 0 && slope > -2 * curve && square > 0))
    return false;
  double s = 2 * a / (-slope + sqrt(fmax(0, square)));
  if (!(s >= 0 && s <= 1))
    return false;
  *at = t[0] + s * (t[1] - t[0]);
  return true;
}

/* Bilinear interpolation of the contact gradients at the corners. */
static void blend(const aspi_dilated_map *f, const cell *c, double u, double v,
                  double gradient[2]) {
  gradient[0] = gradient[1] = 0;
  for (int k = 0; k < 4; k++) {
    size_t at = c->j[k / 2] * f->columns + c->i[k % 2];
    double weight = (k % 2 ? u : 1 - u) * (k / 2 ? v : 1 - v);
    gradient[0] += weight * f->p[at];
    gradient[1] += weight * f->q[at];
  }
}

static bool approaches(const double way[3], const double gradient[2]) {
  return way[2] - gradient[0] * way[0] - gradient[1] * way[1] < 0;
}

/* The gradient at a hit: that of the contact at the nearest corner that the particle approaches. If
 * the particle approaches none, the gradient between the corners. On a wall with crests, the
 * contacts between the corners come first. */
static void gradient_at(const aspi_dilated_map *f, const cell *c, double u, double v,
                        const double way[3], double gradient[2]) {
  double nearest = INFINITY;
  if (f->crests) {
    blend(f, c, u, v, gradient);
    if (approaches(way, gradient))
      return;
  }
  gradient[0] = ((1 - v) * (c->z[1] - c->z[0]) + v * (c->z[3] - c->z[2])) / f->step[0];
  gradient[1] = ((1 - u) * (c->z[2] - c->z[0]) + u * (c->z[3] - c->z[1])) / f->step[1];
  for (int k = 0; k < 4; k++) {
    size_t at = c->j[k / 2] * f->columns + c->i[k % 2];
    double p = f->p[at], q = f->q[at], du = u - k % 2, dv = v - k / 2;
    double far = du * du + dv * dv;
    if (far < nearest && way[2] - p * way[0] - q * way[1] < 0) {
      nearest = far;
      gradient[0] = p;
      gradient[1] = q;
    }
  }
}

static double wrapped(double x, double n) {
  x -= n * floor(x / n);
  return x < n ? x : 0;
}

/* The time at which a flight leaves the interval that it is in. */
static double leaves_at(double x, double v, double first, double width) {
  if (v > 0)
    return (first + width - x) / v;
  return v < 0 ? (first - x) / v : INFINITY;
}

/* True if a flight leaves a cell below its surface while it approaches the wall there; sets
 * `gradient` to that of the wall. */
static bool sinks_in(const aspi_dilated_map *f, const ray *r, const cell *c, double i, double j,
                     double t, const double way[3], double gradient[2]) {
  if (over(r, c, i, j, t) > 0)
    return false;
  gradient_at(f, c, along(r, 0, t) - i, along(r, 1, t) - j, way, gradient);
  return approaches(way, gradient);
}

/* Position of a flight at time t and height z. */
static void land(const aspi_dilated_map *f, const ray *r, double t, double z, aspi_flight *flight) {
  flight->x[0] = wrapped(along(r, 0, t), (double)f->columns) * f->step[0];
  flight->x[1] = wrapped(along(r, 1, t), (double)f->rows) * f->step[1];
  flight->x[2] = z;
}

bool aspi_dilated_map_next(const aspi_dilated_map *f, aspi_flight *flight, double gradient[2]) {
  const double *way = flight->v;
  double speed = hypot(way[0], way[1]);
  ray r = {{flight->x[0] / f->step[0], flight->x[1] / f->step[1], flight->x[2]},
           {way[0] / f->step[0], way[1] / f->step[1], way[2]}};
  if (!(speed > 1e-9 * fabs(way[2])))
    return false; /* straight up */
  double n[2] = {(double)f->columns, (double)f->rows}, t = 0;
  double tiny = 1e-7 * fmin(f->step[0], f->step[1]) / speed;
  int k = 0;
  bool clear = false; /* has been over the surface since it started */
  int under = 0;      /* cells left below the surface until then */
  for (int count = 0; count < BLOCKS_MOST; count++) {
    double z = along(&r, 2, t);
    if (way[2] >= 0 && z > f->pyramid.top)
      return false;
    double x = along(&r, 0, t), y = along(&r, 1, t);
    double u = wrapped(x, n[0]), v = wrapped(y, n[1]), width = (double)((size_t)1 << k);
    size_t i = (size_t)u >> k, j = (size_t)v >> k;
    /* A block at the far edge ends with the map. */
    double wide = fmin(width, n[0] - (double)i * width),
           high = fmin(width, n[1] - (double)j * width);
    double last = t + fmin(leaves_at(u, r.v[0], (double)i * width, wide),
                           leaves_at(v, r.v[1], (double)j * width, high));
    double low = fmin(z, along(&r, 2, last));
    if (low > f->pyramid.level[k].most[j * (size_t)f->pyramid.level[k].columns + i]) {
      t = last + tiny;
      clear = true;
      if (k + 1 < f->pyramid.levels)
        k++;
      continue;
    }
    if (k > 0) {
      k--;
      continue;
    }
    cell c = cell_at(f, i, j);
    double ci = (double)i + (x - u), cj = (double)j + (y - v), span[2] = {t, last}, at;
    if (clear && meets(&r, &c, ci, cj, span, &at)) {
      gradient_at(f, &c, along(&r, 0, at) - ci, along(&r, 1, at) - cj, way, gradient);
      land(f, &r, at, along(&r, 2, at), flight);
      return true;
    }
    if (!clear && sinks_in(f, &r, &c, ci, cj, last, way, gradient) && ++under == UNDER_MOST) {
      land(f, &r, last, along(&r, 2, last) - over(&r, &c, ci, cj, last), flight);
      return true;
    }
    clear = clear || over(&r, &c, ci, cj, last) > 0;
    t = last + tiny;
  }
  return false;
}
