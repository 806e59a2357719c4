/* Contacts of bodies: the search, and what each contact is; see bodies.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/bodies.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/error.h"
#include "dem/step/body_motion.h"
#include "dem/step/body_way.h"
#include "dem/step/flight.h"
#include "dem/text.h"

using namespace asperity;

namespace {

/* The angle by which a body turns in a stretch of its path, rad. */
const double TURN = 0.1;

/* Contacts are at one instant if the gap between them is less than this share of the radius. */
const double SAME = 1e-6;

/* Contacts of a body in a row at one instant, at most, before all are taken as sustained; and
 * twice, before its step ends. */
const int SERIES = 8;

/* Spheres that are this deep in a wall, in radii, on sides with a cosine of less than minus this.
 */
const double DEEP = 0.01, OTHER_SIDE = 0.99;

/* Contacts of one body in one step, at most: then it goes with its wall. */
const int CONTACTS_MOST = 1000;

} // namespace

Way::Way(const std::vector<Stepper *> &walls, Bodies &bodies, size_t number)
    : walls_(walls), bodies_(bodies), number_(number), body_(bodies.all[number]), arrival_(body_),
      left_(bodies.dt), moved_(0), is_stuck_(false) {}

const asp_wall *Way::law(const Touch &touch) const {
  const asp_wall *of = wall(touch).setup.model.wall();
  if (!of)
    throw Error("a body came to be after the run began, and the wall's tables need the diameters "
                "beforehand; make particles before 'run', or by a fix insert");
  return of;
}

/* ---- the search -------------------------------------------------------------------------------
 */

/* The shapes that the body may meet in the rest of the step. */
void Way::find_near() {
  double omega[3], reach = 0, out = 0;
  spin_of(body_, omega);
  for (size_t k = body_.first; k < body_.first + body_.count; k++) {
    const double length = aspi_length(bodies_.spheres[k].arm);
    reach = std::max(reach, length + bodies_.spheres[k].radius);
    out = std::max(out, length);
  }
  reach += left_ * (aspi_length(body_.v) + out * aspi_length(omega));
  near_.clear();
  for (size_t w = 0; w < walls_.size(); w++)
    for (size_t m = 0; m < walls_[w]->setup.shapes.size(); m++) {
      const Shape &shape = *walls_[w]->setup.shapes[m].shape;
      double lo[3], hi[3];
      for (int d = 0; d < 3; d++) {
        lo[d] = body_.x[d] - reach - shape.travel(bodies_.dt);
        hi[d] = body_.x[d] + reach + shape.travel(bodies_.dt);
      }
      if (shape.may_meet(lo, hi))
        near_.push_back(std::make_pair(w, m));
    }
}

/* The first contacts, all at one instant, in the stretch of a time that ends at `end`. */
void Way::search(const Body &end, double time) {
  touches_.clear();
  double first = time;
  for (size_t k = body_.first; k < body_.first + body_.count; k++) {
    const BodySphere &one = bodies_.spheres[k];
    double from[3], to[3];
    Touch touch;
    touch.sphere = k;
    arm_of(body_, one, from);
    arm_of(end, one, to);
    aspi_add_scaled(body_.x, 1, from, touch.before.x);
    aspi_add_scaled(end.x, 1, to, to);
    aspi_subtract(to, touch.before.x, touch.before.v);
    aspi_scale(1 / time, touch.before.v);
    touch.before.left = left_;
    touch.before.dt = bodies_.dt;
    for (const std::pair<size_t, size_t> &at : near_) {
      touch.wall = at.first;
      touch.shape = at.second;
      const double speed = aspi_length(touch.before.v), same = SAME * one.radius;
      const double latest = std::min(time, speed > 0 ? first + same / speed : time);
      if (!(one.mask & wall(touch).setup.groupbit) ||
          !shape(touch).shape->find(touch.before, one.radius, latest, touch.contact))
        continue;
      if ((first - touch.contact.time) * touch.contact.closing > same)
        touches_.clear();
      first = std::min(first, touch.contact.time);
      touches_.push_back(touch);
    }
  }
}

/* Moves the body to its next contacts, or to the end of the step: then false. */
bool Way::find_next() {
  while (left_ > 0) {
    double omega[3];
    spin_of(body_, omega);
    const double rate = aspi_length(omega);
    double time = rate * left_ > TURN ? TURN / rate : left_;
    Body end = body_;
    if (body_.is_changed || time < left_)
      advance(end, time);
    else
      end = arrival_;
    search(end, time);
    if (touches_.empty()) {
      body_ = end;
      left_ = time < left_ ? left_ - time : 0;
      moved_ += time;
      continue;
    }
    const Touch *first = &touches_[0];
    for (const Touch &touch : touches_)
      if (touch.contact.time < first->contact.time)
        first = &touch;
    time = first->contact.time;
    advance(body_, time);
    left_ = std::max(0.0, left_ - time);
    moved_ += time;
    double arm[3], at[3];
    arm_of(body_, sphere(*first), arm);
    aspi_add_scaled(body_.x, 1, arm, at);
    aspi_subtract(first->contact.x, at, at);
    aspi_add_scaled(body_.x, 1, at, body_.x);
    return true;
  }
  return false;
}

/* A body that two faces of one place push apart was made across the wall. */
void Way::check_side() {
  for (const Touch &touch : touches_) {
    const Contact &contact = touch.contact;
    double at[3], moved[3];
    aspi_add_scaled(touch.before.x, contact.time, touch.before.v, at);
    aspi_subtract(contact.x, at, moved);
    if (!contact.overlapped || aspi_length(moved) < DEEP * sphere(touch).radius)
      continue;
    for (const Touch &other : overlaps_)
      if (other.wall == touch.wall && other.shape == touch.shape && other.sphere != touch.sphere &&
          other.contact.piece == contact.piece &&
          aspi_dot(other.contact.n, contact.n) < -OTHER_SIDE)
        throw Error(
            text("body %lld reaches through the wall at %g %g %g: two of its spheres are on "
                 "opposite sides; bodies must be made, or poured, on one side",
                 static_cast<long long>(body_.tag + 1), contact.x[0], contact.x[1], contact.x[2]));
    overlaps_.push_back(touch);
  }
}

/* ---- one contact ------------------------------------------------------------------------------
 */

/* The velocity at this instant. */
void Way::velocity(double v[3]) const {
  aspi_add_scaled(body_.v, 0.5 * bodies_.dt - left_, body_.acceleration, v);
}

/* That of the touching sphere, relative to the wall. */
void Way::relative_velocity(const Touch &touch, double u[3]) const {
  double v[3], omega[3], arm[3], turned[3];
  velocity(v);
  spin_of(body_, omega);
  arm_of(body_, sphere(touch), arm);
  aspi_cross(omega, arm, turned);
  aspi_subtract(v, touch.contact.v_wall, u);
  aspi_add_scaled(u, 1, turned, u);
}

/* The acceleration that presses the body to the wall; may be negative. */
double Way::press(const Touch &touch) const {
  return touch.contact.follow - aspi_dot(body_.acceleration, touch.contact.n);
}

/* The acceleration of the center of a sphere by the free turning of the body. */
static void turning(const Body &body, const asp_body &inverse, const double arm[3], double a[3]) {
  double omega[3], gyro[3], alpha[3], side[3];
  spin_of(body, omega);
  aspi_cross(body.angular_momentum, omega, gyro);
  multiply(inverse.inverse_inertia, gyro, alpha);
  aspi_cross(alpha, arm, a);
  aspi_cross(omega, arm, side);
  aspi_cross(omega, side, gyro);
  aspi_add_scaled(a, 1, gyro, a);
}

/* True for an impact, false for a contact that stays, by the criterion of step.cpp. A body that
 * stayed in the step before has the speed that was added since the middle of that step. */
bool Way::arrives(const Touch &touch, double &approach) const {
  double u[3], arm[3], turns[3];
  const double none[3] = {0, 0, 0}, *n = touch.contact.n;
  const asp_body inverse = inverse_of(body_, none);
  relative_velocity(touch, u);
  arm_of(body_, sphere(touch), arm);
  approach = -aspi_dot(u, n);
  const double half = 0.5 * bodies_.dt, step = static_cast<double>(bodies_.step);
  const bool stayed = fabs(memory(touch.wall).stayed - step) < 0.5;
  const double added = stayed ? half + (bodies_.dt - left_) : half;
  /* A body that stands on another point of it falls that much faster here, at most. */
  const double more = body_.mass * inverse_mass_at(inverse, arm, n);
  turning(body_, inverse, arm, turns);
  const double falls = more * press(touch) + std::max(0.0, -aspi_dot(turns, n));
  return approach > std::max((1 + ROUNDING) * added * falls, GRAZING * aspi_length(u));
}

/* The contacts of this instant: an impact, several at a smooth wall, or all of them stay. */
void Way::meet(bool all_stay) {
  std::vector<Touch> arriving;
  std::vector<Touch *> coming; /* slowly, from elsewhere */
  body_.is_changed = true;
  for (Touch &touch : touches_) {
    touch.hold = 0;
    touch.is_low = false;
    if (!arrives(touch, touch.approach)) {
      if (touch.approach > 0 && memory(touch.wall).stayed < static_cast<double>(bodies_.step))
        coming.push_back(&touch);
    } else if (!all_stay) {
      touch.is_low = is_low(touch, touch.approach);
      if (!touch.is_low)
        arriving.push_back(touch);
    }
  }
  if (arriving.size() > 1 && !asp_wall_surface(law(arriving[0]))) {
    hit_together(arriving);
    return;
  }
  if (!arriving.empty()) {
    hit(arriving[0]);
    return;
  }
  for (const Touch *touch : coming)
    if (!all_stay && sticks(*touch))
      return;
  for (const Touch &touch : touches_)
    if (!all_stay && graze(touch))
      return;
  stay(!all_stay);
}

void Way::go() {
  int series = 0, all = 0;
  find_near();
  if (near_.empty())
    return;
  advance(body_, -bodies_.dt);
  while (find_next()) {
    series = moved_ > 1e-6 * bodies_.dt ? 0 : series + 1;
    moved_ = 0;
    if (series == 2 * SERIES || ++all > CONTACTS_MOST) {
      trap(touches_[0]);
      return;
    }
    check_side();
    meet(series > SERIES);
    if (is_stuck_)
      return;
    find_near();
  }
  if (!body_.is_changed)
    body_ = arrival_;
}

bool Bodies::any_stuck() const {
  for (const std::vector<BodyMemory *> &of_wall : memory)
    for (const BodyMemory *of : of_wall)
      if (of->is_stuck())
        return true;
  return false;
}

void asperity::step_bodies(const std::vector<Stepper *> &walls, Bodies &bodies) {
  bodies.ahead.begin_step(walls, bodies.all.size(), bodies.dt);
  for (size_t b = 0; b < bodies.all.size(); b++) {
    bool is_stuck = false;
    for (const std::vector<BodyMemory *> &of : bodies.memory)
      is_stuck = is_stuck || of[b]->is_stuck();
    if (bodies.all[b].is_led ||
        (!is_stuck &&
         !bodies.ahead.is_near(walls, b, bodies.all[b], bodies.spheres.data(), bodies.dt)))
      continue;
    Way way(walls, bodies, b);
    if (!is_stuck || !way.carry_stuck())
      way.go();
  }
  bodies.begins = false;
}

void asperity::hold_bodies(const std::vector<Stepper *> &walls, Bodies &bodies) {
  for (size_t b = 0; b < bodies.all.size(); b++)
    for (size_t w = 0; w < walls.size(); w++)
      if (bodies.memory[w][b]->is_stuck()) {
        Way(walls, bodies, b).hold_stuck();
        break;
      }
}
