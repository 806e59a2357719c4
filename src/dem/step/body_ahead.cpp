/* Predictions for bodies; see body_ahead.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/body_ahead.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/step/bodies.h"

using namespace asperity;

/* Longest prediction, in steps. */
static const double MOST = 512;

/* Distance per step by which a body may stray from its predicted way, over its size; and less than
 * 1/sqrt(3), for each component of it. */
static const double STRAY = 2e-3, COMPONENT = 0.577;

void BodyAhead::begin_step(const std::vector<Stepper *> &walls, size_t n, double dt) {
  double drift = 0;
  for (const Stepper *wall : walls)
    for (const Member &member : wall->setup.shapes)
      drift = std::max(drift, member.shape->travel(dt));
  now_++;
  if (drift > drift_) {
    drift_ = 2 * drift;
    of_.clear();
  }
  of_.resize(n, Course{-1, 0, 0, {0, 0, 0}, {0, 0, 0}, 0});
}

bool BodyAhead::is_near(const std::vector<Stepper *> &walls, size_t number, const Body &body,
                        const BodySphere *spheres, double dt) {
  Course &of = of_[number];
  const double steps = static_cast<double>(now_ - of.from), most = COMPONENT * steps * of.stray;
  bool strays = of.tag != body.tag;
  for (int d = 0; d < 3; d++)
    strays = strays || !(fabs(body.x[d] - of.x[d] - steps * of.v[d]) <= most);
  if (!strays && now_ < of.due)
    return false;
  double size = 0;
  for (size_t k = body.first; k < body.first + body.count; k++)
    size = std::max(size, aspi_length(spheres[k].arm) + spheres[k].radius);
  asperity::Course course;
  aspi_copy(body.v, of.v);
  aspi_scale(dt, of.v);
  aspi_subtract(body.x, of.v, of.x);
  of.tag = body.tag;
  of.from = now_ - 1;
  of.stray = STRAY * size;
  aspi_copy(of.x, course.x);
  aspi_copy(of.v, course.v);
  course.most = MOST;
  course.widen = of.stray + drift_;
  course.reach = (1 + ROUNDING) * size + course.widen;
  const FaceList none = {0, {0, 0, 0}};
  for (const Stepper *wall : walls)
    for (const Member &member : wall->setup.shapes)
      course.most = course.most < 1 ? 0 : member.shape->clear(course, Twist(), none);
  of.due = now_ + static_cast<int64_t>((1 - ROUNDING) * course.most);
  return of.due <= now_;
}
