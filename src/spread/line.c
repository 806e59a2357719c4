/* First hits along a line over a dilated wall: a path is a constant value of g = z + x tan(alpha1),
 * and touches where g passes its running maximum. The faces have the slopes of the contacts, not of
 * the differences between points: two neighbours' tangents cross in between, on a smooth piece in
 * the middle and at a kink where the kink is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/line.h"
#include "base/error.h"

#include <math.h>
#include <stdlib.h>

/* Rms heights that a beam must pass over a period, so that its first hits lie on many peaks. */
#define RISE_LEAST 16

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
}

double aspi_line_rise(const aspi_line *line, double fall) {
  return fall * line->step * (double)line->n;
}

double aspi_line_fall_least(const aspi_line *line) {
  double mean = 0, square = 0, n = (double)line->n;
  for (size_t i = 0; i < line->n; i++)
    mean += line->end_z[i] / n;
  for (size_t i = 0; i < line->n; i++)
    square += (line->end_z[i] - mean) * (line->end_z[i] - mean) / n;
  return RISE_LEAST * sqrt(square) / (n * line->step);
}

/* The maximum of g over the period before the one that begins with face 0. */
static double highest_before(const aspi_line *line, double fall) {
  double highest = -INFINITY;
  for (size_t i = 0; i < line->n; i++)
    highest = fmax(highest, line->end_z[i] + fall * line->end_x[i]);
  return highest - aspi_line_rise(line, fall);
}

void aspi_line_first_hit(const aspi_line *line, double fall, double *weight) {
  double highest = highest_before(line, fall);
  for (size_t i = 0; i < line->n; i++) {
    double g = line->end_z[i] + fall * line->end_x[i];
    weight[i] = fmax(0, g - highest);
    highest = fmax(highest, g);
  }
}

void aspi_line_hits(const aspi_line *line, double fall, const double *share, size_t count,
                    aspi_spot *spots) {
  double rise = aspi_line_rise(line, fall), first = highest_before(line, fall);
  size_t k = 0, n = line->n;
  for (size_t i = 0; i < n && k < count; i++) {
    double g = line->end_z[i] + fall * line->end_x[i];
    for (; k < count && first + share[k] * rise <= g; k++) {
      /* On the face, back from its end. */
      double back = (g - first - share[k] * rise) / (line->slope[i] + fall);
      spots[k] = (aspi_spot){i, line->end_x[i] - back, line->end_z[i] - line->slope[i] * back};
    }
  }
  for (; k < count; k++)
    spots[k] = (aspi_spot){n - 1, line->end_x[n - 1], line->end_z[n - 1]};
}
