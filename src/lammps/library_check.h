/* Whether a LAMMPS that runs is the one whose headers this was compiled with. Another version, or
 * another layout of its classes, would crash later and elsewhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_LIBRARY_CHECK_H
#define LMP_LIBRARY_CHECK_H

#include <string>

namespace LAMMPS_NS {

/* What is another, as a message; empty if nothing is. */
std::string check_library(class LAMMPS *lammps);

/* That message. */
std::string library_mismatch(const std::string &what, const std::string &found,
                             const std::string &expected);

} // namespace LAMMPS_NS

#endif
