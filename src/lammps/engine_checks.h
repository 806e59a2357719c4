/* Checks for commands that a script must not have beside a wall: each function returns an error
 * message, or "".
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_ENGINE_CHECKS_H
#define LMP_ENGINE_CHECKS_H

#include <string>

#include "engine_lammps.h"

namespace LAMMPS_NS {

std::string particles_error(LAMMPS *lmp);
std::string units_error(const EngineOfLammps &engine);
std::string box_error(LAMMPS *lmp);

/* Fixes that put particles of this wall's group where they want, or change the box in one of the
 * ways of Fix::box_change; all ranks call. */
std::string movers_error(const Fix *wall, int box_changes, LAMMPS *lmp);

/* In two dimensions; when a run is set up. */
std::string discs_error(LAMMPS *lmp);

} // namespace LAMMPS_NS

#endif
