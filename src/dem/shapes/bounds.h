/* A box around something, its sides along the axes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_BOUNDS_H
#define ASPERITY_DEM_BOUNDS_H

#include <string>

namespace asperity {

struct Bounds {
  double lo[3], hi[3];
  bool has(const Bounds &inner) const;
  void include(const double x[3]);
  void widen(double by);
  std::string describe() const;
  static Bounds none();
  /* The box of a sphere that moves from x by v, between two times. */
  static Bounds of_path(const double x[3], const double v[3], double from, double to,
                        double radius);
};

} // namespace asperity

#endif
