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

  /* After particles have moved between ranks, or have been put into another order. */
  void reorder() {
    is_reordered_ = true;
  }

  /* After the first half of a step or at its end, for these walls. Collective. */
  asperity::Bodies *take(const std::vector<asperity::Stepper *> &walls);

  /* Gives the bodies that have changed back, with their atoms; at the end of a step only velocities
   * and forces change. Collective. */
  void put(bool is_end);

  /* Lists the bodies of all ranks that a wall deletes; collective. True for an atom of one. */
  void list_deleted(const asperity::Memories &rows);
  bool is_deleted(int i) const {
    return fix_ && std::binary_search(deleted_.begin(), deleted_.end(), fix_->belongs_to(i));
  }

private:
  void take_spheres();
  void write(size_t b, bool is_end);

  FixMultisphere *fix_;
  asperity::Bodies bodies_;
  bool is_reordered_;           /* since the spheres were listed */
  std::vector<double> deleted_; /* numbers of bodies */
};

} // namespace LAMMPS_NS

#endif
