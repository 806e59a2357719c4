/* Texts; see text.h. The unit style `nano` is LAMMPS's: nanometers, attograms, nanoseconds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <vector>

using namespace asperity;

std::string asperity::text(const char *format, ...) {
  va_list args;
  va_start(args, format);
  const int length = vsnprintf(NULL, 0, format, args);
  va_end(args);
  std::vector<char> line(length + 1);
  va_start(args, format);
  vsnprintf(line.data(), line.size(), format, args);
  va_end(args);
  return line.data();
}

std::string asperity::setting(double value) {
  return text("%.15g", value);
}

std::string asperity::description_text(const asp_description *description) {
  std::string line(asp_description_text(description, NULL, 0) + 1, '\0');
  asp_description_text(description, &line[0], line.size());
  line.pop_back();
  return line;
}

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
