/* Bodies stuck to a wall: one sphere of a body has stuck, and the body is held as a whole. It moves
 * and turns with the wall; see bodies.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "contact/vector.h"
#include "dem/step/body_motion.h"
#include "dem/step/body_way.h"

using namespace asperity;

static const double NONE[3] = {0, 0, 0};

static bool differs(const double *one, const double *other, int n) {
  bool any = false;
  for (int k = 0; k < n; k++)
    any = any || one[k] < other[k] || one[k] > other[k];
  return any;
}

/* The sphere that holds the body. */
const BodySphere &Way::anchor(const StuckBody &at) const {
  for (size_t k = body_.first; k < body_.first + body_.count; k++)
    if (static_cast<double>(bodies_.spheres[k].tag) == at.sphere)
      return bodies_.spheres[k];
  return bodies_.spheres[body_.first];
}

/* Where a contact holds the body. */
StuckBody Way::held_by(const Touch &touch) const {
  Place place;
  StuckBody at = StuckBody();
  shape(touch).shape->stick(touch.before, touch.contact, place);
  at.sphere = static_cast<double>(sphere(touch).tag);
  at.shape = static_cast<double>(touch.shape) + 1;
  at.piece = place.piece;
  aspi_copy(place.at, at.at);
  for (int k = 0; k < 3; k++)
    aspi_copy(body_.axes[k], at.axes[k]);
  return at;
}

/* The body has stuck: its wall takes it along for the rest of the step. */
void Way::stick(const Touch &touch) {
  Stepper &at = wall(touch);
  BodyMemory &of = memory(touch.wall);
  of.stuck = held_by(touch);
  const bool deletes = at.setup.model.deposit() == Model::DELETE;
  of.status = static_cast<double>(deletes ? Status::TO_DELETE : Status::STUCK);
  at.has_to_delete = at.has_to_delete || deletes;
  is_stuck_ = true;
  carry(touch.wall, of.stuck, 1 - left_ / bodies_.dt);
}

/* The walls leave no room: the body goes with the first of them for the rest of the step. */
void Way::trap(const Touch &touch) {
  StuckBody at = held_by(touch);
  carry(touch.wall, at, 1 - left_ / bodies_.dt);
  wall(touch).books.count_guarded();
}

/* Puts the body where its wall has it at the end of the step, from a share of the step on: the
 * periodic image which is nearest to where it is. */
void Way::carry(size_t number, StuckBody &at, double share) {
  const Stepper &wall = *walls_[number];
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
  give_velocity(number, at);
}

/* Gives the body the velocity of its wall, and the wall the load that holds the body. */
void Way::give_velocity(size_t number, const StuckBody &at) {
  const BodySphere &one = anchor(at);
  double change[3], turn[3], center[3], arm[3];
  momentum_of(body_, at.omega, turn);
  aspi_subtract(turn, body_.angular_momentum, turn);
  aspi_subtract(at.v, body_.v, change);
  if (!differs(turn, NONE, 3) && !differs(change, NONE, 3))
    return;
  aspi_add_scaled(body_.v, 1, change, body_.v);
  aspi_add_scaled(body_.angular_momentum, 1, turn, body_.angular_momentum);
  body_.is_changed = true;
  if (!(at.shape >= 1))
    return;
  arm_of(body_, one, center);
  aspi_add_scaled(center, 1, body_.x, center);
  const TouchingSphere view(bodies_, body_, one);
  ContactLoad load(view.view, 0, static_cast<int>(at.piece), center, NONE, change, NONE);
  load.particle = -1;
  aspi_subtract(body_.x, center, arm);
  aspi_cross(arm, load.impulse, load.couple);
  aspi_add_scaled(load.couple, -1, turn, load.couple);
  walls_[number]->books.add_load(static_cast<size_t>(at.shape) - 1, load);
}

/* A wall without deposits holds nothing, nor does one whose flow takes away what sticks. */
static bool lets_go(const Stepper &wall, const StuckBody &at, const BodySphere &one, bool begins) {
  const Model &model = wall.setup.model;
  const size_t shape = static_cast<size_t>(at.shape) - 1;
  return begins && (model.deposit() == Model::OFF ||
                    (shape < wall.setup.shapes.size() &&
                     model.removes(one.type, wall.setup.shapes[shape].wall_type, 2 * one.radius)));
}

bool Way::carry_stuck() {
  for (size_t w = 0; w < walls_.size(); w++) {
    BodyMemory &of = memory(w);
    if (!of.is_stuck())
      continue;
    if (lets_go(*walls_[w], of.stuck, anchor(of.stuck), bodies_.begins)) {
      of.status = static_cast<double>(Status::FREE);
      continue;
    }
    carry(w, of.stuck, 0);
    return true;
  }
  return false;
}

void Way::hold_stuck() {
  for (size_t w = 0; w < walls_.size(); w++)
    if (memory(w).is_stuck()) {
      give_velocity(w, memory(w).stuck);
      return;
    }
}
