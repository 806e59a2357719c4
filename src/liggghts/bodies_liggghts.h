/* The bodies of LIGGGHTS's fix multisphere, for the walls. A body is that of the rank which owns
 * it; its spheres are there, as atoms or ghosts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_LIGGGHTS_BODIES_H
#define ASPERITY_LIGGGHTS_BODIES_H

#include <string>
#include <vector>

#include "fix_multisphere.h"
#include "dem/step/bodies.h"

namespace LAMMPS_NS {

class BodiesOfLiggghts : protected Pointers {
public:
  explicit BodiesOfLiggghts(class LAMMPS *engine);

  /* False where there is no fix multisphere. */
  bool any() const {
    return fix_ != NULL;
  }
  bool has(int i) const {
    return fix_ && fix_->belongs_to(i) >= 0;
  }

  /* Makes room for the memory of a wall, by a name of its own. */
  void add_memory(const std::string &name);

  /* At the end of the step's first half, for walls with such memories. */
  asperity::Bodies *take(const std::vector<std::string> &memories);

  /* Moves the bodies that have met walls, with their atoms; collective. */
  void put();

private:
  void take_spheres();

  FixMultisphere *fix_;
  asperity::Bodies bodies_;
  std::vector<int> local_; /* number of each body in the engine */
};

} // namespace LAMMPS_NS

#endif
