/* A rough wall in a simulation; see wall.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/wall.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <algorithm>
#include <new>

#include "contact/contact.h"
#include "contact/vector.h"
#include "wall/error.h"
#include "wall/text.h"

using namespace asperity;

const char Wall::KEYWORDS[] = "ledger";

namespace {

const double DEGREES = 180 / ASP_PI;

/* A particle is caught that has this many contacts one after the other with less than this share of
 * its radius between them. */
const int CROWD = 16;
const double CROWDED = 0.01;

/* What a sum of rounded numbers may be off where it is compared with another one. */
const double ROUNDING = 1e-9;

/* Ahead::due of a particle that is stuck, or not of the group: never near; and of one that rested
 * in the last step: near without another look. */
const int NEVER = INT_MAX, AT_REST = -1;

/* The sums of so many pieces are told at once. */
const size_t SHOWN = 32768;

/* Whether any of so many particles must be looked at is found out without looking at each. */
const int BLOCK = 32;

/* A look ahead is along so many steps. */
const double AHEAD_MOST = 512;

/* How far a particle may stray from the way that it was looked ahead on, in each step, in radii of
 * the smallest. */
const double STRAY = 2e-3;

/* Less than 1/sqrt(3): the length of a vector whose components are no larger is below 1. */
const double COMPONENT = 0.577;

} // namespace

Wall::Wall(const Engine &engine)
    : engine_(engine), model_(engine), key_(asp_key_wall(engine.id().c_str())), groupbit_(1),
      box_(), state_(NULL), place_(NULL), ahead_(), travel_(0), stray_(0), counters_(), clock_(),
      fastest_(), dt_(0), warned_(false), has_doomed_(false) {}

Wall::Sums::Sums(size_t count)
    : count_(count), numbers_(static_cast<double *>(calloc(count + 1, sizeof(double))), free) {
  if (!numbers_)
    throw std::bad_alloc();
}

void Wall::add_shape(std::unique_ptr<Shape> shape, int wall_type, size_t pieces,
                     const std::string &name) {
  Member member = {std::move(shape), name, wall_type, {}, Sums(pieces * N_SUMS)};
  shapes_.push_back(std::move(member));
}

void Wall::parse(Words &words, const std::string &geometry, OwnKeywords *own) {
  geometry_ = geometry;
  const std::string others = KEYWORDS + (own ? " " + own->keywords() : "");
  while (!words.done()) {
    if (own && own->parse(words))
      continue;
    if (words.take("ledger"))
      parse_ledger(words);
    else
      model_.parse(words, others);
  }
  model_.finish();
  for (const Member &member : shapes_)
    if (model_.lay().kind != ASP_LAY_NONE && model_.lay().kind != member.shape->lay_kind())
      throw Error(std::string("lay is ") +
                  (model_.lay().kind == ASP_LAY_ANGLE ? "an angle" : "a vector") + "; of a " +
                  (member.shape->lay_kind() == ASP_LAY_ANGLE
                       ? "cylinder it must be axial, circumferential, or an angle in degrees from "
                         "its axis"
                       : "plane or a mesh it must be a vector, X Y Z"));
}

void Wall::parse_ledger(Words &words) {
  const int64_t every = static_cast<int64_t>(words.whole("ledger", 1, 2147483647.0));
  std::string path, on_error;
  for (bool more = true; more;) {
    if (words.take("file"))
      path = words.word("the file of 'ledger'");
    else if (words.take("on_error"))
      on_error = words.word("the value of 'on_error'");
    else
      more = false;
  }
  if (!on_error.empty() && on_error != "stop" && on_error != "go_on")
    throw Error("on_error is '" + on_error + "'; it must be stop or go_on");
  if (!on_error.empty() && path.empty())
    throw Error("on_error is of a ledger's file; 'ledger N file FILE' must come with it");
  ledger_.reset(new Ledger(engine_.world(), "fix " + engine_.id(), every, path,
                           on_error == "go_on" ? Ledger::GO_ON : Ledger::STOP));
}

/* ---- before a run -----------------------------------------------------------------------------
 */

void Wall::init(int64_t step, double dt) {
  std::vector<int> types;
  for (const Member &member : shapes_)
    if (std::find(types.begin(), types.end(), member.wall_type) == types.end())
      types.push_back(member.wall_type);
  model_.prepare(types);
  set_clock(step, dt);
  if (ledger_) {
    const std::string report = ledger_->open(heading(), step);
    if (!report.empty())
      engine_.print(report);
  }
  const std::string news = model_.news();
  if (!news.empty())
    engine_.print("fix " + engine_.id() + " wall/rebound: " + news);
}

std::string Wall::heading() const {
  return text("asperity %s; fix %s wall/rebound; units %s; ", asp_version(), engine_.id().c_str(),
              engine_.units().c_str()) +
         model_.heading() + "; angles in degrees";
}

void Wall::setup(const Spheres &spheres, int groupbit, const Box &box) {
  groupbit_ = groupbit;
  box_ = box;
  dt_ = spheres.dt;
  fastest_ = Fastest();
  travel_ = 0;
  double least, most;
  engine_.diameters(least, most);
  stray_ = STRAY * 0.5 * least;
  for (int i = 0; i < spheres.n; i++) {
    if (model_.deposit() == Model::OFF && state(i)[STATE] > FREE)
      state(i)[STATE] = FREE; /* an earlier part of the run had deposits */
  }
  renumber_stuck(spheres);
  look_anew();
  for (int i = 0; i < spheres.n; i++) {
    const size_t shape = static_cast<size_t>(place(i)[SHAPE]) - 1;
    if (state(i)[STATE] > FREE && shape < shapes_.size() &&
        model_.removes(spheres.type[i], shapes_[shape].wall_type, 2 * spheres.radius[i]))
      state(i)[STATE] = FREE; /* it had no such flow */
  }
  reorder(spheres);
  warn_of_speeds();
}

void Wall::reorder(const Spheres &spheres) {
  stuck_.clear();
  touching_.clear();
  has_doomed_ = false;
  for (int i = 0; i < spheres.n; i++)
    if (state(i)[STATE] > FREE)
      stuck_.push_back(i);
    else if (state(i)[STATE] < FREE)
      touching_.push_back(i);
  const size_t n = static_cast<size_t>(spheres.n);
  if (!repeats())
    look_anew();
  ahead_.due.resize(n);
  ahead_.v.resize(3 * n);
  ahead_.tag.resize(n, -1);
  for (size_t i = 0; i < n;
       i++) { /* what is known of a particle holds where it is still this one */
    const int64_t tag = spheres.tag_of(static_cast<int>(i));
    if (ahead_.tag[i] == tag)
      continue;
    ahead_.tag[i] = tag;
    ahead_.due[i] = 0;
  }
  check_speeds(spheres);
}

/* Whether all shapes look the same to a particle that has come round a periodic box. */
bool Wall::repeats() const {
  bool all = true;
  for (const Member &member : shapes_)
    for (int d = 0; d < 3; d++)
      all = all && (!(box_.period[d] > 0) || member.shape->repeats(d));
  return all;
}

void Wall::look_anew() {
  ahead_.now = 0;
  std::fill(ahead_.due.begin(), ahead_.due.end(), 0);
}

/* One formula for the time of a step, whether or not the run was interrupted before it. */
void Wall::set_clock(int64_t step, double dt) {
  const double now = static_cast<double>(step);
  dt_ = dt;
  if (!(clock_.dt > 0))
    clock_ = Clock{engine_.time(), now, dt};
  else if (clock_.dt < dt || clock_.dt > dt)
    clock_ = Clock{time(now), now, dt};
}

double Wall::time(double step) const {
  return clock_.time + (step - clock_.step) * clock_.dt;
}

void Wall::reset_dt(int64_t step, double dt) {
  set_clock(step, dt);
  look_anew(); /* it counts steps */
}

void Wall::reset_step(int64_t now, int64_t before) {
  clock_.step += static_cast<double>(now - before);
}

/* Each rank looks where particles are put into a new order; they tell each other when something is
 * printed, and do not wait for each other in between. */
void Wall::check_speeds(const Spheres &s) {
  for (int i = 0; !warned_ && i < s.n; i++) {
    const double *v = s.v + 3 * static_cast<size_t>(i);
    const double square = vector_dot(v, v), limit = fastest_.ratio * s.radius[i];
    if (!(s.mask[i] & groupbit_) || square <= limit * limit)
      continue;
    fastest_ = Fastest{sqrt(square) / s.radius[i], 2 * s.radius[i], sqrt(square)};
  }
}

void Wall::warn_of_speeds() {
  if (warned_)
    return;
  int rank;
  MPI_Comm_rank(engine_.world(), &rank);
  struct {
    double ratio;
    int rank;
  } mine = {fastest_.ratio, rank}, worst;
  MPI_Allreduce(&mine, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, engine_.world());
  if (worst.ratio * dt_ <= 1)
    return;
  double fastest[2] = {fastest_.d_p, fastest_.speed};
  MPI_Bcast(fastest, 2, MPI_DOUBLE, worst.rank, engine_.world());
  warned_ = true;
  engine_.warn(text("particles move far in a step: one of diameter %g moves at %g, which is %.3g "
                    "diameters in a step of %g. No contact is missed, but paths that forces bend, "
                    "and walls that turn, are taken as straight within a step; where that counts, "
                    "the largest safe step is %g",
                    fastest[0], fastest[1], 0.5 * worst.ratio * dt_, dt_, 1 / worst.ratio));
}

/* ---- contacts ---------------------------------------------------------------------------------
 */

/* One particle on its way through a step. Its path is straight; along it the velocity changes by
 * what acts on the particle, from `begin`, so that a contact finds the velocity of its own instant.
 * `half` is what the engine's second half of the step has to begin with. */
struct Wall::Flight {
  const Spheres &spheres;
  int i;
  double radius, mass;
  Path path;
  double begin[3], acceleration[3], half[3], spin[3];
  std::vector<Event> events;
  double x0[3], v0[3], a0[3]; /* at the beginning of the step */

  Flight(const Spheres &s, int particle);
  asp_particle particle(const asp_pair *pair) const;
  void velocity(double time, double v[3]) const;
  void go_on(const double before[3], const double after[3], const double n[3]);
};

Wall::Flight::Flight(const Spheres &s, int particle)
    : spheres(s), i(particle), radius(s.radius[i]), mass(s.mass[i]) {
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

/* What sticks goes with its wall; then, of the others, the few that may touch a wall. */
void Wall::step(const std::vector<Wall *> &walls, const Spheres &spheres) {
  std::vector<int> near;
  for (Wall *wall : walls) {
    for (int i : wall->touching_) /* those that touched it in the step before */
      wall->state(i)[STATE] = std::max<double>(wall->state(i)[STATE], FREE);
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
}

/* Whether a velocity differs by more than that from the one that was looked ahead along; of n
 * components. */
static bool any_strays(const double *v, const float *along, int n, float most) {
  int over = 0;
  for (int k = 0; k < n; k++)
    over += !(fabsf(static_cast<float>(v[k]) - along[k]) <= most);
  return over > 0;
}

static bool any_due(const int *due, int n, int now) {
  int over = 0;
  for (int i = 0; i < n; i++)
    over += due[i] <= now;
  return over > 0;
}

/* Particles that may touch this wall in this step. Most are known to be too far away: their way was
 * looked ahead on for some steps, in which they may stray from it a little. */
void Wall::find_near(const Spheres &s, std::vector<int> &near) {
  double travel = 0;
  for (const Member &member : shapes_)
    travel = std::max(travel, member.shape->travel(s.dt));
  if (travel > travel_) {
    travel_ = 2 * travel;
    look_anew();
  }
  if (ahead_.now > INT_MAX / 2)
    look_anew(); /* before the count of steps could overflow */
  ahead_.now++;
  const float most = static_cast<float>(COMPONENT * stray_ / s.dt);
  for (int first = 0; first < s.n; first += BLOCK) {
    const int count = std::min(BLOCK, s.n - first);
    const double *v = s.v + 3 * static_cast<size_t>(first);
    const float *along = ahead_.v.data() + 3 * static_cast<size_t>(first);
    const int *due = ahead_.due.data() + first;
    if (!any_strays(v, along, 3 * count, most) && !any_due(due, count, ahead_.now))
      continue;
    for (int i = 0; i < count; i++)
      if (due[i] <= ahead_.now || any_strays(v + 3 * i, along + 3 * i, 3, most))
        look_ahead(s, first + i, near);
  }
}

/* What is known of this particle is used up. (The way that was seen is wider from step to step by
 * as much as a particle may stray in one; so none may stray more in any of them, for one that is
 * thrown back to the wall by another would be there before.) */
void Wall::look_ahead(const Spheres &s, int i, std::vector<int> &near) {
  const double *v = s.v + 3 * static_cast<size_t>(i);
  float *along = &ahead_.v[3 * static_cast<size_t>(i)];
  int *due = &ahead_.due[i];
  const bool out = !(s.mask[i] & groupbit_) || state(i)[STATE] > FREE;
  for (int d = 0; d < 3; d++)
    along[d] = static_cast<float>(v[d]);
  *due = out ? NEVER : *due == AT_REST ? 0 : ahead_.now + steps_clear(s, i);
  if (*due <= ahead_.now)
    near.push_back(i);
}

/* For how many steps, with this one, a particle cannot touch the wall if it keeps its velocity and
 * strays no more than it may; 0 where it may touch in this one. Straying is told in single
 * precision only. */
int Wall::steps_clear(const Spheres &s, int i) const {
  const double *x = s.x + 3 * static_cast<size_t>(i), *v = s.v + 3 * static_cast<size_t>(i);
  double begin[3], by[3], steps = AHEAD_MOST;
  for (int d = 0; d < 3; d++) {
    by[d] = v[d] * s.dt;
    begin[d] = x[d] - by[d];
  }
  const double widen = stray_ + FLT_EPSILON * vector_length(by) + travel_;
  const double reach = (1 + ROUNDING) * s.radius[i] + widen;
  for (const Member &member : shapes_)
    steps = std::min(steps, member.shape->clear(begin, by, reach, widen, steps));
  return static_cast<int>((1 - ROUNDING) * steps);
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
  Flight flight(s, i);
  Path &path = flight.path;
  Wall *wall;
  size_t shape;
  Contact contact;
  bool touched = false, caught = false, stuck = false, one_shape = true;
  int crowd = 0;
  const Wall *first_wall = NULL;
  size_t before_crowd = 0, first_shape = 0;
  double mean_x[3], mean_v[3], spin_before[3] = {0, 0, 0};
  for (Wall *each : walls)
    if (each->state(i)[STATE] < FREE)
      each->state(i)[STATE] = FREE;
  while (!stuck && !caught && find_first(walls, flight, wall, shape, contact)) {
    touched = true;
    if (contact.time * vector_length(path.v) > CROWDED * flight.radius || crowd == 0) {
      crowd = 0;
      one_shape = true;
      first_wall = wall;
      first_shape = shape;
      before_crowd = flight.events.size();
      vector_copy(flight.spin, spin_before);
      for (int d = 0; d < 3; d++)
        mean_x[d] = mean_v[d] = 0;
    }
    crowd++;
    one_shape = one_shape && wall == first_wall && shape == first_shape;
    vector_add_scaled(mean_x, 1.0 / CROWD, contact.x, mean_x);
    vector_add_scaled(mean_v, 1.0 / CROWD, contact.v_wall, mean_v);
    caught = crowd == CROWD;
    if (!caught)
      stuck = wall->touch(flight, shape, contact);
  }
  if (caught) { /* no way out in this step: it goes with the walls, and none of it has happened */
    for (size_t k = before_crowd; k < flight.events.size(); k++)
      flight.events[k].wall->state(i)[IMPACTS]--;
    flight.events.resize(before_crowd);
    wall->counters_[N_GUARDED]++;
    vector_copy(spin_before, flight.spin);
    const Path before = path;
    path.left = std::max(0.0, path.left - contact.time);
    vector_copy(mean_v, path.v);
    vector_copy(mean_v, flight.half);
    vector_copy(mean_x, path.x);
    if (one_shape) { /* at its place there, also where the shape turns */
      Place at;
      double on_wall[3], v_wall[3];
      vector_copy(mean_x, contact.x);
      wall->shapes_[shape].shape->stick(before, contact, at);
      wall->shapes_[shape].shape->carry(at, flight.radius, path.left, on_wall, v_wall);
      wall->box_.bring_near(mean_x, on_wall);
      vector_copy(on_wall, path.x);
      path.left = 0;
    }
  }
  for (const Event &event : flight.events)
    event.wall->count(flight, event);
  for (Wall *each : walls)
    if (s.mask[i] & each->groupbit_)
      each->ahead_.due[i] = each->is_at_rest(i) ? AT_REST : 0;
  if (!touched || stuck)
    return;
  vector_copy(flight.half, s.v + 3 * static_cast<size_t>(i));
  if (s.omega)
    vector_copy(flight.spin, s.omega + 3 * static_cast<size_t>(i));
  vector_add_scaled(path.x, path.left, path.v, s.x + 3 * static_cast<size_t>(i));
  if (!caught)
    note_energy(flight);
}

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
    if (contacts > 1 || wall->state(flight.i)[STATE] < FREE)
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
  vector_add_scaled(v, (now < 0 ? -speed : speed) - now, n, v);
}

/* One contact: moves the flight on to it, and gives it the velocity after it. True where the
 * particle has stuck. */
bool Wall::touch(Flight &flight, size_t shape, const Contact &contact) {
  const Spheres &s = flight.spheres;
  const int i = flight.i;
  const Path before = flight.path;
  double v[3], v1[3];
  flight.velocity(contact.time, v);
  vector_subtract(v, contact.v_wall, v1);
  vector_copy(contact.x, flight.path.x);
  flight.path.left = std::max(0.0, before.left - contact.time);

  /* A bounce that what acts on the particle would end within the step is not resolved: it rests. So
   * does one whose approach is only that of its straight path, or of a wall that turns. */
  const double approach = -vector_dot(v1, contact.n);
  const double push = -vector_dot(flight.acceleration, contact.n) + contact.gain / s.dt;
  const bool rests = approach <= (1 + ROUNDING) * 0.5 * s.dt * std::max(0.0, push);
  if (rests && (!(approach > 0) || !model_.sticks())) {
    rest(flight, shape, contact, v, push);
    return false;
  }
  if (!model_.wall())
    throw Error(text("particle %lld came to be after the run began, and the wall's tables need the "
                     "diameters beforehand; make particles before 'run', or by a fix insert",
                     static_cast<long long>(s.tag_of(i))));
  asp_particle particle = flight.particle(model_.pair(s.type[i], shapes_[shape].wall_type));
  double lay[3];
  if (model_.lay().kind != ASP_LAY_NONE) {
    shapes_[shape].shape->lay(model_.lay(), before, contact, lay);
    particle.lay = lay;
  }
  Event event = {this, shape, contact, {v1[0], v1[1], v1[2]}, 0, 0, {}, {}};
  event.elapsed = s.dt - flight.path.left;
  event.time = time(static_cast<double>(s.step)) - flight.path.left;
  event.key.seed = model_.seed();
  event.key.wall = key_;
  event.key.tag = static_cast<uint64_t>(s.tag_of(i));
  event.key.impact = static_cast<uint32_t>(state(i)[IMPACTS]) + 1;
  asp_wall_impact(model_.wall(), &particle, v1, contact.n, &event.key, &event.impact);
  const bool sticks = event.impact.outcome == ASP_DEPOSIT;
  if (rests && !sticks) {
    rest(flight, shape, contact, v, push);
    return false;
  }
  state(i)[IMPACTS]++;
  flight.events.push_back(event);
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

/* What is left of a sliding velocity when something accelerates it along the wall for a time, and
 * friction, at most, brakes it by `brake` times that time. */
static void slide(double v[3], const double acceleration[3], double brake, double time) {
  vector_add_scaled(v, time, acceleration, v);
  const double speed = vector_length(v), taken = brake * time;
  vector_scale(speed > taken ? 1 - taken / speed : 0, v);
}

/* A particle at rest loses its normal velocity v, and the wall bears what pushes it, `push` along
 * -n per mass, for the rest of the step; Coulomb's friction takes from its sliding. */
void Wall::rest(Flight &flight, size_t shape, const Contact &contact, const double v[3],
                double push) {
  const Spheres &s = flight.spheres;
  const double friction = model_.friction(s.type[flight.i], shapes_[shape].wall_type);
  const double left = flight.path.left, *n = contact.n;
  const double brake = friction * std::max(0.0, push);
  double along[3], none[3] = {0, 0, 0}, before[3];
  vector_copy(flight.half, before);

  /* Along the wall: what the contact leaves, and what acts there. */
  double v1[3], sliding[3];
  vector_subtract(v, contact.v_wall, v1);
  const double approach = -vector_dot(v1, n);
  vector_add_scaled(v1, approach, n, sliding);
  slide(sliding, none, friction * std::max(0.0, approach), 1);
  vector_add_scaled(flight.acceleration, -vector_dot(flight.acceleration, n), n, along);

  /* The path goes on with the velocity in its middle; its part along n is that of the wall as the
   * search has it, so that it is not found again. */
  double mean[3];
  vector_copy(sliding, mean);
  slide(mean, along, brake, 0.5 * left);
  const double off = vector_dot(flight.path.v, n) + (1 + ROUNDING) * contact.closing -
                     vector_dot(contact.v_wall, n);
  vector_add_scaled(contact.v_wall, 1, mean, mean);
  vector_add_scaled(mean, off, n, flight.path.v);
  if (push > 0)
    vector_copy(along, flight.acceleration);
  vector_add_scaled(flight.path.v, -0.5 * left, flight.acceleration, flight.begin);

  slide(sliding, along, brake, std::max(0.0, left - 0.5 * s.dt));
  vector_add_scaled(contact.v_wall, 1, sliding, flight.half);
  if (!(push > 0)) { /* it leaves again: nothing is borne */
    const double later = left - 0.5 * s.dt;
    for (int d = 0; d < 3; d++)
      flight.half[d] = contact.v_wall[d] + v1[d] + approach * n[d] + later * flight.acceleration[d];
    return;
  }
  press(s, flight.i, shape, contact.piece, n, before, flight.half, v1);
  double *row = place(flight.i);
  row[SHAPE] = static_cast<double>(shape) + 1;
  row[PIECE] = contact.piece;
  vector_copy(n, row + NORMAL);
  vector_copy(contact.v_wall, row + VELOCITY);
  state(flight.i)[STATE] = RESTING;
  touching_.push_back(flight.i);
}

/* What has changed a particle's velocity at the wall, for a shape that measures. v1: relative to
 * the wall. */
void Wall::press(const Spheres &s, int i, size_t shape, int piece, const double n[3],
                 const double before[3], const double after[3], const double v1[3]) {
  if (!shapes_[shape].shape->measures())
    return;
  Blow blow;
  blow.piece = piece;
  blow.type = s.type[i];
  blow.mask = s.mask[i];
  for (int d = 0; d < 3; d++)
    blow.impulse[d] = s.mass[i] * (before[d] - after[d]);
  vector_add_scaled(s.x + 3 * static_cast<size_t>(i), -s.radius[i], n, blow.point);
  vector_copy(v1, blow.v_before);
  shapes_[shape].shape->take(blow);
}

void Wall::count(const Flight &flight, const Event &event) {
  const bool stuck = event.impact.outcome == ASP_DEPOSIT;
  const double stuck_mass = stuck ? flight.mass : 0;
  const double energy = 0.5 * flight.mass * vector_dot(event.v1, event.v1);
  counters_[N_IMPACTS]++;
  counters_[N_DEPOSITS] += stuck;
  counters_[DEPOSITED_MASS] += stuck_mass;
  counters_[N_LATER_HITS] += event.impact.hits - 1;
  counters_[N_CAPPED] += event.impact.capped;
  counters_[N_GUARDED] += event.contact.guarded;
  Member &member = shapes_[event.shape];
  member.totals[SHAPE_IMPACTS]++;
  member.totals[SHAPE_DEPOSITS] += stuck;
  member.totals[SHAPE_MASS] += stuck_mass;
  member.totals[SHAPE_ENERGY] += energy;
  if (member.sums.size() > 0) {
    double *sums = member.sums.data() + static_cast<size_t>(event.contact.piece) * N_SUMS;
    sums[PIECE_IMPACTS]++;
    sums[PIECE_MASS] += stuck_mass;
    sums[PIECE_ENERGY] += energy;
  }
  press(flight.spheres, flight.i, event.shape, event.contact.piece, event.contact.n, event.v1,
        event.impact.v2, event.v1);
  if (ledger_)
    record(flight, event);
}

void Wall::record(const Flight &flight, const Event &event) {
  typedef Ledger L;
  const asp_coefficients c = asp_impact_coefficients(event.v1, event.contact.n, &event.impact);
  L::Row row;
  row[L::TAG] = static_cast<double>(event.key.tag);
  row[L::IMPACT] = event.key.impact;
  row[L::TIME] = event.time;
  row[L::MESH] = shapes_[event.shape].sums.size() > 0 ? static_cast<double>(event.shape) + 1 : 0;
  row[L::TRIANGLE] = event.contact.piece;
  for (int d = 0; d < 3; d++)
    row[L::X + d] = event.contact.x[d];
  row[L::D_P] = 2 * flight.radius;
  row[L::V1] = c.v1;
  row[L::ALPHA1] = c.alpha1 * DEGREES;
  row[L::DELTA_ALPHA] = event.impact.delta_alpha * DEGREES;
  row[L::TILT_OUT] = event.impact.tilt_out * DEGREES;
  row[L::HITS] = event.impact.hits;
  row[L::V2] = c.v2;
  row[L::ALPHA2] = c.alpha2 * DEGREES;
  row[L::COR_N] = c.cor_n;
  row[L::COR_T] = c.cor_t;
  row[L::OUTCOME] = event.impact.outcome == ASP_REBOUND ? 0
                    : model_.deposit() == Model::DELETE ? 2
                                                        : 1;
  row[L::STEP] = static_cast<double>(flight.spheres.step);
  row[L::COR_T_DEFINED] = c.cor_t_defined;
  ledger_->add(row);
}

/* ---- what sticks ------------------------------------------------------------------------------
 */

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

void Wall::carry(const Spheres &spheres) {
  for (int i : stuck_)
    carry_one(spheres, i, spheres.dt);
}

/* Puts a stuck particle where its wall has it at the end of the step: the periodic image of that
 * place which is nearest to where the particle is. */
void Wall::carry_one(const Spheres &s, int i, double dt) {
  double *row = place(i), *x = s.x + 3 * static_cast<size_t>(i), on_wall[3];
  const size_t shape = static_cast<size_t>(row[SHAPE]) - 1;
  if (!(row[SHAPE] >= 1) || shape >= shapes_.size())
    return;
  Place at = {static_cast<int>(row[PIECE]), {row[AT], row[AT + 1], row[AT + 2]}};
  shapes_[shape].shape->carry(at, s.radius[i], dt, on_wall, row + VELOCITY);
  row[PIECE] = at.piece;
  vector_copy(at.at, row + AT);
  box_.bring_near(x, on_wall);
  vector_copy(on_wall, x);
  vector_copy(row + VELOCITY, s.v + 3 * static_cast<size_t>(i));
  for (int d = 0; s.omega && d < 3; d++)
    s.omega[3 * static_cast<size_t>(i) + d] = 0;
}

void Wall::hold(const Spheres &s) {
  for (int i : stuck_) {
    vector_copy(place(i) + VELOCITY, s.v + 3 * static_cast<size_t>(i));
    for (int d = 0; s.omega && d < 3; d++)
      s.omega[3 * static_cast<size_t>(i) + d] = 0;
  }
  for (int i : touching_)
    if (is_at_rest(i))
      hold_resting(s, i);
    else if (state(i)[STATE] < RESTING)
      balance(s, i);
}

/* The second half of a step of a particle at rest: the wall bears what forces have given it along
 * -n, with friction. */
void Wall::hold_resting(const Spheres &s, int i) {
  const double *row = place(i), *n = row + NORMAL, *v_wall = row + VELOCITY;
  double *v = s.v + 3 * static_cast<size_t>(i), v1[3], after[3];
  const double none[3] = {0, 0, 0};
  vector_subtract(v, v_wall, v1);
  const double approach = -vector_dot(v1, n);
  if (!(approach > 0))
    return;
  const size_t shape = static_cast<size_t>(row[SHAPE]) - 1;
  vector_add_scaled(v1, approach, n, after);
  slide(after, none, model_.friction(s.type[i], shapes_[shape].wall_type) * approach, 1);
  press(s, i, shape, static_cast<int>(row[PIECE]), n, v1, after, v1);
  vector_add_scaled(v_wall, 1, after, v);
}

void Box::bring_near(const double near[3], double x[3]) const {
  for (int d = 0; d < 3; d++)
    if (period[d] > 0)
      x[d] += period[d] * floor((near[d] - x[d]) / period[d] + 0.5);
}

/* ---- output -----------------------------------------------------------------------------------
 */

void Wall::end_step(int64_t step, bool output) {
  if (output)
    warn_of_speeds();
  if (ledger_)
    check_written(ledger_->end_step(step));
}

/* Rows that cannot be written end the run, or are told, as the script says. */
void Wall::check_written(const std::string &wrong) const {
  if (wrong.empty())
    return;
  if (ledger_->on_error() == Ledger::STOP)
    throw Error(wrong);
  engine_.warn(wrong);
}

void Wall::end_run() {
  warn_of_speeds();
  if (ledger_)
    check_written(ledger_->flush());
}

double Wall::counter(int k) const {
  double all;
  MPI_Allreduce(&counters_[k], &all, 1, MPI_DOUBLE, MPI_SUM, engine_.world());
  return all;
}

double Wall::total(size_t shape, int k) const {
  double all;
  MPI_Allreduce(&shapes_[shape].totals[k], &all, 1, MPI_DOUBLE, MPI_SUM, engine_.world());
  return all;
}

std::vector<double> Wall::sums(size_t shape) const {
  std::vector<double> all;
  show_sums(shape, [&all](size_t, const std::vector<double> &some) {
    all.insert(all.end(), some.begin(), some.end());
  });
  return all;
}

void Wall::show_sums(size_t shape,
                     const std::function<void(size_t, const std::vector<double> &)> &show) const {
  const Sums &mine = shapes_[shape].sums;
  const size_t most = SHOWN * N_SUMS;
  std::vector<double> some;
  for (size_t first = 0; first < mine.size(); first += most) {
    some.resize(std::min(most, mine.size() - first));
    MPI_Allreduce(mine.data() + first, some.data(), static_cast<int>(some.size()), MPI_DOUBLE,
                  MPI_SUM, engine_.world());
    show(first / N_SUMS, some);
  }
}

double Wall::bytes() const {
  size_t all = stuck_.capacity() * sizeof(int) + ahead_.due.capacity() * sizeof(int) +
               ahead_.v.capacity() * sizeof(float) + ahead_.tag.capacity() * sizeof(int64_t);
  for (const Member &member : shapes_)
    all += member.shape->bytes() + member.sums.size() * sizeof(double);
  return static_cast<double>(all) + (ledger_ ? ledger_->memory_usage() : 0);
}

/* ---- restart ----------------------------------------------------------------------------------
 */

std::vector<char> Wall::save() {
  WallState state = WallState();
  state.settings = settings();
  if (ledger_)
    check_written(ledger_->save(state.ledger));
  for (int k = 0; k < N_COUNTERS; k++)
    state.counters.push_back(counter(k));
  for (size_t m = 0; m < shapes_.size(); m++) {
    std::vector<double> totals;
    for (int k = 0; k < N_TOTALS; k++)
      totals.push_back(total(m, k));
    const Member &member = shapes_[m];
    if (member.name.empty())
      state.totals = totals;
    else
      state.meshes.push_back(MeshState{member.name,
                                       static_cast<int64_t>(member.sums.size() / N_SUMS), totals,
                                       sums(m), member.shape->motion_record()});
  }
  std::copy(model_.sizes(), model_.sizes() + 2, state.d_range);
  state.clock[0] = clock_.time;
  state.clock[1] = clock_.step;
  state.clock[2] = clock_.dt;
  int rank;
  MPI_Comm_rank(engine_.world(), &rank);
  return rank == 0 ? pack(state) : std::vector<char>();
}

Settings Wall::settings() const {
  return Settings{{"geometry", geometry_}, {"description", model_.description()}};
}

/* The script is what counts; but it should not differ unnoticed. */
void Wall::restore(const char *record) {
  const WallState saved = unpack(record);
  if (saved.counters.size() != N_COUNTERS)
    throw Error(text("the restart file's record of this wall has %d counters; there must be %d",
                     static_cast<int>(saved.counters.size()), N_COUNTERS));
  const std::string changes = describe_changes(clauses(settings()), clauses(saved.settings));
  if (!changes.empty())
    engine_.warn("the script differs from the restart file, and the script is taken; " + changes);
  model_.set_sizes(saved.d_range);
  clock_ = Clock{saved.clock[0], saved.clock[1], saved.clock[2]};
  int rank;
  MPI_Comm_rank(engine_.world(), &rank);
  if (rank == 0)
    std::copy(saved.counters.begin(), saved.counters.end(), counters_);
  restore_shapes(saved);
  if (ledger_)
    ledger_->restore(saved.ledger);
}

/* Totals and maps, those of a mesh only where it is the same one. */
void Wall::restore_shapes(const WallState &saved) {
  std::vector<std::pair<std::string, int64_t>> meshes;
  std::vector<size_t> member_of;
  int rank;
  MPI_Comm_rank(engine_.world(), &rank);
  for (size_t m = 0; m < shapes_.size(); m++) {
    Member &member = shapes_[m];
    if (!member.name.empty()) {
      meshes.push_back(
          std::make_pair(member.name, static_cast<int64_t>(member.sums.size() / N_SUMS)));
      member_of.push_back(m);
    } else if (rank == 0 && saved.totals.size() == N_TOTALS)
      std::copy(saved.totals.begin(), saved.totals.end(), member.totals);
  }
  std::string lost;
  const std::vector<int> found = match_meshes(saved, meshes, lost);
  if (!lost.empty())
    engine_.warn("not continued by a mesh, but kept in the wall's own counters: " + lost);
  shape_now_.assign(std::max(saved.meshes.size(), static_cast<size_t>(1)), 0);
  if (saved.meshes.empty() && meshes.empty())
    shape_now_[0] = 1;
  for (size_t k = 0; k < found.size(); k++) {
    if (found[k] < 0)
      continue;
    const MeshState &mesh = saved.meshes[found[k]];
    Member &member = shapes_[member_of[k]];
    shape_now_[found[k]] = static_cast<int>(member_of[k]) + 1;
    if (rank == 0 && mesh.totals.size() == N_TOTALS)
      std::copy(mesh.totals.begin(), mesh.totals.end(), member.totals);
    if (rank == 0 && mesh.map.size() == member.sums.size())
      std::copy(mesh.map.begin(), mesh.map.end(), member.sums.data());
    member.shape->restore_motion(mesh.motion);
  }
}

/* What is stuck knows its mesh by a number, which another script may have changed. What is stuck to
 * a mesh that is gone stays where it is. */
void Wall::renumber_stuck(const Spheres &spheres) {
  for (int i = 0; !shape_now_.empty() && i < spheres.n; i++) {
    double *row = place(i);
    const size_t before = static_cast<size_t>(row[SHAPE]);
    if (!(state(i)[STATE] > FREE) || before < 1 || before > shape_now_.size())
      continue;
    row[SHAPE] = shape_now_[before - 1];
    for (int d = 0; d < 3 && shape_now_[before - 1] == 0; d++)
      row[VELOCITY + d] = 0;
  }
  shape_now_.clear();
}
