/* Unit styles; see units.h. `nano` is LAMMPS's: nanometres, attograms, nanoseconds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/units.h"

using namespace asperity;

static const asp_units STYLES[] = {
    {"si", 1, 1, 1}, {"cgs", 1e2, 1e3, 1}, {"micro", 1e6, 1e15, 1e6}, {"nano", 1e9, 1e21, 1e9}};

asp_units asperity::units_of(const std::string &name) {
  for (const asp_units &units : STYLES)
    if (name == units.name)
      return units;
  return asp_units();
}
