/* A region as a wall; see region_shape.h. The search for contacts is in region_search.cpp.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "region_shape.h"

#include <math.h>
#include <algorithm>
#include <type_traits>

#include "contact/tolerances.h"
#include "contact/vector.h"
#include "domain.h"
#include "modify.h"
#include "region.h"
#include "update.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace LAMMPS_NS;
using asperity::Barrier;
using asperity::BarrierList;
using asperity::Barriers;
using asperity::Contact;
using asperity::Course;
using asperity::FaceList;
using asperity::Path;
using asperity::Place;
using asperity::text;

namespace {

const char FLAT[] = " block plane prism ";
const char STYLES[] = "block cone cylinder plane prism sphere union intersect";

/* How far beyond a face, in distances from it, one looks whether another part begins there. */
const double BEYOND = 1e-7;

/* A face's curve is measured over this share of the sphere's radius. */
const double PROBE = 0.01;

/* Two feet of one place. */
const double SAME = 1e-6;

/* On the axis of a cylinder a region has no nearest point: in radii, how far beside the place of a
 * sphere its distance is taken. */
const double ASIDE[3] = {1e-6, 0.7e-6, 0.3e-6};
const double ASIDE_LENGTH = 1.3e-6;

/* The parts of a union or an intersection: in LAMMPS since 2022 by their addresses, before by their
 * numbers. */
template <class R>
auto part_of(const R *region, const Domain *, int i, int) ->
    typename std::decay<decltype(region->reglist[i])>::type {
  return region->reglist[i];
}
template <class R, class D>
auto part_of(const R *region, const D *domain, int i, long) ->
    typename std::decay<decltype(domain->regions[region->list[i]])>::type {
  return domain->regions[region->list[i]];
}

template <class D>
auto region_of(D *domain, const std::string &id, int) -> decltype(domain->get_region_by_id(id)) {
  return domain->get_region_by_id(id);
}
template <class D>
auto region_of(D *domain, const std::string &id, long) ->
    typename std::decay<decltype(domain->regions[0])>::type {
  const int i = domain->find_region(id);
  return i < 0 ? NULL : domain->regions[i];
}

} // namespace

/* ---- what it is made of ---- */

RegionShape::RegionShape(LAMMPS *lammps, const std::string &id)
    : lammps_(lammps), id_(id), open_(false), flat_(true), travel_(0), speed_(0) {
  add_region(find_region(), root_);
}

Region *RegionShape::find_region() const {
  Region *region = region_of(lammps_->domain, id_, 0);
  if (!region)
    throw asperity::Error("region '" + id_ +
                          "' does not exist; define it before the wall, by 'region " + id_ +
                          " STYLE ...'");
  return region;
}

void RegionShape::add_region(Region *region, Node &node) {
  const std::string style = region->style, styles = STYLES;
  if ((" " + styles + " ").find(" " + style + " ") == std::string::npos)
    throw asperity::Error(text("region '%s' is of style '%s'; it must be one of %s", region->id,
                               region->style, STYLES));
  if (region->varshape)
    throw asperity::Error(text("region '%s' changes its size by a variable; it must keep its form, "
                               "and may 'move' and 'rotate'",
                               region->id));
  node.region = region;
  node.part = -1;
  node.is_union = style == "union";
  if (style == "union" || style == "intersect") {
    node.of.resize(region->nregion);
    for (int i = 0; i < region->nregion; i++)
      add_region(part_of(region, lammps_->domain, i, 0), node.of[i]);
    return;
  }
  node.part = static_cast<int>(parts_.size());
  open_ = open_ || region->openflag;
  flat_ = flat_ && std::string(FLAT).find(" " + style + " ") != std::string::npos;
  parts_.push_back(RegionPart(region, node.part));
}

/* A region is known by its ID, its style, its box and its parts. */
std::string RegionShape::description() const {
  std::string all = "region " + id_;
  for (const RegionPart &part : parts_) {
    const Region *r = part.region();
    all += text(" %s %s%s%s%s", r->id, r->style, r->interior ? "" : " out",
                r->moveflag ? " move" : "", r->rotateflag ? " rotate" : "");
    if (r->bboxflag)
      for (double at : {r->extent_xlo, r->extent_xhi, r->extent_ylo, r->extent_yhi, r->extent_zlo,
                        r->extent_zhi})
        all += " " + asperity::setting(at);
  }
  return all;
}

/* A region may have been defined anew, at another address; its motion goes on. */
void RegionShape::init() {
  const std::vector<double> record = motion_record();
  parts_.clear();
  root_.of.clear();
  open_ = false;
  flat_ = true;
  add_region(find_region(), root_);
  restore_motion(record);
}

/* ---- how it moves ---- */

/* A region's box may be endless; that of the simulation is not. */
static void simulation_box(const Domain *domain, double box[2][3]) {
  aspi_copy(domain->boxlo, box[0]);
  aspi_copy(domain->boxhi, box[1]);
}

static void read_variables(LAMMPS *lammps, Region *region) {
  lammps->modify->clearstep_compute();
  region->prematch();
  lammps->modify->addstep_compute(lammps->update->ntimestep + 1);
}

double RegionShape::setup() {
  double box[2][3], most = 0;
  read_variables(lammps_, root_.region);
  simulation_box(lammps_->domain, box);
  for (RegionPart &part : parts_)
    most = std::max(most, part.settle(box));
  return most;
}

bool RegionShape::is_still() const {
  return std::none_of(parts_.begin(), parts_.end(),
                      [](const RegionPart &part) { return part.moves(); });
}

void RegionShape::begin_step() {
  const double dt = lammps_->update->dt;
  double box[2][3];
  travel_ = speed_ = 0;
  if (is_still())
    return;
  read_variables(lammps_, root_.region);
  for (RegionPart &part : parts_)
    if (part.moves())
      part.advance(dt);
  simulation_box(lammps_->domain, box);
  for (const RegionPart &part : parts_)
    if (part.moves())
      travel_ = std::max(travel_, part.travel(box));
  speed_ = travel_ / dt;
}

/* Puts the region to where it is at a share of the step. */
void RegionShape::set_share(double share) const {
  for (const RegionPart &part : parts_)
    if (part.moves())
      part.set_share(share);
}

/* Only parts that move have a rate. The regions may have been deleted since. */
std::vector<double> RegionShape::motion_record() const {
  std::vector<double> record;
  for (const RegionPart &part : parts_)
    if (part.moves())
      part.append_record(record);
  return record;
}

void RegionShape::restore_motion(const std::vector<double> &record) {
  size_t at = 0;
  for (RegionPart &part : parts_)
    if (part.moves() && record.size() >= at + RegionPart::N_RECORD) {
      part.restore(&record[at]);
      at += RegionPart::N_RECORD;
    }
}

/* ---- faces near a point ---- */

/* True if a point is in the room of a region, or, with `flip`, of all that is not in it. */
bool RegionShape::in_room(const Node &node, bool flip, const double x[3]) const {
  const bool outside = flip != !node.region->interior;
  if (node.part >= 0)
    return node.region->openflag || parts_[node.part].has(x) != outside;
  for (const Node &child : node.of)
    if (in_room(child, outside, x) == (node.is_union != outside))
      return node.is_union != outside;
  return node.is_union == outside;
}

/* The nearest points of all faces. Of a union's parts those are hidden behind which another part
 * goes on, of an intersection those before which another one is missing; seen from outside, it is
 * the other way round. */
void RegionShape::find_feet(const Node &node, bool flip, const double x[3], double reach,
                            std::vector<Foot> &feet) const {
  const bool outside = flip != !node.region->interior, joins = node.is_union != outside;
  if (node.part >= 0) {
    const size_t first = feet.size();
    parts_[node.part].add_feet(x, reach, feet);
    for (size_t k = first; k < feet.size(); k++)
      feet[k].wrong_side = !node.region->openflag && feet[k].inside == outside;
    return;
  }
  for (size_t i = 0; i < node.of.size(); i++) {
    const size_t first = feet.size();
    find_feet(node.of[i], outside, x, reach, feet);
    for (size_t k = first; k < feet.size(); k++) {
      double point[3];
      if (feet[k].hidden || feet[k].wrong_side)
        continue;
      aspi_add_scaled(x, -(1 + (joins ? BEYOND : -BEYOND)) * feet[k].distance, feet[k].n, point);
      for (size_t j = 0; j < node.of.size() && !feet[k].hidden; j++)
        feet[k].hidden =
            j != i && !node.of[j].region->openflag && in_room(node.of[j], outside, point) == joins;
    }
  }
}

/* ---- without contact ---- */

/* By the nearest point of each part's faces from either side; those that are hidden count, too. */
double RegionShape::clear(const Course &course, const FaceList &stays) const {
  std::vector<Foot> &feet = buffers_.feet;
  const double speed = aspi_length(course.v), wide = (1 + ASIDE_LENGTH) * course.reach;
  double steps = course.most, aside[3];
  aspi_add_scaled(course.x, course.reach, ASIDE, aside);
  for (const RegionPart &part : parts_) {
    feet.clear();
    part.add_feet(aside, wide + steps * (speed + course.widen), feet);
    for (const Foot &foot : feet) {
      if (stays.has(foot.face))
        continue;
      const double gap = foot.distance - wide;
      const double closing = course.widen + (foot.convex ? -aspi_dot(course.v, foot.n) : speed);
      if (!(gap > 0))
        return 0;
      if (closing * steps > gap)
        steps = gap / closing;
    }
  }
  return steps;
}

/* A hollow face is outside of a ball that touches it at the foot. */
bool RegionShape::separate(const double x[3], double reach, const FaceList &stays,
                           BarrierList &made) const {
  std::vector<Foot> &feet = buffers_.feet;
  double aside[3];
  aspi_add_scaled(x, reach, ASIDE, aside);
  for (const RegionPart &part : parts_) {
    feet.clear();
    part.add_feet(aside, (1 + ASIDE_LENGTH) * reach, feet);
    for (const Foot &foot : feet) {
      double point[3], arm[3];
      if (stays.has(foot.face))
        continue;
      if (!(foot.convex || foot.hollow > 0) || !(foot.distance > 0))
        return false;
      Barrier *barrier = made.add();
      if (!barrier)
        return false;
      barrier->part = foot.part;
      barrier->is_ball = !foot.convex;
      aspi_add_scaled(aside, -foot.distance, foot.n, point);
      aspi_add_scaled(point, foot.convex ? 1 : foot.hollow, foot.n, arm);
      part.motion().end().to_local(point, point);
      part.motion().end().to_local(arm, arm);
      aspi_copy(arm, barrier->n);
      barrier->at = foot.hollow;
      if (foot.convex) {
        aspi_subtract(arm, point, barrier->n);
        barrier->at = aspi_dot(barrier->n, point);
      }
    }
  }
  return true;
}

/* A part that turns sees the straight path bent. */
double RegionShape::gap(const Barriers &all, const double from[3], const double to[3],
                        double radius) const {
  double least = HUGE_VAL;
  const Barrier *last;
  for (const Barrier *first = all.first; first < all.last; first = last) {
    const RegionPart &part = parts_[first->part];
    for (last = first; last < all.last && last->part == first->part;)
      last++;
    double begin[3], end[3];
    aspi_copy(from, begin);
    aspi_copy(to, end);
    const double bent = part.moves() ? part.see(begin, end) : 0;
    least = std::min(least, least_gap(Barriers{first, last}, begin, end) - bent);
  }
  return least - apart(radius);
}

/* The acceleration along n that keeps a center at a face, by the face's curve: from the distance
 * a little way ahead. v: relative to the face. */
double RegionShape::curve(double share, const Foot &at, const double x[3], double radius,
                          const double v[3]) const {
  const Foot foot = at;
  double along[3], ahead[3];
  aspi_add_scaled(v, -aspi_dot(v, foot.n), foot.n, along);
  const double speed = aspi_length(along), way = PROBE * radius;
  if (!(speed > 0))
    return 0;
  aspi_add_scaled(x, way / speed, along, ahead);
  std::vector<Foot> &feet = buffers_.feet;
  feet.clear();
  set_share(share);
  parts_[foot.part].add_feet(ahead, foot.distance + way, feet);
  for (const Foot &other : feet)
    if (other.face == foot.face && other.inside == foot.inside &&
        aspi_dot(other.n, foot.n) > 1 - 4 * PROBE)
      return 2 * (foot.distance - other.distance) * speed * speed / (way * way);
  return 0;
}

bool RegionShape::under(int face, const double x[3], const double v[3], double reach, Contact &at,
                        double &distance) const {
  std::vector<Foot> &feet = buffers_.feet;
  feet.clear();
  find_feet(root_, false, x, reach, feet);
  for (const Foot &foot : feet) {
    if (foot.face != face || foot.hidden || foot.wrong_side)
      continue;
    double point[3], u[3];
    const RegionPart &part = parts_[foot.part];
    aspi_copy(foot.n, at.n);
    aspi_add_scaled(x, -foot.distance, at.n, point);
    distance = foot.distance;
    at.face = face;
    if (part.moves()) {
      part.motion().velocity(1, point, at.v_wall);
      part.end_acceleration(x, v, u);
      at.follow = aspi_dot(u, at.n);
    }
    aspi_subtract(v, at.v_wall, u);
    const double square = aspi_dot(u, u), off = aspi_dot(u, at.n);
    if (foot.hollow > 0 && square > off * off)
      at.curve = curve(1, foot, x, distance, u) * square / (square - off * off);
    return true;
  }
  return false;
}

/* ---- what sticks ---- */

/* To the part whose face is there. */
void RegionShape::stick(const Path &path, const Contact &contact, Place &place) const {
  const double share = path.share() + contact.time / path.dt;
  std::vector<Foot> &feet = buffers_.feet;
  feet.clear();
  set_share(share);
  find_feet(root_, false, contact.x, HUGE_VAL, feet);
  set_share(1);
  place.piece = 0;
  double nearest = HUGE_VAL;
  for (const Foot &foot : feet)
    if (!foot.hidden && !foot.wrong_side && foot.distance < nearest &&
        aspi_dot(foot.n, contact.n) > 1 - SAME) {
      nearest = foot.distance;
      place.piece = foot.part;
    }
  aspi_copy(contact.x, place.at);
  const RegionPart &part = parts_[place.piece];
  if (part.moves())
    part.motion().frame_at(share).to_local(place.at, place.at);
}

/* The vector is of the part as it is defined; it turns with the part that is touched. */
void RegionShape::lay(const asp_lay &lay, const Path &path, const Contact &contact,
                      double direction[3]) const {
  Place place;
  stick(path, contact, place);
  parts_[place.piece]
      .motion()
      .frame_at(path.share() + contact.time / path.dt)
      .to_world_direction(lay.vector, direction);
}

void RegionShape::carry(Place &place, double, double, double x[3], double v[3]) const {
  aspi_copy(place.at, x);
  v[0] = v[1] = v[2] = 0;
  if (place.piece < 0 || place.piece >= static_cast<int>(parts_.size()))
    return;
  const RegionPart &part = parts_[place.piece];
  if (!part.moves())
    return;
  part.motion().end().to_world(x, x);
  part.motion().velocity(1, x, v);
}

void RegionShape::turn(const Place &place, double share, double, double axes[3][3],
                       double omega[3]) const {
  omega[0] = omega[1] = omega[2] = 0;
  const size_t piece = static_cast<size_t>(place.piece);
  if (piece < parts_.size())
    parts_[piece].motion().turn(share, axes, omega);
}
