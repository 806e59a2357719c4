/* The end of a step, after its forces: the walls hold what rests at them, and what has rebounded
 * gets its energy.
 *
 * A mover that rests is held by all of its walls in one solve (supports.h), for the whole of the
 * kick from the middle of this step to that of the next, v_free = v + (dt/2) f/m: then its next
 * path ends at the walls. Half of the impulses belongs to this step and goes into v; the other half
 * is a force, which the engine adds with the others. They are where the next solve begins. A
 * distance from the wall that is off by more than rounding is put right within the next step. A
 * wall that would have to pull lets go.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <algorithm>

#include "asperity_internal.h"
#include "contact/vector.h"

using namespace asperity;

namespace {

typedef std::vector<Stepper *> Walls;

/* A sphere rests at a face while the gap between them is less than GAP radii; less than ROUNDED_OFF
 * is rounding. It leaves a face that does not press it if it moves off by more than PARTS radii in
 * a step. */
const double GAP = 0.01, ROUNDED_OFF = 1e-10, PARTS = 1e-9;

/* The most impacts in one step whose forces are looked at; of more, each is a small share of it. */
const size_t NOTED_MOST = 32;

/* Cosine below which two directions are at right angles. */
const double ACROSS = 1e-9;

/* The contact of a sphere that rests at a face; false: it is there no more. */
bool look_under(const Flight &flight, const Rest &rest, Stepper &wall, const double v[3],
                const double spin[3], Touch &touch, double &distance) {
  const Mover &mover = flight.mover;
  Contact &contact = touch.contact;
  double arm[3], u[3];
  touch = Touch();
  touch.wall = &wall;
  touch.shape = static_cast<size_t>(rest.shape) - 1;
  touch.sphere = mover.number_of(rest.sphere);
  if (touch.sphere == mover.count || touch.shape >= wall.setup.shapes.size())
    return false;
  mover.arm(touch.sphere, arm);
  aspi_add_scaled(flight.path.x, 1, arm, contact.x);
  touch.before = flight.path;
  aspi_copy(contact.x, touch.before.x);
  aspi_copy(v, u);
  if (!mover.is_ball) {
    aspi_cross(spin, arm, u);
    aspi_add_scaled(u, 1, v, u);
  }
  if (!wall.setup.shapes[touch.shape].shape->under(static_cast<int>(rest.face), contact.x, u,
                                                   (1 + GAP) * mover.sphere[touch.sphere].radius,
                                                   contact, distance))
    return false;
  aspi_copy(contact.n, contact.n_end);
  contact.piece = contact.face < 0 ? ~contact.face : contact.face;
  aspi_subtract(u, contact.v_wall, u);
  return fabs(contact.curve) * flight.dt < CURVE * aspi_length(u) || !(fabs(contact.curve) > 0);
}

/* The hold of the valley at a rough wall; where the sphere has come to the next face, it hits that.
 * True where it has. */
bool meet_face(Flight &flight, Touch &touch, double &hold, bool &sticks) {
  const Contact &contact = touch.contact;
  const double v[3] = {flight.begin[0], flight.begin[1], flight.begin[2]};
  Site site(flight, touch, v);
  site.press = contact.follow + contact.curve - aspi_dot(flight.free, contact.n);
  site.find_face(true);
  hold = site.hold(true);
  if (hold > 0 || !site.moved || !site.graze())
    return false;
  sticks = take_impact(site, v);
  return true;
}

/* The accelerations that the walls give a mover until the middle of the next step. */
void sum_pushes(const Walls &walls, const Mover &mover, double push[3], double twist[3]) {
  aspi_copy(NONE, push);
  aspi_copy(NONE, twist);
  for (Stepper *wall : walls)
    for (const Rest &rest : mover.at(*wall).rests()) {
      aspi_add_scaled(push, 1, rest.push, push);
      aspi_add_scaled(twist, 1, rest.twist, twist);
    }
}

/* What holds a mover; the next one uses the same lists. */
struct Resting {
  std::vector<Touch> held;
  std::vector<Support> supports;

  /* alpha: the mover's angular acceleration. Changes the flight's velocity and spin to those of the
   * end of the step. True: it has stuck. */
  bool hold(const Walls &walls, Flight &flight, const double alpha[3], Touch &stuck);

private:
  bool find(const Walls &walls, Flight &flight, const double v[3], const double spin[3],
            Touch &stuck);
  void keep(const Walls &walls, const Flight &flight, const double v[3], const double spin[3]);
};

/* v, spin: what the mover would have without the walls. False: it has hit a face on its way, and
 * these are others. */
bool Resting::find(const Walls &walls, Flight &flight, const double v[3], const double spin[3],
                   Touch &stuck) {
  Mover &mover = flight.mover;
  held.clear();
  supports.clear();
  for (Stepper *wall : walls) {
    const AtWall of = mover.at(*wall);
    const std::vector<Rest> &rests = of.rests();
    const bool rough =
        !rests.empty() && wall->setup.model.wall() && asp_wall_surface(wall->setup.model.wall());
    for (size_t k = 0; k < rests.size(); k++) {
      Touch at;
      double distance, hold = 0;
      bool sticks;
      if (!look_under(flight, rests[k], *wall, v, spin, at, distance))
        continue;
      if (rough && meet_face(flight, at, hold, sticks)) {
        of.drop_rest(k);
        mover.members(*wall).ahead.expire(mover.i);
        if (sticks)
          stuck = at;
        return false;
      }
      const Contact &contact = at.contact;
      const double radius = mover.sphere[at.sphere].radius, off = radius - distance;
      held.push_back(at);
      supports.push_back(
          support_of(mover, *wall, at.shape, at.sphere, contact.n, contact.v_wall, hold));
      Support &support = supports.back();
      aspi_copy(rests[k].push, support.p);
      aspi_scale(flight.dt, support.p);
      const bool counts = off < OVERLAP * radius && fabs(off) > ROUNDED_OFF * radius;
      aspi_add_scaled(support.w,
                      0.5 * flight.dt * (contact.follow + contact.curve) +
                          (counts ? off / flight.dt : 0),
                      contact.n, support.w);
      if (!(off < OVERLAP * radius))
        mover.members(*wall).ahead.expire(mover.i);
    }
  }
  return true;
}

/* True if a mover leaves a face that does not press it. */
bool parts(const Flight &flight, const Touch &at, const Support &support, const double v[3],
           const double spin[3]) {
  double u[3];
  if (aspi_dot(support.p, support.n) > 0)
    return false;
  aspi_cross(spin, support.arm, u);
  aspi_add_scaled(u, 1, v, u);
  aspi_subtract(u, support.w, u);
  return aspi_dot(u, support.n) * flight.dt > PARTS * flight.mover.sphere[at.sphere].radius;
}

/* Notes and counts what has held the mover. */
void Resting::keep(const Walls &walls, const Flight &flight, const double v[3],
                   const double spin[3]) {
  const Mover &mover = flight.mover;
  for (Stepper *wall : walls) {
    const AtWall of = mover.at(*wall);
    std::vector<Rest> &rests = of.rests();
    const size_t were = rests.size();
    rests.clear();
    for (size_t k = 0; k < held.size(); k++) {
      const Support &support = supports[k];
      if (held[k].wall != wall || parts(flight, held[k], support, v, spin))
        continue;
      rests.push_back(Rest());
      Rest &rest = rests.back();
      rest.sphere = static_cast<double>(mover.sphere[held[k].sphere].tag);
      rest.shape = static_cast<double>(held[k].shape) + 1;
      rest.face = held[k].contact.face;
      aspi_copy(support.p, rest.push);
      twist_of(mover, support, rest.twist);
      aspi_scale(1 / flight.dt, rest.push);
      aspi_scale(1 / flight.dt, rest.twist);
      add_load(flight, held[k], support, v, spin);
    }
    if (rests.size() < were)
      mover.members(*wall).ahead.expire(mover.i);
    if (rests.empty())
      of.set_status(Status::FREE);
  }
}

bool Resting::hold(const Walls &walls, Flight &flight, const double alpha[3], Touch &stuck) {
  double before[3], turning[3], v[3], spin[3];
  stuck.wall = NULL;
  do {
    aspi_add_scaled(flight.begin, 0.5 * flight.dt, flight.free, before);
    aspi_add_scaled(flight.spin, 0.5 * flight.dt, alpha, turning);
  } while (!find(walls, flight, before, turning, stuck) && !stuck.wall);
  if (stuck.wall)
    return true;
  aspi_copy(before, v);
  aspi_copy(turning, spin);
  if (!supports.empty() && !solve_supports(flight.mover, supports, v, spin)) {
    held.clear(); /* walls that close: the next flight finds out */
    keep(walls, flight, v, spin);
    aspi_copy(v, flight.begin);
    return false;
  }
  keep(walls, flight, v, spin);
  aspi_subtract(v, before, v);
  aspi_subtract(spin, turning, spin);
  aspi_add_scaled(flight.begin, 0.5, v, flight.begin);
  aspi_add_scaled(flight.spin, 0.5, spin, flight.spin);
  return false;
}

} // namespace

/* ---- the energy of a rebound ------------------------------------------------------------------
 */

/* True if a change of velocity is not across n, to rounding. */
static bool changes_along(const double n[3], const double change[3]) {
  return fabs(aspi_dot(change, n)) > ACROSS * aspi_length(change);
}

/* Forces that change within a step do work before and after the rebound. Their value at the end of
 * the step is not known yet, so the energy of the normal motion is noted as a linear function of
 * it: v_n^2 = v_n2^2 + e^2 (v_n0^2 + 2 W_1 - v_n1^2) + 2 W_2 = SQUARE + WORK a_n(end), with W_1 and
 * W_2 the works by the trapezoidal rule before and after the contact, for the acceleration linear
 * in time, and e = v_n2/v_n1, not above 1; 0 for a particle that was staying at the wall. Of a wall
 * with one contact only, where the contacts with others leave the normal motion alone. */
void asperity::note_energy(const Flight &flight, const double x[3]) {
  const Mover &mover = flight.mover;
  if (!mover.is_ball || !(aspi_dot(flight.a0, flight.a0) > 0))
    return; /* in free flight velocities stay what they are, to the bit */
  if (flight.events.size() > NOTED_MOST)
    return;
  for (const Event &event : flight.events) {
    Stepper *wall = event.wall;
    const AtWall of = mover.at(*wall);
    const double *n = event.contact.n;
    bool others = of.status() == Status::RESTING || changes_along(n, flight.settled);
    for (const Event &other : flight.events) {
      double change[3];
      aspi_subtract(other.result.v2, other.v1, change);
      others = others || (&other != &event && (other.wall == wall || changes_along(n, change)));
    }
    if (others)
      continue;
    double relative[3], leg1[3], leg2[3];
    aspi_subtract(flight.v0, event.contact.v_wall, relative);
    aspi_subtract(event.contact.x, flight.x0, leg1);
    aspi_subtract(x, event.contact.x, leg2);
    const double share = event.elapsed / flight.dt, a0 = aspi_dot(flight.a0, n);
    const double d1 = aspi_dot(leg1, n) - aspi_dot(event.contact.v_wall, n) * event.elapsed;
    const double d2 =
        aspi_dot(leg2, n) - aspi_dot(event.contact.v_wall, n) * (flight.dt - event.elapsed);
    const double v0 = aspi_dot(relative, n), v1 = -aspi_dot(event.v1, n),
                 v2 = aspi_dot(event.result.v2, n);
    const double e = event.grazes ? 0 : std::min(1.0, v2 / v1);
    of.own().rebound.resize(1);
    Rebound &rebound = of.own().rebound[0];
    rebound.square =
        v2 * v2 + e * e * (v0 * v0 + (2 - share) * a0 * d1 - v1 * v1) + (1 - share) * a0 * d2;
    rebound.work = e * e * share * d1 + (1 + share) * d2;
    aspi_copy(n, rebound.normal);
    aspi_copy(event.contact.v_wall, rebound.v_wall);
    rebound.shape = static_cast<double>(event.shape);
    rebound.piece = event.contact.piece;
    of.set_status(Status::REBOUNDED);
    mover.members(*wall).touching.push_back(mover.i);
  }
}

/* The end of a step with a rebound: the normal velocity by its energy, where a acts. Without it,
 * particles that touch each other at a wall would gain or lose energy at each rebound, in steps
 * that resolve their contact well. */
static void balance(Stepper &wall, const Mover &mover, const double x[3], const double a[3],
                    double v[3]) {
  const Rebound &rebound = mover.at(wall).own().rebound[0];
  const double *n = rebound.normal;
  double v1[3];
  aspi_subtract(v, rebound.v_wall, v1);
  const double now = aspi_dot(v1, n);
  const double square = rebound.square + rebound.work * aspi_dot(a, n);
  const double speed = sqrt(std::max(0.0, square));
  const double change = (now < 0 ? -speed : speed) - now;
  const double p[3] = {change * n[0], change * n[1], change * n[2]};
  aspi_add_scaled(v, 1, p, v);
  wall.books.add_load(static_cast<size_t>(rebound.shape),
                      mover.load(0, static_cast<int>(rebound.piece), x, n, x, p, NULL));
}

/* ---- movers -----------------------------------------------------------------------------------
 */

static void balance(Stepper &wall, const Spheres &s, int i) {
  const size_t at = 3 * static_cast<size_t>(i);
  double a[3] = {0, 0, 0};
  aspi_add_scaled(a, 1 / s.mass[i], s.f + at, a);
  balance(wall, Mover(s, i), s.x + at, a, s.v + at);
}

static void balance(Stepper &wall, Bodies &bodies, int i) {
  Body &body = bodies.all[static_cast<size_t>(i)];
  balance(wall, Mover(bodies, static_cast<size_t>(i)), body.x, body.acceleration, body.v);
  body.is_changed = true;
}

/* Adds what walls give a mover to the forces that act on it. */
static void push_one(const Walls &walls, const Spheres &s, int i) {
  const size_t at = 3 * static_cast<size_t>(i);
  double push[3], twist[3];
  sum_pushes(walls, Mover(s, i), push, twist);
  aspi_add_scaled(s.f + at, s.mass[i], push, s.f + at);
  if (s.torque)
    aspi_add_scaled(s.torque + at, 0.4 * s.mass[i] * s.radius[i] * s.radius[i], twist,
                    s.torque + at);
}

static void push_one(const Walls &walls, Bodies &bodies, int i) {
  Body &body = bodies.all[static_cast<size_t>(i)];
  const Mover mover(bodies, static_cast<size_t>(i));
  double push[3], twist[3], torque[3];
  sum_pushes(walls, mover, push, twist);
  aspi_add_scaled(body.acceleration, 1, push, body.acceleration);
  mover.momentum_of(twist, torque);
  aspi_add_scaled(body.torque, mover.mass, torque, body.torque);
  body.is_changed = true;
}

/* A grain that rests at these walls. */
static void end_one(const Walls &walls, const Spheres &s, int i, Resting &resting) {
  Mover mover(s, i);
  Flight flight(mover, s, *walls[0]);
  Touch stuck;
  const size_t at = 3 * static_cast<size_t>(i);
  double alpha[3] = {0, 0, 0};
  flight.put_at_end(s.x + at);
  if (s.torque)
    aspi_add_scaled(alpha, 1 / (0.4 * s.mass[i] * s.radius[i] * s.radius[i]), s.torque + at, alpha);
  if (resting.hold(walls, flight, alpha, stuck))
    leave_stuck(flight, stuck, s);
  count_events(flight);
  if (stuck.wall)
    return;
  aspi_copy(flight.begin, s.v + at);
  if (s.omega)
    aspi_copy(flight.spin, s.omega + at);
  push_one(walls, s, i);
}

static void end_one(const Walls &walls, Bodies &bodies, int i, Resting &resting) {
  Body &body = bodies.all[static_cast<size_t>(i)];
  Mover mover(bodies, static_cast<size_t>(i));
  Flight flight(mover, bodies, *walls[0]);
  Touch stuck;
  double torque[3], alpha[3];
  flight.put_at_end(body.x);
  aspi_copy(body.torque, torque);
  aspi_scale(1 / mover.mass, torque);
  mover.spin_of(torque, alpha);
  const bool sticks = resting.hold(walls, flight, alpha, stuck);
  body.is_changed = true;
  count_events(flight);
  aspi_copy(flight.begin, body.v);
  mover.momentum_of(flight.spin, body.angular_momentum);
  aspi_scale(mover.mass, body.angular_momentum);
  if (sticks)
    leave_stuck(flight, stuck, bodies);
  else
    push_one(walls, bodies, i);
}

/* Calls act(walls, i) for each mover that rests and is not stuck, with the walls that hold it. */
template <class Kind, class Act> static void for_resting(const Walls &walls, Kind &kind, Act act) {
  std::vector<Near> all;
  Walls held_by;
  for (size_t w = 0; w < walls.size(); w++) {
    const Members &of = walls[w]->members(kind);
    for (int i : of.touching)
      if (of.rows.status(i) == Status::RESTING && !is_stuck(walls, kind, i))
        all.push_back(Near{i, static_cast<int>(w)});
  }
  if (!std::is_sorted(all.begin(), all.end()))
    std::sort(all.begin(), all.end());
  for (size_t k = 0; k < all.size();) {
    const int i = all[k].i;
    held_by.clear();
    for (; k < all.size() && all[k].i == i; k++)
      held_by.push_back(walls[all[k].wall]);
    act(held_by, i);
  }
}

template <class Kind> static void end_movers(const Walls &walls, Kind &kind) {
  Resting resting;
  for (Stepper *wall : walls) {
    Members &of = wall->members(kind);
    wall->hold_stuck(kind);
    for (int i : of.touching)
      if (of.rows.status(i) == Status::REBOUNDED)
        balance(*wall, kind, i);
  }
  for_resting(walls, kind,
              [&](const Walls &held_by, int i) { end_one(held_by, kind, i, resting); });
}

void asperity::push_again(const Walls &walls, const Spheres &s) {
  for_resting(walls, s, [&](const Walls &held_by, int i) { push_one(held_by, s, i); });
}

void asperity::push_again(const Walls &walls, Bodies &bodies) {
  for_resting(walls, bodies, [&](const Walls &held_by, int i) { push_one(held_by, bodies, i); });
}

void asperity::end_walls(const Walls &walls, const Spheres &s) {
  for (Stepper *wall : walls)
    wall->books.expire();
  end_movers(walls, s);
}

void asperity::end_bodies(const Walls &walls, Bodies &bodies) {
  for (Body &body : bodies.all)
    body.is_changed = false;
  end_movers(walls, bodies);
}
