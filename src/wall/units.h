/* The unit styles of the engines in which lengths and constants can be converted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_WALL_UNITS_H
#define ASPERITY_WALL_UNITS_H

#include <string>

namespace asperity {

/* How many units of a style make one of SI. */
struct Units {
  const char *name;
  double metre, kilogram, second;

  double kilogram_per_m3() const {
    return kilogram / (metre * metre * metre);
  }
  double pascal() const {
    return kilogram / (metre * second * second);
  }
  double joule_per_m2() const {
    return kilogram / (second * second);
  }
};

/* The style of that name. Throws an Error that says `what` (as "materials are") cannot be converted
 * to others, of which `known` lists those of the engine. */
const Units &units_of(const std::string &name, const char *what, const std::string &known);

} // namespace asperity

#endif
