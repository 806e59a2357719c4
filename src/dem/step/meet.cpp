/* The contacts of one instant: which are impacts, and which last.
 *
 * One criterion separates impacts from sustained contacts, for every kind of wall and of mover. A
 * contact is sustained if a mover that rebounds at the speed of its approach would be pushed back
 * to the wall within one step. With the acceleration a of the mover and f of the wall
 * (Contact::follow), that is
 *
 *   -(v - v_wall).n <= (f - a.n) dt/2
 *
 * For a mover already resting, f includes the curvature of a hollow wall (if it turns less than
 * CURVE per step). A free mover simply hits a curved wall again. A speed below GRAZING is no
 * approach.
 *
 * A sustained contact is no impact: it has no row and is not counted, but where it comes to the
 * next face of a rough wall (faces.cpp). At the end of the step it has become a rest: from then on
 * the walls hold the mover from one middle of a step to the next, in one solve (end_step.cpp), and
 * its path ends at them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <algorithm>

#include "asperity_engine.h"
#include "contact/vector.h"

using namespace asperity;

/* After so many contacts in a row that only slide, they change the path together. */
static const int ALONE = 2;

/* After so many they rise by more each time: the search knows their speed less well than it says.
 */
static const int ROUNDED = 4;

/* How far a contact has moved the center out of the wall. */
static double overlap(const Touch &touch) {
  double moved[3];
  aspi_subtract(touch.x, touch.before.x, moved);
  aspi_add_scaled(moved, -touch.time, touch.before.v, moved);
  return aspi_dot(moved, touch.n);
}

/* ---- one contact ---- */

/* The criterion at the top of this file, f - a.n as `press`; a point of a body falls faster to the
 * wall where others hold it, as its ends do at most. arrives: the sphere comes from elsewhere. */
static bool is_sustained(Flight &flight, ContactPoint &at, bool &arrives) {
  Contact &contact = at.touch;
  double u[3];
  at.sphere_velocity(u);
  const double dt = flight.dt, approach = -aspi_dot(u, contact.n), speed = aspi_length(u);
  if (!(fabs(contact.curve) * dt < CURVE * speed))
    contact.curve = contact.chord = 0;
  const bool again = flight.find_sustained(at.touch);
  const bool stayed = again || at.memory.status() != Status::FREE;
  at.press = contact.follow - aspi_dot(flight.free, contact.n) + (stayed ? contact.curve : 0);
  double falls = at.press;
  if (at.memory.status() == Status::RESTING) /* engines may leave out forces as a run begins */
    falls = std::max(falls, contact.follow - aspi_dot(at.memory.own().free, contact.n));
  if (!at.mover.is_ball) {
    double side[3], turns[3];
    aspi_cross(flight.spin, at.arm, side);
    aspi_cross(flight.spin, side, turns);
    double arm[3], most = 1;
    for (size_t k = 0; k < at.mover.count; k++) {
      at.mover.arm(k, arm);
      most = std::max(most, at.mover.response(arm, contact.n));
    }
    falls *= most;
    if (aspi_length(flight.spin) * dt < CURVE)
      falls += std::max(0.0, -aspi_dot(turns, contact.n));
  }
  arrives = approach > 0 && !stayed;
  const double least = (stayed ? ON_EDGES : GRAZING) * speed;
  return again || !(approach > std::max((1 + ROUNDING) * 0.5 * dt * falls, least));
}

/* Applies the wall's law to a contact, as the last impact of the flight. */
static const asp_impact &hit(Flight &flight, ContactPoint &at) {
  double lay[3];
  const asp_wall *law = at.law();
  const asp_particle particle = at.particle(lay);
  flight.impacts.push_back(at.impact());
  Impact &made = flight.impacts.back();
  (at.is_new ? asp_wall_impact : asp_wall_impact_mean)(law, &particle, at.v1, at.touch.n, &made.key,
                                                       &made.result);
  return made.result;
}

/* Gives the mover, which had the velocity v, what its last impact leaves it. True: it sticks. */
static bool take_impact(Flight &flight, const double v[3]) {
  const Impact &last = flight.impacts.back();
  if (last.result.outcome == ASP_DEPOSIT)
    return true;
  double after[3];
  flight.set_spin(last.result.omega);
  aspi_add_scaled(last.contact.v_wall, 1, last.result.v2, after);
  flight.turn(v, after, last.contact.n);
  return false;
}

/* ---- the contacts of one instant ---- */

/* The restitution of a sphere as if it hit alone, straight on. True if it sticks. */
static bool hit_alone(ContactPoint &at, const asp_key &key, double &restitution) {
  double lay[3], u[3], turned[3];
  const double approach = at.approach();
  asp_particle one = at.particle(lay);
  asp_impact result;
  std::fill(one.omega, one.omega + 3, 0.0);
  aspi_copy(at.touch.n, u);
  aspi_scale(-approach, u);
  asp_wall_impact_mean(at.law(), &one, u, at.touch.n, &key, &result);
  aspi_cross(result.omega, at.arm, turned);
  restitution = (aspi_dot(result.v2, at.touch.n) + aspi_dot(turned, at.touch.n)) / approach;
  return result.outcome == ASP_DEPOSIT;
}

/* Several spheres of a body hit smooth walls at one instant. Their restitution is that of the law
 * for the approach of each alone, on average; if one of them sticks, the body does: the number of
 * the sphere, else -1. */
static int hit_together(Flight &flight, std::vector<Touch> &touches, const double v[3]) {
  const Mover &mover = flight.mover;
  const Moment now = flight.moment(v);
  std::vector<Impact> hits;
  std::vector<Held> points;
  double e = 0, after[3], spin[3];
  for (size_t k = 0; k < touches.size(); k++) {
    ContactPoint at(mover, now, touches[k]);
    double restitution, nth = 1;
    for (const Impact &other : hits)
      nth += other.wall == touches[k].wall;
    hits.push_back(at.impact(nth));
    if (hit_alone(at, hits[k].key, restitution)) {
      flight.impacts.push_back(at.impact());
      asp_impact &result = flight.impacts.back().result;
      result.outcome = ASP_DEPOSIT;
      result.hits = 1;
      at.finish(flight.impacts.back());
      take_impact(flight, v);
      return static_cast<int>(touches[k].sphere);
    }
    e += restitution;
    points.push_back(Held());
    static_cast<Touch &>(points.back()) = touches[k];
    points.back().set(mover, 0);
  }
  const double share = 1.0 / static_cast<double>(touches.size());
  e = std::min(1.0, std::max(0.0, e * share));
  aspi_copy(v, after);
  aspi_copy(flight.spin, spin);
  solve_held(mover, points, after, spin);
  for (int d = 0; d < 3; d++) {
    after[d] += e * (after[d] - v[d]);
    spin[d] += e * (spin[d] - flight.spin[d]);
  }
  double n[3] = {0, 0, 0};
  for (size_t k = 0; k < touches.size(); k++) {
    const Touch &touch = touches[k];
    Impact &one = hits[k];
    aspi_subtract(after, touch.v_wall, one.result.v2);
    aspi_copy(spin, one.result.omega);
    one.result.hits = 1;
    aspi_scale(1 + e, points[k].p);
    one.load =
        mover.load(touch.sphere, touch.piece, touch.x, touch.n, flight.path.x, points[k].p, NULL);
    one.load.dissipated = share * mover.mass *
                          (mover.energy(one.v1, flight.spin) - mover.energy(one.result.v2, spin));
    flight.impacts.push_back(one);
    ++mover.at(*touch.wall).impacts();
    aspi_add_scaled(n, share, touch.n, n);
  }
  flight.set_spin(spin);
  flight.turn(v, after, n);
  return -1;
}

/* True if a sphere rests at the face that it touches, or at one in the plane of an edge ahead. */
static bool rests_there(const Flight &flight, const Touch &touch) {
  const BodySphere &one = flight.mover.sphere[touch.sphere];
  const WallMemory of = flight.mover.at(*touch.wall);
  if (of.rests_at(one.tag, touch.shape, touch.face) || !flight.mover.is_ball)
    return of.rests_at(one.tag, touch.shape, touch.face);
  for (const Rest &rest : of.rests()) {
    Contact end = Contact();
    double distance, tilt[3];
    if (static_cast<int64_t>(rest.sphere) != one.tag ||
        static_cast<size_t>(rest.shape) != touch.shape + 1 ||
        !touch.wall->setup.shapes[touch.shape].shape->under(
            static_cast<int>(rest.face), touch.x, touch.before.v, 2 * one.radius, end, distance))
      continue;
    aspi_subtract(end.n, touch.n_end, tilt);
    if (aspi_length(tilt) < ON_EDGES)
      return true;
  }
  return false;
}

/* A sphere whose path ends at a face at which it rests, but for rounding, only slides along it, and
 * so does one that does not approach its face, but for rounding of its own place: then the path
 * that is searched changes, and nothing else. Those that are met again in a row, as in a narrow
 * groove, change it together. */
static bool slides(Flight &flight, const Touch &touch, int nth) {
  const BodySphere &one = flight.mover.sphere[touch.sphere];
  const double approach = std::max(0.0, touch.approach_speed), left = flight.path.left;
  if (!flight.is_undisturbed || approach * left > OVERLAP * one.radius ||
      (fabs(touch.approach_speed) * left > SUM_ROUNDING * one.radius &&
       !rests_there(flight, touch)))
    return false;
  const double rounding = ldexp(SUM_ROUNDING, std::max(0, nth - ROUNDED));
  const double rises = (1 + ROUNDING) * approach + rounding * aspi_length(touch.before.v);
  if (nth > ALONE)
    flight.slide(touch, rises);
  else
    aspi_add_scaled(flight.path.v, rises, touch.n_end, flight.path.v);
  return true;
}

int asperity::meet(Flight &flight, std::vector<Touch> &touches, int nth, bool all_stay,
                   bool &slid) {
  const Mover &mover = flight.mover;
  double v[3];
  flight.advance(touches[0], v);
  slid = true;
  for (const Touch &touch : touches)
    slid = slides(flight, touch, nth) && slid;
  if (slid)
    return -1;
  const Moment now = flight.moment(v);
  std::vector<Touch> arriving;
  bool smooth = true;
  for (size_t k = 0; k < touches.size(); k++) {
    Touch &touch = touches[k];
    touch.overlapped =
        touch.overlapped && overlap(touch) > OVERLAP * mover.sphere[touch.sphere].radius;
    if (touches.size() == 1)
      break;
    if (!touch.overlapped) { /* it may be met a little later */
      mover.arm(touch.sphere, touch.x);
      aspi_add_scaled(touch.x, 1, flight.path.x, touch.x);
    }
    ContactPoint at(mover, now, touch);
    bool arrives;
    if (!all_stay && !is_sustained(flight, at, arrives)) {
      arriving.push_back(touch);
      smooth = smooth && !asp_wall_surface(at.law());
    }
  }
  if (arriving.size() > 1 && smooth) {
    /* Rounding, which says which of them is first, does not number their impacts. */
    std::sort(arriving.begin(), arriving.end(),
              [](const Touch &one, const Touch &other) { return one.sphere < other.sphere; });
    const int stuck = hit_together(flight, arriving, v);
    for (size_t k = 0; k < touches.size(); k++)
      if (static_cast<int>(touches[k].sphere) == stuck)
        return static_cast<int>(k);
    return -1;
  }
  std::vector<double> holds;
  for (Touch &touch : touches) {
    const int k = static_cast<int>(holds.size());
    ContactPoint at(mover, now, touch);
    bool arrives;
    const bool stays = is_sustained(flight, at, arrives) || all_stay;
    at.find_face(stays);
    const bool low = !stays && at.is_low(), sustained = stays || low;
    const double hold = all_stay || (at.is_new && !sustained) ? 0 : at.hold(sustained);
    if (!sustained && hold > 0)
      at.stop_along();
    if (!sustained || (arrives && touch.wall->setup.model.sticks())) {
      if (hit(flight, at).outcome == ASP_DEPOSIT || !sustained) {
        at.finish(flight.impacts.back());
        return take_impact(flight, v) ? k : -1;
      }
      flight.impacts.pop_back();
    }
    Impact grazing;
    if (!all_stay && !(hold > 0) && at.moved && at.graze(grazing)) {
      flight.impacts.push_back(grazing);
      return take_impact(flight, v) ? k : -1;
    }
    if (low)
      at.lose_bounce();
    holds.push_back(hold);
  }
  for (size_t k = 0; k < touches.size(); k++) {
    const Touch &touch = touches[k];
    if (touch.overlapped && overlap(touch) > DISPLACED * mover.sphere[touch.sphere].radius)
      touch.wall->books.count_guarded();
    flight.sustain(touch, holds[k]);
  }
  return -1;
}
