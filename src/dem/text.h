/* Texts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_TEXT_H
#define ASPERITY_DEM_TEXT_H

#include <string>

namespace asperity {

#if defined(__GNUC__)
#define ASPERITY_FORMAT __attribute__((format(printf, 1, 2)))
#else
#define ASPERITY_FORMAT
#endif

/* printf into a string. */
std::string text(const char *format, ...) ASPERITY_FORMAT;

} // namespace asperity

#endif
