/* First hits along a line over a dilated wall: a path is a constant value of g = z + x tan(alpha1),
 * and touches where g passes its running maximum. The faces have the slopes of the contacts, not of
 * the differences between points: two neighbors' tangents cross in between, on a smooth piece in
 * the middle and at a kink where the kink is.
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

void aspi_line_set(aspi_line *line, const float *z, const float *p, ptrdiff_t stride) {
  ptrdiff_t n = (ptrdiff_t)line->n;
  double step = line->step, sign = stride < 0 ? -1 : 1;
  if (stride < 0) {
    z -= (n - 1) * stride;
    p -= (n - 1) * stride;
  }
  for (ptrdiff_t i = 0; i < n; i++) {
    ptrdiff_t k = (i + 1 < n ? i + 1 : 0) * stride;
    double here = z[i * stride], next = z[k], a = sign * p[i * stride], b = sign * p[k];
    double over = next - b * step - here, bend = a - b;
    /* The crossing of the tangents where it lies between the points, else the middle. */
    double at = 0.5 * step, height = 0.5 * (here + next + 0.5 * step * bend);
    if (over * bend > 0 && fabs(over) < fabs(bend) * step) {
      at = over / bend;
      height = here + a * at;
    }
    line->slope[i] = a;
    line->end_x[i] = (double)i * step + at;
    line->end_z[i] = height;
  }
  set_fall_least(line);
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

asp_code aspi_line_coarsen(aspi_line *line, const aspi_line *fine, size_t parts, size_t most,
                           bool back, asp_error *error) {
  size_t n = fine->n / parts < most ? fine->n / parts : most;
  asp_code code = aspi_line_create(line, n, 1, error);
  if (code)
    return code;
  double z = 0;
  for (size_t i = 0; i < n; i++) {
    const double *slope = fine->slope + (back ? n - 1 - i : i) * parts;
    line->slope[i] = 0;
    for (size_t k = 0; k < parts; k++)
      line->slope[i] += (back ? -slope[k] : slope[k]) / (double)parts;
    line->end_x[i] = (double)(i + 1);
    line->end_z[i] = z += line->slope[i];
  }
  set_fall_least(line);
  return ASP_OK;
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
