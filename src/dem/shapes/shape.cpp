/* Default functions of a shape, from its boxes alone; see shape.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/shapes/shape.h"

#include <algorithm>

using namespace asperity;

/* Each try divides the number of steps by this. */
static const double FEWER = 4;

double Shape::clear(const double x[3], const double v[3], double reach, double widen, double most,
                    const FaceList &) const {
  for (double steps = most; steps >= 1; steps /= FEWER) {
    const double wide = reach + steps * widen;
    double lo[3], hi[3];
    for (int d = 0; d < 3; d++) {
      const double end = x[d] + v[d] * steps;
      lo[d] = std::min(x[d], end) - wide;
      hi[d] = std::max(x[d], end) + wide;
    }
    if (!may_meet(lo, hi))
      return steps;
  }
  return 0;
}

void Shape::turn(const Place &, double, double, double[3][3], double omega[3]) const {
  std::fill(omega, omega + 3, 0.0);
}
