/* The contacts of a particle in one step: impacts, by the wall's law, and sustained contacts, by
 * Moreau's rule (sustained.h).
 *
 * One criterion tells them apart, for every kind of wall: a contact is sustained if the particle,
 * thrown back at the speed of its approach, would return within a step by what its straight path
 * leaves out. With the acceleration a of the particle and f of the wall (Contact::follow), that is
 *
 *   -(v - v_wall).n <= (f - a.n) dt/2
 *
 * where the curve of the wall joins f if the particle stayed there before, and turns it by less
 * than TURN in a step; one that flies meets a curved wall again by its straight path. Less than
 * GRAZING is no approach.
 *
 * A sustained contact is no impact: it has no row and is not counted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/wall.h"

#include <math.h>
#include <algorithm>

#include "contact/contact.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/sustained.h"
#include "dem/text.h"

using namespace asperity;

namespace {

/* Sine of the angle to the wall below which a particle slides. */
const double GRAZING = 1e-6;

/* The angle by which a wall's curve may turn a particle that stays at it in a step, rad. */
const double TURN = 0.1;

/* Contacts in a row within this share of the radius. After SERIES of them, as between walls that
 * close, all are taken as sustained; after twice as many the search ends for this step, and the
 * particle is trapped if there were impacts among them. */
const int SERIES = 16;
const double NEAR = 0.01;

/* Contacts of one particle in one step, at most. */
const int CONTACTS_MOST = 10000;

/* A particle that has stayed at a wall is still there at the end of the step if its centre is
 * within this many radii. */
const double REACH = 1.01;

/* Two contacts are one where the cosine between their normals differs from 1 by less; on one face,
 * which may be curved, by less than TURNED. */
const double SAME = 1e-9, TURNED = 0.01;

/* Relative rounding of sums, and of velocities and times. */
const double ROUNDING = 1e-9;
const double EPSILON = 1e-12;

} // namespace

/* One particle on its way through a step. Its path is straight; along it the velocity changes by
 * what acts on the particle, from `begin`, so that a contact finds the velocity of its own instant.
 * `half` is what the engine's second half of the step has to begin with. */
struct Wall::Flight {
  /* A sustained contact as it began. The path needs the speed `keep` along `n`, which is the normal
   * where it met the wall last. */
  struct Stay {
    Wall *wall;
    size_t shape;
    Contact contact;
    double keep, n[3];

    /* Faces of a flat mesh count as one. */
    bool is_at(const Wall *other, size_t of, const Contact &now) const {
      return wall == other && shape == of &&
             vector_dot(n, now.n) > 1 - (contact.face == now.face ? TURNED : SAME);
    }
  };

  const Spheres &spheres;
  int i;
  double radius, mass;
  Path path;
  double begin[3], acceleration[3], half[3], spin[3];
  double x0[3], v0[3], a0[3]; /* at the beginning of the step */

  /* The impacts of the step; the sustained contacts of one place, and what the particle had before
   * them. Their memory is used again by the next particle. */
  struct Lists {
    std::vector<Event> events;
    std::vector<Stay> stays;
    std::vector<Support> supports, along;
  };
  std::vector<Event> &events;
  std::vector<Stay> &stays;
  std::vector<Support> &supports, &along;
  double free_half[3], free_spin[3];
  double given[3]; /* impulses per mass of those that are over */
  bool squeezed;   /* no velocity satisfies all of them */

  bool far; /* from the last contact */

  /* Contacts in a row: the first impact among them, and the spin before. */
  size_t series_begin;
  double series_spin[3];

  Flight(const Spheres &s, int particle, Lists &lists);
  asp_particle particle(const asp_pair *pair) const;
  void velocity(double time, double v[3]) const;
  void go_on(const double before[3], const double after[3], const double n[3]);
  Stay *find_stay(const Wall *wall, size_t shape, const Contact &contact);
  void stay(Wall *wall, size_t shape, const Contact &contact);
  void follow_walls();
  void settle();
  void give_rest(Wall *wall, size_t shape, const Contact &contact, const double end[3]) const;
  void trap();
  double elapsed() const {
    return spheres.dt - path.left;
  }
};

Wall::Flight::Flight(const Spheres &s, int particle, Lists &lists)
    : spheres(s), i(particle), radius(s.radius[i]), mass(s.mass[i]), events(lists.events),
      stays(lists.stays), supports(lists.supports), along(lists.along), given(), squeezed(false),
      far(false), series_begin(0) {
  events.clear();
  const double *x = s.x + 3 * static_cast<size_t>(i), *v = s.v + 3 * static_cast<size_t>(i);
  path.left = path.dt = s.dt;
  vector_copy(v, path.v);
  vector_copy(v, half);
  for (int d = 0; d < 3; d++)
    spin[d] = s.omega ? s.omega[3 * static_cast<size_t>(i) + d] : 0;
  vector_add_scaled(x, -s.dt, v, path.x);
  vector_copy(s.f + 3 * static_cast<size_t>(i), acceleration);
  vector_scale(1 / mass, acceleration);
  vector_copy(path.x, x0);
  vector_add_scaled(v, -0.5 * s.dt, acceleration, v0);
  vector_copy(v0, begin);
  vector_copy(acceleration, a0);
}

/* As it comes to a contact. */
asp_particle Wall::Flight::particle(const asp_pair *pair) const {
  const double d_p = 2 * radius;
  return asp_particle{
      d_p, mass / (ASP_PI / 6 * d_p * d_p * d_p), pair, {spin[0], spin[1], spin[2]}, NULL};
}

/* At a time since the beginning of the path. */
void Wall::Flight::velocity(double time, double v[3]) const {
  vector_add_scaled(begin, time, acceleration, v);
}

/* The path from where it has come to, by a contact that has changed the velocity there. Its mean
 * velocity differs from that at its beginning: along n by what acts for the rest of the step, and
 * across it by as much as before, so that a particle which loses nothing along the wall ends where
 * it would have without the wall. */
void Wall::Flight::go_on(const double before[3], const double after[3], const double n[3]) {
  double ahead[3];
  vector_subtract(path.v, before, ahead);
  vector_add_scaled(ahead, 0.5 * path.left * vector_dot(acceleration, n) - vector_dot(ahead, n), n,
                    ahead);
  vector_copy(after, begin);
  vector_add_scaled(after, 1, ahead, path.v);
}

/* ---- the contacts of a step -------------------------------------------------------------------
 */

/* What sticks goes with its wall; then, of the others, the few that may touch a wall. */
void Wall::step(const std::vector<Wall *> &walls, const Spheres &spheres) {
  std::vector<int> near;
  for (Wall *wall : walls) {
    std::fill(wall->counters_ + FORCE, wall->counters_ + TORQUE + 3, 0.0);
    for (int i : wall->touching_) /* those that touched it in the step before */
      if (wall->status(i) < FREE)
        wall->state(i)[STATE] = wall->is_at_rest(i) ? RESTED : FREE;
    wall->rested_.swap(wall->touching_);
    wall->touching_.clear();
    if (wall->ledger_)
      wall->ledger_->begin_step(spheres.step);
    wall->carry(spheres);
    wall->find_near(spheres, near);
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (int i : near) {
    bool stuck = false;
    for (const Wall *wall : walls)
      stuck = stuck || wall->state(i)[STATE] > FREE;
    if (!stuck)
      fly(walls, spheres, i);
  }
  for (Wall *wall : walls)
    for (int i : wall->rested_)
      if (wall->status(i) == RESTED)
        wall->state(i)[STATE] = FREE;
}

/* The first contact of what is left of a path. An edge is met at one instant by all that share it:
 * the contact is that of the first wall and shape. */
bool Wall::find_first(const std::vector<Wall *> &walls, const Flight &flight, Wall *&first,
                      size_t &shape, Contact &contact) {
  first = NULL;
  const double same = 2 * CONTACT_TOLERANCE * flight.radius;
  for (Wall *wall : walls) {
    if (!(flight.spheres.mask[flight.i] & wall->groupbit_))
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

/* All contacts of one particle in this step. */
void Wall::fly(const std::vector<Wall *> &walls, const Spheres &s, int i) {
  static thread_local Flight::Lists lists;
  Flight flight(s, i, lists);
  Path &path = flight.path;
  Wall *wall = NULL, *last = NULL;
  size_t shape;
  Contact contact;
  bool stuck = false;
  int series = 0, all = 0;
  while (!stuck && !flight.squeezed && series < 2 * SERIES && all < CONTACTS_MOST &&
         find_first(walls, flight, wall, shape, contact)) {
    flight.far = contact.time * vector_length(path.v) > NEAR * flight.radius;
    if (all == 0 || flight.far) {
      series = 0;
      flight.series_begin = flight.events.size();
      vector_copy(flight.spin, flight.series_spin);
    }
    series++;
    all++;
    last = wall;
    stuck = wall->touch(flight, shape, contact, series > SERIES);
  }
  const bool trapped =
      flight.squeezed || (series == 2 * SERIES && flight.events.size() > flight.series_begin);
  if (trapped) {
    last->counters_[N_GUARDED]++;
    flight.trap();
  }
  flight.settle();
  if (stuck || trapped)
    flight.give_rest(last, shape, contact, stuck ? s.v + 3 * static_cast<size_t>(i) : flight.half);
  if (all == CONTACTS_MOST)
    last->cut_ = true;
  for (const Event &event : flight.events)
    event.wall->count(s, i, event);
  for (Wall *each : walls)
    if (s.mask[i] & each->groupbit_)
      each->look_next(i);
  if (all == 0 || stuck)
    return;
  vector_copy(flight.half, s.v + 3 * static_cast<size_t>(i));
  if (s.omega)
    vector_copy(flight.spin, s.omega + 3 * static_cast<size_t>(i));
  vector_add_scaled(path.x, path.left, path.v, s.x + 3 * static_cast<size_t>(i));
  note_energy(flight);
}

/* One contact: moves the flight on to it, and gives it the velocity after it. True where the
 * particle has stuck. */
bool Wall::touch(Flight &flight, size_t shape, Contact contact, bool crowded) {
  const Spheres &s = flight.spheres;
  const int i = flight.i;
  const Path before = flight.path;
  double v[3], v1[3];
  flight.velocity(contact.time, v);
  vector_subtract(v, contact.v_wall, v1);
  vector_copy(contact.x, flight.path.x);
  flight.path.left = std::max(0.0, before.left - contact.time);
  vector_copy(v, flight.begin);

  const double approach = -vector_dot(v1, contact.n);
  const double speed = vector_length(v1);
  if (!(fabs(contact.curve) * s.dt < TURN * speed))
    contact.curve = 0;
  const bool stays = flight.find_stay(this, shape, contact), stayed = stays || status(i) != FREE;
  const double push =
      contact.follow - vector_dot(flight.a0, contact.n) + (stayed ? contact.curve : 0);
  const double least = std::max((1 + ROUNDING) * 0.5 * s.dt * push, GRAZING * speed);
  const bool sustained = crowded || stays || !(approach > least);
  const bool arrives = approach > 0 && !stayed;
  if (sustained && !(arrives && model_.sticks())) {
    flight.stay(this, shape, contact);
    return false;
  }
  if (!model_.wall())
    throw Error(text("particle %lld came to be after the run began, and the wall's tables need the "
                     "diameters beforehand; make particles before 'run', or by a fix insert",
                     static_cast<long long>(s.tag_of(i))));
  asp_particle particle = flight.particle(model_.pair(s.type[i], shapes_[shape].wall_type));
  double lay[3] = {0, 0, 1};
  if (engine_.dimension() == 2) /* at normal impact, too, the tilt is in the plane */
    particle.lay = lay;
  else if (model_.lay().kind != ASP_LAY_NONE) {
    shapes_[shape].shape->lay(model_.lay(), before, contact, lay);
    particle.lay = lay;
  }
  Event event = {this, shape, contact, {v1[0], v1[1], v1[2]}, {}, 0, 0, {}, {}};
  vector_copy(flight.spin, event.omega1);
  event.elapsed = flight.elapsed();
  event.time = time(static_cast<double>(s.step)) - flight.path.left;
  event.key.seed = model_.seed();
  event.key.wall = key_;
  event.key.tag = static_cast<uint64_t>(s.tag_of(i));
  event.key.impact = static_cast<uint32_t>(state(i)[IMPACTS]) + 1;
  asp_wall_impact(model_.wall(), &particle, v1, contact.n, &event.key, &event.impact);
  const bool sticks = event.impact.outcome == ASP_DEPOSIT;
  if (sustained && !sticks) {
    flight.stay(this, shape, contact);
    return false;
  }
  state(i)[IMPACTS]++;
  flight.events.push_back(event);
  flight.settle();
  if (sticks) {
    stick(flight, shape, before, contact);
    return true;
  }
  double after[3];
  vector_copy(event.impact.omega, flight.spin);
  vector_add_scaled(contact.v_wall, 1, event.impact.v2, after);
  for (int d = 0; d < 3; d++)
    flight.half[d] = after[d] + (flight.half[d] - v[d]);
  flight.go_on(v, after, contact.n);
  return false;
}

/* ---- sustained contact ------------------------------------------------------------------------
 */

Wall::Flight::Stay *Wall::Flight::find_stay(const Wall *wall, size_t shape,
                                            const Contact &contact) {
  for (Stay &stay : stays)
    if (stay.is_at(wall, shape, contact))
      return &stay;
  return NULL;
}

/* Adds a sustained contact to those of this place, and solves all of them. One that is there
 * already is met again because the path is straight, and only the path changes. */
void Wall::Flight::stay(Wall *wall, size_t shape, const Contact &contact) {
  const double speed = vector_length(path.v) + vector_length(contact.v_wall);
  const double keep = vector_dot(path.v, contact.n) +
                      (1 + ROUNDING) * std::max(0.0, contact.closing) + EPSILON * speed;
  if (Stay *stay = find_stay(wall, shape, contact)) {
    stay->keep = keep;
    vector_copy(contact.n, stay->n);
    follow_walls();
    return;
  }
  if (far)
    settle();
  if (stays.empty()) {
    vector_copy(half, free_half);
    vector_copy(spin, free_spin);
  }
  stays.push_back(Stay{wall, shape, contact, keep, {contact.n[0], contact.n[1], contact.n[2]}});
  supports.push_back(Support());
  Support &s = supports.back();
  vector_copy(contact.n, s.n);
  vector_add_scaled(contact.v_wall, 0.5 * path.left * contact.follow, contact.n, s.w);
  s.friction = wall->model_.friction(spheres.type[i], wall->shapes_[shape].wall_type);

  double before[3];
  vector_copy(half, before);
  vector_copy(free_half, half);
  vector_copy(free_spin, spin);
  squeezed = !solve_supports(supports, radius, half, spin) || squeezed;
  for (int d = 0; d < 3; d++)
    path.v[d] += half[d] - before[d];
  follow_walls();
}

/* The path keeps along the walls as the search has them, which is not exactly what velocities at an
 * instant say; and what pushes the particle against them does not speed it up. */
void Wall::Flight::follow_walls() {
  double none[3] = {0, 0, 0};
  vector_copy(a0, acceleration);
  along = supports;
  for (size_t k = 0; k < stays.size(); k++) {
    along[k].friction = 0;
    const Contact &contact = stays[k].contact;
    vector_copy(stays[k].n, along[k].n);
    vector_copy(stays[k].n, along[k].w);
    vector_scale(stays[k].keep, along[k].w);
    const double push = contact.follow + contact.curve - vector_dot(acceleration, contact.n);
    vector_add_scaled(acceleration, std::max(0.0, push), contact.n, acceleration);
  }
  solve_supports(along, radius, path.v, none);
  vector_add_scaled(half, elapsed() - 0.5 * spheres.dt, acceleration, begin);
}

/* The contacts of this place are over, or the step is: the walls take their impulses, and know of
 * the particle until the end of the step. */
void Wall::Flight::settle() {
  for (size_t k = 0; k < stays.size(); k++) {
    const Stay &stay = stays[k];
    const Support &s = supports[k];
    double u[3];
    vector_subtract(free_half, stay.contact.v_wall, u);
    ContactLoad load(spheres, i, stay.contact.piece, stay.contact.x, s.n, s.p, u);
    load.dissipated = mass * slide_work(s, radius, half, spin);
    stay.wall->add(stay.shape, load);
    vector_add_scaled(given, 1, s.p, given);
    stay.wall->keep_resting(i, stay.shape, stay.contact);
  }
  stays.clear();
  supports.clear();
}

/* What the contacts of a particle that has stuck or was trapped leave of the change from its
 * velocity at the beginning to the one at the end: what acts on it until it moves with its wall. */
void Wall::Flight::give_rest(Wall *wall, size_t shape, const Contact &contact,
                             const double end[3]) const {
  const double none[3] = {0, 0, 0};
  double rest[3];
  vector_subtract(end, v0, rest);
  vector_add_scaled(rest, -0.5 * spheres.dt, a0, rest);
  vector_subtract(rest, given, rest);
  for (const Event &event : events)
    for (int d = 0; d < 3; d++)
      rest[d] -= event.impact.v2[d] - event.v1[d];
  wall->add(shape, ContactLoad(spheres, i, contact.piece, contact.x, none, rest, none));
}

/* The walls leave no room: the particle goes with them, in their middle, and none of the impacts in
 * this place has happened. */
void Wall::Flight::trap() {
  const double share = 1.0 / static_cast<double>(stays.size());
  for (size_t k = series_begin; k < events.size(); k++)
    events[k].wall->state(i)[IMPACTS]--;
  events.resize(series_begin);
  vector_copy(series_spin, spin);
  for (int d = 0; d < 3; d++) {
    path.x[d] = path.v[d] = 0;
    for (const Stay &stay : stays) {
      path.x[d] += share * stay.contact.x[d];
      path.v[d] += share * stay.contact.v_wall[d];
    }
    half[d] = path.v[d];
  }
}

/* Notes a face at which a particle stays; of more than a row has room for, the last ones. */
void Wall::keep_resting(int i, size_t shape, const Contact &contact) {
  double *row = place(i);
  if (!is_at_rest(i)) {
    std::fill(row, row + N_PLACE, 0.0);
    state(i)[STATE] = RESTING;
    touching_.push_back(i);
  }
  int k = 0;
  while (
      k < FROM && row[k] > 0 &&
      !(static_cast<size_t>(row[k]) == shape + 1 && static_cast<int>(row[k + 1]) == contact.face))
    k += 2;
  if (k == FROM) {
    std::copy(row + 2, row + FROM, row);
    k = FROM - 2;
  }
  row[k] = static_cast<double>(shape) + 1;
  row[k + 1] = contact.face;
  for (int d = 0; d < 3; d++)
    row[FROM + d] = fabs(contact.curve) > 0 ? contact.n[d] : 0;
}

/* A curved wall only turns a velocity, from the normal that it had to n: gives back what the
 * projection takes of its tangential part. */
static void turn_along(const double from[3], const double n[3], const double v_wall[3],
                       double v[3]) {
  double across[3], u[3];
  const double cosine = vector_dot(from, n);
  vector_add_scaled(from, -cosine, n, across);
  const double sine = vector_length(across);
  if (!(cosine > 0 && sine > 0))
    return;
  vector_subtract(v, v_wall, u);
  vector_add_scaled(v, vector_dot(u, across) / (sine * sine) * (1 / cosine - 1), across, v);
}

/* The end of a step: what sticks has its wall's velocity; a particle that stays at walls loses what
 * the second half of the step has given it against them; one that has rebounded gets its energy. */
void Wall::hold(const std::vector<Wall *> &walls, const Spheres &s) {
  std::vector<int> resting;
  for (Wall *wall : walls) {
    for (int i : wall->stuck_) {
      double before[3];
      vector_copy(s.v + 3 * static_cast<size_t>(i), before);
      vector_copy(wall->place(i) + VELOCITY, s.v + 3 * static_cast<size_t>(i));
      wall->add_held(s, i, before);
      for (int d = 0; s.omega && d < 3; d++)
        s.omega[3 * static_cast<size_t>(i) + d] = 0;
    }
    for (int i : wall->touching_)
      if (wall->is_at_rest(i))
        resting.push_back(i);
      else if (wall->status(i) == REBOUNDED)
        wall->balance(s, i);
  }
  std::sort(resting.begin(), resting.end());
  resting.erase(std::unique(resting.begin(), resting.end()), resting.end());
  for (int i : resting)
    hold_resting(walls, s, i);
}

/* By the same rule as within the step, with the walls as they are at its end. */
void Wall::hold_resting(const std::vector<Wall *> &walls, const Spheres &s, int i) {
  struct At {
    Wall *wall;
    size_t shape;
    int face;
  };
  static thread_local std::vector<At> at;
  static thread_local std::vector<Support> supports;
  at.clear();
  supports.clear();
  double *v = s.v + 3 * static_cast<size_t>(i), spin[3] = {0, 0, 0}, before[3], turned[3];
  const double *x = s.x + 3 * static_cast<size_t>(i), *from = NULL;
  for (Wall *wall : walls) {
    const double *row = wall->place(i);
    if (wall->is_at_rest(i))
      from = row + FROM;
    for (int k = 0; wall->is_at_rest(i) && k < FROM && row[k] > 0; k += 2) {
      const At here = {wall, static_cast<size_t>(row[k]) - 1, static_cast<int>(row[k + 1])};
      const Member &member = wall->shapes_[here.shape];
      Support support;
      if (!member.shape->under(here.face, x, REACH * s.radius[i], support.n, support.w))
        continue;
      support.friction = wall->model_.friction(s.type[i], member.wall_type);
      at.push_back(here);
      supports.push_back(support);
    }
  }
  if (supports.empty())
    return;
  if (s.omega)
    vector_copy(s.omega + 3 * static_cast<size_t>(i), spin);
  vector_copy(v, before);
  if (supports.size() == 1)
    turn_along(from, supports[0].n, supports[0].w, v);
  vector_subtract(v, before, turned);
  solve_supports(supports, s.radius[i], v, spin);
  if (s.omega)
    vector_copy(spin, s.omega + 3 * static_cast<size_t>(i));
  for (size_t k = 0; k < at.size(); k++) {
    double u[3];
    vector_subtract(before, supports[k].w, u);
    const double slid = slide_work(supports[k], s.radius[i], v, spin);
    if (k == 0)
      vector_add_scaled(supports[0].p, 1, turned, supports[0].p);
    ContactLoad load(s, i, at[k].face < 0 ? ~at[k].face : at[k].face, x, supports[k].n,
                     supports[k].p, u);
    load.dissipated = s.mass[i] * slid;
    at[k].wall->add(at[k].shape, load);
  }
}

/* ---- impacts and what sticks -------------------------------------------------------------------
 */

/* A force that changes within a step, as that of another particle, does its work before and after a
 * rebound on two legs of the path. What it is at the end of the step is not known yet; so the
 * energy of the normal motion is noted as a linear function of it: v_n^2 = v_n2^2 + e^2 (v_n0^2 + 2
 * W_1 - v_n1^2) + 2 W_2 = SQUARE + WORK a_n(end), with W_1 and W_2 the works by the trapezoidal
 * rule before and after the contact, for the acceleration linear in time, and e = v_n2/v_n1, not
 * above 1. Of a wall with one contact only. */
void Wall::note_energy(const Flight &flight) {
  const Spheres &s = flight.spheres;
  const double *x = s.x + 3 * static_cast<size_t>(flight.i);
  if (!(vector_dot(flight.a0, flight.a0) > 0))
    return; /* in free flight velocities stay what they are, to the bit */
  for (const Event &event : flight.events) {
    Wall *wall = event.wall;
    int contacts = 0;
    for (const Event &other : flight.events)
      contacts += other.wall == wall;
    if (contacts > 1 || wall->is_at_rest(flight.i))
      continue;
    const double *n = event.contact.n;
    double relative[3], leg1[3], leg2[3];
    vector_subtract(flight.v0, event.contact.v_wall, relative);
    vector_subtract(event.contact.x, flight.x0, leg1);
    vector_subtract(x, event.contact.x, leg2);
    const double share = event.elapsed / s.dt, a0 = vector_dot(flight.a0, n);
    const double d1 = vector_dot(leg1, n) - vector_dot(event.contact.v_wall, n) * event.elapsed;
    const double d2 =
        vector_dot(leg2, n) - vector_dot(event.contact.v_wall, n) * (s.dt - event.elapsed);
    const double v0 = vector_dot(relative, n), v1 = -vector_dot(event.v1, n),
                 v2 = vector_dot(event.impact.v2, n);
    const double e = std::min(1.0, v2 / v1);
    double *row = wall->place(flight.i);
    row[SQUARE] =
        v2 * v2 + e * e * (v0 * v0 + (2 - share) * a0 * d1 - v1 * v1) + (1 - share) * a0 * d2;
    row[WORK] = e * e * share * d1 + (1 + share) * d2;
    vector_copy(n, row + NORMAL);
    vector_copy(event.contact.v_wall, row + VELOCITY);
    row[HIT] = static_cast<double>(event.shape);
    row[HIT + 1] = event.contact.piece;
    wall->state(flight.i)[STATE] = REBOUNDED;
    wall->touching_.push_back(flight.i);
  }
}

/* The end of a step with a rebound: the normal velocity by its energy. Without it, particles that
 * touch each other at a wall would gain or lose energy at each rebound, in steps that resolve their
 * contact well. */
void Wall::balance(const Spheres &s, int i) {
  const double *row = place(i), *n = row + NORMAL, *f = s.f + 3 * static_cast<size_t>(i);
  double *v = s.v + 3 * static_cast<size_t>(i), v1[3];
  vector_subtract(v, row + VELOCITY, v1);
  const double now = vector_dot(v1, n);
  const double square = row[SQUARE] + row[WORK] * vector_dot(f, n) / s.mass[i];
  const double speed = sqrt(std::max(0.0, square));
  const double change = (now < 0 ? -speed : speed) - now, none[3] = {0, 0, 0};
  double p[3] = {change * n[0], change * n[1], change * n[2]};
  vector_add_scaled(v, 1, p, v);
  add(static_cast<size_t>(row[HIT]), ContactLoad(s, i, static_cast<int>(row[HIT + 1]),
                                                 s.x + 3 * static_cast<size_t>(i), n, p, none));
}

/* Notes where the particle has stuck, and takes it along with the wall for the rest of the step. */
void Wall::stick(Flight &flight, size_t shape, const Path &before, const Contact &contact) {
  const int i = flight.i;
  Place at;
  shapes_[shape].shape->stick(before, contact, at);
  double *row = place(i);
  row[SHAPE] = static_cast<double>(shape) + 1;
  row[PIECE] = at.piece;
  vector_copy(at.at, row + AT);
  state(i)[STATE] = model_.deposit() == Model::DELETE ? DOOMED : FROZEN;
  has_doomed_ = has_doomed_ || model_.deposit() == Model::DELETE;
  stuck_.push_back(i);
  vector_copy(contact.x, flight.spheres.x + 3 * static_cast<size_t>(i));
  carry_one(flight.spheres, i, flight.path.left);
}
