/* A part of a region, and its motion; see region_part.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "region_part.h"

#include <math.h>
#include <string.h>
#include <algorithm>
#include <string>

#include "contact/vector.h"
#include "region.h"

using namespace LAMMPS_NS;

namespace {

/* Faces of one part, at most. */
const int FACES = 64;

/* The least relative speed of a path, as a share of the speeds: of one that rides on a part. */
const double LEAST = 1e-3;

/* An arc over its chord, at most: that of a quarter of a turn is 1.11. */
const double ARC = 1.2;

/* More than an eighth, for arcs of up to a quarter of a turn: by how much of the product of its
 * angle with its length an arc is off its chord. */
const double SAGITTA = 0.15;

/* An axis is along one of the coordinates', or a box as wide as another, within this share; and
 * LAMMPS's 1e20 is endless. */
const double ALONG = 1e-9, ENDLESS = 1e19;

/* The corners of the box of a region as it was made; false where LAMMPS sets none, or it is
 * endless, or changes. */
bool extent(const Region *region, double box[2][3]) {
  if (!region->bboxflag || region->varshape)
    return false;
  const double all[2][3] = {{region->extent_xlo, region->extent_ylo, region->extent_zlo},
                            {region->extent_xhi, region->extent_yhi, region->extent_zhi}};
  bool ends = true;
  for (int side = 0; side < 2; side++) {
    aspi_copy(all[side], box[side]);
    for (double at : all[side])
      ends = ends && fabs(at) < ENDLESS;
  }
  return ends;
}

/* True if a region is round about an axis through a point, that of one coordinate. A cylinder may
 * lie across it in the same box: then it has points near the corners. */
bool is_round_about(Region *region, const double origin[3], const double axis[3]) {
  double box[2][3], at[3];
  int along = 0;
  while (along < 2 && !(fabs(axis[along]) > 1 - ALONG))
    along++;
  const int one = (along + 1) % 3, other = (along + 2) % 3;
  const std::string style = region->style;
  if (!(fabs(axis[along]) > 1 - ALONG) || !extent(region, box) ||
      !(style == "cylinder" || style == "cone" || style == "sphere"))
    return false;
  const double wide = box[1][one] - box[0][one];
  bool is = fabs(box[1][other] - box[0][other] - wide) <= ALONG * wide;
  for (int d : {one, other})
    is = is && fabs(0.5 * (box[0][d] + box[1][d]) - origin[d]) <= ALONG * wide;
  for (double side : {0.05, 0.95}) {
    at[along] = 0.5 * (box[0][along] + box[1][along]);
    at[one] = box[0][one] + side * wide;
    at[other] = box[0][other] + 0.95 * wide;
    is = is && !region->inside(at[0], at[1], at[2]);
  }
  return is;
}

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
      axis_(), is_round_(false), pose_(), rate_(), to_come_(), has_rate_(false), dt_(0) {
  if (!region->rotateflag)
    return;
  AxisOf::read(region, origin_, axis_);
  is_round_ = is_round_about(region, origin_, axis_);
}

/* LAMMPS sets the shift only with `move`, and the angle only with `rotate`. */
RegionPart::Pose RegionPart::pose() const {
  Pose now = Pose();
  if (region_->moveflag) {
    const double shift[3] = {region_->dx, region_->dy, region_->dz};
    aspi_copy(shift, now.shift);
  }
  if (region_->rotateflag)
    now.angle = region_->theta;
  return now;
}

/* The turn, then the displacement. */
asperity::Frame RegionPart::frame_of(const Pose &pose) const {
  asperity::Frame frame = asperity::turn_about(origin_, axis_, pose.angle);
  aspi_add_scaled(frame.shift, 1, pose.shift, frame.shift);
  return frame;
}

double RegionPart::settle(const double box[2][3]) {
  const asperity::Frame before = frame_of(pose_);
  pose_ = pose();
  motion_.settle(frame_of(pose_), false);
  frame_ = motion_.end();
  return has_rate_ ? way(box, before, frame_) : 0;
}

/* The velocity of a displacement and of a turn. */
asperity::Twist RegionPart::twist_of(const Pose &at, const Pose &rate) const {
  double center[3];
  aspi_copy(origin_, center);
  aspi_add_scaled(center, 1, at.shift, center);
  asperity::Twist twist = asperity::twist_about(center, axis_, rate.angle);
  aspi_add_scaled(twist.linear, 1, rate.shift, twist.linear);
  return twist;
}

/* LAMMPS has no velocities: that of the middle of the step is its mean rate. In the step it changes
 * as much as from the step before; where that is more than the rate itself, as where the part turns
 * round, the velocity is the mean throughout, so that it does not go against the way from one place
 * to the other. The end of the step shows what the next one is expected to have beyond that. */
void RegionPart::advance(double dt) {
  const Pose last = rate_, before = pose_;
  Pose begin, end, more;
  dt_ = dt;
  pose_ = pose();
  asperity::check_turn("region", region_->id, pose_.angle - before.angle);
  for (int k = 0; k < Pose::COUNT; k++) {
    rate_[k] = (pose_[k] - before[k]) / dt;
    const double change = has_rate_ ? rate_[k] - last[k] : 0;
    const double half = fabs(change) <= fabs(rate_[k]) ? 0.5 * change : 0;
    begin[k] = rate_[k] - half;
    end[k] = rate_[k] + half;
    more[k] = (2 * change - 4 * half) / dt;
  }
  has_rate_ = true;
  to_come_ = twist_of(pose_, more);
  motion_.set_last(twist_of(before, begin));
  motion_.advance(frame_of(pose_), twist_of(pose_, end), dt);
  frame_ = motion_.end();
}

void RegionPart::end_acceleration(const double x[3], const double v[3], double a[3]) const {
  double more[3];
  motion_.acceleration(1, x, v, a);
  to_come_.velocity(x, more);
  aspi_add_scaled(a, 1, more, a);
}

void RegionPart::append_record(std::vector<double> &record) const {
  for (int k = 0; k < Pose::COUNT && has_rate_; k++) {
    record.push_back(rate_[k]);
    record.push_back(pose_[k]);
  }
}

void RegionPart::restore(const double *record) {
  for (int k = 0; k < Pose::COUNT; k++) {
    rate_[k] = *record++;
    pose_[k] = *record++;
  }
  has_rate_ = true;
}

double RegionPart::travel(const double box[2][3]) const {
  return ARC * way(box, motion_.frame_at(0), motion_.end());
}

/* How far a face moves at most from one frame to another, straight. */
double RegionPart::way(const double box[2][3], const asperity::Frame &from,
                       const asperity::Frame &to) const {
  double own[2][3] = {}, size[3], own_size[3], most = 0;
  aspi_subtract(box[1], box[0], size);
  const bool ends = extent(region_, own);
  aspi_subtract(own[1], own[0], own_size);
  const bool is_smaller = ends && aspi_length(own_size) < aspi_length(size);
  const double(*of)[3] = is_smaller ? own : box;
  for (int corner = 0; corner < 8; corner++) {
    double x[3], begin[3], end[3];
    for (int d = 0; d < 3; d++)
      x[d] = is_round_ ? origin_[d] : of[corner >> d & 1][d];
    if (!is_smaller && !is_round_)
      to.to_local(x, x);
    from.to_world(x, begin);
    to.to_world(x, end);
    aspi_subtract(end, begin, begin);
    most = std::max(most, aspi_length(begin));
  }
  return most;
}

/* One that looks the same however far it turns is not turned, as the search sees it. */
double RegionPart::turn_speed() const {
  return is_round_ ? 0 : fabs(rate_.angle);
}

/* What is seen is bent by the product of the turn with the velocities of both. */
double RegionPart::see(double from[3], double to[3]) const {
  const double turn = aspi_length(motion_.screw().angular);
  double way[3], seen[3];
  aspi_subtract(to, from, way);
  motion_.start().to_local(from, from);
  motion_.end().to_local(to, to);
  if (!(turn > 0))
    return 0;
  aspi_subtract(to, from, seen);
  return SAGITTA * turn * (aspi_length(seen) + 3 * aspi_length(way));
}

/* The way from one end of the step to the other, as the part sees it, and what turns it. */
double RegionPart::fastest(const asperity::Path &path, double most) const {
  double from[3], to[3];
  if (!moves_)
    return aspi_length(path.v);
  if (path.left < path.dt)
    return most;
  aspi_add_scaled(path.x, path.left, path.v, to);
  motion_.frame_at(0).to_local(path.x, from);
  motion_.end().to_local(to, to);
  aspi_subtract(to, from, to);
  return aspi_length(to) / path.left + 2 * turn_speed() * path.left * most + LEAST * most;
}

void RegionPart::set_share(double share) const {
  if (moves_)
    frame_ = motion_.frame_at(share);
}

/* ---- faces ---- */

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
    foot.convex = !(foot.hollow > 0) && (inside || !region_->openflag);
    foot.part = number_;
    foot.face = FACES * number_ + c.iwall;
    feet.push_back(foot);
  }
}
