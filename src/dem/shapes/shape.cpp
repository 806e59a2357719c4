/* Default functions of a shape, from its boxes alone; see shape.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/shapes/shape.h"

#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

/* Vectors are parallel within this angle, rad: nodes of an STL file may be in single precision. */
static const double PARALLEL = 1e-6;

/* Each try divides the number of steps by this. */
static const double FEWER = 4;

double Shape::clear(const Course &course, const FaceList &) const {
  for (double steps = course.most; steps >= 1; steps /= FEWER) {
    const double wide = course.reach + steps * course.widen;
    double lo[3], hi[3];
    for (int d = 0; d < 3; d++) {
      const double end = course.x[d] + course.v[d] * steps;
      lo[d] = std::min(course.x[d], end) - wide;
      hi[d] = std::max(course.x[d], end) + wide;
    }
    if (!may_meet(lo, hi))
      return steps;
  }
  return 0;
}

void Shape::turn(const Place &, double, double, double[3][3], double omega[3]) const {
  std::fill(omega, omega + 3, 0.0);
}

bool Shape::are_parallel(const double a[3], const double b[3]) {
  double across[3];
  aspi_cross(a, b, across);
  return aspi_length(across) <= PARALLEL * aspi_length(a) * aspi_length(b);
}
