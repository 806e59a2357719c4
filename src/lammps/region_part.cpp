/* A part of a region, and its motion; see region_part.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "region_part.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "contact/vector.h"
#include "region.h"

using namespace LAMMPS_NS;

namespace {

/* Faces of one part, at most. */
const int FACES = 64;

/* The least relative speed of a path, as a share of the speeds: of one that rides on a part. */
const double LEAST = 1e-3;

/* The axis of a region's turn is protected in it. */
class AxisOf : public Region {
public:
  static void read(const Region *region, double origin[3], double axis[3]) {
    aspi_copy(region->*(&AxisOf::point), origin);
    aspi_copy(region->*(&AxisOf::runit), axis);
  }
};

} // namespace

RegionPart::RegionPart(Region *region, int number)
    : region_(region), number_(number), moves_(region->moveflag || region->rotateflag), origin_(),
      axis_(), before_(), now_(), rate_(), last_rate_(), dt_(0), has_rate_(false),
      has_last_(false) {
  if (region->rotateflag)
    AxisOf::read(region, origin_, axis_);
}

void RegionPart::settle() {
  now_ = RegionPose{{region_->dx, region_->dy, region_->dz}, region_->theta};
  before_ = now_;
  frame_ = begin_ = end_ = frame_at(1);
}

void RegionPart::advance(double dt) {
  dt_ = dt;
  before_ = now_;
  now_ = RegionPose{{region_->dx, region_->dy, region_->dz}, region_->theta};
  last_rate_ = rate_;
  has_last_ = has_rate_;
  has_rate_ = true;
  for (int d = 0; d < 3; d++)
    rate_.shift[d] = (now_.shift[d] - before_.shift[d]) / dt;
  rate_.angle = (now_.angle - before_.angle) / dt;
  begin_ = end_;
  frame_ = end_ = frame_at(1);
}

void RegionPart::set_rate(const RegionPose &rate) {
  rate_ = rate;
  has_rate_ = true;
}

double RegionPart::travel(const double lo[3], const double hi[3]) const {
  double most = 0;
  for (int corner = 0; corner < 8; corner++) {
    double x[3], v[3];
    for (int d = 0; d < 3; d++)
      x[d] = corner >> d & 1 ? hi[d] : lo[d];
    for (double share : {0.0, 1.0}) {
      velocity(share, x, v);
      most = std::max(most, dt_ * aspi_length(v));
    }
  }
  return most;
}

double RegionPart::turn_speed() const {
  return region_->rotateflag ? fabs(rate_.angle) : 0;
}

/* The way from one end of the step to the other, as the part sees it, and what turns it. */
double RegionPart::fastest(const asperity::Path &path, double most) const {
  double from[3], to[3];
  if (!moves_)
    return aspi_length(path.v);
  if (path.left < path.dt)
    return most;
  aspi_add_scaled(path.x, path.left, path.v, to);
  begin_.to_local(path.x, from);
  end_.to_local(to, to);
  aspi_subtract(to, from, to);
  return aspi_length(to) / path.left + 2 * turn_speed() * path.left * most + LEAST * most;
}

RegionPose RegionPart::pose(double share) const {
  if (share >= 1)
    return now_;
  RegionPose pose;
  for (int d = 0; d < 3; d++)
    pose.shift[d] = before_.shift[d] + share * (now_.shift[d] - before_.shift[d]);
  pose.angle = before_.angle + share * (now_.angle - before_.angle);
  return pose;
}

/* Rodrigues, about the axis through the origin; then the displacement. */
asperity::Frame RegionPart::frame_at(double share) const {
  asperity::Frame frame;
  const RegionPose now = pose(share);
  if (region_->rotateflag) {
    const double c = cos(now.angle), s = sin(now.angle);
    for (int i = 0; i < 3; i++) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      frame.turn[i][i] = c + (1 - c) * axis_[i] * axis_[i];
      frame.turn[i][j] = (1 - c) * axis_[i] * axis_[j] - s * axis_[k];
      frame.turn[i][k] = (1 - c) * axis_[i] * axis_[k] + s * axis_[j];
    }
    for (int i = 0; i < 3; i++)
      frame.shift[i] = origin_[i] - aspi_dot(frame.turn[i], origin_);
  }
  if (region_->moveflag)
    aspi_add_scaled(frame.shift, 1, now.shift, frame.shift);
  return frame;
}

/* Most searches ask for the beginning and the end of the step. */
void RegionPart::set_share(double share) const {
  if (moves_)
    frame_ = share >= 1 ? end_ : share > 0 ? frame_at(share) : begin_;
}

void RegionPart::to_world(double share, double x[3]) const {
  frame_at(share).to_world(x, x);
}

void RegionPart::turn_vector(double share, double vector[3]) const {
  asperity::Frame frame = frame_at(share);
  frame.shift[0] = frame.shift[1] = frame.shift[2] = 0;
  frame.to_world(vector, vector);
}

void RegionPart::turn(double share, double axes[3][3], double omega[3]) const {
  for (int d = 0; d < 3; d++)
    omega[d] = region_->rotateflag ? rate_at(1).angle * axis_[d] : 0;
  asperity::Frame begin = frame_at(share);
  begin.shift[0] = begin.shift[1] = begin.shift[2] = 0;
  for (int k = 0; k < 3; k++) {
    begin.to_local(axes[k], axes[k]);
    turn_vector(1, axes[k]);
  }
}

void RegionPart::to_local(double share, double x[3]) const {
  frame_at(share).to_local(x, x);
}

/* ---- faces ------------------------------------------------------------------------------------
 */

bool RegionPart::has(const double x[3]) const {
  double at[3];
  aspi_copy(x, at);
  if (moves_)
    frame_.to_local(x, at);
  return region_->inside(at[0], at[1], at[2]);
}

/* LAMMPS reports only the side of a region on which the point is. */
void RegionPart::add_feet(const double x[3], double reach, std::vector<RegionFoot> &feet) const {
  double at[3];
  aspi_copy(x, at);
  if (moves_)
    frame_.to_local(x, at);
  int n = region_->surface_interior(at, reach);
  const bool inside = n > 0;
  if (!inside)
    n = region_->surface_exterior(at, reach);
  for (int i = 0; i < n; i++) {
    const Region::Contact &c = region_->contact[i];
    RegionFoot foot = RegionFoot();
    const double away[3] = {c.delx, c.dely, c.delz};
    foot.distance = c.r;
    for (int d = 0; d < 3 && c.r > 0; d++)
      foot.n[d] = (region_->rotateflag ? aspi_dot(frame_.turn[d], away) : away[d]) / c.r;
    if (inside && c.radius < 0)
      foot.hollow = -c.radius / (strcmp(region_->style, "sphere") == 0 ? 1 : 2);
    foot.inside = inside;
    foot.behind = !(foot.hollow > 0) && (inside || !region_->openflag);
    foot.part = number_;
    foot.face = FACES * number_ + c.iwall;
    feet.push_back(foot);
  }
}

void RegionPart::velocity_by(const RegionPose &rate, double share, const double x[3],
                             double v[3]) const {
  v[0] = v[1] = v[2] = 0;
  if (region_->rotateflag) {
    double arm[3];
    aspi_subtract(x, origin_, arm);
    if (region_->moveflag)
      aspi_subtract(arm, pose(share).shift, arm);
    aspi_cross(axis_, arm, v);
    aspi_scale(rate.angle, v);
  }
  if (region_->moveflag)
    aspi_add_scaled(v, 1, rate.shift, v);
}

/* A stored rate is the mean over a step, valid at its middle. Within the step it is extrapolated
 * from the last change. */
RegionPose RegionPart::rate_at(double share) const {
  RegionPose then = rate_;
  const double on = has_last_ ? share - 0.5 : 0;
  for (int d = 0; d < 3; d++)
    then.shift[d] += on * (rate_.shift[d] - last_rate_.shift[d]);
  then.angle += on * (rate_.angle - last_rate_.angle);
  return then;
}

void RegionPart::velocity(double share, const double x[3], double v[3]) const {
  velocity_by(rate_at(share), share, x, v);
}

/* The axis moves with the region, so that dV/dt at a fixed point has the part -omega x shift'. */
void RegionPart::acceleration(double share, const double x[3], const double v[3],
                              double a[3]) const {
  const RegionPose rate = rate_at(share);
  RegionPose change = RegionPose();
  for (int d = 0; d < 3 && has_last_; d++)
    change.shift[d] = (rate_.shift[d] - last_rate_.shift[d]) / dt_;
  if (has_last_)
    change.angle = (rate_.angle - last_rate_.angle) / dt_;
  velocity_by(change, share, x, a);
  if (!region_->rotateflag)
    return;
  double now[3], swept[3], turned[3];
  velocity_by(rate, share, x, now);
  for (int d = 0; d < 3; d++)
    swept[d] = 2 * v[d] - now[d] - (region_->moveflag ? rate.shift[d] : 0);
  aspi_cross(axis_, swept, turned);
  aspi_add_scaled(a, rate.angle, turned, a);
}
