/* Checks that the running LAMMPS is the one whose headers this was compiled with. Another version,
 * or another layout of its classes, would crash later and elsewhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_LIBRARY_CHECK_H
#define LMP_LIBRARY_CHECK_H

#include <string>

namespace LAMMPS_NS {

/* A message about the first difference; empty if there is none. */
std::string check_library(class LAMMPS *lammps);

/* The text of that message. */
std::string library_mismatch(const std::string &what, const std::string &found,
                             const std::string &expected);

} // namespace LAMMPS_NS

#endif
