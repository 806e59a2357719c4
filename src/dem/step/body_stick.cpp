/* Bodies stuck to a wall: one sphere of a body has stuck, and the body is held as a whole. It moves
 * and turns with the wall; see bodies.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "contact/vector.h"
#include "dem/step/body_motion.h"
#include "dem/step/mover.h"

using namespace asperity;

static bool differs(const double *one, const double *other, int n) {
  bool any = false;
  for (int k = 0; k < n; k++)
    any = any || one[k] < other[k] || one[k] > other[k];
  return any;
}

namespace {

typedef std::vector<Stepper *> Walls;

/* A body that is stuck to a wall. */
class StuckOne {
public:
  StuckOne(const Walls &walls, Bodies &bodies, size_t number)
      : walls_(walls), bodies_(bodies), number_(number), body_(bodies.all[number]) {}

  /* The wall to which it is stuck, or none: then how many there are. */
  size_t wall() const {
    size_t w = 0;
    while (w < walls_.size() && !memory(w).is_stuck())
      w++;
    return w;
  }
  BodyMemory &memory(size_t wall) const {
    return *bodies_.memory[wall][number_];
  }
  bool lets_go(size_t wall) const;
  void carry(size_t wall, double share);
  void give_velocity(size_t wall);

private:
  const BodySphere &anchor(const StuckBody &at) const;

  const Walls &walls_;
  Bodies &bodies_;
  const size_t number_;
  Body &body_;
};

/* The sphere that holds the body. */
const BodySphere &StuckOne::anchor(const StuckBody &at) const {
  for (size_t k = body_.first; k < body_.first + body_.count; k++)
    if (static_cast<double>(bodies_.spheres[k].tag) == at.sphere)
      return bodies_.spheres[k];
  return bodies_.spheres[body_.first];
}

/* Puts the body where its wall has it at the end of the step, from a share of the step on: the
 * periodic image which is nearest to where it is. */
void StuckOne::carry(size_t number, double share) {
  const Stepper &wall = *walls_[number];
  StuckBody &at = memory(number).stuck;
  const BodySphere &one = anchor(at);
  double now[3], arm[3], x[3], v[3], off[3];
  arm_of(body_, one, now);
  aspi_add_scaled(now, 1, body_.x, now);
  if (at.shape >= 1) {
    const Shape &shape = *wall.setup.shapes[static_cast<size_t>(at.shape) - 1].shape;
    Place place = {static_cast<int>(at.piece), {at.at[0], at.at[1], at.at[2]}};
    shape.turn(place, share, bodies_.dt, at.axes, at.omega);
    shape.carry(place, one.radius, (1 - share) * bodies_.dt, x, v);
    at.piece = place.piece;
    aspi_copy(place.at, at.at);
  } else {
    if (!(fabs(at.at[0]) <= HUGE_VAL)) { /* its shape is gone */
      aspi_copy(now, at.at);
      for (int k = 0; k < 3; k++)
        aspi_copy(body_.axes[k], at.axes[k]);
    }
    aspi_copy(at.at, x);
    aspi_copy(NONE, v);
    aspi_copy(NONE, at.omega);
  }
  wall.setup.box.bring_near(now, x);
  body_.is_changed = body_.is_changed || differs(body_.axes[0], at.axes[0], 9);
  for (int k = 0; k < 3; k++)
    aspi_copy(at.axes[k], body_.axes[k]);
  arm_of(body_, one, arm);
  aspi_subtract(x, arm, x);
  body_.is_changed = body_.is_changed || differs(body_.x, x, 3);
  aspi_copy(x, body_.x);
  aspi_cross(at.omega, arm, off);
  aspi_subtract(v, off, at.v);
  give_velocity(number);
}

/* Gives the body the velocity of its wall, and the wall the load that holds the body. */
void StuckOne::give_velocity(size_t number) {
  const StuckBody &at = memory(number).stuck;
  const BodySphere &one = anchor(at);
  double change[3], turn[3], spin[3], center[3];
  momentum_of(body_, at.omega, turn);
  aspi_subtract(turn, body_.angular_momentum, turn);
  aspi_subtract(at.v, body_.v, change);
  if (!differs(turn, NONE, 3) && !differs(change, NONE, 3))
    return;
  spin_of(body_, spin);
  aspi_subtract(at.omega, spin, spin);
  aspi_add_scaled(body_.v, 1, change, body_.v);
  aspi_add_scaled(body_.angular_momentum, 1, turn, body_.angular_momentum);
  body_.is_changed = true;
  if (!(at.shape >= 1))
    return;
  const Mover mover(walls_, bodies_, number_);
  arm_of(body_, one, center);
  aspi_add_scaled(center, 1, body_.x, center);
  walls_[number]->books.add_load(static_cast<size_t>(at.shape) - 1,
                                 mover.load(static_cast<size_t>(&one - mover.sphere),
                                            static_cast<int>(at.piece), center, NONE, body_.x,
                                            change, spin, NONE));
}

/* A wall without deposits holds nothing, nor does one whose flow takes away what sticks. */
bool StuckOne::lets_go(size_t number) const {
  const Stepper &wall = *walls_[number];
  const StuckBody &at = memory(number).stuck;
  const BodySphere &one = anchor(at);
  const size_t shape = static_cast<size_t>(at.shape) - 1;
  return bodies_.begins &&
         (wall.setup.model.deposit() == Model::OFF ||
          (shape < wall.setup.shapes.size() &&
           wall.setup.model.removes(one.type, wall.setup.shapes[shape].wall_type, 2 * one.radius)));
}

} // namespace

void asperity::stick_body(const Walls &walls, Bodies &bodies, size_t number, Stepper &wall,
                          size_t shape, size_t sphere, const Path &before, const Contact &contact,
                          double left) {
  StuckOne one(walls, bodies, number);
  const Body &body = bodies.all[number];
  size_t w = 0;
  while (walls[w] != &wall)
    w++;
  BodyMemory &of = one.memory(w);
  Place place;
  wall.setup.shapes[shape].shape->stick(before, contact, place);
  of.stuck.sphere = static_cast<double>(bodies.spheres[body.first + sphere].tag);
  of.stuck.shape = static_cast<double>(shape) + 1;
  of.stuck.piece = place.piece;
  aspi_copy(place.at, of.stuck.at);
  for (int k = 0; k < 3; k++)
    aspi_copy(body.axes[k], of.stuck.axes[k]);
  const bool deletes = wall.setup.model.deposit() == Model::DELETE;
  of.status = static_cast<double>(deletes ? Status::TO_DELETE : Status::STUCK);
  wall.has_to_delete = wall.has_to_delete || deletes;
  one.carry(w, 1 - left / bodies.dt);
}

bool asperity::carry_body(const Walls &walls, Bodies &bodies, size_t number) {
  StuckOne one(walls, bodies, number);
  for (size_t w = one.wall(); w < walls.size(); w = one.wall()) {
    if (!one.lets_go(w)) {
      one.carry(w, 0);
      return true;
    }
    one.memory(w).status = static_cast<double>(Status::FREE);
  }
  return false;
}

bool asperity::hold_body(const Walls &walls, Bodies &bodies, size_t number) {
  StuckOne one(walls, bodies, number);
  const size_t w = one.wall();
  if (w < walls.size())
    one.give_velocity(w);
  return w < walls.size();
}
