/* The bodies of LIGGGHTS's fix multisphere, for the walls. A body is that of the rank which owns
 * it; its spheres are there, as atoms or ghosts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <string>
#include <vector>

#include "fix_multisphere.h"
#include "dem/step/bodies.h"

namespace LAMMPS_NS {

class BodiesOfLiggghts : public asperity::BodySource, protected Pointers {
public:
  explicit BodiesOfLiggghts(class LAMMPS *engine);

  bool any() const override { /* fix multisphere */
    return fix_ != NULL;
  }
  /* Also of a body that is being taken away. */
  bool has(int i) const override {
    return fix_->belongs_to(i) >= 0 || fix_->fix_delflag()->vector_atom[i] > 0;
  }
  /* The fix may send its bodies afterwards: take() lists them. */
  void list(const std::vector<asperity::Wall *> &, bool) override {
    is_reordered_ = true;
  }
  asperity::Bodies *take(const std::vector<asperity::Wall *> &walls) override;

private:
  void take_spheres();
  double name_of(size_t b) const override {
    return static_cast<double>(bodies_.all[b].tag) + 1;
  }
  double name_at(int i) const override {
    return fix_->belongs_to(i);
  }
  void write(size_t b, bool is_end) override;
  void set_particles(bool is_end) override;

  FixMultisphere *fix_;
  bool is_reordered_; /* since the spheres were listed */
};

} // namespace LAMMPS_NS
