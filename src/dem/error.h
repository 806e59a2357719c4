/* A fault in a script, a file or a record. Code in dem throws it; the engine's adapter catches it
 * and shows it as an error of the engine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <new>
#include <stdexcept>
#include <string>

#include "asperity_engine.h"

namespace asperity {

class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/* The memory of this rank is out. The others know nothing of it, and wait for this one. */
class OutOfMemory : public Error {
public:
  using Error::Error;
};

/* Throws an error of the core. of: what goes before its text. */
[[noreturn]] inline void throw_error(const asp_error &wrong, const std::string &of = "") {
  if (wrong.code == ASP_ENOMEM)
    throw OutOfMemory(of + wrong.text);
  throw Error(of + wrong.text);
}

/* The text for the user. */
inline std::string message_of(const std::exception &wrong) {
  return dynamic_cast<const std::bad_alloc *>(&wrong) ? "out of memory" : wrong.what();
}

} // namespace asperity
