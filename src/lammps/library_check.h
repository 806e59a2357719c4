/* Whether a LAMMPS that runs is the one whose headers this was compiled with. Another version, or
 * another layout of its classes, would crash later and elsewhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_LIBRARY_CHECK_H
#define LMP_LIBRARY_CHECK_H

#include <string>

namespace LAMMPS_NS {

/* Ends the program, after a message by rank 0, where it is another. program: who says so. */
void check_library(class LAMMPS *lammps, const std::string &program);

/* That message, and the end. */
[[noreturn]] void fail_library(const std::string &program, const std::string &what,
                               const std::string &found, const std::string &expected);

} // namespace LAMMPS_NS

#endif
