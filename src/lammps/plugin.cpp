/* wallreboundplugin.so: the fix style wall/rebound as a plugin, for a LAMMPS with the package
 * PLUGIN. A script loads it by `plugin load wallreboundplugin.so`; LAMMPS finds it by itself in the
 * folders of LAMMPS_PLUGIN_PATH. It works with the version of LAMMPS only whose headers it was
 * compiled with.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "lammpsplugin.h"

#include "fix_wall_rebound.h"
#include "library_check.h"
#include "version.h"

using namespace LAMMPS_NS;

static Fix *create_wall_rebound(LAMMPS *lammps, int narg, char **arg) {
  return new FixWallRebound(lammps, narg, arg);
}

extern "C" void lammpsplugin_init(void *lammps, void *handle, void *register_function) {
  check_library(static_cast<LAMMPS *>(lammps), "wallreboundplugin.so");
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
