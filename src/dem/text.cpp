/* Texts; see text.h. The unit style `nano` is LAMMPS's: nanometers, attograms, nanoseconds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/text.h"

#include <math.h>
#include <stdarg.h>

#include "base/number.h"
#include "dem/error.h"

using namespace asperity;

std::string asperity::text(const char *format, ...) {
  va_list args;
  va_start(args, format);
  const int length = aspi_print_list(NULL, 0, format, args);
  va_end(args);
  std::vector<char> line(length + 1);
  va_start(args, format);
  aspi_print_list(line.data(), line.size(), format, args);
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
  const char *time;
} STYLES[] = {{{"si", 1, 1, 1, {}}, " s"},
              {{"cgs", 1e2, 1e3, 1, {}}, " s"},
              {{"micro", 1e6, 1e15, 1e6, {}}, " us"},
              {{"nano", 1e9, 1e21, 1e9, {}}, " ns"}};

asp_units asperity::units_of(const std::string &name) {
  for (const auto &style : STYLES)
    if (name == style.units.name)
      return style.units;
  return asp_units();
}

std::string asperity::quantity_of_time(double value, const std::string &name) {
  std::string unit = " ";
  for (const auto &style : STYLES)
    if (name == style.units.name)
      unit = style.time;
  return text("%g", value) + unit;
}

/* ---- the words of a command ---- */

bool Words::is_one_of(const std::string &list) const {
  return !done() && (" " + list + " ").find(" " + words_[next_] + " ") != std::string::npos;
}

std::vector<const char *> Words::left_over() const {
  std::vector<const char *> all;
  for (size_t i = next_; i < words_.size(); i++)
    all.push_back(words_[i].c_str());
  return all;
}

bool Words::take(const char *word) {
  if (!is(word))
    return false;
  next_++;
  return true;
}

std::string Words::word(const char *what) {
  if (done())
    throw Error(text("%s is missing at the end of the command", what));
  return words_[next_++];
}

double Words::number(const char *what) {
  const std::string value = word(what);
  char *end;
  const double number = aspi_number(value.c_str(), &end);
  if (value.empty() || *end)
    throw Error(text("%s is '%s'; it must be a number", what, value.c_str()));
  return number;
}

double Words::whole(const char *what, double least, double most) {
  const double value = number(what);
  if (!(value >= least && value <= most) || value < floor(value) || value > floor(value))
    throw Error(
        text("%s is %.15g; it must be a whole number from %.0f to %.0f", what, value, least, most));
  return value;
}
