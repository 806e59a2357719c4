/* The sustained contacts of a mover on its way through a step; see flight.h and held.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

/* ROUNDING of the normals of one face, which may be curved. */
const double TURNED = 0.01;

} // namespace

bool asperity::find_rest(const Mover &mover, Wall &wall, Rest &rest, const double x[3],
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

/* Turns a contact into one along which the path moves at least at a speed. */
static void lead_along(const Mover &mover, const double n[3], double speed, Held &one) {
  aspi_copy(n, one.n);
  one.set(mover, 0);
  one.friction = 0;
  aspi_copy(n, one.w);
  aspi_scale(speed, one.w);
}

/* Makes the path satisfy all of those. */
void Flight::lead_path() {
  double w[3];
  aspi_copy(turning, w);
  for (Held &one : along)
    aspi_copy(NONE, one.p);
  solve_held(mover, along, path.v, w);
  aspi_subtract(w, turning, w);
  aspi_add_scaled(lift, mover.is_ball ? 0 : 1, w, lift);
}

/* Makes the path rise by a speed above where it ends at a face at which the mover rests, and as
 * much as before above the others that it has met in this row. */
void Flight::slide(const Touch &touch, double rises) {
  const auto is_same = [&](const Held &one) {
    return one.wall == touch.wall && one.shape == touch.shape && one.face == touch.face &&
           one.sphere == touch.sphere;
  };
  auto one = std::find_if(along.begin(), along.end(), is_same);
  if (one == along.end())
    one = along.insert(one, Held());
  static_cast<Touch &>(*one) = touch;
  lead_along(mover, touch.n_end, along_path(touch, touch.n_end) + rises, *one);
  lead_path();
}

/* Adds a sustained contact to those of this place, and solves all of them. One that is there
 * already is met again because the path is straight, and only the path changes. */
void Flight::sustain(const Touch &touch, double hold) {
  const double speed = aspi_length(touch.before.v) + aspi_length(touch.v_wall);
  const double least_speed = along_path(touch, touch.n_end) +
                             (1 + ROUNDING) * std::max(0.0, touch.approach_speed) +
                             SUM_ROUNDING * speed;
  is_undisturbed = false;
  Held *one = find_sustained(touch);
  if (!one)
    one = &add_sustained(touch, hold);
  one->least_speed = least_speed;
  aspi_copy(touch.n, one->n_last);
  aspi_copy(touch.n_end, one->n_path);
  follow_walls();
}

/* The acceleration by walls that lead a ball around a curve: what they give beyond what holds it
 * against the forces. */
void Flight::lead(double a[3]) const {
  aspi_subtract(acceleration, free, a);
  const double square = aspi_dot(a, a);
  aspi_scale(mover.is_ball && square > 0 ? std::max(0.0, aspi_dot(acceleration, a)) / square : 0,
             a);
}

Held &Flight::add_sustained(const Touch &touch, double hold) {
  if (is_apart)
    settle();
  if (sustained.empty()) {
    if (is_held && is_pushed) {
      lead(led);
      aspi_scale(elapsed() - 0.5 * dt, led);
    } else
      aspi_copy(NONE, led);
    aspi_add_scaled(half, 1, led, free_half);
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
  aspi_subtract(half, led, half);
  for (int d = 0; d < 3; d++)
    path.v[d] += half[d] - before[d];
  return one;
}

/* Makes the path follow the walls as the search finds them, which differs slightly from the
 * velocities at one instant. The push against the walls must not speed the mover up along them, and
 * at this instant a ball moves along them. */
void Flight::follow_walls() {
  aspi_copy(is_held ? a0 : free, acceleration);
  is_pushed = true;
  for (const Held &one : sustained) {
    const double push = one.follow + one.curve - aspi_dot(acceleration, one.n);
    aspi_add_scaled(acceleration, std::max(0.0, push), one.n, acceleration);
  }
  if (sustained.size() == 1 && mover.is_ball) {
    const double *n = sustained[0].n_path, less = sustained[0].least_speed - aspi_dot(path.v, n);
    aspi_add_scaled(path.v, std::max(0.0, less), n, path.v);
  } else {
    along = sustained;
    for (Held &one : along)
      lead_along(mover, one.n_path, one.least_speed, one);
    lead_path();
  }
  aspi_add_scaled(half, elapsed() - 0.5 * dt,
                  !mover.is_ball ? acceleration
                  : is_held      ? a0
                                 : free,
                  begin);
  aspi_subtract(begin, led, begin);
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
  for (Wall *wall : walls_)
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

/* Where a wall takes what is at it to in the rest of the step, with its velocity then. One that
 * slides along itself takes it nowhere. */
void Flight::ride(const Touch &at, double x[3], double v[3]) const {
  const Shape &shape = *at.wall->setup.shapes[at.shape].shape;
  double arm[3];
  aspi_copy(at.x, x);
  aspi_copy(NONE, v);
  if (shape.travel(dt) > 0) {
    Place place;
    shape.stick(at.before, at, place);
    shape.carry(place, mover.sphere[at.sphere].radius, path.left, x, v);
  }
  mover.arm(at.sphere, arm);
  aspi_subtract(x, arm, x);
}

/* The mover waits at a wall for the next step, as it is. */
void Flight::wait(const Touch &at) {
  double v[3];
  ride(at, path.x, v);
  path.left = 0;
}

/* The walls leave no room: the mover goes with them, in their middle, and none of the impacts in
 * this place has happened. */
void Flight::trap() {
  const double part = 1.0 / static_cast<double>(sustained.size());
  double x[3] = {0, 0, 0}, v[3] = {0, 0, 0}, change[3], turned[3];
  for (const Held &one : sustained) {
    double its_x[3], its_v[3];
    ride(one, its_x, its_v);
    aspi_add_scaled(x, part, its_x, x);
    aspi_add_scaled(v, part, its_v, v);
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
  aspi_copy(v, half);
  path.left = 0;
}
