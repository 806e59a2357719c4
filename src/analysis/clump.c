/* Clumps of spheres; see clump.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/clump.h"
#include "base/csv.h"
#include "base/error.h"
#include "base/stream.h"

#include <math.h>
#include <stdlib.h>

enum { SPHERES_MOST = 10000, LINES = 400 };

/* Volume, first and second moments (xx, yy, zz, xy, xz, yz) of what the spheres cover. */
typedef struct moments {
  double volume, first[3], second[6];
} moments;

static void add_sphere(moments *m, const double c[3], double d) {
  double volume = ASP_PI / 6 * d * d * d, own = d * d / 20;
  static const int of[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  m->volume += volume;
  for (int k = 0; k < 3; k++)
    m->first[k] += volume * c[k];
  for (int k = 0; k < 6; k++)
    m->second[k] += volume * (c[of[k][0]] * c[of[k][1]] + (k < 3 ? own : 0));
}

/* A part of a line along x, of cross section `area`. */
static void add_part(moments *m, double from, double to, double y, double z, double area) {
  double length = (to - from) * area, x = 0.5 * (from + to), w = (to - from) * (to - from) / 12;
  const double first[3] = {x, y, z}, second[6] = {x * x + w, y * y, z * z, x * y, x * z, y * z};
  m->volume += length;
  for (int k = 0; k < 3; k++)
    m->first[k] += length * first[k];
  for (int k = 0; k < 6; k++)
    m->second[k] += length * second[k];
}

static int by_begin(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* The parts of one line that the spheres cover, each once. */
static void add_line(moments *m, const aspi_clump *c, double y, double z, double area,
                     double (*parts)[2]) {
  size_t count = 0;
  for (int i = 0; i < c->count; i++) {
    double dy = y - c->centers[i][1], dz = z - c->centers[i][2];
    double half2 = 0.25 * c->d[i] * c->d[i] - dy * dy - dz * dz;
    if (half2 > 0) {
      parts[count][0] = c->centers[i][0] - sqrt(half2);
      parts[count++][1] = c->centers[i][0] + sqrt(half2);
    }
  }
  qsort(parts, count, sizeof *parts, by_begin);
  for (size_t i = 0, next; i < count; i = next) {
    double to = parts[i][1];
    for (next = i + 1; next < count && parts[next][0] <= to; next++)
      to = fmax(to, parts[next][1]);
    add_part(m, parts[i][0], to, y, z, area);
  }
}

static bool overlap(const aspi_clump *c) {
  for (int i = 0; i < c->count; i++)
    for (int k = 0; k < i; k++) {
      double apart =
          hypot(hypot(c->centers[i][0] - c->centers[k][0], c->centers[i][1] - c->centers[k][1]),
                c->centers[i][2] - c->centers[k][2]);
      if (apart < 0.5 * (c->d[i] + c->d[k]) * (1 - 1e-9))
        return true;
    }
  return false;
}

static bool add_lines(moments *m, const aspi_clump *c) {
  double low[3] = {0}, high[3] = {0};
  double(*parts)[2] = calloc((size_t)c->count, sizeof *parts);
  if (!parts)
    return false;
  for (int k = 1; k < 3; k++) {
    low[k] = INFINITY;
    high[k] = -INFINITY;
    for (int i = 0; i < c->count; i++) {
      low[k] = fmin(low[k], c->centers[i][k] - 0.5 * c->d[i]);
      high[k] = fmax(high[k], c->centers[i][k] + 0.5 * c->d[i]);
    }
  }
  double dy = (high[1] - low[1]) / LINES, dz = (high[2] - low[2]) / LINES;
  for (int i = 0; i < LINES; i++)
    for (int k = 0; k < LINES; k++)
      add_line(m, c, low[1] + (i + 0.5) * dy, low[2] + (k + 0.5) * dz, dy * dz, parts);
  free(parts);
  return true;
}

/* Moves the center of mass to 0, and scales the clump. */
static bool complete(aspi_clump *c) {
  moments m = {0};
  if (!overlap(c))
    for (int i = 0; i < c->count; i++)
      add_sphere(&m, c->centers[i], c->d[i]);
  else if (!add_lines(&m, c))
    return false;
  double d = cbrt(6 / ASP_PI * m.volume), s[6];
  const double center[3] = {m.first[0] / m.volume, m.first[1] / m.volume, m.first[2] / m.volume};
  static const int of[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (int k = 0; k < 6; k++)
    s[k] = (m.second[k] - m.volume * center[of[k][0]] * center[of[k][1]]) / (d * d * d * d * d);
  const double inertia[6] = {s[1] + s[2], s[0] + s[2], s[0] + s[1], -s[3], -s[4], -s[5]};
  for (int k = 0; k < 6; k++)
    c->inertia[k] = inertia[k];
  for (int i = 0; i < c->count; i++) {
    c->d[i] /= d;
    for (int k = 0; k < 3; k++)
      c->centers[i][k] = (c->centers[i][k] - center[k]) / d;
  }
  return true;
}

static asp_code read_spheres(aspi_clump *c, aspi_csv *csv, const char *path, asp_error *error) {
  static const char *const names[] = {"x", "y", "z", "d"};
  int columns[4];
  bool found = true;
  for (int k = 0; k < 4; k++)
    if ((columns[k] = aspi_csv_need(csv, names[k], error)) < 0)
      return ASP_EDATA;
  for (;;) {
    asp_code code = aspi_csv_row(csv, &found, error);
    if (code || !found)
      return code ? code
             : c->count > 0
                 ? ASP_OK
                 : aspi_fail(error, ASP_EDATA, "%s has no sphere; it must have at least one", path);
    if (c->count == SPHERES_MOST)
      return aspi_fail(error, ASP_EDATA, "%s has over %d spheres", path, SPHERES_MOST);
    double row[4];
    for (int k = 0; k < 4 && !code; k++)
      code = aspi_csv_number(csv, columns[k], k < 3 ? -1e12 : 1e-12, 1e12, &row[k], NULL, error);
    if (code)
      return code;
    for (int k = 0; k < 3; k++)
      c->centers[c->count][k] = row[k];
    c->d[c->count++] = row[3];
  }
}

aspi_clump *aspi_clump_read(const char *path, asp_error *error) {
  aspi_csv *csv = aspi_csv_open(path, error);
  aspi_clump *c = csv ? calloc(1, sizeof *c) : NULL;
  asp_code code = ASP_OK;
  if (c) {
    c->centers = calloc(SPHERES_MOST, sizeof *c->centers);
    c->d = calloc(SPHERES_MOST, sizeof *c->d);
  }
  if (csv && (!c || !c->centers || !c->d))
    code = aspi_fail(error, ASP_ENOMEM, "out of memory for a clump");
  else if (csv)
    code = read_spheres(c, csv, path, error);
  if (csv && !code && !complete(c))
    code = aspi_fail(error, ASP_ENOMEM, "out of memory for a clump");
  if (csv)
    aspi_csv_close(csv);
  if (csv && !code)
    return c;
  aspi_clump_free(c);
  return NULL;
}

void aspi_clump_free(aspi_clump *clump) {
  if (clump) {
    free(clump->centers);
    free(clump->d);
  }
  free(clump);
}

/* The rotation of a random unit quaternion. */
static void random_rotation(aspi_stream *s, double r[3][3]) {
  double q[4], sum = 0;
  for (int k = 0; k < 4; k++) {
    q[k] = aspi_stream_normal(s);
    sum += q[k] * q[k];
  }
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++) {
      int other = 3 - i - k; /* where i and k differ */
      double sign = (k - i + 3) % 3 == 1 ? -1 : 1;
      r[i][k] = i == k ? 1 - 2 * (sum - q[0] * q[0] - q[1 + i] * q[1 + i]) / sum
                       : 2 * (q[1 + i] * q[1 + k] + sign * q[0] * q[1 + other]) / sum;
    }
}

asp_body aspi_clump_turned(const aspi_clump *c, double d_p, double density, const asp_key *key,
                           double *d) {
  double r[3][3], lowest = INFINITY;
  aspi_stream stream = aspi_stream_begin(key);
  random_rotation(&stream, r);
  asp_body body = {6 / (ASP_PI * density * d_p * d_p * d_p), {0}, {0}};
  for (int i = 0; i < c->count; i++) {
    double at[3];
    for (int k = 0; k < 3; k++)
      at[k] = r[k][0] * c->centers[i][0] + r[k][1] * c->centers[i][1] + r[k][2] * c->centers[i][2];
    if (!(at[2] - 0.5 * c->d[i] < lowest))
      continue;
    lowest = at[2] - 0.5 * c->d[i];
    *d = c->d[i] * d_p;
    for (int k = 0; k < 3; k++)
      body.lever[k] = at[k] * d_p;
  }
  const double *m = c->inertia;
  double a = m[1] * m[2] - m[5] * m[5], b = m[4] * m[5] - m[3] * m[2],
         e = m[3] * m[5] - m[4] * m[1];
  double unit = (m[0] * a + m[3] * b + m[4] * e) * density * d_p * d_p * d_p * d_p * d_p;
  const double own[3][3] = {{a, b, e},
                            {b, m[0] * m[2] - m[4] * m[4], m[3] * m[4] - m[0] * m[5]},
                            {e, m[3] * m[4] - m[0] * m[5], m[0] * m[1] - m[3] * m[3]}};
  static const int of[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (int k = 0; k < 6; k++)
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++)
        body.inverse_inertia[k] += r[of[k][0]][i] * own[i][j] * r[of[k][1]][j] / unit;
  return body;
}
