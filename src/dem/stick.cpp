/* Particles stuck to a wall, and how they move with it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/flight.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

/* Notes where the particle has stuck, and takes it along with the wall for the rest of the step. */
void Wall::stick(Flight &flight, size_t shape, const Path &before, const Contact &contact) {
  const int i = flight.i;
  Place at;
  shapes_[shape].shape->stick(before, contact, at);
  StuckPlace &stuck = place(i).stuck;
  stuck.shape = static_cast<double>(shape) + 1;
  stuck.piece = at.piece;
  aspi_copy(at.at, stuck.at);
  const bool deletes = model_.deposit() == Model::DELETE;
  set_status(i, deletes ? Status::TO_DELETE : Status::STUCK);
  has_to_delete_ = has_to_delete_ || deletes;
  stuck_.push_back(i);
  aspi_copy(contact.x, flight.spheres.x + 3 * static_cast<size_t>(i));
  carry_one(flight.spheres, i, flight.path.left);
}

void Wall::carry(const Spheres &spheres) {
  for (int i : stuck_) {
    const Held before(spheres, i);
    carry_one(spheres, i, spheres.dt);
    add_held(spheres, i, before);
  }
}

/* Puts a stuck particle where its wall has it at the end of the step: the periodic image of that
 * place which is nearest to where the particle is. */
void Wall::carry_one(const Spheres &s, int i, double dt) {
  StuckPlace &stuck = place(i).stuck;
  double *x = s.x + 3 * static_cast<size_t>(i), on_wall[3];
  if (stuck.shape >= 1) {
    const size_t shape = static_cast<size_t>(stuck.shape) - 1;
    Place at = {static_cast<int>(stuck.piece), {stuck.at[0], stuck.at[1], stuck.at[2]}};
    shapes_[shape].shape->carry(at, s.radius[i], dt, on_wall, stuck.velocity);
    stuck.piece = at.piece;
    aspi_copy(at.at, stuck.at);
  } else
    aspi_copy(stuck.at, on_wall);
  box_.bring_near(x, on_wall);
  aspi_copy(on_wall, x);
  aspi_copy(stuck.velocity, s.v + 3 * static_cast<size_t>(i));
  for (int d = 0; s.omega && d < 3; d++)
    s.omega[3 * static_cast<size_t>(i) + d] = 0;
}

void Box::bring_near(const double near[3], double x[3]) const {
  for (int d = 0; d < 3; d++)
    if (period[d] > 0)
      x[d] += period[d] * floor((near[d] - x[d]) / period[d] + 0.5);
}

/* What a shape of the restart file is now, both from 1; 0: it is gone. */
int Wall::shape_now(double before) const {
  const size_t k = before >= 1 ? static_cast<size_t>(before) : 0;
  return k >= 1 && k <= shape_now_.size() ? shape_now_[k - 1] : 0;
}

/* Particles refer to shapes by numbers, which may differ in another script. One that is stuck to a
 * removed mesh stays in place; one that rests on it is free. From here on each row names a shape of
 * this wall, or none. */
void Wall::renumber(const Spheres &spheres) {
  for (int i = 0; !shape_now_.empty() && i < spheres.n; i++) {
    StuckPlace &stuck = place(i).stuck;
    RestingPlace &at = place(i).resting;
    if (is_stuck(i)) {
      stuck.shape = shape_now(stuck.shape);
      if (!(stuck.shape >= 1)) {
        aspi_copy(spheres.x + 3 * static_cast<size_t>(i), stuck.at);
        std::fill(stuck.velocity, stuck.velocity + 3, 0.0);
      }
    } else if (is_at_rest(i)) {
      size_t kept = 0;
      for (size_t k = 0; k < at.FACES && at.shape[k] > 0; k++)
        if (const int now = shape_now(at.shape[k])) {
          at.face[kept] = at.face[k];
          at.shape[kept++] = now;
        }
      std::fill(at.shape + kept, at.shape + at.FACES, 0.0);
      if (kept == 0)
        set_status(i, Status::FREE);
    }
  }
  shape_now_.clear();
}
