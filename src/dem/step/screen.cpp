/* What stands between a particle and a wall; see screen.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/screen.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

/* Screen::range() in radii. */
const double RANGE = 0.25;

/* The square of the distance of a point from the farther end of a way. */
double farther_square(const double from[3], const double to[3], const double x[3]) {
  double begin[3], end[3];
  aspi_subtract(from, x, begin);
  aspi_subtract(to, x, end);
  return std::max(aspi_dot(begin, begin), aspi_dot(end, end));
}

} // namespace

double Screen::range(double radius) {
  return RANGE * radius;
}

Screen::Screen(const Spheres &s, int which)
    : i(which), radius_(s.radius[which]), way_(range(radius_)), gap_(0) {
  aspi_copy(s.x + 3 * static_cast<size_t>(i), x_);
  barriers_.count = 0;
}

bool Screen::add(const Setup &setup, size_t shape, const FaceList &stays) {
  const int first = barriers_.count;
  if (!setup.shapes[shape].shape->separate(x_, (1 + ON_EDGES) * radius_ + way_, stays, barriers_))
    return false;
  for (int k = first; k < barriers_.count; k++)
    barriers_.all[k].shape = static_cast<int>(shape);
  return true;
}

/* Shapes see a straight way bent, by less than half of a gap that holds both of its ends. */
bool Screen::holds(const Setup &setup, const Spheres &s, double travel) {
  const size_t at = 3 * static_cast<size_t>(i);
  const double *to = s.x + at;
  double from[3];
  aspi_add_scaled(to, -s.dt, s.v + at, from);
  way_ -= travel;
  gap_ -= 2 * travel;
  if (gap_ > 0 && farther_square(from, to, at_) <= 0.25 * gap_ * gap_)
    return true;
  const double left = way_ - sqrt(farther_square(from, to, x_));
  if (!(left >= 0))
    return false;
  gap_ = 2 * left;
  aspi_copy(to, at_);
  for (int first = 0; first < barriers_.count;) {
    const Barriers of = barriers_.of(first);
    const Shape &shape = *setup.shapes[static_cast<size_t>(of.first->shape)].shape;
    gap_ = std::min(gap_, shape.gap(of, from, to, radius_));
    first = static_cast<int>(of.last - barriers_.all);
  }
  return gap_ >= 0;
}
