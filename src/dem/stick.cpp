/* Particles stuck to a wall, and how they move with it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/flight.h"

#include <math.h>

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
  const size_t shape = static_cast<size_t>(stuck.shape) - 1;
  if (!(stuck.shape >= 1) || shape >= shapes_.size())
    return;
  Place at = {static_cast<int>(stuck.piece), {stuck.at[0], stuck.at[1], stuck.at[2]}};
  shapes_[shape].shape->carry(at, s.radius[i], dt, on_wall, stuck.velocity);
  stuck.piece = at.piece;
  aspi_copy(at.at, stuck.at);
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

/* A stuck particle refers to its mesh by a number, which may differ in another script. One that is
 * stuck to a removed mesh stays in place. */
void Wall::renumber_stuck(const Spheres &spheres) {
  for (int i = 0; !shape_now_.empty() && i < spheres.n; i++) {
    StuckPlace &stuck = place(i).stuck;
    const size_t before = is_stuck(i) ? static_cast<size_t>(stuck.shape) : 0;
    if (before < 1 || before > shape_now_.size())
      continue;
    stuck.shape = shape_now_[before - 1];
    for (int d = 0; d < 3 && shape_now_[before - 1] == 0; d++)
      stuck.velocity[d] = 0;
  }
  shape_now_.clear();
}
