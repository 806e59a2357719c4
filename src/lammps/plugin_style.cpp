/* wallreboundstyle.so: the fix style wall/rebound, as wallreboundplugin.so loads it into a LAMMPS
 * of the version whose headers it was compiled with.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "lammpsplugin.h"

#include "error.h"
#include "fix_wall_rebound.h"
#include "version.h"

using namespace LAMMPS_NS;

static Fix *create_wall_rebound(LAMMPS *lammps, int narg, char **arg) {
  return new FixWallRebound(lammps, narg, arg);
}

/* The arguments of lammpsplugin_init. */
extern "C" void aspi_register_style(void *lammps, void *handle, void *register_function) {
  LAMMPS *engine = static_cast<LAMMPS *>(lammps);
  const std::string wrong = check_library(engine);
  if (!wrong.empty())
    engine->error->all(FLERR, "wallreboundplugin.so: " + wrong);
  lammpsplugin_t plugin;
  plugin.version = LAMMPS_VERSION;
  plugin.style = "fix";
  plugin.name = "wall/rebound";
  plugin.info = "rough walls, by asperity";
  plugin.author = "the authors of asperity";
  plugin.creator.v2 = reinterpret_cast<lammpsplugin_factory2 *>(&create_wall_rebound);
  plugin.handle = handle;
  reinterpret_cast<lammpsplugin_regfunc>(register_function)(&plugin, lammps);
}
