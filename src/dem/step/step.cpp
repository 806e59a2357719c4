/* One step, and the contacts in it.
 *
 * The engine has moved each mover straight, with the velocity of the middle of the step (a drawing
 * is in the README of dem). A mover that can meet a wall is taken back to the beginning of the step
 * and flies through it: the first contact on its path is an impact, by the wall's law, or is
 * sustained, by Moreau's rule (supports.h); then it goes on with its new velocity, through any
 * number of contacts on any number of walls.
 *
 * One criterion separates impacts from sustained contacts, for every kind of wall and of mover. A
 * contact is sustained if a mover that rebounds at the speed of its approach would be pushed back
 * to the wall within one step. With the acceleration a of the mover and f of the wall
 * (Contact::follow), that is
 *
 *   -(v - v_wall).n <= (f - a.n) dt/2
 *
 * f includes the curvature of the wall if the mover rested there before and turns by less than
 * CURVE in a step; a free one meets a curved wall again on its straight path. A speed below GRAZING
 * is no approach.
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

namespace {

/* Contacts are in a row if they are NEAR each other. After SERIES of them for each sphere, as
 * between closing walls, all are taken as sustained. After twice as many the search ends for this
 * step; the mover is trapped if there were impacts among them. */
const int SERIES = 16;

/* Contacts of one mover in one step, at most. */
const int CONTACTS_MOST = 10000;

/* How far a contact has moved the center out of the wall. */
double overlap(const Path &path, const Contact &contact) {
  double moved[3];
  aspi_subtract(contact.x, path.x, moved);
  aspi_add_scaled(moved, -contact.time, path.v, moved);
  return aspi_dot(moved, contact.n);
}

typedef std::vector<Stepper *> Walls;

} // namespace

/* From here on all walls are searched; predictions are void. */
static void search_all(const Walls &walls, Flight &flight) {
  if (flight.searches_all)
    return;
  flight.searches_all = true;
  for (Stepper *wall : walls)
    flight.mover.members(*wall).ahead.expire(flight.mover.i);
}

/* ---- one contact ------------------------------------------------------------------------------
 */

/* The criterion at the top of this file, f - a.n as `press`; a point of a body falls faster to the
 * wall where others hold it, as its ends do at most. arrives: the sphere comes from elsewhere. */
static bool is_sustained(Site &site, bool &arrives) {
  Flight &flight = site.flight;
  Contact &contact = site.contact;
  double u[3];
  site.sphere_velocity(u);
  const double dt = flight.dt, approach = -aspi_dot(u, contact.n), speed = aspi_length(u);
  if (!(fabs(contact.curve) * dt < CURVE * speed))
    contact.curve = contact.chord = 0;
  const bool again = flight.find_sustained(site.touch);
  const bool stayed = again || site.memory.status() != Status::FREE;
  site.press = contact.follow - aspi_dot(flight.free, contact.n) + (stayed ? contact.curve : 0);
  double falls = site.press;
  if (!site.mover.is_ball) {
    double side[3], turns[3];
    aspi_cross(flight.spin, site.arm, side);
    aspi_cross(flight.spin, side, turns);
    double arm[3], most = 1;
    for (size_t k = 0; k < site.mover.count; k++) {
      site.mover.arm(k, arm);
      most = std::max(most, site.mover.response(arm, contact.n));
    }
    falls *= most;
    if (aspi_length(flight.spin) * dt < CURVE)
      falls += std::max(0.0, -aspi_dot(turns, contact.n));
  }
  arrives = approach > 0 && !stayed;
  const double least = (stayed ? ON_EDGES : GRAZING) * speed;
  return again || !(approach > std::max((1 + ROUNDING) * 0.5 * dt * falls, least));
}

/* Applies the wall's law to a contact; the event is the last one then. */
static const asp_impact &hit(Site &site) {
  double lay[3];
  const asp_wall *law = site.law();
  const asp_particle particle = site.particle(lay);
  Event event = site.event();
  (site.is_new ? asp_wall_impact : asp_wall_impact_mean)(law, &particle, site.v1, site.contact.n,
                                                         &event.key, &event.result);
  site.flight.events.push_back(event);
  return site.flight.events.back().result;
}

/* The mover has this velocity before the last event, and what that leaves it afterwards. */
bool asperity::take_impact(const Site &site, const double v[3]) {
  Flight &flight = site.flight;
  const asp_impact &result = flight.events.back().result;
  site.finish(flight.events.back());
  ++site.memory.impacts();
  flight.settle();
  if (result.outcome == ASP_DEPOSIT)
    return true;
  double after[3];
  flight.set_spin(result.omega);
  aspi_add_scaled(site.contact.v_wall, 1, result.v2, after);
  flight.turn(v, after, site.contact.n);
  return false;
}

/* ---- the contacts of one instant --------------------------------------------------------------
 */

/* The restitution of a sphere as if it hit alone, straight on. True if it sticks. */
static bool hit_alone(Site &site, const Event &event, double &restitution) {
  double lay[3], u[3], turned[3];
  const double approach = site.approach();
  asp_particle one = site.particle(lay);
  asp_impact result;
  std::fill(one.omega, one.omega + 3, 0.0);
  aspi_copy(site.contact.n, u);
  aspi_scale(-approach, u);
  asp_wall_impact_mean(site.law(), &one, u, site.contact.n, &event.key, &result);
  aspi_cross(result.omega, site.arm, turned);
  restitution = (aspi_dot(result.v2, site.contact.n) + aspi_dot(turned, site.contact.n)) / approach;
  return result.outcome == ASP_DEPOSIT;
}

/* Several spheres of a body hit smooth walls at one instant. Their restitution is that of the law
 * for the approach of each alone, on average; if one of them sticks, the body does: its number,
 * else -1. */
static int hit_together(Flight &flight, std::vector<Touch> &touches, const double v[3]) {
  std::vector<Event> events;
  std::vector<Support> points;
  double e = 0, after[3], spin[3];
  for (size_t k = 0; k < touches.size(); k++) {
    Site site(flight, touches[k], v);
    double restitution, before = 1;
    for (const Event &other : events)
      before += other.wall == touches[k].wall;
    events.push_back(site.event(before));
    if (hit_alone(site, events[k], restitution)) {
      Event event = site.event();
      event.result.outcome = ASP_DEPOSIT;
      event.result.hits = 1;
      std::fill(event.result.omega, event.result.omega + 3, 0.0);
      flight.events.push_back(event);
      take_impact(site, v);
      return static_cast<int>(k);
    }
    e += restitution;
    points.push_back(Support());
    set_support(flight.mover, *touches[k].wall, touches[k].shape, touches[k].sphere,
                touches[k].contact.n, touches[k].contact.v_wall, 0, points.back());
  }
  e = std::min(1.0, std::max(0.0, e / static_cast<double>(touches.size())));
  aspi_copy(v, after);
  aspi_copy(flight.spin, spin);
  flight.settle();
  solve_supports(flight.mover, points, after, spin);
  const Mover &mover = flight.mover;
  for (int d = 0; d < 3; d++) {
    after[d] += e * (after[d] - v[d]);
    spin[d] += e * (spin[d] - flight.spin[d]);
  }
  double n[3] = {0, 0, 0};
  const double share = 1.0 / static_cast<double>(touches.size());
  for (size_t k = 0; k < touches.size(); k++) {
    Site site(flight, touches[k], v);
    Event &event = events[k];
    aspi_subtract(after, touches[k].contact.v_wall, event.result.v2);
    aspi_copy(spin, event.result.omega);
    event.result.hits = 1;
    aspi_scale(1 + e, points[k].p);
    event.load = mover.load(touches[k].sphere, touches[k].contact.piece, touches[k].contact.x,
                            touches[k].contact.n, flight.path.x, points[k].p, NULL);
    event.load.dissipated =
        share * mover.mass *
        (mover.energy(event.v1, flight.spin) - mover.energy(event.result.v2, spin));
    flight.events.push_back(event);
    ++site.memory.impacts();
    aspi_add_scaled(n, share, touches[k].contact.n, n);
  }
  flight.set_spin(spin);
  flight.turn(v, after, n);
  return -1;
}

/* True if a sphere rests at the face that it touches, or at one in the plane of an edge ahead. */
static bool rests_there(const Flight &flight, const Touch &touch) {
  const Contact &contact = touch.contact;
  const BodySphere &one = flight.mover.sphere[touch.sphere];
  const AtWall of = flight.mover.at(*touch.wall);
  if (of.rests_at(one.tag, touch.shape, contact.face) || !flight.mover.is_ball)
    return of.rests_at(one.tag, touch.shape, contact.face);
  for (const Rest &rest : of.rests()) {
    Contact end = Contact();
    double distance, tilt[3];
    if (static_cast<int64_t>(rest.sphere) != one.tag ||
        static_cast<size_t>(rest.shape) != touch.shape + 1 ||
        !touch.wall->setup.shapes[touch.shape].shape->under(
            static_cast<int>(rest.face), contact.x, touch.before.v, 2 * one.radius, end, distance))
      continue;
    aspi_subtract(end.n, contact.n_end, tilt);
    if (aspi_length(tilt) < ON_EDGES)
      return true;
  }
  return false;
}

/* A sphere whose path ends at a face at which it rests, but for rounding, only slides along it, and
 * so does one that does not approach its face, but for rounding of its own place: then the path
 * that is searched changes, and nothing else. */
static bool slides(Flight &flight, const Touch &touch) {
  const Contact &contact = touch.contact;
  const BodySphere &one = flight.mover.sphere[touch.sphere];
  const double closing = std::max(0.0, contact.closing), deep = closing * flight.path.left;
  if (!flight.is_led || deep > OVERLAP * one.radius ||
      (deep > SUM_ROUNDING * one.radius && !rests_there(flight, touch)))
    return false;
  aspi_add_scaled(flight.path.v,
                  (1 + ROUNDING) * closing + SUM_ROUNDING * aspi_length(touch.before.v),
                  contact.n_end, flight.path.v);
  return true;
}

/* The contacts of one instant: an impact, several at smooth walls, or all of them are sustained.
 * The number of the one by which the mover has stuck, else -1. all_stay: it is in a long series.
 * slid: no contact has done more than to slide. */
static int meet(Flight &flight, std::vector<Touch> &touches, bool all_stay, bool &slid) {
  double v[3];
  flight.advance(touches[0], v);
  slid = true;
  for (const Touch &touch : touches)
    slid = slides(flight, touch) && slid;
  if (slid)
    return -1;
  std::vector<Touch> arriving;
  std::vector<size_t> number;
  bool smooth = true;
  for (size_t k = 0; k < touches.size(); k++) {
    Touch &touch = touches[k];
    touch.contact.overlapped =
        touch.contact.overlapped &&
        overlap(touch.before, touch.contact) > OVERLAP * flight.mover.sphere[touch.sphere].radius;
    if (touches.size() == 1)
      break;
    Site site(flight, touch, v);
    bool arrives;
    if (!all_stay && !is_sustained(site, arrives)) {
      arriving.push_back(touch);
      number.push_back(k);
      smooth = smooth && !asp_wall_surface(site.law());
    }
  }
  if (arriving.size() > 1 && smooth) {
    const int stuck = hit_together(flight, arriving, v);
    return stuck < 0 ? -1 : static_cast<int>(number[static_cast<size_t>(stuck)]);
  }
  std::vector<double> holds;
  for (Touch &touch : touches) {
    const int k = static_cast<int>(holds.size());
    Site site(flight, touch, v);
    bool arrives;
    const bool stays = is_sustained(site, arrives) || all_stay;
    site.find_face(stays);
    const bool low = !stays && site.is_low(), sustained = stays || low;
    const double hold = all_stay || (site.is_new && !sustained) ? 0 : site.hold(sustained);
    if (!sustained && hold > 0)
      site.stop_along();
    if (!sustained || (arrives && touch.wall->setup.model.sticks())) {
      if (hit(site).outcome == ASP_DEPOSIT || !sustained)
        return take_impact(site, v) ? k : -1;
      flight.events.pop_back();
    }
    if (!all_stay && !(hold > 0) && site.moved && site.graze())
      return take_impact(site, v) ? k : -1;
    if (low)
      site.lose_bounce();
    holds.push_back(hold);
  }
  for (size_t k = 0; k < touches.size(); k++) {
    const Touch &touch = touches[k];
    if (touch.contact.overlapped &&
        overlap(touch.before, touch.contact) > DISPLACED * flight.mover.sphere[touch.sphere].radius)
      touch.wall->books.count_guarded();
    flight.sustain(touch, holds[k]);
  }
  return -1;
}

/* ---- one mover, and all of them ---------------------------------------------------------------
 */

/* All contacts of one mover in this step. near: the walls that it may touch on its known way. True
 * if any of them changes its way, which sliding along walls where it rests does not; stuck: where
 * it has stuck. */
static bool fly(const Walls &walls, const Walls &near, Flight &flight, double most, Touch &stuck) {
  const Mover &mover = flight.mover;
  const int series_most = SERIES * static_cast<int>(mover.count);
  const double known_way[3] = {flight.path.v[0], flight.path.v[1], flight.path.v[2]};
  std::vector<Touch> touches;
  Touch last;
  bool only_slid = true;
  int series = 0, all = 0, by = -1;
  stuck.wall = NULL;
  for (Stepper *wall : walls)
    for (const Rest &rest : mover.at(*wall).rests())
      aspi_add_scaled(flight.free, -1, rest.push, flight.free);
  while (by < 0 && !flight.squeezed && series < 2 * series_most && all < CONTACTS_MOST &&
         find_next(flight.searches_all ? walls : near, flight, touches)) {
    flight.way += touches[0].contact.time * aspi_length(touches[0].before.v) / mover.sphere->radius;
    flight.is_apart = flight.way > NEAR;
    flight.way = 0;
    if (all == 0 || flight.is_apart) {
      series = 0;
      flight.series_begin = flight.events.size();
      aspi_copy(flight.spin, flight.series_spin);
    }
    series++;
    all++;
    last = touches[0];
    bool slid;
    by = meet(flight, touches, series > series_most, slid);
    only_slid = only_slid && slid;
    if (!slid || flight.has_strayed(known_way, most))
      search_all(walls, flight);
  }
  bool stands = mover.is_ball; /* a body on walls that move takes the path that was searched */
  if (!stands)
    stands =
        std::all_of(walls.begin(), walls.end(), [](const Stepper *wall) { return wall->is_still; });
  if (only_slid && (stands || all == 0) && series < 2 * series_most)
    return false;
  const bool endless = by < 0 && series == 2 * series_most;
  if (flight.squeezed || (endless && mover.is_ball && flight.events.size() > flight.series_begin)) {
    last.wall->books.count_guarded();
    search_all(walls, flight);
    flight.trap();
    flight.settle();
    flight.give_rest(last, flight.half);
  } else if (endless && !mover.is_ball)
    flight.path.left = 0; /* it waits here for the next step */
  if (all == CONTACTS_MOST) {
    last.wall->is_cut = true;
    flight.path.left = 0;
  }
  flight.settle();
  if (by >= 0)
    stuck = touches[static_cast<size_t>(by)];
  return true;
}

void asperity::count_events(const Flight &flight) {
  for (const Event &event : flight.events)
    event.wall->books.count(event);
}

void asperity::leave_stuck(const Flight &flight, const Touch &touch, const Movers &movers) {
  double v[3]; /* what the impact has left it */
  aspi_subtract(flight.half, flight.begin, v);
  aspi_add_scaled(v, 1, touch.contact.v_wall, v);
  movers.place(flight.mover, flight.path.x);
  movers.write(flight.mover, v, flight.events.back().result.omega);
  stick(touch, flight.mover, movers, flight.path.left);
}

/* True if a grain's path meets one of these walls: those of most that are near do not. */
static bool meets(const Walls &near, const Spheres &s, int i) {
  const size_t at = 3 * static_cast<size_t>(i);
  Path path;
  Contact contact;
  path.left = path.dt = s.dt;
  path.rest = 0;
  aspi_copy(s.v + at, path.v);
  aspi_add_scaled(s.x + at, -s.dt, path.v, path.x);
  for (const Stepper *wall : near)
    for (const Member &member : wall->setup.shapes)
      if (member.shape->find(path, s.radius[i], s.dt, contact))
        return true;
  return false;
}

/* Where the engine's turn of a body differs from the one that was searched, the body takes that. */
static void take_turn(Flight &flight, const Movers &movers) {
  const Mover &mover = flight.mover;
  const Body &body = *mover.body;
  double off = 0;
  flight.go_on(flight.path.left);
  for (size_t k = 0; k < mover.count; k++) {
    double searched[3], arm[3];
    mover.arm(k, searched);
    arm_of(body, mover.sphere[k], arm);
    aspi_subtract(searched, arm, arm);
    off = std::max(off, aspi_length(arm));
  }
  if (off > OVERLAP * mover.sphere->radius)
    movers.place(mover, body.x);
}

/* All contacts of a mover. */
static void fly_one(const Walls &walls, const Walls &near, const Movers &movers, int i) {
  const Spheres *grains = movers.grains;
  if (grains ? !meets(near, *grains, i) : movers.bodies->all[static_cast<size_t>(i)].is_led)
    return;
  Mover mover(movers, i);
  Instant now;
  movers.read(mover, now);
  movers.read_rates(mover, now);
  Flight flight(mover, movers, now, *walls[0]);
  Touch stuck;
  const double most = grains ? Ahead::bend(grains->radius[i]) / movers.dt : 0;
  if (!fly(walls, grains ? near : walls, flight, most, stuck)) {
    if (!mover.is_ball)
      take_turn(flight, movers);
    return;
  }
  count_events(flight);
  if (stuck.wall) {
    leave_stuck(flight, stuck, movers);
    return;
  }
  if (flight.path.left > 0)
    flight.leap(flight.path.left);
  movers.place(mover, flight.path.x);
  movers.write(mover, flight.half, flight.spin);
  note_energy(flight);
}

/* Stuck movers go with their wall, then the few others that may touch a wall are searched. */
static void step_movers(const Walls &walls, const Movers &movers) {
  std::vector<Near> near;
  Walls near_walls;
  const Spheres all = movers.bounds();
  for (size_t w = 0; w < walls.size(); w++) {
    Members &of = movers.members(*walls[w]);
    const auto first = static_cast<std::ptrdiff_t>(near.size());
    of.begin_step();
    walls[w]->let_go(movers);
    walls[w]->carry_stuck(movers);
    of.ahead.find_near(all, static_cast<int>(w), near);
    std::inplace_merge(near.begin(), near.begin() + first, near.end());
  }
  for (size_t k = 0; k < near.size();) {
    const int i = near[k].i;
    near_walls.clear();
    for (; k < near.size() && near[k].i == i; k++)
      if (near_walls.empty() || near_walls.back() != walls[near[k].wall])
        near_walls.push_back(walls[near[k].wall]);
    if (!movers.is_stuck(walls, i))
      fly_one(walls, near_walls, movers, i);
  }
}

void asperity::step_walls(const Walls &walls, const Spheres &spheres, Bodies *bodies) {
  for (Stepper *wall : walls)
    wall->books.begin_step(spheres.step);
  step_movers(walls, spheres);
  if (!bodies)
    return;
  step_movers(walls, *bodies);
  for (size_t b = 0; b < bodies->all.size(); b++)
    walls[0]->body_rows.set_attitude(static_cast<int>(b), bodies->step + 1, bodies->all[b].axes);
  bodies->begins = false;
}
