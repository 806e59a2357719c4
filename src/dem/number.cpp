/* Numbers as text; see number.h. std::to_chars is the one part of this room that asks for
 * C++17; a source tree compiled for less has the same characters from the C library.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/number.h"

#if __cplusplus >= 201703L
#include <charconv>
#endif
#ifndef __cpp_lib_to_chars
#include <stdio.h>
#include <string>
#include "base/number.h"
#endif

using namespace asperity;

#ifdef __cpp_lib_to_chars

char *asperity::print_count(long long value, char *to) {
  return std::to_chars(to, to + NUMBER_MOST, value).ptr;
}

char *asperity::print_number(double value, char *to) {
  return std::to_chars(to, to + NUMBER_MOST, value, std::chars_format::general, 10).ptr;
}

bool asperity::read_number(const char *from, const char *end, double &value) {
  from += from < end && *from == '+';
  return from < end && std::from_chars(from, end, value).ptr == end;
}

#else

char *asperity::print_count(long long value, char *to) {
  return to + snprintf(to, NUMBER_MOST, "%lld", value);
}

char *asperity::print_number(double value, char *to) {
  return to + snprintf(to, NUMBER_MOST, "%.10g", value);
}

bool asperity::read_number(const char *from, const char *end, double &value) {
  const std::string number(from, end);
  char *stop;
  value = aspi_number(number.c_str(), &stop);
  return stop > number.c_str() && stop == number.c_str() + number.size();
}

#endif
