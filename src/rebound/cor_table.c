/* Tables of coefficients of restitution: made from points, checked for gaps and double values, read
 * from a file, interpolated. Speed by speed a monotone cubic in the angle (Steffen 1990; a straight
 * line where there are only two angles), and a straight line between speeds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/cor_table.h"
#include "base/table.h"
#include "base/error.h"
#include "base/grow.h"
#include "base/monotone.h"

#include <gsl/gsl_interp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEGREES (180 / ASP_PI)

/* Angles of a table are at least this far apart, in radians, so that slopes between them are
 * numbers.
 */
#define APART_LEAST 1e-9

/* Energy that rounding of a file's coefficients may seem to create. */
#define ENERGY_MOST (1 + 1e-6)

struct aspi_cor_table {
  size_t n_speeds, n_angles;
  double *speeds, *angles;
  double *cor_n, *cor_t;         /* [speed][angle] */
  double *tangent_n, *tangent_t; /* of them over the angle */
  double room[];                 /* of all six */
};

static int compare(const void *left, const void *right) {
  const aspi_cor_point *a = left, *b = right;
  if (a->speed < b->speed || a->speed > b->speed)
    return a->speed < b->speed ? -1 : 1;
  return (a->alpha1 > b->alpha1) - (a->alpha1 < b->alpha1);
}

static bool same(double a, double b) {
  return !(a < b || a > b);
}

static asp_code check_energy(const aspi_cor_point *p, asp_error *error) {
  double energy = pow(p->cor_n * sin(p->alpha1), 2) + pow(p->cor_t * cos(p->alpha1), 2);
  if (energy <= ENERGY_MOST)
    return ASP_OK;
  return aspi_fail(error, ASP_EARG,
                   "cor_n %g and cor_t %g at %g degrees leave %g times the energy; it must be 1 "
                   "at most",
                   p->cor_n, p->cor_t, p->alpha1 * DEGREES, energy);
}

/* The sorted points are a grid when every speed has the angles of the first. */
static asp_code check_grid(const aspi_cor_point *p, size_t count, size_t n_angles,
                           asp_error *error) {
  for (size_t i = 1; i < count; i++)
    if (compare(&p[i - 1], &p[i]) == 0)
      return aspi_fail(error, ASP_EDATA,
                       "two rows for speed %g and %g degrees: a law needs one value in one place",
                       p[i].speed, p[i].alpha1 * DEGREES);
  if (n_angles < 2)
    return aspi_fail(error, ASP_EDATA, "one angle at speed %g; at least two are needed", p->speed);
  for (size_t i = 1; i < n_angles; i++)
    if (p[i].alpha1 - p[i - 1].alpha1 < APART_LEAST)
      return aspi_fail(error, ASP_EDATA,
                       "angles of %g and %g degrees; they must be at least %.2g degrees apart",
                       p[i - 1].alpha1 * DEGREES, p[i].alpha1 * DEGREES, APART_LEAST * DEGREES);
  for (size_t i = n_angles; i < count || i % n_angles; i++) {
    const aspi_cor_point *want = &p[i % n_angles], *row = &p[i - i % n_angles];
    if (i >= count || !same(p[i].alpha1, want->alpha1) || !same(p[i].speed, row->speed))
      return aspi_fail(error, ASP_EDATA,
                       "a gap or an odd angle near speed %g and %g degrees: every speed needs the "
                       "same angles",
                       row->speed, want->alpha1 * DEGREES);
  }
  return ASP_OK;
}

static aspi_cor_table *allocate(size_t n_speeds, size_t n_angles) {
  size_t count = n_speeds * n_angles, numbers = n_speeds + n_angles + 4 * count;
  aspi_cor_table *t = numbers < SIZE_MAX / sizeof(double) / 2
                          ? malloc(sizeof *t + numbers * sizeof *t->room)
                          : NULL;
  if (!t)
    return NULL;
  t->n_speeds = n_speeds;
  t->n_angles = n_angles;
  t->speeds = t->room;
  t->angles = t->speeds + n_speeds;
  t->cor_n = t->angles + n_angles;
  t->cor_t = t->cor_n + count;
  t->tangent_n = t->cor_t + count;
  t->tangent_t = t->tangent_n + count;
  return t;
}

/* A table of sorted points that are a grid; NULL without memory. */
static aspi_cor_table *make(const aspi_cor_point *p, size_t count, size_t n_angles) {
  aspi_cor_table *t = allocate(count / n_angles, n_angles);
  if (!t)
    return NULL;
  for (size_t i = 0; i < count; i++) {
    t->cor_n[i] = p[i].cor_n;
    t->cor_t[i] = p[i].cor_t;
    t->angles[i % n_angles] = p[i % n_angles].alpha1;
    t->speeds[i / n_angles] = p[i].speed;
  }
  for (size_t i = 0; i < count; i += n_angles) {
    aspi_monotone_tangents(t->angles, &t->cor_n[i], n_angles, &t->tangent_n[i]);
    aspi_monotone_tangents(t->angles, &t->cor_t[i], n_angles, &t->tangent_t[i]);
  }
  return t;
}

aspi_cor_table *aspi_cor_table_create(const aspi_cor_point *points, size_t count,
                                      asp_error *error) {
  if (count == 0)
    return aspi_fail_null(error, ASP_EDATA, "a table of coefficients without a row");
  aspi_cor_point *sorted = malloc(count * sizeof *sorted);
  aspi_cor_table *table = NULL;
  size_t n_angles = 1;
  asp_code code = ASP_ENOMEM;
  if (sorted) {
    for (size_t i = 0; i < count; i++)
      sorted[i] = points[i];
    qsort(sorted, count, sizeof *sorted, compare);
    while (n_angles < count && same(sorted[n_angles].speed, sorted[0].speed))
      n_angles++;
    code = check_grid(sorted, count, n_angles, error);
    table = code ? NULL : make(sorted, count, n_angles);
  }
  free(sorted);
  if (!table && (!code || code == ASP_ENOMEM))
    aspi_fail(error, ASP_ENOMEM, "out of memory for a table of %zu coefficients", count);
  return table;
}

aspi_cor_table *aspi_cor_table_copy(const aspi_cor_table *t) {
  aspi_cor_table *copy = allocate(t->n_speeds, t->n_angles);
  if (copy)
    memcpy(copy->room, t->room,
           (t->n_speeds + t->n_angles + 4 * t->n_speeds * t->n_angles) * sizeof *t->room);
  return copy;
}

void aspi_cor_table_free(aspi_cor_table *t) {
  free(t);
}

typedef struct columns {
  int angle, speed, cor_n, cor_t;
} columns;

static asp_code read_point(const aspi_table *file, const columns *at, double meter_per_second,
                           aspi_cor_point *p, asp_error *error) {
  double degrees, speed = 0;
  asp_error wrong;
  asp_code code;
  if ((code = aspi_table_number(file, at->angle, 0, 90, &degrees, NULL, error)) ||
      (code = aspi_table_number(file, at->cor_n, 0, 1e9, &p->cor_n, NULL, error)) ||
      (code = aspi_table_number(file, at->cor_t, -1e9, 1e9, &p->cor_t, NULL, error)) ||
      (at->speed >= 0 && (code = aspi_table_number(file, at->speed, 0, 1e9, &speed, NULL, error))))
    return code;
  p->speed = speed * meter_per_second;
  p->alpha1 = fmin(degrees / DEGREES, ASP_PI / 2);
  return check_energy(p, &wrong) ? aspi_table_fail(file, error, "%s", wrong.text) : ASP_OK;
}

/* All points of the file, to be freed by the caller; NULL on error. */
static aspi_cor_point *read_points(aspi_table *file, double meter_per_second, size_t *count,
                                   asp_error *error) {
  bool means = aspi_table_find(file, "cor_n_mean") >= 0; /* as those of a publication are called */
  columns at = {aspi_table_need(file, "alpha1_deg", error), aspi_table_find(file, "v1_m_s"),
                aspi_table_need(file, means ? "cor_n_mean" : "cor_n", error),
                aspi_table_need(file, means ? "cor_t_mean" : "cor_t", error)};
  aspi_cor_point *points = NULL;
  asp_code code = at.angle < 0 || at.cor_n < 0 || at.cor_t < 0 ? ASP_EDATA : ASP_OK;
  bool found = !code;
  for (*count = 0; found && !code; (*count)++) {
    aspi_cor_point *grown = aspi_grow(points, *count, sizeof *points);
    if (!grown) {
      code = aspi_fail(error, ASP_ENOMEM, "out of memory for a table of coefficients");
      break;
    }
    points = grown;
    code = aspi_table_row(file, &found, error);
    if (code || !found)
      break;
    code = read_point(file, &at, meter_per_second, &points[*count], error);
  }
  if (!code)
    return points;
  free(points);
  return NULL;
}

aspi_cor_table *aspi_cor_table_read(const char *path, double meter_per_second, asp_error *error) {
  aspi_table *file = aspi_table_open(NULL, path, 0, error);
  size_t count = 0;
  aspi_cor_point *points = file ? read_points(file, meter_per_second, &count, error) : NULL;
  aspi_cor_table *table = NULL;
  asp_error wrong;
  if (points && !(table = aspi_cor_table_create(points, count, &wrong)))
    aspi_fail(error, wrong.code, "%.150s: %.300s", path, wrong.text);
  free(points);
  aspi_table_close(file);
  return table;
}

/* Index of the last speed at or below this one, and the fraction of the step to the next. */
static size_t find_speed(const aspi_cor_table *t, double speed, double *part) {
  *part = 0;
  if (!(speed > t->speeds[0]))
    return 0;
  if (speed >= t->speeds[t->n_speeds - 1])
    return t->n_speeds - 1;
  size_t i = gsl_interp_bsearch(t->speeds, speed, 0, t->n_speeds - 1);
  *part = (speed - t->speeds[i]) / (t->speeds[i + 1] - t->speeds[i]);
  return i;
}

static double in_angle(const aspi_cor_table *t, const double *cor, const double *tangent,
                       size_t speed, double angle) {
  size_t at = speed * t->n_angles;
  return aspi_monotone_at(t->angles, &cor[at], &tangent[at], t->n_angles, angle);
}

void aspi_cor_table_at(const aspi_cor_table *t, double speed, double alpha1, double *cor_n,
                       double *cor_t) {
  double part, angle = fmin(fmax(alpha1, t->angles[0]), t->angles[t->n_angles - 1]);
  size_t i = find_speed(t, speed, &part);
  *cor_n = in_angle(t, t->cor_n, t->tangent_n, i, angle);
  *cor_t = in_angle(t, t->cor_t, t->tangent_t, i, angle);
  if (!(part > 0))
    return;
  *cor_n += part * (in_angle(t, t->cor_n, t->tangent_n, i + 1, angle) - *cor_n);
  *cor_t += part * (in_angle(t, t->cor_t, t->tangent_t, i + 1, angle) - *cor_t);
}
