/* The path of a mover within a step, and its sustained contacts; see flight.h and held.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

/* ROUNDING of the normals of one face, which may be curved. */
const double TURNED = 0.01;

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

/* ---- the path ---------------------------------------------------------------------------------
 */

Flight::Flight(Mover &m, const Movers &movers, const Instant &now,
               const std::vector<Stepper *> &walls)
    : mover(m), dt(movers.dt), step(movers.step), is_held(true), is_led(true), squeezed(false),
      searches_all(m.body), is_apart(false), way(0), series_begin(0), walls_(walls) {
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
  for (Stepper *wall : walls)
    for (const Rest &rest : mover.at(*wall).rests()) {
      aspi_add_scaled(free, -1, rest.push, free);
      push = std::max(push, aspi_dot(rest.push, rest.push));
      is_led = push > 0; /* else nothing has held it in this step */
    }
  aspi_copy(now.spin, spin);
  for (int d = 0; d < 3; d++)
    turning[d] = lift[d] = settled[d] = 0;
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

/* At a time since the beginning of the path. */
void Flight::velocity(double time, double v[3]) const {
  aspi_add_scaled(begin, time, acceleration, v);
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

/* Moves the mover on to a contact. v: its velocity there. */
void Flight::advance(const Touch &touch, double v[3]) {
  velocity(touch.time, v);
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
  aspi_subtract(path.v, before, ahead);
  if (by > 0) {
    aspi_scale(1 / by, held);
    act_along(held, ahead);
  }
  act_along(n, ahead);
  is_led = false;
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
  is_led = false;
  if (mover.body)
    mover.momentum_of(to, momentum);
}

/* True if the path differs from that at the beginning of the step by more than this velocity. */
bool Flight::has_strayed(const double v[3], double most) const {
  double change[3];
  aspi_subtract(path.v, v, change);
  return !(aspi_dot(change, change) <= most * most);
}

/* ---- sustained contacts -----------------------------------------------------------------------
 */

bool asperity::find_rest(const Mover &mover, Stepper &wall, Rest &rest, const double x[3],
                         const double v[3], const double spin[3], double dt, Held &at,
                         double &off) {
  double u[3], distance;
  at.wall = &wall;
  at.rest = &rest;
  at.shape = static_cast<size_t>(rest.shape) - 1;
  at.sphere = mover.is_ball ? 0 : mover.number_of(rest.sphere);
  at.face = static_cast<int>(rest.face);
  at.piece = at.face < 0 ? ~at.face : at.face;
  aspi_copy(NONE, at.n);
  aspi_copy(NONE, at.v_wall);
  aspi_copy(x, at.x);
  at.follow = at.curve = 0;
  if (at.sphere == mover.count || at.shape >= wall.setup.shapes.size())
    return false;
  aspi_copy(v, u);
  if (!mover.is_ball) {
    double arm[3], across[3];
    mover.arm(at.sphere, arm);
    aspi_add_scaled(at.x, 1, arm, at.x);
    aspi_cross(spin, arm, across);
    aspi_add_scaled(u, 1, across, u);
  }
  const double radius = mover.sphere[at.sphere].radius;
  if (!wall.setup.shapes[at.shape].shape->under(at.face, at.x, u, (1 + NEAR) * radius, at,
                                                distance))
    return false;
  at.piece = at.face < 0 ? ~at.face : at.face;
  off = radius - distance;
  if (!(fabs(at.curve) > 0))
    return true;
  aspi_subtract(u, at.v_wall, u);
  return fabs(at.curve) * dt < CURVE * aspi_length(u);
}

/* Faces of a flat mesh count as one. */
static bool is_at(const Held &one, const Touch &now) {
  return one.wall == now.wall && one.shape == now.shape && one.sphere == now.sphere &&
         aspi_dot(one.n_last, now.n) > 1 - (one.face == now.face ? TURNED : ROUNDING);
}

Held *Flight::find_sustained(const Touch &touch) {
  for (Held &one : sustained)
    if (is_at(one, touch))
      return &one;
  return NULL;
}

/* The speed of a contact along n by the path, as the turn begins. */
double Flight::along_path(const Touch &touch, const double n[3]) const {
  double arm[3], across[3];
  const double center = aspi_dot(path.v, n);
  if (mover.is_ball)
    return center;
  mover.arm(touch.sphere, arm);
  aspi_cross(turning, arm, across);
  return center + aspi_dot(across, n);
}

/* Adds a sustained contact to those of this place, and solves all of them. One that is there
 * already is met again because the path is straight, and only the path changes. */
void Flight::sustain(const Touch &touch, double hold) {
  const double speed = aspi_length(touch.before.v) + aspi_length(touch.v_wall);
  const double least_speed = along_path(touch, touch.n_end) +
                             (1 + ROUNDING) * std::max(0.0, touch.approach_speed) +
                             SUM_ROUNDING * speed;
  is_led = false;
  Held *one = find_sustained(touch);
  if (!one)
    one = &add_sustained(touch, hold);
  one->least_speed = least_speed;
  aspi_copy(touch.n, one->n_last);
  aspi_copy(touch.n_end, one->n_path);
  follow_walls();
}

Held &Flight::add_sustained(const Touch &touch, double hold) {
  if (is_apart)
    settle();
  if (sustained.empty()) {
    aspi_copy(half, free_half);
    mover.momentum_of(spin, free_momentum);
  }
  sustained.push_back(Held());
  Held &one = sustained.back();
  static_cast<Touch &>(one) = touch;
  one.set(mover, hold);
  aspi_add_scaled(one.w, 0.5 * path.left * touch.follow + touch.chord, touch.n, one.w);

  double before[3];
  aspi_copy(half, before);
  aspi_copy(free_half, half);
  mover.spin_of(free_momentum, spin);
  squeezed = !solve_held(mover, sustained, half, spin) || squeezed;
  set_spin(spin);
  for (int d = 0; d < 3; d++)
    path.v[d] += half[d] - before[d];
  return one;
}

/* Makes the path follow the walls as the search finds them, which differs slightly from the
 * velocities at one instant. The push against the walls must not speed the mover up along them, and
 * at this instant a ball moves along them. */
void Flight::follow_walls() {
  aspi_copy(is_held ? a0 : free, acceleration);
  for (const Held &one : sustained) {
    const double push = one.follow + one.curve - aspi_dot(acceleration, one.n);
    aspi_add_scaled(acceleration, std::max(0.0, push), one.n, acceleration);
  }
  if (sustained.size() == 1 && mover.is_ball) {
    const double *n = sustained[0].n_path, less = sustained[0].least_speed - aspi_dot(path.v, n);
    aspi_add_scaled(path.v, std::max(0.0, less), n, path.v);
  } else {
    double w[3];
    aspi_copy(turning, w);
    along = sustained;
    for (Held &one : along) {
      aspi_copy(one.n_path, one.n);
      one.set(mover, 0);
      one.friction = 0;
      aspi_copy(one.n, one.w);
      aspi_scale(one.least_speed, one.w);
    }
    solve_held(mover, along, path.v, w);
    aspi_subtract(w, turning, w);
    aspi_add_scaled(lift, mover.is_ball ? 0 : 1, w, lift);
  }
  aspi_add_scaled(half, elapsed() - 0.5 * dt, acceleration, begin);
  for (const Held &one : sustained)
    if (mover.is_ball)
      aspi_add_scaled(begin, aspi_dot(one.v_wall, one.n) - aspi_dot(begin, one.n), one.n, begin);
}

/* Ends the contacts of this place: the walls take their impulses, and remember that the mover rests
 * at them. */
void Flight::settle() {
  for (const Held &one : sustained) {
    add_load(mover, path.x, one);
    aspi_add_scaled(settled, 1, one.p, settled);
    const WallMemory at = mover.at(*one.wall);
    if (at.status() != Status::RESTING)
      mover.members(*one.wall).resting.push_back(mover.i);
    at.rest_at(mover.sphere[one.sphere].tag, one.shape, one.face);
  }
  sustained.clear();
}

/* The walls at which it rests, with the impulses that the books have of them ahead. */
void Flight::list_rests(std::vector<Held> &rests) const {
  for (Stepper *wall : walls_)
    for (Rest &rest : mover.at(*wall).rests()) {
      Held at;
      double off;
      if (!find_rest(mover, *wall, rest, path.x, half, spin, dt, at, off) &&
          (at.sphere == mover.count || at.shape >= wall->setup.shapes.size()))
        continue;
      aspi_copy(rest.push, at.p);
      aspi_scale(0.5 * dt, at.p);
      rests.push_back(at);
    }
}

/* Books what sustained contacts have given velocity and spin beyond their impulses: those act over
 * the step, and may end within it. Each takes a part as its own impulse is. */
void Flight::share(const double change[3], const double turned[3]) {
  double sum[3] = {0, 0, 0}, size = 0, left[3];
  std::vector<Held> all;
  if (is_held)
    list_rests(all);
  all.insert(all.end(), sustained.begin(), sustained.end());
  if (all.empty())
    return;
  for (const Held &one : all) {
    aspi_add_scaled(sum, 1, one.p, sum);
    size += aspi_length(one.p);
  }
  const double square = aspi_dot(sum, sum);
  const double part = square > 0 ? aspi_dot(change, sum) / square : 0;
  aspi_add_scaled(change, -part, sum, left);
  for (const Held &one : all) {
    double p[3];
    aspi_copy(one.p, p);
    aspi_scale(part, p);
    const double equal = size > 0 ? aspi_length(one.p) / size : 1 / static_cast<double>(all.size());
    aspi_add_scaled(p, equal, left, p);
    double turn[3];
    aspi_copy(turned, turn);
    aspi_scale(1 / static_cast<double>(all.size()), turn);
    one.wall->books.add_load(one.shape,
                             mover.load(one.sphere, one.piece, one.x, one.n, path.x, p, turn));
  }
}

/* The walls leave no room: the mover goes with them, in their middle, and none of the impacts in
 * this place has happened. */
void Flight::trap() {
  const double part = 1.0 / static_cast<double>(sustained.size());
  double x[3] = {0, 0, 0}, v[3] = {0, 0, 0}, change[3], turned[3];
  for (const Held &one : sustained) {
    double arm[3];
    mover.arm(one.sphere, arm);
    aspi_add_scaled(x, part, one.x, x);
    aspi_add_scaled(x, -part, arm, x);
    aspi_add_scaled(v, part, one.v_wall, v);
  }
  aspi_copy(x, path.x);
  aspi_subtract(v, half, change);
  aspi_subtract(series_spin, spin, turned);
  for (size_t k = series_begin; k < impacts.size(); k++) {
    const Impact &one = impacts[k];
    double p[3], turn[3];
    --mover.at(*one.wall).impacts();
    aspi_subtract(one.result.v2, one.v1, p);
    aspi_subtract(one.result.omega, one.omega1, turn);
    aspi_add_scaled(change, 1, p, change);
    aspi_add_scaled(turned, 1, turn, turned);
  }
  impacts.erase(impacts.begin() + static_cast<std::ptrdiff_t>(series_begin), impacts.end());
  share(change, turned);
  settle();
  set_spin(series_spin);
  aspi_copy(v, path.v);
  aspi_copy(v, half);
  aspi_copy(NONE, lift);
}
