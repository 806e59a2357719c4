/* Predicts the earliest step in which a particle can meet a wall. Most particles are too far away
 * for many steps and are skipped until then.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/wall.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

/* Ahead::due of a particle that is stuck, or not of the group: never near. */
const int NEVER = INT_MAX;

/* A particle that stays at faces and is near others counts as near for this many steps. */
const int STAYS_NEAR = 32;

/* Particles are screened in blocks of this many. */
const int BLOCK = 32;

/* Longest prediction, in steps. */
const double AHEAD_MOST = 512;

/* Less than 1/sqrt(3): the length of a vector whose components are no larger is below 1. */
const double COMPONENT = 0.577;

} // namespace

void Wall::look_anew() {
  ahead_.now = 0;
  std::fill(ahead_.due.begin(), ahead_.due.end(), 0);
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

/* Lists the particles that may touch this wall in this step. Most have a valid prediction that they
 * are too far away; it holds while their velocity stays near the predicted one. */
void Wall::find_near(const Spheres &s, int number, std::vector<Near> &near) {
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
      if ((due[i] <= ahead_.now || any_strays(v + 3 * i, along + 3 * i, 3, most)) &&
          look_ahead(s, first + i))
        near.push_back(Near{first + i, number});
  }
}

/* The faces of a shape at which a particle stayed in the step before. */
Faces Wall::faces(int i, size_t shape) const {
  Faces faces = {0, {0, 0, 0}};
  const RestingPlace &at = place(i).resting;
  for (size_t k = 0; status(i) == Status::RESTED && k < at.FACES && at.shape[k] > 0; k++)
    if (static_cast<size_t>(at.shape[k]) == shape + 1)
      faces.face[faces.count++] = static_cast<int>(at.face[k]);
  return faces;
}

/* Makes a new prediction when the old one has expired; true if the particle may touch in this step.
 * (A prediction widens by the allowed stray distance in every step, so no particle may stray
 * farther in any of them: another particle could throw it back to the wall earlier.) */
bool Wall::look_ahead(const Spheres &s, int i) {
  const double *v = s.v + 3 * static_cast<size_t>(i);
  float *along = &ahead_.v[3 * static_cast<size_t>(i)];
  int *due = &ahead_.due[i];
  if (*due < 0 && ahead_.now < -*due)
    return false;
  const bool out = !(s.mask[i] & groupbit_) || is_stuck(i);
  for (int d = 0; d < 3; d++)
    along[d] = static_cast<float>(v[d]);
  *due = out ? NEVER : ahead_.now + steps_clear(s, i);
  if (*due > ahead_.now)
    return false;
  if (status(i) == Status::RESTED)
    *due = -(ahead_.now + STAYS_NEAR);
  return true;
}

/* Number of steps, with this one, in which a particle cannot touch the wall if it keeps its
 * velocity within the allowed stray distance; 0 if it may touch in this one. Straying is measured
 * in single precision. */
int Wall::steps_clear(const Spheres &s, int i) const {
  const double *x = s.x + 3 * static_cast<size_t>(i), *v = s.v + 3 * static_cast<size_t>(i);
  double begin[3], by[3], steps = AHEAD_MOST;
  for (int d = 0; d < 3; d++) {
    by[d] = v[d] * s.dt;
    begin[d] = x[d] - by[d];
  }
  const double widen = stray_ + bend_ + FLT_EPSILON * aspi_length(by) + travel_;
  const double reach = (1 + ROUNDING) * s.radius[i] + widen;
  for (size_t m = 0; m < shapes_.size(); m++)
    steps = std::min(steps, shapes_[m].shape->clear(begin, by, reach, widen, steps, faces(i, m)));
  return static_cast<int>((1 - ROUNDING) * steps);
}
