/* The path of a mover within a step; see flight.h. Its sustained contacts are in sustained.cpp.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

/* The angular velocity that turns axes into others in a time, by less than half a turn. */
void turn_between(const double from[3][3], const double to[3][3], double time, double omega[3]) {
  double trace = 0, sine[3] = {0, 0, 0};
  for (int k = 0; k < 3; k++) {
    double side[3];
    trace += aspi_dot(from[k], to[k]);
    aspi_cross(from[k], to[k], side);
    aspi_add_scaled(sine, 0.5, side, sine);
  }
  const double s = aspi_length(sine);
  aspi_copy(sine, omega);
  aspi_scale(s > 0 ? atan2(s, 0.5 * (trace - 1)) / (s * time) : 0, omega);
}

} // namespace

Flight::Flight(Mover &m, const Movers &movers, const Instant &now, const std::vector<Wall *> &walls)
    : mover(m), dt(movers.dt), step(movers.step), is_held(true), is_pushed(false),
      is_undisturbed(true), squeezed(false), searches_all(m.body), is_apart(false), way(0),
      series_begin(0), walls_(walls) {
  path.left = path.dt = stretch = dt;
  path.rest = 0;
  aspi_copy(now.v, path.v);
  aspi_copy(now.v, half);
  aspi_add_scaled(now.x, -dt, now.v, path.x);
  aspi_copy(now.a, acceleration);
  aspi_copy(path.x, x0);
  aspi_add_scaled(now.v, -0.5 * dt, acceleration, v0);
  aspi_copy(v0, begin);
  aspi_copy(acceleration, a0);
  aspi_copy(acceleration, free);
  double push = 0;
  for (Wall *wall : walls)
    for (const Rest &rest : mover.at(*wall).rests()) {
      aspi_add_scaled(free, -1, rest.push, free);
      push = std::max(push, aspi_dot(rest.push, rest.push));
      is_pushed = is_undisturbed = push > 0; /* else nothing has held it in this step */
    }
  aspi_copy(now.spin, spin);
  for (int d = 0; d < 3; d++)
    turning[d] = lift[d] = settled[d] = led[d] = 0;
  if (m.body)
    turn_back();
}

/* The axes from which a free turn leads to those that the engine has given the body. Its own turn
 * is less exact: the difference counts as one of the beginning, so that the path ends where a body
 * that meets no wall stays. */
void Flight::turn_back() {
  double start[3][3];
  memcpy(start, mover.axes, sizeof start);
  turn_free(mover.body->inertia, mover.body->angular_momentum, -dt, start);
  aspi_copy(mover.body->angular_momentum, momentum);
  aspi_scale(1 / mover.mass, momentum);
  mover.set_axes(start);
  mover.spin_of(momentum, spin);
}

/* At a time since the beginning of the path. Around a curve it turns, and keeps its speed. */
void Flight::velocity(double time, double v[3]) const {
  double turn[3];
  aspi_add_scaled(begin, time, acceleration, v);
  if (!is_pushed)
    return;
  lead(turn);
  const double most = aspi_dot(turn, turn) * time * time;
  if (!(most > 0))
    return;
  aspi_scale(time, turn);
  aspi_subtract(v, turn, v);
  const double square = aspi_dot(v, v), part = aspi_dot(turn, v);
  if (square > 0)
    aspi_scale(sqrt(std::max(0.0, 1 - (most - part * part / square) / square)), v);
  aspi_add_scaled(v, 1, turn, v);
}

Path Flight::path_of(size_t k) const {
  if (mover.is_ball)
    return path;
  Path its = path;
  double from[3], to[3], end[3][3];
  mover.arm(k, from);
  for (int j = 0; j < 3; j++)
    aspi_copy(mover.axes[j], end[j]);
  turn_by(turning, stretch, end);
  for (int d = 0; d < 3; d++)
    to[d] = mover.sphere[k].arm[0] * end[0][d] + mover.sphere[k].arm[1] * end[1][d] +
            mover.sphere[k].arm[2] * end[2][d];
  aspi_add_scaled(its.x, 1, from, its.x);
  aspi_subtract(to, from, to);
  aspi_add_scaled(its.v, 1 / stretch, to, its.v);
  if (stretch < path.left) {
    its.left = stretch;
    its.rest = path.left - stretch;
  }
  return its;
}

/* The axes of a body that no wall turns, after a time. */
void Flight::turn_alone(double time, double to[3][3]) const {
  double whole[3] = {0, 0, 0};
  memcpy(to, mover.axes, sizeof mover.axes);
  aspi_add_scaled(whole, mover.mass, momentum, whole);
  turn_free(mover.body->inertia, whole, time, to);
}

void Flight::aim(double angle) {
  if (mover.is_ball) {
    stretch = path.left;
    return;
  }
  double to[3][3];
  const double spins = aspi_length(spin);
  const double time = spins * path.left > angle ? angle / spins : path.left;
  turn_alone(time, to);
  turn_between(mover.axes, to, time, turning);
  aspi_add_scaled(turning, 1, lift, turning);
  const double rate = aspi_length(turning);
  stretch = rate * path.left > angle ? angle / rate : path.left;
}

double Flight::farthest() const {
  double most = 0;
  for (size_t k = 0; k < mover.count && !mover.is_ball; k++)
    most = std::max(most, aspi_length(mover.sphere[k].arm));
  return most;
}

void Flight::go_on(double time) {
  aspi_add_scaled(path.x, time, path.v, path.x);
  velocity(time, begin);
  path.left = time < path.left ? path.left - time : 0;
  if (mover.is_ball)
    return;
  mover.turn(turning, time);
  mover.spin_of(momentum, spin);
}

void Flight::leap(double time) {
  double to[3][3];
  if (mover.is_ball) {
    go_on(time);
    return;
  }
  turn_alone(time, to);
  turn_by(lift, time, to);
  aspi_copy(NONE, turning);
  go_on(time);
  mover.set_axes(to);
  mover.spin_of(momentum, spin);
}

/* Moves the mover on to a contact; the path ends where it would have. A wall that turns finds its
 * contacts on a path that is straight as that wall sees it. v: its velocity there. */
void Flight::advance(const Touch &touch, double v[3]) {
  velocity(touch.time, v);
  if (!touch.wall->is_still && path.left - touch.time > ROUNDING * dt) {
    double off[3];
    aspi_add_scaled(touch.before.x, touch.time, touch.before.v, off);
    aspi_subtract(touch.x, off, off);
    if (touch.overlapped)
      aspi_add_scaled(off, -aspi_dot(off, touch.n), touch.n, off);
    aspi_add_scaled(path.v, -1 / (path.left - touch.time), off, path.v);
  }
  if (mover.is_ball) {
    aspi_copy(touch.x, path.x);
    path.left = std::max(0.0, path.left - touch.time);
  } else {
    double arm[3];
    go_on(touch.time);
    mover.arm(touch.sphere, arm);
    aspi_subtract(touch.x, arm, path.x);
  }
  aspi_copy(v, begin);
}

/* Adds the mean velocity change along n during the rest of the step. */
void Flight::act_along(const double n[3], double ahead[3]) const {
  aspi_add_scaled(ahead, 0.5 * path.left * aspi_dot(free, n) - aspi_dot(ahead, n), n, ahead);
}

/* The path from where it has come to, by a contact that has changed the velocity there. Its mean
 * velocity differs from that at its beginning: along n by what acts for the rest of the step, and
 * across it by as much as before, so that a mover which loses nothing along the wall ends where it
 * would have without the wall. The walls at which it stayed hold it no more: they have given what
 * its velocity has got by now. */
void Flight::turn(const double before[3], const double after[3], const double n[3]) {
  double ahead[3], held[3], change[3];
  aspi_subtract(acceleration, free, held);
  const double by = aspi_length(held);
  aspi_copy(free, acceleration);
  is_pushed = false;
  aspi_subtract(path.v, before, ahead);
  if (by > 0) {
    aspi_scale(1 / by, held);
    act_along(held, ahead);
  }
  act_along(n, ahead);
  is_undisturbed = false;
  aspi_subtract(before, half, change);
  aspi_add_scaled(change, 0.5 * dt - elapsed(), free, change);
  share(change, NONE);
  settle();
  is_held = false;
  aspi_add_scaled(after, 0.5 * dt - elapsed(), free, half);
  aspi_copy(after, begin);
  aspi_add_scaled(after, 1, ahead, path.v);
}

void Flight::set_spin(const double to[3]) {
  aspi_copy(to, spin);
  aspi_copy(to, turning);
  aspi_copy(NONE, lift);
  is_undisturbed = false;
  if (mover.body)
    mover.momentum_of(to, momentum);
}

/* True if the path differs from that at the beginning of the step by more than this velocity. */
bool Flight::has_strayed(const double v[3], double most) const {
  double change[3];
  aspi_subtract(path.v, v, change);
  return !(aspi_dot(change, change) <= most * most);
}
