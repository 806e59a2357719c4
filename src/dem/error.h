/* A fault in a script, a file or a record. Code in dem throws it; the engine's adapter catches it
 * and shows it as an error of the engine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_WALL_ERROR_H
#define ASPERITY_WALL_ERROR_H

#include <new>
#include <stdexcept>
#include <string>

namespace asperity {

class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/* The text for the user. */
inline std::string message_of(const std::exception &wrong) {
  return dynamic_cast<const std::bad_alloc *>(&wrong) ? "out of memory" : wrong.what();
}

} // namespace asperity

#endif
