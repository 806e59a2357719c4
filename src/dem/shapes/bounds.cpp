/* A box around something; see bounds.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/shapes/bounds.h"

#include <math.h>
#include <algorithm>

#include "dem/text.h"

using namespace asperity;

Bounds Bounds::none() {
  return Bounds{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
}

Bounds Bounds::of_path(const double x[3], const double v[3], double from, double to,
                       double radius) {
  Bounds box;
  for (int d = 0; d < 3; d++) {
    const double a = x[d] + v[d] * from, b = x[d] + v[d] * to;
    box.lo[d] = std::min(a, b) - radius;
    box.hi[d] = std::max(a, b) + radius;
  }
  return box;
}

bool Bounds::has(const Bounds &inner) const {
  bool all = true;
  for (int d = 0; d < 3; d++)
    all = all && lo[d] <= inner.lo[d] && inner.hi[d] <= hi[d];
  return all;
}

void Bounds::include(const double x[3]) {
  for (int d = 0; d < 3; d++) {
    lo[d] = std::min(lo[d], x[d]);
    hi[d] = std::max(hi[d], x[d]);
  }
}

void Bounds::widen(double by) {
  for (int d = 0; d < 3; d++) {
    lo[d] -= by;
    hi[d] += by;
  }
}

std::string Bounds::describe() const {
  return text("x %.6g to %.6g, y %.6g to %.6g, z %.6g to %.6g", lo[0], hi[0], lo[1], hi[1], lo[2],
              hi[2]);
}
