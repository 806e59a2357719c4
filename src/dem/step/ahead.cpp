/* Predictions of the next contact; see ahead.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/ahead.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

namespace {

/* Ahead::due_ of a particle that is stuck, or not of the group: never near. */
const int NEVER = INT_MAX;

/* Ahead::due_ of one that has a screen. */
const int SCREENED = INT_MAX - 1;

/* A particle that comes to a wall within so many steps is near: they are not worth another look. */
const double SOON = 2;

/* A particle that is near, not counting faces at which it stays, counts as near for this many
 * steps. */
const int STAYS_NEAR = 32;

/* One that moves by a larger share of a screen's range in a step has none. Before one is made, and
 * where it does not hold, the wall is searched for some steps. */
const double SLOW_SHARE = 0.125;
const int SEARCHES = 2;

/* Predictions of fewer steps are not worth their cost where a screen holds. */
const int SHORT = 32;

/* A path of so many radii in a step is none: the engine has blown up. */
const double FARTHEST = 1e9;

/* Velocities are checked in blocks of so many particles. */
const int BLOCK = 32;

/* Longest prediction, in steps. */
const double AHEAD_MOST = 2048;

/* The first predictions are of this many lengths, so that they do not all expire in one step. */
const int LENGTHS = 8;

/* Distance per step by which a particle may stray from its predicted path: as a share of its way,
 * and what the forces on it do within a radius; at most so many radii. */
const double STRAY = 2e-3, STRAY_MOST = 2e-3;

/* Walls may move farther in a step than so far by this factor before predictions are made anew. */
const double FASTER = 1.2;

/* Largest bend of the path by contacts along which it slides within a step, in radii. */
const double BEND = 5 * OVERLAP;

/* Less than 1/sqrt(3): the length of a vector whose components are no larger is below 1. */
const double COMPONENT = 0.577;

} // namespace

Ahead::Ahead(const Setup &setup, const Memories &rows, bool are_bodies)
    : setup_(setup), rows_(rows), are_bodies_(are_bodies), now_(0), travel_(0), most_(0) {}

double Ahead::bend(double radius) {
  return BEND * radius;
}

void Ahead::watch(int i) {
  due_[i] = -(now_ + STAYS_NEAR);
}

void Ahead::clear() {
  for (int &due : due_)
    due = due < -now_ ? due + now_ : 0;
  now_ = 0;
}

void Ahead::reorder(const Spheres &s) {
  const size_t n = static_cast<size_t>(s.n);
  if (!setup_.repeats())
    clear();
  due_.resize(n);
  v_.resize(3 * n);
  stray_.resize(n);
  least_.assign(n / BLOCK + 1, 0);
  tag_.resize(n, -1);
  for (size_t i = 0; i < n; i++) {
    const int64_t tag = s.tag_of(static_cast<int>(i));
    const bool was_stuck = due_[i] == NEVER && !(stray_[i] < INFINITY);
    if (tag_[i] == tag && (!was_stuck || rows_.is_stuck(static_cast<int>(i))))
      continue;
    tag_[i] = tag;
    due_[i] = 0;
  }
  const auto is_gone = [this, &s](const Screen &one) {
    return one.i >= s.n || due_[static_cast<size_t>(one.i)] != SCREENED;
  };
  screens_.erase(std::remove_if(screens_.begin(), screens_.end(), is_gone), screens_.end());
}

size_t Ahead::bytes() const {
  return due_.capacity() * sizeof(int) + tag_.capacity() * sizeof(int64_t) +
         (v_.capacity() + stray_.capacity() + least_.capacity()) * sizeof(float) +
         screens_.capacity() * sizeof(Screen);
}

/* True if one of n components of a velocity differs by more than `most` from the predicted one. */
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

/* The speed by which a particle may stray. A wide course comes to a wall long before the particle
 * does, unless that is slow; a narrow one is left as soon as forces act. What is stuck has none. */
float Ahead::stray(const Spheres &s, int i) const {
  if (rows_.is_stuck(i))
    return INFINITY;
  const size_t at = 3 * static_cast<size_t>(i);
  const double most = STRAY_MOST * s.radius[i] / s.dt, speed = aspi_length(s.v + at);
  if (are_bodies_ || rows_.status(i) == Status::RESTING || speed <= most)
    return static_cast<float>(most);
  const double pushed = sqrt(aspi_length(s.f + at) / s.mass[i] * s.radius[i]);
  return static_cast<float>(std::min(most, STRAY * speed + pushed));
}

/* Most particles have a valid prediction that they are too far away; it holds while their velocity
 * stays near the predicted one. A block is checked by what its particles may stray at least. */
void Ahead::find_near(const Spheres &s, int number, std::vector<Candidate> &near) {
  travel_ = 0;
  for (const Member &member : setup_.shapes)
    travel_ = std::max(travel_, member.shape->travel(s.dt));
  if (travel_ > most_) {
    most_ = FASTER * travel_;
    clear();
  }
  if (now_ > INT_MAX / 2)
    clear(); /* before the count of steps could overflow */
  now_++;
  const auto first_near = static_cast<std::ptrdiff_t>(near.size());
  if (!screens_.empty())
    check_screens(s, number, near);
  const auto last_screened = static_cast<std::ptrdiff_t>(near.size());
  const float share = static_cast<float>(COMPONENT);
  for (int first = 0; first < s.n; first += BLOCK) {
    const int count = std::min(BLOCK, s.n - first);
    const float *stray = stray_.data() + first;
    float &least = least_[static_cast<size_t>(first / BLOCK)];
    const double *v = s.v + 3 * static_cast<size_t>(first);
    const float *along = v_.data() + 3 * static_cast<size_t>(first);
    const int *due = due_.data() + first;
    const bool some_stray = least < INFINITY && any_strays(v, along, 3 * count, share * least);
    if (!some_stray && !any_due(due, count, now_))
      continue;
    for (int i = 0; i < count; i++)
      if ((due[i] <= now_ ||
           (some_stray && any_strays(v + 3 * i, along + 3 * i, 3, share * stray[i]))) &&
          look(s, first + i))
        near.push_back(Candidate{first + i, number});
    least = *std::min_element(stray, stray + count);
  }
  if (last_screened > first_near)
    std::sort(near.begin() + first_near, near.end());
}

/* The faces of a shape at which a particle rests: its way ends at them, unless a command of the
 * script has given it another velocity or place before the first step of a run. */
FaceList Ahead::faces(const Spheres &s, int i, size_t shape) const {
  static_assert(RESTS_MOST <= sizeof(FaceList::face) / sizeof(int), "all rests are faces");
  FaceList faces = FaceList();
  const size_t at = 3 * static_cast<size_t>(i);
  const Memory *of = rows_.find(i);
  if (are_bodies_ || rows_.status(i) != Status::RESTING || !of)
    return faces;
  for (const Rest &rest : of->rests) {
    const int face = static_cast<int>(rest.face);
    Contact end = Contact();
    double distance;
    if (static_cast<size_t>(rest.shape) == shape + 1 &&
        (now_ > 1 || (setup_.shapes[shape].shape->under(face, s.x + at, s.v + at, 2 * s.radius[i],
                                                        end, distance) &&
                      s.radius[i] - distance < OVERLAP * s.radius[i])))
      faces.face[faces.count++] = face;
  }
  return faces;
}

void Ahead::note_velocity(const Spheres &s, int i) {
  const size_t at = 3 * static_cast<size_t>(i);
  for (size_t d = at; d < at + 3; d++)
    v_[d] = static_cast<float>(s.v[d]);
}

/* Makes a new prediction when the old one has expired; true if the particle may touch in this step.
 * (A prediction widens by the allowed stray distance in every step, so no particle may stray
 * farther in any of them: another particle could throw it back to the wall earlier.) One that stays
 * near, or moves less than its course widens, gets a screen where that holds. */
bool Ahead::look(const Spheres &s, int i) {
  const double *v = s.v + 3 * static_cast<size_t>(i);
  int *due = &due_[i];
  const bool was_near = *due < 0;
  if (was_near && now_ < -*due)
    return true;
  float &strays = stray_[static_cast<size_t>(i)];
  strays = stray(s, i);
  note_velocity(s, i);
  if (!(s.mask[i] & setup_.groupbit) || rows_.is_stuck(i)) {
    *due = NEVER;
    return false;
  }
  if (!(aspi_length(v) * s.dt <= FARTHEST * s.radius[i]))
    throw Error(
        text("the velocity of particle %lld is %g %g %g, by which it moves over %g radii in "
             "a step; a force or the time step is far too large",
             static_cast<long long>(s.tag_of(i)), v[0], v[1], v[2], FARTHEST));
  int steps = was_near ? 0 : steps_clear(s, i);
  Screened now = Screened::NONE;
  if (was_near || (steps < SHORT && is_wide(s, i, steps))) {
    Screen made(s, i);
    now = screen(s, i, made);
    if (now == Screened::HOLDS &&
        (!made.is_empty() || steps == 0 || rows_.status(i) == Status::RESTING)) {
      screens_.push_back(made);
      strays = INFINITY;
      *due = SCREENED;
      return false;
    }
  }
  if (was_near && now == Screened::NONE)
    steps = steps_clear(s, i);
  const int searches = was_near && now == Screened::NONE ? STAYS_NEAR : SEARCHES;
  *due = steps > 0 ? now_ + steps : -(now_ + searches);
  return !(steps > 0);
}

/* True if a particle moves by less than its course widens, and this has ended the course near the
 * wall: a screen holds for longer. */
bool Ahead::is_wide(const Spheres &s, int i, int steps) const {
  const size_t at = static_cast<size_t>(i);
  const double widens = s.dt * static_cast<double>(stray_[at]) + most_;
  if (s.dt * aspi_length(s.v + 3 * at) > widens)
    return false;
  return rows_.status(i) == Status::RESTING || steps * widens < Screen::range(s.radius[i]);
}

/* Number of steps, with this one, in which a particle cannot touch the wall if it keeps its
 * velocity within the allowed stray distance; 0 if it may touch in this one. Straying is measured
 * in single precision. */
int Ahead::steps_clear(const Spheres &s, int i) const {
  const double *x = s.x + 3 * static_cast<size_t>(i), *v = s.v + 3 * static_cast<size_t>(i);
  Course course;
  course.least = SOON;
  course.most = now_ > 1 ? AHEAD_MOST : AHEAD_MOST / LENGTHS * (1 + i % LENGTHS);
  for (int d = 0; d < 3; d++) {
    course.v[d] = v[d] * s.dt;
    course.x[d] = x[d] - course.v[d];
  }
  const double stray = s.dt * stray_[static_cast<size_t>(i)];
  course.widen = stray + bend(s.radius[i]) + FLT_EPSILON * aspi_length(course.v) + most_;
  course.reach = (1 + ROUNDING) * s.radius[i] + (course.widen - stray);
  if (!are_bodies_ && rows_.status(i) == Status::RESTING)
    course.most =
        std::min(course.most, Screen::range(s.radius[i]) / (course.widen + aspi_length(course.v)));
  for (size_t m = 0; m < setup_.shapes.size(); m++)
    course.most = setup_.shapes[m].shape->clear(course, faces(s, i, m));
  course.most *= 1 - ROUNDING;
  return course.most < SOON ? 0 : static_cast<int>(course.most);
}

/* ---- screens ---- */

/* Makes one for a slow particle. */
Ahead::Screened Ahead::screen(const Spheres &s, int i, Screen &made) const {
  const double way = s.dt * aspi_length(s.v + 3 * static_cast<size_t>(i)) + travel_;
  if (are_bodies_ || way > SLOW_SHARE * Screen::range(s.radius[i]))
    return Screened::NONE;
  made = Screen(s, i);
  for (size_t m = 0; m < setup_.shapes.size(); m++)
    if (!made.add(setup_, m, faces(s, i, m)))
      return Screened::NONE;
  return made.holds(setup_, s, travel_) ? Screened::HOLDS : Screened::FAILS;
}

/* Lists those whose screens do not hold, nor new ones. One that is free and has nothing near is
 * predicted. */
void Ahead::check_screens(const Spheres &s, int number, std::vector<Candidate> &near) {
  for (size_t k = 0; k < screens_.size();) {
    Screen &one = screens_[k];
    const int i = one.i;
    bool holds = false;
    if (due_[i] == SCREENED) {
      Screened now = one.holds(setup_, s, travel_) ? Screened::HOLDS : Screened::NONE;
      if (now == Screened::NONE && (!one.is_empty() || rows_.status(i) == Status::RESTING))
        now = screen(s, i, one);
      holds = now == Screened::HOLDS;
      if (!holds)
        due_[i] = now == Screened::NONE ? 0 : -(now_ + SEARCHES);
      if (now == Screened::FAILS)
        near.push_back(Candidate{i, number});
    }
    if (holds) {
      note_velocity(s, i); /* by which its block is checked, too */
      k++;
    } else {
      one = screens_.back();
      screens_.pop_back();
    }
  }
}
