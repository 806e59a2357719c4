/* A Gaussian map is made from white noise with the square root of the spectrum of
 * r_q^2 exp(-r' M r), which is proportional to exp(-k' M^-1 k / 8), by FFT over the rows and then
 * over the columns. The noise is drawn in Fourier space, complex and without symmetry; the real
 * part of its transform is the map.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "gauss_map.h"
#include "base/error.h"
#include "base/stream.h"

#include <math.h>
#include <stdlib.h>

/* The amplitudes exp(-k' M^-1 k / 8) of one row of wave numbers, ky being that of the row. */
typedef struct spectrum {
  double m[3]; /* M^-1: xx, xy, yy */
  double unit[2];
} spectrum;

/* The wave number of an index on a circle of n points. */
static double wave(size_t i, size_t n, double unit) {
  return unit * (i <= n / 2 ? (double)i : (double)i - (double)n);
}

static double amplitude(const spectrum *s, double kx, double ky) {
  return exp(-(s->m[0] * kx * kx + 2 * s->m[1] * kx * ky + s->m[2] * ky * ky) / 8);
}

static spectrum spectrum_of(const gauss_wall *wall, const asp_heights *map) {
  double c = cos(wall->axis), s = sin(wall->axis);
  double a = wall->lambda_1 * wall->lambda_1, b = wall->lambda_2 * wall->lambda_2;
  return (spectrum){{c * c * a + s * s * b, c * s * (a - b), s * s * a + c * c * b},
                    {2 * ASP_PI / ((double)map->columns * map->step[0]),
                     2 * ASP_PI / ((double)map->rows * map->step[1])}};
}

/* Fills `data`, complex, with the noise, filtered; the sum of the squares of the amplitudes. */
static double fill_waves(const spectrum *s, const asp_heights *map, uint32_t seed, double *data) {
  double sum = 0;
  for (size_t j = 0; j < map->rows; j++) {
    aspi_stream stream =
        aspi_stream_begin(&(asp_key){.seed = seed, .wall = asp_key_wall("map"), .tag = j});
    for (size_t i = 0; i < map->columns; i++) {
      double a = amplitude(s, wave(i, map->columns, s->unit[0]), wave(j, map->rows, s->unit[1]));
      double *z = data + 2 * (j * map->columns + i);
      sum += a * a;
      if (a < 1e-12) {
        z[0] = z[1] = 0;
        continue;
      }
      z[0] = a * aspi_stream_normal(&stream);
      z[1] = a * aspi_stream_normal(&stream);
    }
  }
  return sum;
}

asp_heights *gauss_map_create(const gauss_wall *wall, const double step[2], size_t columns,
                              size_t rows, uint32_t seed, asp_error *error) {
  asp_heights shape = {
      .columns = columns, .rows = rows, .step = {step[0], step[1]}, .periodic = true};
  size_t n = columns * rows;
  double *data = malloc((2 * n + aspi_fft2_room(rows)) * sizeof *data);
  shape.z = aspi_allocate(columns * rows);
  if (!data || !shape.z) {
    free(data);
    free(shape.z);
    aspi_fail(error, ASP_ENOMEM, "out of memory for a map of %zu x %zu points", columns, rows);
    return NULL;
  }
  spectrum s = spectrum_of(wall, &shape);
  double sum = fill_waves(&s, &shape, seed, data), scale = wall->r_q / sqrt(sum);
  data[0] = 0;
  aspi_fft2(data, columns, rows, true, data + 2 * n);
  for (size_t i = 0; i < n; i++)
    shape.z[i] = scale * data[2 * i];
  free(data);
  return aspi_heights_adopt(shape.z, columns, rows, step, true, error);
}
