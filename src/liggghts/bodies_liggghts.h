/* The bodies of LIGGGHTS's fix multisphere, for the walls. A body is that of the rank which owns
 * it; its spheres are there, as atoms or ghosts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_LIGGGHTS_BODIES_H
#define ASPERITY_LIGGGHTS_BODIES_H

#include <algorithm>
#include <string>
#include <vector>

#include "fix_multisphere.h"
#include "dem/wall.h"

namespace LAMMPS_NS {

class BodiesOfLiggghts : protected Pointers {
public:
  explicit BodiesOfLiggghts(class LAMMPS *engine);

  /* False where there is no fix multisphere. */
  bool any() const {
    return fix_ != NULL;
  }
  /* True for atoms of bodies, and for those of a body that is being taken away. */
  bool has(int i) const {
    return fix_ && (fix_->belongs_to(i) >= 0 || fix_->fix_delflag()->vector_atom[i] > 0);
  }

  /* Makes room for the memory of a wall, by a name of its own, with what is restored of it; gives
   * its rows to a restart file; takes it away. */
  void add_memory(const std::string &name, const asperity::Wall &wall);
  std::vector<double> rows(const std::string &name) const;
  void remove_memory(const std::string &name);

  /* After particles have moved between ranks, or have been put into another order. */
  void reorder() {
    is_reordered_ = true;
  }

  /* At the end of the step's first half, for walls with such memories. */
  asperity::Bodies *take(const std::vector<std::string> &memories);

  /* Moves the bodies that have met walls, with their atoms; collective. */
  void put();

  /* The same at the end of a step, if a body is stuck on any rank: else NULL. Then only velocities
   * have changed. */
  asperity::Bodies *take_stuck(const std::vector<std::string> &memories);
  void put_velocities();

  /* Lists the bodies of all ranks that a wall deletes; collective. True for an atom of one. */
  void list_deleted(const std::string &name);
  bool is_deleted(int i) const {
    return fix_ && std::binary_search(deleted_.begin(), deleted_.end(), fix_->belongs_to(i));
  }

private:
  void take_spheres();
  void put_velocity(size_t b);

  FixMultisphere *fix_;
  asperity::Bodies bodies_;
  bool is_reordered_;           /* since the spheres were listed */
  bool is_any_stuck_;           /* on any rank, in this step */
  std::vector<double> deleted_; /* numbers of bodies */
};

} // namespace LAMMPS_NS

#endif
