/* What is wrong with a script, a file or a record: thrown in this room, and shown by the engine's
 * own means where it is caught.
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

/* What to tell a user of it. */
inline std::string told(const std::exception &wrong) {
  return dynamic_cast<const std::bad_alloc *>(&wrong) ? "out of memory" : wrong.what();
}

} // namespace asperity

#endif
