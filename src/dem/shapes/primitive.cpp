/* Planes and cylinders as walls; see primitive.h. A wall moves only along itself, so its surface
 * stays in place and paths are searched without a moving frame.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/shapes/primitive.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

/* The contact of a path at a time, of a sphere that overlaps by so much along n. */
static void fill(const Path &path, double time, const double n[3], double overlap,
                 Contact &contact) {
  contact.time = time;
  contact.overlapped = overlap > 0;
  contact.piece = contact.face = 0;
  contact.follow = contact.curve = contact.chord = 0;
  contact.approach_speed = -aspi_dot(path.v, n);
  aspi_copy(n, contact.n);
  aspi_copy(n, contact.n_end);
  aspi_add_scaled(path.x, time, path.v, contact.x);
  aspi_add_scaled(contact.x, overlap, n, contact.x);
}

PlaneShape::PlaneShape(int axis, double at, const double velocity[3]) : axis_(axis), at_(at) {
  aspi_copy(velocity, v_);
}

double PlaneShape::clear(const Course &course, const FaceList &stays) const {
  if (stays.count > 0)
    return course.most;
  const double off = course.x[axis_] - at_, gap = fabs(off) - course.reach;
  const double closing = course.widen + (off > 0 ? -course.v[axis_] : course.v[axis_]);
  return !(gap > 0) ? 0 : closing * course.most > gap ? gap / closing : course.most;
}

bool PlaneShape::separate(const double x[3], double reach, const FaceList &stays,
                          BarrierList &made) const {
  const double off = x[axis_] - at_;
  if (stays.count > 0 || fabs(off) > reach)
    return true;
  Barrier *barrier = made.add();
  if (!barrier)
    return false;
  barrier->n[axis_] = off < 0 ? -1 : 1;
  barrier->at = barrier->n[axis_] * at_;
  return true;
}

/* The side of a center on the plane is the one that it comes from. */
bool PlaneShape::find(const Path &path, double radius, double latest, Contact &contact) const {
  const double off = path.x[axis_] - at_, v = path.v[axis_], gap = fabs(off) - radius;
  const bool centered = fabs(off) <= SUM_ROUNDING * radius;
  const double side = centered ? (v > 0 ? -1 : 1) : off > 0 ? 1 : -1, approach = -side * v;
  if (!(approach > APPROACH * aspi_length(path.v)))
    return false;
  const double time = gap > 0 ? gap / approach : 0;
  if (!(time <= latest))
    return false;
  double n[3] = {0, 0, 0};
  n[axis_] = side;
  fill(path, time, n, gap < -TOUCHING * radius ? -gap : 0, contact);
  contact.overlapped = contact.overlapped || centered;
  aspi_copy(v_, contact.v_wall);
  return true;
}

bool PlaneShape::under(int face, const double x[3], const double[3], double reach, Contact &at,
                       double &distance) const {
  const double off = x[axis_] - at_;
  at.face = face;
  at.n[axis_] = off < 0 ? -1 : 1;
  aspi_copy(v_, at.v_wall);
  distance = fabs(off);
  return distance <= reach;
}

void PlaneShape::carry(Place &place, double, double dt, double x[3], double v[3]) const {
  aspi_add_scaled(place.at, dt, v_, place.at);
  aspi_copy(place.at, x);
  aspi_copy(v_, v);
}

CylinderShape::CylinderShape(int axis, const double center[3], double radius, double along,
                             double turn)
    : axis_(axis), radius_(radius), along_(along), turn_(turn) {
  aspi_copy(center, center_);
  center_[axis] = 0;
}

double CylinderShape::clear(const Course &course, const FaceList &) const {
  double v[3];
  aspi_copy(course.v, v);
  v[axis_] = 0;
  const double gap = fabs(axis_distance(course.x) - radius_) - course.reach;
  const double closing = course.widen + aspi_length(v);
  return !(gap > 0) ? 0 : closing * course.most > gap ? gap / closing : course.most;
}

/* From outside a plane along the cylinder; from inside the cylinder itself. */
bool CylinderShape::separate(const double x[3], double reach, const FaceList &,
                             BarrierList &made) const {
  const double off = axis_distance(x);
  if (fabs(off - radius_) > reach)
    return true;
  Barrier *barrier = made.add();
  if (!barrier)
    return false;
  barrier->is_ball = off < radius_;
  if (barrier->is_ball)
    return true;
  aspi_subtract(x, center_, barrier->n);
  barrier->n[axis_] = 0;
  aspi_scale(1 / off, barrier->n);
  barrier->at = aspi_dot(barrier->n, center_) + radius_;
  return true;
}

double CylinderShape::gap(const Barriers &all, const double from[3], const double to[3],
                          double radius) const {
  if (!all.first->is_ball)
    return Shape::gap(all, from, to, radius);
  return radius_ - std::max(axis_distance(from), axis_distance(to)) - apart(radius);
}

/* Wall velocity at the particle's center, so that a wall that turns carries all sizes at one
 * angular speed. */
void CylinderShape::velocity(const double x[3], double v[3]) const {
  double axis[3] = {0, 0, 0}, arm[3];
  axis[axis_] = 1;
  aspi_subtract(x, center_, arm);
  aspi_cross(axis, arm, v);
  aspi_scale(turn_, v);
  v[axis_] = along_;
}

/* The time at which the distance from the axis is `touching`. It is `distance` at first and the
 * square root of a quadratic in time; 0 if it is beyond already and moves on, infinite for never.
 * rate: half the initial growth of its square; square: of the speed, > 0. */
static double chord_time(bool inside, double distance, double touching, double rate,
                         double square) {
  const double beyond = (distance - touching) * (distance + touching);
  const double root = sqrt(fmax(0.0, rate * rate - square * beyond));
  if (inside) {
    if (rate > 0)
      return beyond < 0 ? -beyond / (rate + root) : 0;
    return (root - rate) / square;
  }
  if (rate >= 0 || (beyond > 0 && !(root > 0)))
    return HUGE_VAL;
  return beyond > 0 ? beyond / (root - rate) : 0;
}

/* A sphere that touches the inside and slides along it, with next to no normal speed, but would
 * leave the wall's curve by the end of its straight path, touches at time 0. One that is wider than
 * the cylinder is put back on the axis at the end of its path. */
bool CylinderShape::find(const Path &path, double radius, double latest, Contact &contact) const {
  double v[3], arm[3], n[3];
  aspi_copy(path.v, v);
  aspi_subtract(path.x, center_, arm);
  v[axis_] = arm[axis_] = 0;
  const double distance = aspi_length(arm), square = aspi_dot(v, v);
  const bool inside = distance < radius_;
  const double touching = inside ? fmax(0.0, radius_ - radius) : radius_ + radius;
  if (!(square > 0))
    return false;
  const double rate = aspi_dot(arm, v), speed = sqrt(square);
  const bool touches = inside && fabs(distance - touching) <= TOUCHING * radius;
  const bool wide = inside && !(touching > 0);
  double time =
      wide ? path.left : chord_time(inside, touches ? touching : distance, touching, rate, square);
  if (!(time <= latest))
    return false;
  if (touches && !wide && time < path.left && fabs(rate) <= GRAZING * speed * distance)
    time = 0;
  aspi_add_scaled(arm, time, v, n);
  if (inside)
    aspi_scale(-1, n);
  const double length = aspi_length(n), approach = -aspi_dot(v, n);
  const bool slides = inside && time < path.left && fabs(approach) <= GRAZING * speed * length;
  if (!(length > 0) || !(wide || slides || approach > APPROACH * speed * length))
    return false;
  aspi_scale(1 / length, n);
  const double overlap = inside ? length - touching : touching - length;
  fill(path, time, n, overlap > TOUCHING * radius ? overlap : 0, contact);
  velocity(contact.x, contact.v_wall);
  const double there = axis_distance(contact.x);
  if (!(there > 0 && there < radius_))
    return true; /* a path along the outside does not come into the wall */
  double axis[3] = {0, 0, 0}, around[3];
  axis[axis_] = 1;
  aspi_cross(axis, contact.n, around);
  const double along = aspi_dot(path.v, around);
  contact.curve = along * along / there;
  contact.chord = chord_speed(contact.curve, fabs(along), path.left - time);
  contact.approach_speed += contact.chord;
  return true;
}

double CylinderShape::axis_distance(const double x[3]) const {
  double arm[3];
  aspi_subtract(x, center_, arm);
  arm[axis_] = 0;
  return aspi_length(arm);
}

bool CylinderShape::under(int face, const double x[3], const double v[3], double reach, Contact &at,
                          double &distance) const {
  at.face = face;
  const double off = axis_distance(x), side = off < radius_ ? -1 : 1;
  aspi_subtract(x, center_, at.n);
  at.n[axis_] = 0;
  aspi_scale(side / off, at.n);
  velocity(x, at.v_wall);
  const double along = v[axis_];
  distance = fabs(off - radius_);
  if (side < 0)
    at.curve = (aspi_dot(v, v) - along * along) / off;
  return off > 0 && distance <= reach;
}

void CylinderShape::carry(Place &place, double, double dt, double x[3], double v[3]) const {
  const int a = (axis_ + 1) % 3, b = (axis_ + 2) % 3;
  const double c = cos(turn_ * dt), s = sin(turn_ * dt);
  const double p = place.at[a] - center_[a], q = place.at[b] - center_[b];
  place.at[a] = center_[a] + (c * p - s * q);
  place.at[b] = center_[b] + (s * p + c * q);
  place.at[axis_] += along_ * dt;
  aspi_copy(place.at, x);
  velocity(x, v);
}

void CylinderShape::turn(const Place &, double share, double dt, double axes[3][3],
                         double omega[3]) const {
  const int a = (axis_ + 1) % 3, b = (axis_ + 2) % 3;
  const double angle = turn_ * (1 - share) * dt, c = cos(angle), s = sin(angle);
  for (int k = 0; k < 3; k++) {
    const double p = axes[k][a], q = axes[k][b];
    axes[k][a] = c * p - s * q;
    axes[k][b] = s * p + c * q;
  }
  omega[a] = omega[b] = 0;
  omega[axis_] = turn_;
}

/* On a cylinder the lay is a helix with a fixed angle to the axis, so a turning wall does not
 * change it. */
void CylinderShape::lay(const asp_lay &lay, const Path &, const Contact &contact,
                        double direction[3]) const {
  double axis[3] = {0, 0, 0}, around[3];
  axis[axis_] = 1;
  aspi_cross(contact.n, axis, around);
  for (int d = 0; d < 3; d++)
    direction[d] = cos(lay.angle) * axis[d] + sin(lay.angle) * around[d];
}

std::unique_ptr<Shape> asperity::read_primitive(Words &words, std::string &geometry) {
  const std::string axes = "xyz", style = words.word("the primitive wall");
  const size_t axis = axes.find(style.empty() ? ' ' : style[0]);
  const bool plane = axis != std::string::npos && style.substr(1) == "plane";
  if (!plane && (axis == std::string::npos || style.substr(1) != "cylinder"))
    throw Error(text("primitive wall '%s' is unknown; there are: xplane yplane zplane xcylinder "
                     "ycylinder zcylinder",
                     style.c_str()));
  const int a = static_cast<int>(axis);
  const double first = words.number(plane ? "the plane's place" : "the cylinder's radius");
  double center[3] = {0, 0, 0}, velocity[3] = {0, 0, 0}, along = 0, turn = 0;
  if (!plane) {
    if (!(first > 0))
      throw Error(text("the cylinder's radius is %g; it must be > 0", first));
    const std::string what =
        text("the axis of '%s R %c %c'", style.c_str(), axes[static_cast<size_t>(a + 1) % 3],
             axes[static_cast<size_t>(a + 2) % 3]);
    for (int k = 1; k < 3; k++)
      center[(a + k) % 3] = words.number(what.c_str());
  }
  geometry = style + " " + setting(first);
  for (int k = 1; !plane && k < 3; k++)
    geometry += " " + setting(center[(a + k) % 3]);
  if (words.take("shear")) {
    const std::string name = words.word("the axis of 'shear'");
    const size_t d = name.size() == 1 ? axes.find(name) : std::string::npos;
    const double speed = words.number("the speed of 'shear'");
    if (d == std::string::npos || (plane && d == axis))
      throw Error(text("shear is along '%s'; it must be an axis, x, y or z, that lies in the wall",
                       name.c_str()));
    geometry += " shear " + name + " " + setting(speed);
    if (plane)
      velocity[d] = speed;
    else
      (d == axis ? along : turn) = speed;
  }
  if (plane)
    return std::unique_ptr<Shape>(new PlaneShape(a, first, velocity));
  return std::unique_ptr<Shape>(new CylinderShape(a, center, first, along, turn));
}
