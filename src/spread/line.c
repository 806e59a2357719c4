/* First hits along a line over a dilated wall: a path is a constant value of g = z + x tan(alpha1),
 * and touches where g passes its running maximum.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/line.h"
#include "base/error.h"
#include "surface/closing.h"
#include "surface/profile.h"

#include <math.h>
#include <stdlib.h>

/* A steeper beam is vertical. */
#define FALL_MOST 1e12

asp_code aspi_line_create(aspi_line *line, size_t n, double step, asp_error *error) {
  *line = (aspi_line){.n = n, .step = step};
  line->memory = n <= SIZE_MAX / (3 * sizeof(double)) ? malloc(3 * n * sizeof(double)) : NULL;
  if (!line->memory)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a line of %zu points", n);
  line->slope = line->memory;
  line->end_x = line->memory + n;
  line->end_z = line->memory + 2 * n;
  return ASP_OK;
}

void aspi_line_free(aspi_line *line) {
  free(line->memory);
}

static void set_fall_least(aspi_line *line) {
  double mean = 0, square = 0, n = (double)line->n;
  for (size_t i = 0; i < line->n; i++)
    mean += line->end_z[i] / n;
  for (size_t i = 0; i < line->n; i++)
    square += (line->end_z[i] - mean) * (line->end_z[i] - mean) / n;
  line->fall_least = ASPI_RISE_LEAST * sqrt(square) / (n * line->step);
}

asp_code aspi_line_over_profile(aspi_line *line, const asp_profile *profile, double d_p,
                                asp_error *error) {
  asp_error own;
  error = error ? error : &own;
  *line = (aspi_line){0};
  if (aspi_check_range(error, "d_p", "", d_p, 0, INFINITY))
    return error->code;
  asp_profile *rolled = NULL; /* a point follows the profile itself */
  if (d_p > 0 && !(rolled = aspi_profile_path(profile, d_p, ASP_LINE_POINTS_MOST, error)))
    return error->code;
  const asp_profile *path = rolled ? rolled : profile;
  size_t points = asp_profile_points(path);
  size_t n = aspi_profile_periodic(path) ? points : 2 * points - 2;
  asp_code code = aspi_line_create(line, n, 1, error);
  const double *z = asp_profile_heights(path);
  double unit = 1 / asp_profile_spacing(path);
  for (size_t i = 0; !code && i < n; i++) {
    size_t k = i + 1 < n ? i + 1 : 0;
    double begin = z[i < points ? i : 2 * points - 2 - i] * unit;
    line->end_x[i] = (double)(i + 1);
    line->end_z[i] = z[k < points ? k : 2 * points - 2 - k] * unit;
    line->slope[i] = line->end_z[i] - begin;
  }
  asp_profile_free(rolled);
  if (!code)
    set_fall_least(line);
  return code;
}

double aspi_line_fall(const aspi_line *line, double alpha1) {
  return fmin(fmax(tan(alpha1), line->fall_least), FALL_MOST);
}

/* The maximum of g over the period before the one that begins with face 0. */
static double highest_before(const aspi_line *line, double fall) {
  double highest = -INFINITY, period = line->step * (double)line->n;
  for (size_t i = 0; i < line->n; i++) {
    double g = line->end_z[i] + fall * (line->end_x[i] - period);
    highest = g > highest ? g : highest;
  }
  return highest;
}

void aspi_line_first_hits(const aspi_line *line, double fall, double *weight) {
  double highest = highest_before(line, fall), rise = fall * line->step * (double)line->n;
  for (size_t i = 0; i < line->n; i++) {
    double g = line->end_z[i] + fall * line->end_x[i];
    weight[i] = g > highest ? (g - highest) / rise : 0;
    highest = g > highest ? g : highest;
  }
}
