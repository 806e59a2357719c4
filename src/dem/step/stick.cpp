/* Particles stuck to a wall, and how they move with it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

static const double NONE[3] = {0, 0, 0};

/* Notes where the particle has stuck, and takes it along with the wall for the rest of the step. */
void Stepper::stick(Flight &flight, size_t shape, const Path &before, const Contact &contact) {
  const int i = flight.i;
  Place at;
  setup.shapes[shape].shape->stick(before, contact, at);
  StuckPlace &to = rows.place[i].stuck;
  to.shape = static_cast<double>(shape) + 1;
  to.piece = at.piece;
  aspi_copy(at.at, to.at);
  const bool deletes = setup.model.deposit() == Model::DELETE;
  rows.set_status(i, deletes ? Status::TO_DELETE : Status::STUCK);
  has_to_delete = has_to_delete || deletes;
  stuck.push_back(i);
  held_at.resize(3 * stuck.size(), NAN);
  aspi_copy(contact.x, flight.spheres.x + 3 * static_cast<size_t>(i));
  carry(flight.spheres, i, flight.path.left);
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
  ContactLoad load(s, i, static_cast<int>(at.piece), s.x + row, NONE, p, NONE);
  load.set_couple(s, i, s.x + row, turn);
  wall.books.add_load(static_cast<size_t>(at.shape) - 1, load);
}

static inline uint64_t bits(const double *x) {
  uint64_t all;
  memcpy(&all, x, sizeof all);
  return all;
}

/* True if a vector is 0, and no component is -0. */
static inline bool is_zero(const double x[3]) {
  return (bits(x) | bits(x + 1) | bits(x + 2)) == 0;
}

/* True if a particle's wall left it at rest in this place, and it has neither velocity nor spin. */
static inline bool is_held(const Spheres &s, int i, const double at[3]) {
  const size_t row = 3 * static_cast<size_t>(i);
  return at[0] <= HUGE_VAL && is_zero(s.v + row) && (!s.omega || is_zero(s.omega + row));
}

/* A particle that a wall at rest holds costs no more than the look at it. */
void Stepper::carry_stuck(const Spheres &s) {
  is_still = true;
  for (const Member &member : setup.shapes)
    is_still = is_still && member.shape->is_still();
  double *at = held_at.data();
  for (int i : stuck) {
    const double *x = s.x + 3 * static_cast<size_t>(i);
    const bool moved =
        ((bits(x) ^ bits(at)) | (bits(x + 1) ^ bits(at + 1)) | (bits(x + 2) ^ bits(at + 2))) != 0;
    if (!is_still || moved || !is_held(s, i, at)) {
      hold_one(*this, s, i, [&] { carry(s, i, s.dt); });
      at[0] = NAN;
      if (is_still && is_zero(rows.place[i].stuck.velocity))
        aspi_copy(x, at);
    }
    at += 3;
  }
}

void Stepper::hold_stuck(const Spheres &s) {
  const double *at = held_at.data();
  for (int i : stuck) {
    if (!is_still || !is_held(s, i, at))
      hold_one(*this, s, i, [&] { set_velocity(rows.place[i].stuck, s, i); });
    at += 3;
  }
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
    RestingPlace &resting = rows.place[i].resting;
    if (rows.is_stuck(i)) {
      at.shape = now(at.shape);
      if (!(at.shape >= 1)) {
        aspi_copy(s.x + 3 * static_cast<size_t>(i), at.at);
        std::fill(at.velocity, at.velocity + 3, 0.0);
      }
    } else if (rows.status(i) == Status::RESTING) {
      size_t kept = 0;
      for (size_t k = 0; k < resting.FACES && resting.shape[k] > 0; k++)
        if (const int shape = now(resting.shape[k])) {
          resting.face[kept] = resting.face[k];
          resting.shape[kept++] = shape;
        }
      std::fill(resting.shape + kept, resting.shape + resting.FACES, 0.0);
      if (kept == 0)
        rows.set_status(i, Status::FREE);
    }
  }
}
