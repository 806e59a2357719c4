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
#include "dem/flight.h"

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

/* Computes all contacts of a step: stuck particles move with their wall, then the few others that
 * may touch a wall are searched. */
void Wall::step(const std::vector<Wall *> &walls, const Spheres &spheres) {
  static thread_local std::vector<Near> near;
  static thread_local std::vector<Wall *> near_walls;
  near.clear();
  bool any_stuck = false;
  for (size_t w = 0; w < walls.size(); w++) {
    walls[w]->begin_step(spheres, static_cast<int>(w), near);
    any_stuck = any_stuck || !walls[w]->stuck_.empty();
  }
  std::sort(near.begin(), near.end());
  for (size_t k = 0; k < near.size();) {
    const int i = near[k].i;
    near_walls.clear();
    for (; k < near.size() && near[k].i == i; k++)
      if (near_walls.empty() || near_walls.back() != walls[near[k].wall])
        near_walls.push_back(walls[near[k].wall]);
    bool stuck = false;
    for (size_t w = 0; any_stuck && w < walls.size(); w++)
      stuck = stuck || walls[w]->is_stuck(i);
    if (!stuck)
      fly(walls, near_walls, spheres, i);
  }
  for (Wall *wall : walls)
    for (int i : wall->rested_)
      if (wall->status(i) == Status::RESTED)
        wall->set_status(i, Status::FREE);
}

/* Prepares one wall for a step: resets the states of the last step, moves stuck particles, and
 * lists the particles that may touch it. */
void Wall::begin_step(const Spheres &spheres, int number, std::vector<Near> &near) {
  numbers_.clear();
  std::fill(counters_ + FORCE, counters_ + TORQUE + 3, 0.0);
  for (int i : touching_) {
    if (status(i) == Status::RESTING) {
      set_status(i, Status::RESTED);
      near.push_back(Near{i, number});
    } else if (!is_stuck(i))
      set_status(i, Status::FREE);
  }
  rested_.swap(touching_);
  touching_.clear();
  if (ledger_)
    ledger_->begin_step(spheres.step);
  carry(spheres);
  find_near(spheres, number, near);
}

/* ---- the search -------------------------------------------------------------------------------
 */

/* The first contact of what is left of a path. An edge is met at one instant by all that share it:
 * the contact is that of the first wall and shape. */
bool Wall::find_first(const std::vector<Wall *> &walls, const Flight &flight, Wall *&first,
                      size_t &shape, Contact &contact) {
  first = NULL;
  const double same = 2 * CONTACT_TOLERANCE * flight.radius;
  for (Wall *wall : walls) {
    if (!(flight.spheres.mask[flight.i] & wall->groupbit_) ||
        (!flight.searches_all && wall->ahead_.due[flight.i] > wall->ahead_.now))
      continue;
    for (size_t m = 0; m < wall->shapes_.size(); m++) {
      Contact other;
      const double latest = first ? contact.time : flight.path.left;
      if (!wall->shapes_[m].shape->find(flight.path, flight.radius, latest, other))
        continue;
      if (first && !((contact.time - other.time) * other.closing > same))
        continue;
      first = wall;
      shape = m;
      contact = other;
    }
  }
  return first != NULL;
}

/* The faces at which the particle stayed in the step before. */
void Wall::list_known(const std::vector<Wall *> &walls, Flight &flight) {
  const int i = flight.i;
  for (Wall *wall : walls) {
    if (wall->status(i) != Status::RESTED || !(flight.spheres.mask[i] & wall->groupbit_))
      continue;
    const RestingPlace &at = wall->place(i).resting;
    for (size_t k = 0; k < RestingPlace::FACES && at.shape[k] > 0; k++)
      flight.known.push_back(Flight::Known{wall, static_cast<size_t>(at.shape[k]) - 1,
                                           static_cast<int>(at.face[k]), false});
  }
}

/* One of these where the particle still is: it is met at the beginning of the step, without a
 * search. */
bool Wall::find_known(Flight &flight, Wall *&wall, size_t &shape, Contact &contact) {
  for (Flight::Known &known : flight.known) {
    if (flight.searches_all || known.met)
      continue;
    const Shape &at = *known.wall->shapes_[known.shape].shape;
    if (!at.find_known(known.face, flight.path, flight.radius, contact))
      continue;
    if (contact.overlapped || contact.time * aspi_length(flight.path.v) > KNOWN * flight.radius) {
      known.wall->ahead_.due[flight.i] = 0;
      continue;
    }
    known.met = true;
    wall = known.wall;
    shape = known.shape;
    return true;
  }
  return false;
}

/* From here on all walls are searched; what was known of the way ahead holds no more. */
void Wall::search_all(const std::vector<Wall *> &walls, Flight &flight) {
  if (flight.searches_all)
    return;
  flight.searches_all = true;
  for (Wall *wall : walls)
    wall->ahead_.due[flight.i] = 0;
}

/* A prediction stays valid if the particle has met exactly the faces at which it stayed before. */
void Wall::look_next(const std::vector<Wall *> &near, const Flight &flight) {
  const int i = flight.i;
  for (Wall *wall : near) {
    const RestingPlace &at = wall->place(i).resting;
    const bool rests = wall->is_at_rest(i);
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
      wall->ahead_.due[i] = 0;
  }
}

/* All contacts of one particle in this step. near: the walls that it may touch on its known way. */
void Wall::fly(const std::vector<Wall *> &walls, const std::vector<Wall *> &near, const Spheres &s,
               int i) {
  static thread_local Flight::Lists lists;
  Flight flight(s, i, lists);
  Wall *wall = NULL, *last = NULL;
  size_t shape;
  Contact contact;
  bool stuck = false;
  int series = 0, all = 0;
  const double most = near[0]->bend_ / s.dt;
  list_known(near, flight);
  while (!stuck && !flight.squeezed && series < 2 * SERIES && all < CONTACTS_MOST) {
    const bool known = find_known(flight, wall, shape, contact);
    if (!known && !find_first(flight.searches_all ? walls : near, flight, wall, shape, contact))
      break;
    flight.far = contact.time * aspi_length(flight.path.v) > NEAR * flight.radius;
    if (all == 0 || flight.far) {
      series = 0;
      flight.series_begin = flight.events.size();
      aspi_copy(flight.spin, flight.series_spin);
    }
    series++;
    all++;
    last = wall;
    stuck = wall->touch(flight, shape, contact, series > SERIES);
    if (!known || flight.stays.empty() || flight.has_strayed(most))
      search_all(walls, flight);
  }
  const bool trapped = flight.squeezed || (!stuck && series == 2 * SERIES &&
                                           flight.events.size() > flight.series_begin);
  if (trapped) {
    last->counters_[N_GUARDED]++;
    search_all(walls, flight);
    flight.trap();
  }
  if (all == CONTACTS_MOST) {
    last->cut_ = true;
    flight.path.left = 0;
  }
  flight.settle();
  if (stuck || trapped)
    flight.give_rest(last, shape, contact, stuck ? s.v + 3 * static_cast<size_t>(i) : flight.half);
  finish(near, flight, all > 0 && !stuck);
}

/* The end of a flight. moved: contacts have changed the particle's path. */
void Wall::finish(const std::vector<Wall *> &near, Flight &flight, bool moved) {
  const Spheres &s = flight.spheres;
  const size_t at = 3 * static_cast<size_t>(flight.i);
  for (const Event &event : flight.events)
    event.wall->count(s, flight.i, event);
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

/* ---- one contact ------------------------------------------------------------------------------
 */

/* Moves the flight on to a contact, and gives it the velocity after it. True where the particle has
 * stuck. trapped: the contact is taken as sustained. */
bool Wall::touch(Flight &flight, size_t shape, Contact &contact, bool trapped) {
  Site site = {shape, flight.path, contact, 0, NULL, true, false};
  double v[3], v1[3];
  flight.advance(contact, v);
  contact.overlapped =
      contact.overlapped && overlap(site.before, contact) > ROUNDED * flight.radius;
  aspi_subtract(v, contact.v_wall, v1);
  bool arrives;
  const bool stays = is_sustained(flight, shape, contact, v1, site.press, arrives) || trapped;
  find_face(flight, site);
  const bool low = !stays && is_low(flight, site, v1), sustained = stays || low;
  const double hold =
      trapped || (site.is_new && !sustained) ? 0 : hold_of(flight, site, v1, sustained);
  if (!sustained && hold > 0)
    stop_along(flight, site, v1);
  Event event = {};
  bool hits = !sustained;
  if (hits || (arrives && model_.sticks())) {
    event = hit(flight, site, v1);
    hits = hits || event.impact.outcome == ASP_DEPOSIT;
  }
  if (!hits && (trapped || hold > 0 || !site.moved || !graze(flight, site, v1, event))) {
    if (low)
      lose_bounce(flight, site, v1);
    flight.stay(this, shape, contact, hold);
    return false;
  }
  state(flight.i).impacts++;
  flight.events.push_back(event);
  flight.settle();
  if (event.impact.outcome == ASP_DEPOSIT) {
    stick(flight, shape, site.before, contact);
    return true;
  }
  double after[3];
  aspi_copy(event.impact.omega, flight.spin);
  aspi_add_scaled(contact.v_wall, 1, event.impact.v2, after);
  flight.turn(v, after, contact.n);
  return false;
}

/* The criterion at the top of this file, f - a.n as `press`. v1: relative to the wall. arrives: the
 * particle comes from elsewhere. */
bool Wall::is_sustained(Flight &flight, size_t shape, Contact &contact, const double v1[3],
                        double &press, bool &arrives) const {
  const double dt = flight.spheres.dt, approach = -aspi_dot(v1, contact.n);
  const double speed = aspi_length(v1);
  if (!(fabs(contact.curve) * dt < TURN * speed))
    contact.curve = 0;
  const bool stays = flight.find_stay(this, shape, contact);
  const bool stayed = stays || status(flight.i) != Status::FREE;
  press = contact.follow - aspi_dot(flight.a0, contact.n) + (stayed ? contact.curve : 0);
  arrives = approach > 0 && !stayed;
  return stays || !(approach > std::max((1 + ROUNDING) * 0.5 * dt * press, GRAZING * speed));
}

/* The particle at a contact. lay: room for the wall's lay there. */
asp_particle Wall::at_site(const Flight &flight, const Site &site, double lay[3]) const {
  asp_particle particle =
      flight.particle(model_.pair(flight.spheres.type[flight.i], shapes_[site.shape].wall_type));
  lay[0] = lay[1] = 0;
  lay[2] = 1;
  if (engine_.dimension() == 2) /* at normal impact, too, the tilt is in the plane */
    particle.lay = lay;
  else if (model_.lay().kind != ASP_LAY_NONE) {
    shapes_[site.shape].shape->lay(model_.lay(), site.before, site.contact, lay);
    particle.lay = lay;
  }
  return particle;
}

/* A contact that is to be counted. */
Wall::Event Wall::event_at(const Flight &flight, const Site &site, const double v1[3]) {
  const Spheres &s = flight.spheres;
  const int i = flight.i;
  Event event = {this, site.shape, site.contact, {v1[0], v1[1], v1[2]}, {}, 0, 0, false, {}, {}};
  aspi_copy(flight.spin, event.omega1);
  event.elapsed = flight.elapsed();
  event.time = time(static_cast<double>(s.step)) - flight.path.left;
  event.key.seed = model_.seed();
  event.key.wall = key_;
  event.key.tag = static_cast<uint64_t>(s.tag_of(i));
  event.key.impact = static_cast<uint32_t>(state(i).impacts) + 1;
  return event;
}

/* Applies the wall's law to a contact. */
Wall::Event Wall::hit(const Flight &flight, const Site &site, const double v1[3]) {
  if (!model_.wall())
    throw Error(text("particle %lld came to be after the run began, and the wall's tables need the "
                     "diameters beforehand; make particles before 'run', or by a fix insert",
                     static_cast<long long>(flight.spheres.tag_of(flight.i))));
  double lay[3];
  const asp_particle particle = at_site(flight, site, lay);
  Event event = event_at(flight, site, v1);
  (site.is_new ? asp_wall_impact : asp_wall_impact_mean)(model_.wall(), &particle, v1,
                                                         site.contact.n, &event.key, &event.impact);
  return event;
}
