/* What is wrong with a script, a file or a record: thrown in this room, and shown by the engine's
 * own means where it is caught.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_WALL_ERROR_H
#define ASPERITY_WALL_ERROR_H

#include <stdexcept>

namespace asperity {

class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace asperity

#endif
