/* Unit styles; see units.h. `nano` is LAMMPS's: nanometres, attograms, nanoseconds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/units.h"

#include "dem/text.h"

using namespace asperity;

static const struct {
  asp_units units;
  const char *length, *time;
} STYLES[] = {{{"si", 1, 1, 1}, "m", "s"},
              {{"cgs", 1e2, 1e3, 1}, "cm", "s"},
              {{"micro", 1e6, 1e15, 1e6}, "um", "us"},
              {{"nano", 1e9, 1e21, 1e9}, "nm", "ns"}};

asp_units asperity::units_of(const std::string &name) {
  for (const auto &style : STYLES)
    if (name == style.units.name)
      return style.units;
  return asp_units();
}

std::string asperity::quantity(double value, const std::string &kind, const std::string &name) {
  std::string unit;
  for (const auto &style : STYLES)
    if (name == style.units.name)
      unit = kind == "length" ? style.length
             : kind == "time" ? style.time
                              : std::string(style.length) + "/" + style.time;
  return text("%g", value) + (unit.empty() ? "" : " ") + unit;
}
