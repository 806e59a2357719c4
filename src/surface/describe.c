/* Numbers of a profile or a map: heights, slopes, correlation lengths, lay. The autocorrelation
 * comes from tiles padded with zeros (a large map costs no more memory than a tile; a profile is
 * one tile). Each lag is divided by its number of products; divided by the number of points, which
 * damps lags with few products, lambda_c of profiles 7 to 17 lambda_c long was another 6 to 4 %
 * smaller. On a Gaussian wall with the autocovariance exp(-r' M r) its 1/e contour is an ellipse; M
 * is fitted to the contour by least squares.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/describe.h"
#include "base/error.h"
#include "base/least_squares.h"
#include "base/tolerances.h"
#include "surface/ball.h"
#include "surface/rolling.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A correlation length of fewer spacings is that of noise: white noise has 0.63 by the 1/e lag. */
#define SPACINGS_LEAST 1.5

/* A larger phi_r is that of wrong units. */
#define PHI_R_MOST 1.

/* Levels of the autocorrelation that define correlation lengths. */
#define LEVEL_1_E 0.36787944117144233
#define LEVEL_S_AL 0.2 /* S_al of ISO 25178-2 */

enum { TILE_MOST = 1024, DIRECTIONS = 180 };

/* The share of a profile in the length of all; of a map 1. */
static double share_of(const asp_heights *h, const asp_heights *all) {
  return h->rows > 1 ? 1 : aspi_profile_length(h) / aspi_heights_extent(all).total;
}

static void describe_heights(const asp_heights *all, asp_heights_numbers *d) {
  double square = 0, skew = 0, excess = 0;
  for (const asp_heights *h = all; h; h = h->next) {
    size_t n = h->columns * h->rows;
    double lo, hi, mean = gsl_stats_mean(h->z, 1, n), part = share_of(h, all);
    gsl_stats_minmax(&lo, &hi, h->z, 1, n);
    d->mean += part * mean;
    square += part * gsl_stats_variance_with_fixed_mean(h->z, 1, n, mean);
    d->s_a += part * gsl_stats_absdev_m(h->z, 1, n, mean);
    d->s_p = fmax(d->s_p, hi - mean);
    d->s_v = fmax(d->s_v, mean - lo);
  }
  d->s_q = sqrt(square);
  for (const asp_heights *h = all; h; h = h->next) {
    size_t n = h->columns * h->rows;
    double mean = gsl_stats_mean(h->z, 1, n), part = share_of(h, all);
    skew += part * gsl_stats_skew_m_sd(h->z, 1, n, mean, d->s_q);
    excess += part * gsl_stats_kurtosis_m_sd(h->z, 1, n, mean, d->s_q);
  }
  d->s_sk = skew;
  d->s_ku = excess + 3; /* GSL's is the excess */
  d->s_z = d->s_p + d->s_v;
}

/* The mean square gradient, by differences of neighbors along both axes. */
static double gradient_square(const asp_heights *h) {
  double sum = 0;
  for (int axis = 0; axis < (h->rows > 1 ? 2 : 1); axis++) {
    double square = 0, count = 0;
    size_t columns = h->columns - (axis == 0 && !h->periodic),
           rows = h->rows - (axis == 1 && !h->periodic);
    for (size_t j = 0; j < rows; j++)
      for (size_t i = 0; i < columns; i++) {
        size_t next = axis ? (j + 1) % h->rows * h->columns + i
                           : j * h->columns + (i + 1 < h->columns ? i + 1 : 0);
        double rise = (h->z[next] - h->z[j * h->columns + i]) / h->step[axis];
        square += rise * rise;
        count++;
      }
    sum += square / count;
  }
  return sum;
}

void aspi_gradient_describe(const float *p, const float *q, size_t n, double lay, double rms[2],
                            double skewness[2]) {
  double c = cos(lay), s = sin(lay), square[2] = {0}, cube[2] = {0};
  for (size_t i = 0; i < n; i++) {
    double slope[2] = {s * p[i] - c * q[i], c * p[i] + s * q[i]};
    for (int axis = 0; axis < 2; axis++) {
      square[axis] += slope[axis] * slope[axis] / (double)n;
      cube[axis] += slope[axis] * slope[axis] * slope[axis] / (double)n;
    }
  }
  for (int axis = 0; axis < 2; axis++) {
    rms[axis] = sqrt(square[axis]);
    skewness[axis] = cube[axis] / (square[axis] * rms[axis]);
  }
}

/* The autocorrelation of a map or of one of several profiles, at lags up to half a tile either way,
 * row after row, lag 0 in the middle. */
typedef struct correlation {
  const asp_heights *of;
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

static void load_tile(const asp_heights *h, double mean, double s_q, const size_t first[2],
                      const size_t size[2], size_t columns, size_t rows, double *data) {
  memset(data, 0, 2 * columns * rows * sizeof *data);
  for (size_t j = 0; j < size[1]; j++)
    for (size_t i = 0; i < size[0]; i++)
      data[2 * (j * columns + i)] = (h->z[(first[1] + j) * h->columns + first[0] + i] - mean) / s_q;
}

/* The sum of products at lag (u, v), of data padded with zeros; if the tile `wraps`, with those
 * across its edges. */
static double products(const double *data, const long padded[2], const long size[2], bool wraps,
                       long u, long v) {
  double sum = 0;
  for (int b = 0; b <= (wraps && size[1] > 1); b++)
    for (int a = 0; a <= wraps; a++) {
      long x = u - a * (u > 0 ? size[0] : -size[0]), y = v - b * (v > 0 ? size[1] : -size[1]);
      x += x < 0 ? padded[0] : 0;
      y += y < 0 ? padded[1] : 0;
      sum += data[2 * (y * padded[0] + x)];
    }
  return sum / ((double)padded[0] * (double)padded[1]);
}

static void add_lags(correlation *c, const double *data, const long padded[2], const long size[2],
                     bool wraps, double *weight) {
  long rx = (long)c->reach[0], ry = (long)c->reach[1];
  size_t at = 0;
  for (long v = -ry; v <= ry; v++)
    for (long u = -rx; u <= rx; u++, at++) {
      c->values[at] += products(data, padded, size, wraps, u, v);
      weight[at] +=
          (double)(size[0] - (wraps ? 0 : labs(u))) * (double)(size[1] - (wraps ? 0 : labs(v)));
    }
}

static asp_code autocorrelation(const asp_heights *h, double s_q, correlation *c,
                                asp_error *error) {
  bool is_map = h->rows > 1;
  size_t size[2] = {is_map && h->columns > TILE_MOST ? TILE_MOST : h->columns,
                    h->rows < TILE_MOST ? h->rows : TILE_MOST};
  bool wraps = h->periodic && size[0] == h->columns && size[1] == h->rows;
  size_t columns = aspi_power_of_two(2 * size[0]),
         rows = is_map ? aspi_power_of_two(2 * size[1]) : 1;
  double mean = gsl_stats_mean(h->z, 1, h->columns * h->rows);
  *c = (correlation){h, {size[0] / 2, size[1] / 2}, NULL};
  size_t lags = (2 * c->reach[0] + 1) * (2 * c->reach[1] + 1);
  c->values = calloc(lags, sizeof *c->values);
  double *weight = calloc(lags, sizeof *weight);
  double *data = aspi_allocate(2 * columns * rows), *room = aspi_allocate(aspi_fft2_room(rows));
  bool made = c->values && weight && data && room;
  for (size_t j = 0; made && j + size[1] <= h->rows; j += size[1])
    for (size_t i = 0; i + size[0] <= h->columns; i += size[0]) {
      load_tile(h, mean, s_q, (const size_t[2]){i, j}, size, columns, rows, data);
      correlate(data, columns, rows, room);
      add_lags(c, data, (const long[2]){(long)columns, (long)rows},
               (const long[2]){(long)size[0], (long)size[1]}, wraps, weight);
    }
  for (size_t i = 0; made && i < lags; i++)
    c->values[i] /= weight[i];
  free(weight);
  free(data);
  free(room);
  if (made)
    return ASP_OK;
  free(c->values);
  return aspi_fail(error, ASP_ENOMEM, "out of memory for the autocorrelation of a %s",
                   aspi_kind_of_rows(h->rows));
}

/* Between the lags, bilinear; x and y in steps. */
static double at_lag_of(const correlation *c, double x, double y) {
  size_t width = 2 * c->reach[0] + 1, height = 2 * c->reach[1] + 1;
  double u = x + (double)c->reach[0], v = y + (double)c->reach[1];
  size_t i = (size_t)u, j = (size_t)v;
  size_t right = i + 1 < width ? 1 : 0, up = j + 1 < height ? width : 0;
  const double *z = c->values + j * width + i;
  u -= (double)i;
  v -= (double)j;
  return (1 - v) * ((1 - u) * z[0] + u * z[right]) + v * ((1 - u) * z[up] + u * z[up + right]);
}

/* The mean over profiles that reach so far, each by the length of its products. NAN: none does. */
static double at_lag(const correlation *c, size_t count, double x, double y) {
  double sum = 0, all = 0;
  for (; count > 0; count--, c++) {
    double u = x / c->of->step[0], v = y / c->of->step[1];
    if (fabs(u) > (double)c->reach[0] || fabs(v) > (double)c->reach[1])
      continue;
    double length = aspi_profile_length(c->of) - fabs(x);
    sum += length * at_lag_of(c, u, v);
    all += length;
  }
  return sum / all;
}

/* The distance at which the autocorrelation first falls to the level along a direction; 0 if it
 * does not fall that far. */
static double contour(const correlation *c, size_t count, double angle, double level) {
  double x = cos(angle), y = sin(angle), step = INFINITY, before = 1;
  for (size_t i = 0; i < count; i++)
    step = fmin(step, 1 / fmax(fabs(x / c[i].of->step[0]), fabs(y / c[i].of->step[1])));
  double whole = at_lag(c, count, 0, 0);
  for (size_t k = 1;; k++) {
    double r = (double)k * step, here = at_lag(c, count, r * x, r * y) / whole;
    if (here <= level)
      return r - step * (level - here) / (before - here);
    if (!(here > level))
      return 0;
    before = here;
  }
}

/* The symmetric M with r' M r = 1 nearest to the points, by least squares; false if they do not
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

static void describe_axes(const double m[3], asp_heights_numbers *d) {
  double mean = 0.5 * (m[0] + m[2]), half = hypot(0.5 * (m[0] - m[2]), m[1]);
  d->lambda_1 = 1 / sqrt(mean + half);
  d->lambda_2 = 1 / sqrt(mean - half);
  /* The eigenvector of the smaller eigenvalue. */
  double angle = 0.5 * atan2(2 * m[1], m[0] - m[2]) + ASP_PI / 2;
  d->lay = fmod(angle + 2 * ASP_PI, ASP_PI);
}

static asp_code describe_contours(const asp_heights *h, const correlation *c, size_t profiles,
                                  asp_heights_numbers *d, asp_error *error) {
  int directions = h->rows > 1 ? DIRECTIONS : 1;
  double point[DIRECTIONS][2], m[3], most = 0;
  size_t count = 0;
  d->s_al = INFINITY;
  bool long_enough = true;
  for (int k = 0; k < directions; k++) {
    double angle = ASP_PI * k / DIRECTIONS;
    double r = contour(c, profiles, angle, LEVEL_1_E),
           far = contour(c, profiles, angle, LEVEL_S_AL);
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
  d->s_tr = long_enough ? d->s_al / most : NAN;
  if (directions == 1 && count == 1) {
    d->lambda_1 = d->lambda_2 = point[0][0];
    return ASP_OK;
  }
  if (count < 3 || !fit_ellipse((const double(*)[2])point, count, m))
    return aspi_fail(
        error, ASP_EDATA,
        "the autocorrelation does not fall to 1/e within half the %s: it is too short, "
        "or form is left in it",
        aspi_kind_of_rows(h->rows));
  describe_axes(m, d);
  return ASP_OK;
}

static asp_code describe_lengths(const asp_heights *all, asp_heights_numbers *d, asp_error *error) {
  size_t most = 0, n = 0;
  for (const asp_heights *h = all; h; h = h->next)
    most++;
  correlation *c = malloc(most * sizeof *c);
  asp_code code = c ? ASP_OK : aspi_fail(error, ASP_ENOMEM, "out of memory for %zu profiles", most);
  for (const asp_heights *h = all; h && !code; h = h->next) {
    code = autocorrelation(h, d->s_q, &c[n], error);
    n += !code;
  }
  code = code ? code : describe_contours(all, c, n, d, error);
  while (n > 0)
    free(c[--n].values);
  free(c);
  return code;
}

asp_code asp_heights_describe(const asp_heights *h, asp_heights_numbers *numbers,
                              asp_error *error) {
  const char *kind = aspi_kind_of_rows(h->rows);
  asp_heights_numbers d = {0};
  describe_heights(h, &d);
  for (const asp_heights *one = h; one; one = one->next)
    d.s_dq += share_of(one, h) * gradient_square(one);
  d.s_dq = sqrt(d.s_dq);
  if (!isfinite(d.s_q) || !isfinite(d.s_dq))
    return aspi_fail(error, ASP_EDATA, "the heights of the %s are too large to work with", kind);
  if (!(d.s_q > ASPI_ROUNDING_DOUBLE * fabs(h->z[0])))
    return aspi_fail(error, ASP_EDATA, "the %s is constant", kind);
  asp_code code = describe_lengths(h, &d, error);
  *numbers = d;
  return code;
}

static asp_code check(const asp_heights *h, const asp_heights_numbers *d, asp_error *error) {
  bool is_map = h->rows > 1;
  double phi_r = d->s_q / d->lambda_1;
  if (d->lambda_1 <
      SPACINGS_LEAST * (is_map ? fmin(h->step[0], h->step[1]) : aspi_heights_extent(h).spacing))
    return aspi_fail(
        error, ASP_EDATA,
        "the %scorrelation length, %g, is less than %g spacings of the points: this "
        "is noise, or sampled too coarsely%s",
        is_map ? "shorter " : "", d->lambda_1, SPACINGS_LEAST,
        is_map ? "" : "; take short waves out (asperity surface --lambda_s LENGTH --save FILE)");
  if (phi_r > PHI_R_MOST)
    return aspi_fail(error, ASP_EDATA,
                     "phi_r = %s is %g; over %g is no roughness: are the units of positions and "
                     "heights right (asperity surface --unit um)?",
                     is_map ? "S_q/lambda_1" : "R_q/lambda_c", phi_r, PHI_R_MOST);
  return ASP_OK;
}

/* The heights of the center of a disc over profiles. */
static asp_heights *paths(const asp_heights *h, double d_p, asp_error *error) {
  asp_heights *path = aspi_profile_path(h, d_p, h->columns, error);
  if (!path || !h->next || (path->next = paths(h->next, d_p, error)))
    return path;
  asp_heights_free(path);
  return NULL;
}

/* The same, or those of a sphere over a map. */
static asp_heights *rolled(const asp_heights *h, double d_p, asp_error *error) {
  if (h->rows == 1)
    return paths(h, d_p, error);
  size_t n = h->columns * h->rows;
  aspi_ball *ball = aspi_ball_create(h, d_p, error);
  double *z = ball ? aspi_allocate(n) : NULL;
  aspi_ball_search search = aspi_ball_begin(ball);
  for (size_t i = 0; z && i < n; i++)
    z[i] = aspi_ball_at(&search, (double)(i % h->columns) * h->step[0],
                        (double)(i / h->columns) * h->step[1])
               .height;
  aspi_ball_free(ball);
  return ball ? aspi_heights_adopt(z, h->columns, h->rows, h->step, h->periodic, error) : NULL;
}

asp_code aspi_heights_judge(const asp_heights *h, double d_least, asp_heights_numbers *numbers,
                            asp_error *error) {
  asp_code code = asp_heights_describe(h, numbers, error);
  if (code || !(numbers->s_q > PHI_R_MOST * numbers->lambda_1) || !(d_least > 0))
    return code ? code : check(h, numbers, error);
  asp_heights_numbers reached;
  asp_heights *over = rolled(h, d_least, NULL);
  if (over && !asp_heights_describe(over, &reached, NULL) && !check(over, &reached, NULL))
    *numbers = reached;
  asp_heights_free(over);
  return check(h, numbers, error);
}
