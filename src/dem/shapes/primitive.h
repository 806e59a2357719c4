/* Planes and cylinders as walls. Either may move along itself.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <math.h>
#include <memory>
#include <string>

#include "contact/tolerances.h"
#include "contact/vector.h"
#include "dem/shapes/shape.h"
#include "dem/text.h"

namespace asperity {

/* The plane x[axis] = at, axis 0 to 2, met from both sides, which slides with a velocity along
 * itself.
 */
class PlaneShape : public Shape {
public:
  PlaneShape(int axis, double at, const double velocity[3]);
  bool is_across(const double direction[3]) const override {
    double n[3] = {0, 0, 0};
    n[axis_] = 1;
    return are_parallel(direction, n);
  }
  double clear(const Course &course, const FaceList &stays) const override;
  bool separate(const double x[3], double reach, const FaceList &stays,
                BarrierList &made) const override;
  bool repeats(int axis) const override {
    return axis != axis_;
  }
  bool bars(int axis) const override {
    return !repeats(axis);
  }
  bool find(const Path &path, double radius, double latest, Contact &contact) const override;
  bool under(int face, const double x[3], const double v[3], double reach, Contact &at,
             double &distance) const override;
  bool is_still() const override {
    return !(aspi_dot(v_, v_) > 0);
  }
  void carry(Place &place, double radius, double dt, double x[3], double v[3]) const override;

private:
  int axis_;
  double at_, v_[3];
};

/* A cylinder of infinite length around an axis parallel to a coordinate axis, through `center`
 * (whose component along the axis is not used), met from inside or outside. It slides along its
 * axis with `along`, or turns about it with `turn` (rad/time). */
class CylinderShape : public Shape {
public:
  CylinderShape(int axis, const double center[3], double radius, double along, double turn);
  double clear(const Course &course, const FaceList &stays) const override;
  bool separate(const double x[3], double reach, const FaceList &stays,
                BarrierList &made) const override;
  double gap(const Barriers &all, const double from[3], const double to[3],
             double radius) const override;
  bool repeats(int axis) const override {
    return axis == axis_;
  }
  bool bars(int axis) const override {
    return !repeats(axis);
  }
  bool find(const Path &path, double radius, double latest, Contact &contact) const override;
  bool under(int face, const double x[3], const double v[3], double reach, Contact &at,
             double &distance) const override;
  bool is_still() const override {
    return !(fabs(along_) > 0) && !(fabs(turn_) > 0);
  }
  void carry(Place &place, double radius, double dt, double x[3], double v[3]) const override;
  void turn(const Place &place, double share, double dt, double axes[3][3],
            double omega[3]) const override;
  asp_lay_kind lay_kind() const override {
    return ASP_LAY_ANGLE;
  }
  void lay(const asp_lay &lay, const Path &path, const Contact &contact,
           double direction[3]) const override;

private:
  void velocity(const double x[3], double v[3]) const;
  double axis_distance(const double x[3]) const;

  int axis_;
  double center_[3], radius_, along_, turn_;
};

/* Reads `xplane C`, `yplane C`, `zplane C`, or `xcylinder R Y Z` (`ycylinder R Z X`, `zcylinder R X
 * Y`), and behind it, where it is there, `shear x|y|z V`: along the wall with the speed V, or, of a
 * cylinder across its axis, about the axis with the angular velocity V. `geometry` becomes what was
 * read, equal for equal walls. Throws an Error. */
std::unique_ptr<Shape> read_primitive(Words &words, std::string &geometry);

} // namespace asperity
