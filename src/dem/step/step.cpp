/* The contacts of a particle in one step: impacts, by the wall's law, and sustained contacts, by
 * Moreau's rule (sustained.h).
 *
 * One criterion separates them, for every kind of wall. A contact is sustained if a particle that
 * rebounds at the speed of its approach would be pushed back to the wall within one step. With the
 * acceleration a of the particle and f of the wall (Contact::follow), that is
 *
 *   -(v - v_wall).n <= (f - a.n) dt/2
 *
 * f includes the curvature of the wall if the particle stayed there before and turns by less than
 * TURN in a step; a free particle meets a curved wall again on its straight path. A speed below
 * GRAZING is no approach.
 *
 * A sustained contact is no impact: it has no row and is not counted, but where it comes to the
 * next face of a rough wall (faces.cpp).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <algorithm>

#include "asperity_front.h"
#include "contact/contact.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

namespace {

/* The angle by which a wall's curve may turn a particle that stays at it in a step, rad. */
const double TURN = 0.1;

/* Contacts are in a row if they are within this share of the radius. After SERIES of them, as
 * between closing walls, all are taken as sustained. After twice as many the search ends for this
 * step; the particle is trapped if there were impacts among them. */
const int SERIES = 16;
const double NEAR = 0.01;

/* A face at which a particle stayed is met at the beginning of a step if it is within this many
 * radii. */
const double KNOWN = 1e-6;

/* An overlap of less than this many radii is rounding: particles in a settled bed have up to 1e-6.
 */
const double ROUNDED = 1e-5;

/* Contacts of one particle in one step, at most. */
const int CONTACTS_MOST = 10000;

/* How far a contact has moved the center out of the wall. */
double overlap(const Path &path, const Contact &contact) {
  double moved[3];
  aspi_subtract(contact.x, path.x, moved);
  aspi_add_scaled(moved, -contact.time, path.v, moved);
  return aspi_dot(moved, contact.n);
}

} // namespace

/* ---- the search -------------------------------------------------------------------------------
 */

/* The first contact of what is left of a path. An edge is met at one instant by all that share it:
 * the contact is that of the first wall and shape. NULL: there is none. */
static Stepper *find_first(const std::vector<Stepper *> &walls, const Flight &flight, size_t &shape,
                           Contact &contact) {
  Stepper *first = NULL;
  const double same = 2 * CONTACT_TOLERANCE * flight.radius;
  for (Stepper *wall : walls) {
    if (!(flight.spheres.mask[flight.i] & wall->setup.groupbit) ||
        (!flight.searches_all && !wall->ahead.is_near(flight.i)))
      continue;
    for (size_t m = 0; m < wall->setup.shapes.size(); m++) {
      Contact other;
      const double latest = first ? contact.time : flight.path.left;
      if (!wall->setup.shapes[m].shape->find(flight.path, flight.radius, latest, other))
        continue;
      if (first && !((contact.time - other.time) * other.closing > same))
        continue;
      first = wall;
      shape = m;
      contact = other;
    }
  }
  return first;
}

/* The faces at which the particle stayed in the step before. */
static void list_known(const std::vector<Stepper *> &walls, Flight &flight) {
  const int i = flight.i;
  for (Stepper *wall : walls) {
    if (wall->rows.status(i) != Status::RESTED || !(flight.spheres.mask[i] & wall->setup.groupbit))
      continue;
    const RestingPlace &at = wall->rows.place[i].resting;
    for (size_t k = 0; k < RestingPlace::FACES && at.shape[k] > 0; k++)
      flight.known.push_back(Flight::Known{wall, static_cast<size_t>(at.shape[k]) - 1,
                                           static_cast<int>(at.face[k]), false});
  }
}

/* Finds a known face where the particle still is: it is met at the beginning of the step, without a
 * search. */
static Stepper *find_known(Flight &flight, size_t &shape, Contact &contact) {
  for (Flight::Known &known : flight.known) {
    if (flight.searches_all || known.met)
      continue;
    const Shape &at = *known.wall->setup.shapes[known.shape].shape;
    if (!at.find_known(known.face, flight.path, flight.radius, contact))
      continue;
    if (contact.overlapped || contact.time * aspi_length(flight.path.v) > KNOWN * flight.radius) {
      known.wall->ahead.expire(flight.i);
      continue;
    }
    known.met = true;
    shape = known.shape;
    return known.wall;
  }
  return NULL;
}

/* True if a contact is one of the known faces again: the path is straight, and the wall may move.
 */
static bool is_met_again(const Flight &flight, const Stepper *wall, size_t shape,
                         const Contact &contact) {
  for (const Flight::Known &known : flight.known)
    if (known.met && known.wall == wall && known.shape == shape && known.face == contact.face)
      return true;
  return false;
}

/* From here on all walls are searched; what was known of the way ahead holds no more. */
static void search_all(const std::vector<Stepper *> &walls, Flight &flight) {
  if (flight.searches_all)
    return;
  flight.searches_all = true;
  for (Stepper *wall : walls)
    wall->ahead.expire(flight.i);
}

/* A prediction stays valid if the particle has met exactly the faces at which it stayed before. */
static void look_next(const std::vector<Stepper *> &near, const Flight &flight) {
  const int i = flight.i;
  for (Stepper *wall : near) {
    const RestingPlace &at = wall->rows.place[i].resting;
    const bool rests = wall->rows.status(i) == Status::RESTING;
    bool same = true;
    size_t k = 0;
    for (const Flight::Known &known : flight.known)
      if (known.wall == wall) {
        same = same && rests && k < RestingPlace::FACES &&
               static_cast<size_t>(at.shape[k]) == known.shape + 1 &&
               static_cast<int>(at.face[k]) == known.face;
        k++;
      }
    if (!same || (rests && k < RestingPlace::FACES && at.shape[k] > 0))
      wall->ahead.expire(i);
  }
}

/* ---- one contact ------------------------------------------------------------------------------
 */

Site::Site(Flight &of, Stepper &at, size_t number, Contact &met)
    : flight(of), wall(at), shape(number), before(of.path), contact(met), press(0), face(NULL),
      is_new(true), moved(false) {
  flight.advance(contact, v);
  contact.overlapped = contact.overlapped && overlap(before, contact) > ROUNDED * flight.radius;
  aspi_subtract(v, contact.v_wall, v1);
}

/* The particle as it is here. lay: room for the wall's lay. */
asp_particle Site::particle(double lay[3]) const {
  const Setup &setup = wall.setup;
  const Member &member = setup.shapes[shape];
  asp_particle particle = {};
  particle.d_p = 2 * flight.radius;
  particle.density = flight.mass / (ASP_PI / 6 * particle.d_p * particle.d_p * particle.d_p);
  particle.pair = setup.model.pair(flight.spheres.type[flight.i], member.wall_type);
  aspi_copy(flight.spin, particle.omega);
  lay[0] = lay[1] = 0;
  lay[2] = 1;
  if (setup.engine.dimension() == 2) /* at normal impact, too, the tilt is in the plane */
    particle.lay = lay;
  else if (setup.model.lay().kind != ASP_LAY_NONE) {
    member.shape->lay(setup.model.lay(), before, contact, lay);
    particle.lay = lay;
  }
  return particle;
}

/* An impact here that is to be counted, without its result. */
Event Site::event() const {
  const Spheres &s = flight.spheres;
  Event event = Event();
  event.wall = &wall;
  event.shape = shape;
  event.contact = contact;
  aspi_copy(v1, event.v1);
  aspi_copy(flight.spin, event.omega1);
  event.elapsed = flight.elapsed();
  event.time = wall.setup.time(static_cast<double>(s.step)) - flight.path.left;
  event.key.seed = wall.setup.model.seed();
  event.key.wall = wall.setup.key;
  event.key.tag = static_cast<uint64_t>(s.tag_of(flight.i));
  event.key.impact = static_cast<uint32_t>(wall.rows.state[flight.i].impacts) + 1;
  return event;
}

/* The criterion at the top of this file, f - a.n as `press`. arrives: the particle comes from
 * elsewhere. */
static bool is_sustained(Site &site, bool &arrives) {
  Flight &flight = site.flight;
  Contact &contact = site.contact;
  const double dt = flight.spheres.dt, approach = -aspi_dot(site.v1, contact.n);
  const double speed = aspi_length(site.v1);
  if (!(fabs(contact.curve) * dt < TURN * speed))
    contact.curve = 0;
  const bool again = flight.find_sustained(&site.wall, site.shape, contact);
  const bool stayed = again || site.wall.rows.status(flight.i) != Status::FREE;
  site.press = contact.follow - aspi_dot(flight.a0, contact.n) + (stayed ? contact.curve : 0);
  arrives = approach > 0 && !stayed;
  return again || !(approach > std::max((1 + ROUNDING) * 0.5 * dt * site.press, GRAZING * speed));
}

/* Applies the wall's law to a contact. */
static Event hit(const Site &site) {
  const asp_wall *wall = site.wall.setup.model.wall();
  if (!wall)
    throw Error(text("particle %lld came to be after the run began, and the wall's tables need the "
                     "diameters beforehand; make particles before 'run', or by a fix insert",
                     static_cast<long long>(site.flight.spheres.tag_of(site.flight.i))));
  double lay[3];
  const asp_particle particle = site.particle(lay);
  Event event = site.event();
  (site.is_new ? asp_wall_impact : asp_wall_impact_mean)(wall, &particle, site.v1, site.contact.n,
                                                         &event.key, &event.result);
  return event;
}

/* Moves the flight on to a contact, and gives it the velocity after it. True where the particle has
 * stuck. trapped: the contact is taken as sustained. */
static bool touch(Flight &flight, Stepper &wall, size_t shape, Contact &contact, bool trapped) {
  Site site(flight, wall, shape, contact);
  bool arrives;
  const bool stays = is_sustained(site, arrives) || trapped;
  site.find_face();
  const bool low = !stays && site.is_low(), sustained = stays || low;
  const double hold = trapped || (site.is_new && !sustained) ? 0 : site.hold(sustained);
  if (!sustained && hold > 0)
    site.stop_along();
  std::vector<Event> &events = flight.events;
  bool hits = !sustained;
  if (hits || (arrives && wall.setup.model.sticks())) {
    events.push_back(hit(site));
    hits = hits || events.back().result.outcome == ASP_DEPOSIT;
    if (!hits)
      events.pop_back();
  }
  if (!hits && (trapped || hold > 0 || !site.moved || !site.graze())) {
    if (low)
      site.lose_bounce();
    flight.sustain(&wall, shape, contact, hold);
    return false;
  }
  const asp_impact &result = events.back().result;
  wall.rows.state[flight.i].impacts++;
  flight.settle();
  if (result.outcome == ASP_DEPOSIT) {
    wall.stick(flight, shape, site.before, contact);
    return true;
  }
  double after[3];
  aspi_copy(result.omega, flight.spin);
  aspi_add_scaled(contact.v_wall, 1, result.v2, after);
  flight.turn(site.v, after, contact.n);
  return false;
}

/* ---- one particle, and all of them ------------------------------------------------------------
 */

/* The end of a flight. moved: contacts have changed the particle's path. */
static void finish(const std::vector<Stepper *> &near, Flight &flight, bool moved) {
  const Spheres &s = flight.spheres;
  const size_t at = 3 * static_cast<size_t>(flight.i);
  for (const Event &event : flight.events)
    event.wall->books.count(s, flight.i, event);
  if (!flight.searches_all)
    look_next(near, flight);
  if (!moved)
    return;
  aspi_copy(flight.half, s.v + at);
  if (s.omega)
    aspi_copy(flight.spin, s.omega + at);
  aspi_add_scaled(flight.path.x, flight.path.left, flight.path.v, s.x + at);
  note_energy(flight);
}

/* All contacts of one particle in this step. near: the walls that it may touch on its known way. */
static void fly(const std::vector<Stepper *> &walls, const std::vector<Stepper *> &near,
                const Spheres &s, int i) {
  static thread_local Flight::Lists lists;
  Flight flight(s, i, lists);
  Stepper *last = NULL;
  size_t shape = 0;
  Contact contact;
  bool stuck = false;
  int series = 0, all = 0;
  const double most = near[0]->ahead.bend() / s.dt;
  list_known(near, flight);
  while (!stuck && !flight.squeezed && series < 2 * SERIES && all < CONTACTS_MOST) {
    Stepper *const known = find_known(flight, shape, contact);
    Stepper *const wall =
        known ? known : find_first(flight.searches_all ? walls : near, flight, shape, contact);
    if (!wall)
      break;
    flight.is_apart = contact.time * aspi_length(flight.path.v) > NEAR * flight.radius;
    if (all == 0 || flight.is_apart) {
      series = 0;
      flight.series_begin = flight.events.size();
      aspi_copy(flight.spin, flight.series_spin);
    }
    series++;
    all++;
    last = wall;
    stuck = touch(flight, *wall, shape, contact, series > SERIES);
    if (!is_met_again(flight, wall, shape, contact) || flight.sustained.empty() ||
        flight.has_strayed(most))
      search_all(walls, flight);
  }
  const bool trapped = flight.squeezed || (!stuck && series == 2 * SERIES &&
                                           flight.events.size() > flight.series_begin);
  if (trapped) {
    last->books.count_guarded();
    search_all(walls, flight);
    flight.trap();
  }
  if (all == CONTACTS_MOST) {
    last->is_cut = true;
    flight.path.left = 0;
  }
  flight.settle();
  if (stuck || trapped)
    flight.give_rest(last, shape, contact, stuck ? s.v + 3 * static_cast<size_t>(i) : flight.half);
  finish(near, flight, all > 0 && !stuck);
}

Stepper::Stepper(const Setup &of, Books &its)
    : setup(of), books(its), rows(), ahead(of, rows), is_in_step(false), is_still(false),
      has_to_delete(false), is_cut(false) {}

void Stepper::begin_run(const Spheres &s, const std::vector<int> &shape_now) {
  double least, most;
  setup.engine.diameters(least, most);
  ahead.setup(least);
  for (int i = 0; i < s.n; i++)
    if (setup.model.deposit() == Model::OFF && rows.is_stuck(i))
      rows.set_status(i, Status::FREE); /* an earlier part of the run had deposits */
  if (!shape_now.empty())
    renumber(s, shape_now);
  ahead.clear();
  for (int i = 0; i < s.n; i++) {
    const size_t shape = static_cast<size_t>(rows.place[i].stuck.shape) - 1;
    if (rows.is_stuck(i) && shape < setup.shapes.size() &&
        setup.model.removes(s.type[i], setup.shapes[shape].wall_type, 2 * s.radius[i]))
      rows.set_status(i, Status::FREE); /* it had no such flow */
  }
  reorder(s);
}

void Stepper::reorder(const Spheres &s) {
  stuck.clear();
  touching.clear();
  has_to_delete = false;
  for (int i = 0; i < s.n; i++)
    if (rows.is_stuck(i)) {
      StuckPlace &at = rows.place[i].stuck;
      if (at.is_kept > 0 && is_in_step)
        aspi_scale(0.5, rows.state[i].force); /* the second half of the step is to come */
      at.is_kept = 0;
      stuck.push_back(StuckParticle{i, false, false, {}, {}, 0});
    } else if (rows.status(i) != Status::FREE)
      touching.push_back(i);
  ahead.reorder(s);
}

void Stepper::begin_step(const Spheres &s, int number, std::vector<Near> &near) {
  books.begin_step(s.step);
  const auto first = static_cast<std::ptrdiff_t>(near.size());
  for (int i : touching) {
    if (rows.status(i) == Status::RESTING) {
      rows.set_status(i, Status::RESTED);
      near.push_back(Near{i, number});
    } else if (!rows.is_stuck(i))
      rows.set_status(i, Status::FREE);
  }
  rested.swap(touching);
  touching.clear();
  const auto found = static_cast<std::ptrdiff_t>(near.size());
  carry_stuck(s);
  ahead.find_near(s, number, near);
  std::inplace_merge(near.begin() + first, near.begin() + found, near.end());
  std::inplace_merge(near.begin(), near.begin() + first, near.end());
}

/* Stuck particles move with their wall, then the few others that may touch a wall are searched. */
void asperity::step_walls(const std::vector<Stepper *> &walls, const Spheres &s) {
  static thread_local std::vector<Near> near;
  static thread_local std::vector<Stepper *> near_walls;
  near.clear();
  bool any_stuck = false;
  for (size_t w = 0; w < walls.size(); w++) {
    walls[w]->begin_step(s, static_cast<int>(w), near);
    any_stuck = any_stuck || !walls[w]->stuck.empty();
  }
  for (size_t k = 0; k < near.size();) {
    const int i = near[k].i;
    near_walls.clear();
    for (; k < near.size() && near[k].i == i; k++)
      if (near_walls.empty() || near_walls.back() != walls[near[k].wall])
        near_walls.push_back(walls[near[k].wall]);
    bool stuck = false;
    for (size_t w = 0; any_stuck && w < walls.size(); w++)
      stuck = stuck || walls[w]->rows.is_stuck(i);
    if (!stuck)
      fly(walls, near_walls, s, i);
  }
  for (Stepper *wall : walls)
    for (int i : wall->rested)
      if (wall->rows.status(i) == Status::RESTED)
        wall->rows.set_status(i, Status::FREE);
}
