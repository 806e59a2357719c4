/* Numbers of a map: heights, slopes, correlation lengths, lay. The autocorrelation comes from tiles
 * padded with zeros (a large map costs no more memory than a tile); each lag is divided by its
 * number of products. On a Gaussian wall with the autocovariance exp(-r' M r) its 1/e contour is an
 * ellipse; M is fitted to the contour by least squares.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/describe.h"
#include "base/error.h"
#include "base/least_squares.h"
#include "surface/profile.h"
#include "base/tolerances.h"

#include <gsl/gsl_statistics_float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TILE_MOST = 1024, DIRECTIONS = 180 };

static void describe_heights(const asp_map *map, asp_map_numbers *d) {
  const float *z = map->heights;
  size_t n = map->columns * map->rows;
  double mean = gsl_stats_float_mean(z, 1, n);
  float lo, hi;
  gsl_stats_float_minmax(&lo, &hi, z, 1, n);
  d->s_q = sqrt(gsl_stats_float_variance_with_fixed_mean(z, 1, n, mean));
  d->s_a = gsl_stats_float_absdev_m(z, 1, n, mean);
  d->s_sk = gsl_stats_float_skew_m_sd(z, 1, n, mean, d->s_q);
  d->s_ku = gsl_stats_float_kurtosis_m_sd(z, 1, n, mean, d->s_q) + 3; /* GSL's is the excess */
  d->s_p = (double)hi - mean;
  d->s_v = mean - (double)lo;
  d->s_z = d->s_p + d->s_v;
}

/* The rms gradient, by differences of neighbors along both axes. */
static double gradient_rms(const asp_map *map) {
  double sum = 0;
  for (int axis = 0; axis < 2; axis++) {
    double square = 0, count = 0, step = map->step[axis];
    size_t columns = map->columns - (axis == 0), rows = map->rows - (axis == 1);
    size_t next = axis ? map->columns : 1;
    for (size_t j = 0; j < rows; j++)
      for (size_t i = 0; i < columns; i++) {
        const float *z = &map->heights[j * map->columns + i];
        double rise = ((double)z[next] - z[0]) / step;
        square += rise * rise;
        count++;
      }
    sum += square / count;
  }
  return sqrt(sum);
}

void aspi_gradient_describe(const float *p, const float *q, size_t n, double lay, double rms[2],
                            double skewness[2], double *mixed) {
  double c = cos(lay), s = sin(lay), square[2] = {0}, cube[2] = {0};
  *mixed = 0;
  for (size_t i = 0; i < n; i++) {
    double slope[2] = {s * p[i] - c * q[i], c * p[i] + s * q[i]};
    for (int axis = 0; axis < 2; axis++) {
      square[axis] += slope[axis] * slope[axis] / (double)n;
      cube[axis] += slope[axis] * slope[axis] * slope[axis] / (double)n;
    }
    *mixed -= slope[0] * slope[1] / (double)n;
  }
  for (int axis = 0; axis < 2; axis++) {
    rms[axis] = sqrt(square[axis]);
    skewness[axis] = cube[axis] / (square[axis] * rms[axis]);
  }
}

/* The autocorrelation at lags up to half a tile either way, row after row, lag 0 in the middle. */
typedef struct correlation {
  size_t reach[2];
  double *values;
} correlation;

/* Sums of products of one tile: its power spectrum, back. */
static void correlate(double *data, size_t columns, size_t rows, double *room) {
  aspi_fft2(data, columns, rows, false, room);
  for (size_t i = 0; i < columns * rows; i++) {
    data[2 * i] = data[2 * i] * data[2 * i] + data[2 * i + 1] * data[2 * i + 1];
    data[2 * i + 1] = 0;
  }
  aspi_fft2(data, columns, rows, true, room);
}

static void load_tile(const asp_map *map, double scale, const size_t first[2], const size_t size[2],
                      size_t columns, size_t rows, double *data) {
  memset(data, 0, 2 * columns * rows * sizeof *data);
  for (size_t j = 0; j < size[1]; j++)
    for (size_t i = 0; i < size[0]; i++)
      data[2 * (j * columns + i)] =
          map->heights[(first[1] + j) * map->columns + first[0] + i] / scale;
}

static void add_lags(correlation *c, const size_t size[2], const double *data, size_t columns,
                     size_t rows, double *weight) {
  long rx = (long)c->reach[0], ry = (long)c->reach[1];
  double n = (double)columns * (double)rows;
  for (long v = -ry; v <= ry; v++)
    for (long u = -rx; u <= rx; u++) {
      size_t i = (size_t)(u < 0 ? u + (long)columns : u), j = (size_t)(v < 0 ? v + (long)rows : v);
      size_t at = (size_t)((v + ry) * (2 * rx + 1) + u + rx);
      c->values[at] += data[2 * (j * columns + i)] / n;
      weight[at] += ((double)size[0] - (double)labs(u)) * ((double)size[1] - (double)labs(v));
    }
}

static asp_code autocorrelation(const asp_map *map, double scale, correlation *c,
                                asp_error *error) {
  size_t size[2] = {map->columns < TILE_MOST ? map->columns : TILE_MOST,
                    map->rows < TILE_MOST ? map->rows : TILE_MOST};
  size_t columns = aspi_power_of_two(2 * size[0]), rows = aspi_power_of_two(2 * size[1]);
  *c = (correlation){{size[0] / 2, size[1] / 2}, NULL};
  size_t lags = (2 * c->reach[0] + 1) * (2 * c->reach[1] + 1);
  c->values = calloc(lags, sizeof *c->values);
  double *weight = calloc(lags, sizeof *weight);
  double *data = aspi_allocate(2 * columns * rows), *room = aspi_allocate(aspi_fft2_room(rows));
  bool made = c->values && weight && data && room;
  for (size_t j = 0; made && j + size[1] <= map->rows; j += size[1])
    for (size_t i = 0; i + size[0] <= map->columns; i += size[0]) {
      load_tile(map, scale, (const size_t[2]){i, j}, size, columns, rows, data);
      correlate(data, columns, rows, room);
      add_lags(c, size, data, columns, rows, weight);
    }
  for (size_t i = 0; made && i < lags; i++)
    c->values[i] /= weight[i];
  free(weight);
  free(data);
  free(room);
  if (made)
    return ASP_OK;
  free(c->values);
  return aspi_fail(error, ASP_ENOMEM, "out of memory for the autocorrelation of a map");
}

/* Between the lags, bilinear; x and y in steps. */
static double at_lag(const correlation *c, double x, double y) {
  size_t width = 2 * c->reach[0] + 1;
  double u = x + (double)c->reach[0], v = y + (double)c->reach[1];
  size_t i = (size_t)u, j = (size_t)v;
  const double *z = c->values + j * width + i;
  u -= (double)i;
  v -= (double)j;
  return (1 - v) * ((1 - u) * z[0] + u * z[1]) + v * ((1 - u) * z[width] + u * z[width + 1]);
}

/* The distance at which the autocorrelation first falls to the level along a direction; 0 when it
 * does not within the lags that there are. */
static double contour(const asp_map *map, const correlation *c, double angle, double level) {
  double ex = cos(angle) / map->step[0], ey = sin(angle) / map->step[1];
  double step = 1 / fmax(fabs(ex), fabs(ey)), before = 1;
  double whole = at_lag(c, 0, 0);
  for (double r = step;; r += step) {
    double x = r * ex, y = r * ey;
    if (fabs(x) >= (double)c->reach[0] - 1 || fabs(y) >= (double)c->reach[1] - 1)
      return 0;
    double here = at_lag(c, x, y) / whole;
    if (here <= level)
      return r - step * (level - here) / (before - here);
    before = here;
  }
}

/* The symmetric M with r' M r = 1 nearest to the points, by least squares; false where they do not
 * fix it. */
static bool fit_ellipse(const double (*point)[2], size_t count, double m[3]) {
  aspi_least_squares fit = {.terms = 3};
  for (size_t i = 0; i < count; i++) {
    double x = point[i][0], y = point[i][1];
    aspi_least_squares_add(&fit, (const double[3]){x * x, 2 * x * y, y * y}, 1);
  }
  if (!aspi_least_squares_solve(&fit))
    return false;
  memcpy(m, fit.b, 3 * sizeof *m);
  return m[0] > 0 && m[2] > 0 && m[0] * m[2] > m[1] * m[1];
}

static void describe_axes(const double m[3], asp_map_numbers *d) {
  double mean = 0.5 * (m[0] + m[2]), half = hypot(0.5 * (m[0] - m[2]), m[1]);
  d->lambda_1 = 1 / sqrt(mean + half);
  d->lambda_2 = 1 / sqrt(mean - half);
  /* The eigenvector of the smaller eigenvalue. */
  double angle = 0.5 * atan2(2 * m[1], m[0] - m[2]) + ASP_PI / 2;
  d->lay = fmod(angle + 2 * ASP_PI, ASP_PI);
}

static asp_code describe_lengths(const asp_map *map, asp_map_numbers *d, asp_error *error) {
  correlation c;
  asp_code code = autocorrelation(map, d->s_q, &c, error);
  if (code)
    return code;
  double point[DIRECTIONS][2], m[3], most = 0;
  size_t count = 0;
  d->s_al = INFINITY;
  bool long_enough = true;
  for (int k = 0; k < DIRECTIONS; k++) {
    double angle = ASP_PI * k / DIRECTIONS;
    double r = contour(map, &c, angle, ASP_LEVEL_1_E),
           far = contour(map, &c, angle, ASP_LEVEL_S_AL);
    if (r > 0) {
      point[count][0] = r * cos(angle);
      point[count++][1] = r * sin(angle);
    }
    if (far > 0) {
      d->s_al = fmin(d->s_al, far);
      most = fmax(most, far);
    }
    long_enough = long_enough && far > 0;
  }
  free(c.values);
  if (count < 3 || !fit_ellipse((const double(*)[2])point, count, m))
    return aspi_fail(error, ASP_EDATA,
                     "the autocorrelation does not fall to 1/e within half the map: it is too "
                     "small, or form is left in it");
  d->s_tr = long_enough ? d->s_al / most : NAN;
  describe_axes(m, d);
  return ASP_OK;
}

asp_code asp_map_describe(const asp_map *map, asp_map_numbers *numbers, asp_error *error) {
  asp_map_numbers d = {0};
  describe_heights(map, &d);
  if (!(d.s_q > ASPI_ROUNDING_SINGLE * fmax(d.s_p, d.s_v)))
    return aspi_fail(error, ASP_EDATA, "the map is constant");
  d.s_dq = gradient_rms(map);
  asp_code code = describe_lengths(map, &d, error);
  *numbers = d;
  return code;
}

asp_code aspi_map_check(const asp_map *map, const asp_map_numbers *d, double phi_r_most,
                        asp_error *error) {
  return aspi_roughness_check("shorter ", d->lambda_1, fmin(map->step[0], map->step[1]), "",
                              "S_q/lambda_1", d->s_q / d->lambda_1, phi_r_most, error);
}
