/* The version of the library.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity.h"

#define TEXT_OF(number) #number
#define JOINED(major, minor, patch) TEXT_OF(major) "." TEXT_OF(minor) "." TEXT_OF(patch)

const char *asp_version(void) {
  return JOINED(ASP_VERSION_MAJOR, ASP_VERSION_MINOR, ASP_VERSION_PATCH);
}
