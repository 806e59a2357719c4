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

/* A particle that comes to a wall within so many steps is near: they are not worth another look. */
const double SOON = 2;

/* A particle that is near, not counting faces at which it stays, counts as near for this many
 * steps. */
const int STAYS_NEAR = 32;

/* A path of so many radii in a step is none: the engine has blown up. */
const double FARTHEST = 1e9;

/* Particles are screened in blocks of this many. */
const int BLOCK = 32;

/* Longest prediction, in steps. */
const double AHEAD_MOST = 2048;

/* A particle that rests looks this many radii ahead: many triangles are near. */
const double RESTING_WAY = 0.25;

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
    : setup_(setup), rows_(rows), are_bodies_(are_bodies), now_(0), travel_(0) {}

double Ahead::bend(double radius) {
  return BEND * radius;
}

void Ahead::watch(int i) {
  due_[i] = -(now_ + STAYS_NEAR);
}

void Ahead::clear() {
  now_ = 0;
  std::fill(due_.begin(), due_.end(), 0);
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
    if (tag_[i] == tag && (stray_[i] < INFINITY || rows_.is_stuck(static_cast<int>(i))))
      continue;
    tag_[i] = tag;
    due_[i] = 0;
  }
}

size_t Ahead::bytes() const {
  return due_.capacity() * sizeof(int) + tag_.capacity() * sizeof(int64_t) +
         (v_.capacity() + stray_.capacity() + least_.capacity()) * sizeof(float);
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
 * does; a narrow one is left as soon as forces act. What is stuck has none. */
float Ahead::stray(const Spheres &s, int i) const {
  if (rows_.is_stuck(i))
    return INFINITY;
  const size_t at = 3 * static_cast<size_t>(i);
  const double most = STRAY_MOST * s.radius[i] / s.dt;
  if (are_bodies_ || rows_.status(i) == Status::RESTING)
    return static_cast<float>(most);
  const double pushed = sqrt(aspi_length(s.f + at) / s.mass[i] * s.radius[i]);
  return static_cast<float>(std::min(most, STRAY * aspi_length(s.v + at) + pushed));
}

/* Most particles have a valid prediction that they are too far away; it holds while their velocity
 * stays near the predicted one. A block is screened by what its particles may stray at least. */
void Ahead::find_near(const Spheres &s, int number, std::vector<Candidate> &near) {
  double travel = 0;
  for (const Member &member : setup_.shapes)
    travel = std::max(travel, member.shape->travel(s.dt));
  if (travel > travel_) {
    travel_ = FASTER * travel;
    clear();
  }
  if (now_ > INT_MAX / 2)
    clear(); /* before the count of steps could overflow */
  now_++;
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

/* Makes a new prediction when the old one has expired; true if the particle may touch in this step.
 * (A prediction widens by the allowed stray distance in every step, so no particle may stray
 * farther in any of them: another particle could throw it back to the wall earlier.) */
bool Ahead::look(const Spheres &s, int i) {
  const double *v = s.v + 3 * static_cast<size_t>(i);
  float *along = &v_[3 * static_cast<size_t>(i)];
  int *due = &due_[i];
  if (*due < 0 && now_ < -*due)
    return true;
  const bool out = !(s.mask[i] & setup_.groupbit) || rows_.is_stuck(i);
  if (!out && !(aspi_length(v) * s.dt <= FARTHEST * s.radius[i]))
    throw Error(
        text("the velocity of particle %lld is %g %g %g, by which it moves over %g radii in "
             "a step; a force or the time step is far too large",
             static_cast<long long>(s.tag_of(i)), v[0], v[1], v[2], FARTHEST));
  for (int d = 0; d < 3; d++)
    along[d] = static_cast<float>(v[d]);
  stray_[static_cast<size_t>(i)] = stray(s, i);
  *due = out ? NEVER : now_ + steps_clear(s, i);
  if (*due > now_)
    return false;
  *due = -(now_ + STAYS_NEAR);
  return true;
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
  course.widen = stray + bend(s.radius[i]) + FLT_EPSILON * aspi_length(course.v) + travel_;
  course.reach = (1 + ROUNDING) * s.radius[i] + (course.widen - stray);
  if (!are_bodies_ && rows_.status(i) == Status::RESTING)
    course.most =
        std::min(course.most, RESTING_WAY * s.radius[i] / (course.widen + aspi_length(course.v)));
  for (size_t m = 0; m < setup_.shapes.size(); m++)
    course.most = setup_.shapes[m].shape->clear(course, faces(s, i, m));
  course.most *= 1 - ROUNDING;
  return course.most < SOON ? 0 : static_cast<int>(course.most);
}
