/* The first contacts of a mover on the rest of its path.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

typedef std::vector<Wall *> Walls;

/* The path of a sphere of a body is straight if it is off by less than this share of the radius. */
const double STRAIGHT = 2e-6;

} // namespace

/* The first contact of one sphere in this stretch, before that of other spheres. An edge is met at
 * one instant by all that share it: the contact is that of the first wall and shape. wider: by how
 * much the sphere may be off its path. */
static bool find_first(const Walls &walls, const Flight &flight, size_t sphere, double wider,
                       double latest, Touch &touch) {
  const BodySphere &one = flight.mover.sphere[sphere];
  const double same = 2 * TOUCHING * one.radius;
  touch.wall = NULL;
  touch.sphere = sphere;
  touch.before = flight.path_of(sphere);
  for (Wall *wall : walls) {
    if (!(one.mask & wall->setup.groupbit) ||
        (!flight.searches_all && !wall->grains.ahead.is_near(flight.mover.i)))
      continue;
    for (size_t m = 0; m < wall->setup.shapes.size(); m++) {
      Contact other;
      if (!wall->setup.shapes[m].shape->find(touch.before, one.radius + wider,
                                             touch.wall ? touch.time : latest, other))
        continue;
      if (touch.wall && !((touch.time - other.time) * other.approach_speed > same))
        continue;
      touch.wall = wall;
      touch.shape = m;
      static_cast<Contact &>(touch) = other;
    }
  }
  return touch.wall;
}

/* The first contacts in a stretch, one of each sphere and all at one instant. */
static bool search(const Walls &walls, const Flight &flight, double wider,
                   std::vector<Touch> &touches) {
  const double speed = aspi_length(flight.path.v);
  double first = flight.stretch;
  touches.clear();
  for (size_t k = 0; k < flight.mover.count; k++) {
    Touch touch;
    const double radius = flight.mover.sphere[k].radius;
    const double slack = touches.empty() || !(speed > 0) ? 0 : AT_ONCE * radius / speed;
    if (!find_first(walls, flight, k, wider, std::min(flight.stretch, first + slack), touch))
      continue;
    const double time = touch.time;
    if (touches.empty() || time < first) {
      const auto is_later = [&](const Touch &one) { return one.time > time + slack; };
      touches.erase(std::remove_if(touches.begin(), touches.end(), is_later), touches.end());
      first = time;
    }
    touches.push_back(touch);
  }
  if (touches.size() > 1)
    std::stable_sort(touches.begin(), touches.end(),
                     [](const Touch &one, const Touch &other) { return one.time < other.time; });
  return !touches.empty();
}

/* For which time no wall is in reach of a body, however it turns. */
static double time_clear(const Walls &walls, const Flight &flight) {
  const Body &body = *flight.mover.body;
  Course course;
  course.widen = 0;
  course.least = flight.stretch / flight.dt;
  course.most = flight.path.left / flight.dt;
  aspi_copy(flight.path.x, course.x);
  aspi_copy(flight.path.v, course.v);
  aspi_scale(flight.dt, course.v);
  for (const Wall *wall : walls)
    for (const Member &member : wall->setup.shapes) {
      course.reach = (1 + ROUNDING) * body.reach + member.shape->travel(flight.dt);
      course.most = member.shape->clear(course, FaceList());
    }
  return course.most * flight.dt;
}

bool asperity::find_next(const Walls &walls, Flight &flight, std::vector<Touch> &touches) {
  const double radius = flight.mover.sphere->radius, farthest = flight.farthest();
  double angle = TURN;
  touches.clear();
  while (flight.path.left > 0) {
    flight.aim(angle);
    if (flight.stretch < flight.path.left) {
      const double clear = time_clear(walls, flight);
      if (clear > flight.stretch) {
        flight.way +=
            clear * (aspi_length(flight.path.v) + farthest * aspi_length(flight.spin)) / radius;
        flight.leap(clear);
        continue;
      }
    }
    const double turns = flight.stretch * aspi_length(flight.turning);
    const double bulge = farthest * turns * turns / 8;
    const bool is_straight = !(bulge > STRAIGHT * radius);
    if (search(walls, flight, is_straight ? 0 : bulge, touches)) {
      if (is_straight)
        return true;
      angle = std::min(angle, turns) / 4;
      continue;
    }
    if (!(flight.stretch < flight.path.left))
      return false;
    flight.way += (flight.stretch * aspi_length(flight.path.v) + farthest * turns) / radius;
    flight.go_on(flight.stretch);
    angle = std::min(TURN, 2 * angle);
  }
  return false;
}
