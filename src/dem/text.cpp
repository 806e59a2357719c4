/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <vector>

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
