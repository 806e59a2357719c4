/* Texts, with numbers in the unit styles of the engines.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_TEXT_H
#define ASPERITY_DEM_TEXT_H

#include <string>

#include "asperity_internal.h"

namespace asperity {

#if defined(__GNUC__)
#define ASPERITY_FORMAT __attribute__((format(printf, 1, 2)))
#else
#define ASPERITY_FORMAT
#endif

/* printf into a string. */
std::string text(const char *format, ...) ASPERITY_FORMAT;

/* A number in a setting: equal texts for equal numbers. */
std::string setting(double value);

/* The canonical text of a description. */
std::string description_text(const asp_description *description);

/* The unit style of that name; one that cannot be converted to others has no name and all 0. */
asp_units units_of(const std::string &name);

/* A number in the units of a style, with its unit: of length, speed or time. */
std::string quantity(double value, const std::string &kind, const std::string &style);

} // namespace asperity

#endif
