/* Particles stuck to a wall, and how they move with it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/mover.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

/* Notes where the particle has stuck, and takes it along with the wall for the rest of the step. */
void Stepper::stick(const Spheres &s, int i, double left, size_t shape, const Path &before,
                    const Contact &contact) {
  Place at;
  setup.shapes[shape].shape->stick(before, contact, at);
  StuckPlace &to = rows.place[i].stuck;
  to.shape = static_cast<double>(shape) + 1;
  to.piece = at.piece;
  aspi_copy(at.at, to.at);
  to.is_kept = 0;
  const bool deletes = setup.model.deposit() == Model::DELETE;
  rows.set_status(i, deletes ? Status::TO_DELETE : Status::STUCK);
  has_to_delete = has_to_delete || deletes;
  stuck.push_back(StuckParticle{i, false, false, {}, {}, 0});
  aspi_copy(contact.x, s.x + 3 * static_cast<size_t>(i));
  carry(s, i, left);
}

/* Gives a stuck particle the velocity of its wall. */
static void set_velocity(const StuckPlace &at, const Spheres &s, int i) {
  const size_t row = 3 * static_cast<size_t>(i);
  aspi_copy(at.velocity, s.v + row);
  for (int d = 0; s.omega && d < 3; d++)
    s.omega[row + d] = 0;
}

/* Changes a stuck particle, and gives its wall the load that holds the particle. */
template <class Change>
static void hold_one(const Stepper &wall, const Spheres &s, int i, Change change) {
  const StuckPlace &at = wall.rows.place[i].stuck;
  const size_t row = 3 * static_cast<size_t>(i);
  double v[3], turn[3] = {0, 0, 0}, p[3];
  aspi_copy(s.v + row, v);
  if (s.omega)
    aspi_add_scaled(turn, -1, s.omega + row, turn);
  change();
  aspi_subtract(s.v + row, v, p);
  if (!(aspi_dot(p, p) + aspi_dot(turn, turn) > 0) || !(at.shape >= 1))
    return;
  wall.books.add_load(
      static_cast<size_t>(at.shape) - 1,
      Mover(s, i).load(0, static_cast<int>(at.piece), s.x + row, NONE, s.x + row, p, turn, NONE));
}

static inline uint64_t bits(const double *x) {
  uint64_t all;
  memcpy(&all, x, sizeof all);
  return all;
}

/* 0 if two vectors are the same to the bit. */
static inline uint64_t change(const double a[3], const double b[3]) {
  return (bits(a) ^ bits(b)) | (bits(a + 1) ^ bits(b + 1)) | (bits(a + 2) ^ bits(b + 2));
}

/* True if a particle without spin comes again as its wall stopped it before. */
static inline bool comes_again(const StuckParticle &at, const Spheres &s) {
  const size_t row = 3 * static_cast<size_t>(at.i);
  const uint64_t spin = s.omega ? change(s.omega + row, NONE) : 0;
  return (change(s.v + row, at.v) | spin | (bits(&at.mass) ^ bits(s.mass + at.i))) == 0;
}

/* Ends the load of a particle after this share of a step. */
void Stepper::drop_load(StuckParticle &at, double share) {
  if (at.is_kept) {
    books.drop_load(at.i, at.x, at.v, at.mass, share);
    rows.place[at.i].stuck.is_kept = 0;
  }
  at.was_stopped = at.is_kept = false;
}

/* A particle that a wall at rest stops again and again, as against gravity, costs no more than its
 * place and velocity: the books keep the load. */
void Stepper::carry_stuck(const Spheres &s) {
  is_in_step = is_still = true;
  for (const Member &member : setup.shapes)
    is_still = is_still && member.shape->is_still() && !member.shape->measures();
  for (StuckParticle &at : stuck) {
    if (is_still && at.was_stopped && comes_again(at, s)) {
      if (!at.is_kept) {
        books.keep_load(at.i, at.x, at.v, at.mass);
        at.is_kept = true;
        rows.place[at.i].stuck.is_kept = 1;
      }
      aspi_copy(at.x, s.x + 3 * static_cast<size_t>(at.i));
      aspi_copy(NONE, s.v + 3 * static_cast<size_t>(at.i));
    } else {
      drop_load(at, 0);
      hold_one(*this, s, at.i, [&] { carry(s, at.i, s.dt); });
    }
  }
  books.add_kept_loads();
}

void Stepper::hold_stuck(const Spheres &s) {
  is_in_step = false;
  for (StuckParticle &at : stuck) {
    double *v = s.v + 3 * static_cast<size_t>(at.i);
    if (at.is_kept && comes_again(at, s)) {
      aspi_copy(NONE, v);
      continue;
    }
    drop_load(at, 0.5);
    const double *v_wall = rows.place[at.i].stuck.velocity;
    at.was_stopped = is_still && change(v_wall, NONE) == 0;
    aspi_copy(s.x + 3 * static_cast<size_t>(at.i), at.x);
    aspi_copy(v, at.v);
    at.mass = s.mass[at.i];
    hold_one(*this, s, at.i, [&] { set_velocity(rows.place[at.i].stuck, s, at.i); });
  }
  books.add_kept_loads();
}

/* Puts a stuck particle where its wall has it at the end of the step: the periodic image of that
 * place which is nearest to where the particle is. */
void Stepper::carry(const Spheres &s, int i, double dt) {
  StuckPlace &at = rows.place[i].stuck;
  double *x = s.x + 3 * static_cast<size_t>(i), on_wall[3];
  if (at.shape >= 1) {
    Place place = {static_cast<int>(at.piece), {at.at[0], at.at[1], at.at[2]}};
    setup.shapes[static_cast<size_t>(at.shape) - 1].shape->carry(place, s.radius[i], dt, on_wall,
                                                                 at.velocity);
    at.piece = place.piece;
    aspi_copy(place.at, at.at);
  } else
    aspi_copy(at.at, on_wall);
  setup.box.bring_near(x, on_wall);
  aspi_copy(on_wall, x);
  set_velocity(at, s, i);
}

void Box::bring_near(const double near[3], double x[3]) const {
  for (int d = 0; d < 3; d++)
    if (period[d] > 0)
      x[d] += period[d] * floor((near[d] - x[d]) / period[d] + 0.5);
}

/* Particles refer to shapes by numbers, which may differ in another script. One that is stuck to a
 * removed mesh stays in place; one that rests on it is free. From here on each row names a shape of
 * this wall, or none. */
void Stepper::renumber(const Spheres &s, const std::vector<int> &shape_now) {
  const auto now = [&](double saved) {
    return saved >= 1 && saved <= static_cast<double>(shape_now.size())
               ? shape_now[static_cast<size_t>(saved) - 1]
               : 0;
  };
  for (int i = 0; i < s.n; i++) {
    StuckPlace &at = rows.place[i].stuck;
    if (rows.is_stuck(i)) {
      at.shape = now(at.shape);
      if (!(at.shape >= 1)) {
        aspi_copy(s.x + 3 * static_cast<size_t>(i), at.at);
        std::fill(at.velocity, at.velocity + 3, 0.0);
      }
    } else if (rows.status(i) == Status::RESTING) {
      Rest *const rests = rows.place[i].rests;
      size_t kept = 0;
      for (size_t k = 0; k < ParticlePlace::RESTS && rests[k].shape > 0; k++)
        if (const int shape = now(rests[k].shape)) {
          rests[kept] = rests[k];
          rests[kept++].shape = shape;
        }
      std::fill(rests + kept, rests + ParticlePlace::RESTS, Rest());
      if (kept == 0)
        rows.set_status(i, Status::FREE);
    }
  }
}
