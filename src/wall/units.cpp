/* Unit styles; see units.h. `nano` is LAMMPS's: nanometres, attograms, nanoseconds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/units.h"

#include "wall/error.h"
#include "wall/text.h"

using namespace asperity;

static const Units STYLES[] = {
    {"si", 1, 1, 1}, {"cgs", 1e2, 1e3, 1}, {"micro", 1e6, 1e15, 1e6}, {"nano", 1e9, 1e21, 1e9}};

const Units &asperity::units_of(const std::string &name, const char *what,
                                const std::string &known) {
  for (const Units &units : STYLES)
    if (name == units.name)
      return units;
  throw Error(text("%s in SI units, which cannot be converted to 'units %s'; units must be %s",
                   what, name.c_str(), known.c_str()));
}
