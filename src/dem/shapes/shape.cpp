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

/* A body that turns by more than this angle (rad) is looked at again. */
static const double TURNS = 0.1;

/* A straight way is bent as a turning body sees it, by 2 omega x u + omega x (omega x r) at most,
 * with u the sphere's velocity relative to the body, and |omega x r| <= w; within TURNS neither
 * grows so much that 3 (u + w) would not do. */
Course Course::seen_from(const Twist &body) const {
  Course seen = *this;
  double w[3];
  body.velocity(x, w);
  aspi_add_scaled(x, 1, w, seen.x); /* where the body is at the end of this step */
  aspi_subtract(v, w, seen.v);
  const double turn = aspi_length(body.angular);
  const double bend = 1.5 * turn * (aspi_length(seen.v) + aspi_length(w));
  if (!(bend > 0))
    return seen;
  seen.most = std::max(1.0, std::min(most, std::min(TURNS / turn, widen / bend)));
  seen.widen += bend * seen.most;
  seen.reach += bend * seen.most;
  return seen;
}

double Shape::clear(const Course &course, const Twist &screw, const FaceList &) const {
  const Course seen = course.seen_from(screw);
  for (double steps = seen.most; steps >= 1; steps /= FEWER) {
    const double wide = seen.reach + steps * seen.widen;
    double lo[3], hi[3];
    for (int d = 0; d < 3; d++) {
      const double end = seen.x[d] + seen.v[d] * steps;
      lo[d] = std::min(seen.x[d], end) - wide;
      hi[d] = std::max(seen.x[d], end) + wide;
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
