/* The unit styles of the engines in which lengths and constants can be converted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_UNITS_H
#define ASPERITY_DEM_UNITS_H

#include <string>

#include "asperity_internal.h"

namespace asperity {

/* The style of that name; one that cannot be converted to others has no name and all 0. */
asp_units units_of(const std::string &name);

/* A number in the units of a style, with its unit: of length, speed or time. */
std::string quantity(double value, const std::string &kind, const std::string &style);

} // namespace asperity

#endif
