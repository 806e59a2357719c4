/* The version of the library, and the sizes of its structs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"

#include <string.h>

#define TEXT_OF(number) #number
#define JOINED(major, minor, patch) TEXT_OF(major) "." TEXT_OF(minor) "." TEXT_OF(patch)

const char *asp_version(void) {
  return JOINED(ASP_VERSION_MAJOR, ASP_VERSION_MINOR, ASP_VERSION_PATCH);
}

size_t asp_struct_size(const char *name) {
  static const struct {
    const char *name;
    size_t size;
  } sizes[] = {
      {"body", sizeof(asp_body)},
      {"coefficients", sizeof(asp_coefficients)},
      {"error", sizeof(asp_error)},
      {"impact", sizeof(asp_impact)},
      {"key", sizeof(asp_key)},
      {"particle", sizeof(asp_particle)},
      {"check_input", sizeof(asp_check_input)},
  };
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
    if (strcmp(sizes[i].name, name) == 0)
      return sizes[i].size;
  return 0;
}
