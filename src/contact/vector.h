/* Vectors of three numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <math.h>

static inline double aspi_dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void aspi_cross(const double a[3], const double b[3], double c[3]) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void aspi_copy(const double a[3], double c[3]) {
  c[0] = a[0];
  c[1] = a[1];
  c[2] = a[2];
}

static inline void aspi_subtract(const double a[3], const double b[3], double c[3]) {
  c[0] = a[0] - b[0];
  c[1] = a[1] - b[1];
  c[2] = a[2] - b[2];
}

/* c = a + s b; c may be a. */
static inline void aspi_add_scaled(const double a[3], double s, const double b[3], double c[3]) {
  c[0] = a[0] + s * b[0];
  c[1] = a[1] + s * b[1];
  c[2] = a[2] + s * b[2];
}

static inline void aspi_scale(double s, double a[3]) {
  a[0] *= s;
  a[1] *= s;
  a[2] *= s;
}

static inline double aspi_length(const double a[3]) {
  return sqrt(aspi_dot(a, a));
}
