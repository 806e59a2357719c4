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

namespace {

ContactPath contact_path(const Path &path) {
  ContactPath p;
  aspi_copy(path.x, p.x);
  aspi_copy(path.v, p.v);
  p.left = path.left;
  return p;
}

void take_over(const ContactTouch &touch, const Path &path, Contact &contact) {
  contact.time = touch.time;
  contact.overlapped = touch.overlapped;
  contact.piece = contact.face = 0;
  contact.follow = contact.curve = contact.chord = 0;
  contact.approach_speed = -aspi_dot(path.v, touch.n);
  aspi_copy(touch.n, contact.n);
  aspi_copy(touch.n, contact.n_end);
  aspi_add_scaled(path.x, touch.time, path.v, contact.x);
  aspi_add_scaled(contact.x, touch.overlap, touch.n, contact.x);
}

} // namespace

PlaneShape::PlaneShape(int axis, double at, const double velocity[3]) {
  plane_.axis = axis;
  plane_.at = at;
  aspi_copy(velocity, v_);
}

double PlaneShape::clear(const Course &course, const FaceList &stays) const {
  if (stays.count > 0)
    return course.most;
  const double off = course.x[plane_.axis] - plane_.at, gap = fabs(off) - course.reach;
  const double closing = course.widen + (off > 0 ? -course.v[plane_.axis] : course.v[plane_.axis]);
  return !(gap > 0) ? 0 : closing * course.most > gap ? gap / closing : course.most;
}

bool PlaneShape::find(const Path &path, double radius, double latest, Contact &contact) const {
  ContactTouch touch;
  const ContactPath p = contact_path(path);
  if (!aspi_plane_find(&plane_, &p, radius, latest, &touch))
    return false;
  take_over(touch, path, contact);
  aspi_copy(v_, contact.v_wall);
  return true;
}

bool PlaneShape::under(int face, const double x[3], const double[3], double reach, Contact &at,
                       double &distance) const {
  const double off = x[plane_.axis] - plane_.at;
  at.face = face;
  at.n[plane_.axis] = off < 0 ? -1 : 1;
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
    : along_(along), turn_(turn) {
  cylinder_.axis = axis;
  cylinder_.radius = radius;
  aspi_copy(center, cylinder_.center);
  cylinder_.center[axis] = 0;
}

double CylinderShape::clear(const Course &course, const FaceList &) const {
  double v[3];
  aspi_copy(course.v, v);
  v[cylinder_.axis] = 0;
  const double gap = fabs(axis_distance(course.x) - cylinder_.radius) - course.reach;
  const double closing = course.widen + aspi_length(v);
  return !(gap > 0) ? 0 : closing * course.most > gap ? gap / closing : course.most;
}

/* Wall velocity at the particle's center, so that a wall that turns carries all sizes at one
 * angular speed. */
void CylinderShape::velocity(const double x[3], double v[3]) const {
  double axis[3] = {0, 0, 0}, arm[3];
  axis[cylinder_.axis] = 1;
  aspi_subtract(x, cylinder_.center, arm);
  aspi_cross(axis, arm, v);
  aspi_scale(turn_, v);
  v[cylinder_.axis] = along_;
}

bool CylinderShape::find(const Path &path, double radius, double latest, Contact &contact) const {
  ContactTouch touch;
  const ContactPath p = contact_path(path);
  if (!aspi_cylinder_find(&cylinder_, &p, radius, latest, &touch))
    return false;
  take_over(touch, path, contact);
  velocity(contact.x, contact.v_wall);
  const double distance = axis_distance(contact.x);
  if (!(distance > 0 && distance < cylinder_.radius))
    return true; /* a path along the outside does not come into the wall */
  double axis[3] = {0, 0, 0}, around[3];
  axis[cylinder_.axis] = 1;
  aspi_cross(axis, contact.n, around);
  const double speed = aspi_dot(path.v, around);
  contact.curve = speed * speed / distance;
  contact.chord = chord_speed(contact.curve, fabs(speed), path.left - touch.time);
  contact.approach_speed += contact.chord;
  return true;
}

double CylinderShape::axis_distance(const double x[3]) const {
  double arm[3];
  aspi_subtract(x, cylinder_.center, arm);
  arm[cylinder_.axis] = 0;
  return aspi_length(arm);
}

bool CylinderShape::under(int face, const double x[3], const double v[3], double reach, Contact &at,
                          double &distance) const {
  at.face = face;
  const double off = axis_distance(x), side = off < cylinder_.radius ? -1 : 1;
  aspi_subtract(x, cylinder_.center, at.n);
  at.n[cylinder_.axis] = 0;
  aspi_scale(side / off, at.n);
  velocity(x, at.v_wall);
  const double along = v[cylinder_.axis];
  distance = fabs(off - cylinder_.radius);
  if (side < 0)
    at.curve = (aspi_dot(v, v) - along * along) / off;
  return off > 0 && distance <= reach;
}

void CylinderShape::carry(Place &place, double, double dt, double x[3], double v[3]) const {
  const int a = (cylinder_.axis + 1) % 3, b = (cylinder_.axis + 2) % 3;
  const double c = cos(turn_ * dt), s = sin(turn_ * dt);
  const double p = place.at[a] - cylinder_.center[a], q = place.at[b] - cylinder_.center[b];
  place.at[a] = cylinder_.center[a] + (c * p - s * q);
  place.at[b] = cylinder_.center[b] + (s * p + c * q);
  place.at[cylinder_.axis] += along_ * dt;
  aspi_copy(place.at, x);
  velocity(x, v);
}

void CylinderShape::turn(const Place &, double share, double dt, double axes[3][3],
                         double omega[3]) const {
  const int a = (cylinder_.axis + 1) % 3, b = (cylinder_.axis + 2) % 3;
  const double angle = turn_ * (1 - share) * dt, c = cos(angle), s = sin(angle);
  for (int k = 0; k < 3; k++) {
    const double p = axes[k][a], q = axes[k][b];
    axes[k][a] = c * p - s * q;
    axes[k][b] = s * p + c * q;
  }
  omega[a] = omega[b] = 0;
  omega[cylinder_.axis] = turn_;
}

/* On a cylinder the lay is a helix with a fixed angle to the axis, so a turning wall does not
 * change it. */
void CylinderShape::lay(const asp_lay &lay, const Path &, const Contact &contact,
                        double direction[3]) const {
  double axis[3] = {0, 0, 0}, around[3];
  axis[cylinder_.axis] = 1;
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
