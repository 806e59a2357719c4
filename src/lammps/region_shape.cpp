/* A region as a wall; see region_shape.h. The search goes along the path from one point to the
 * next, each time so far that no face can be reached before: a flat or bulging face lies behind the
 * plane across its nearest point, of a hollow one a chord is known. A face is reached by the
 * sphere, or, from its other side, first by the center. A part of a union may hide the nearest
 * point of a face and not the next one: where the sphere is at such a face, the next look is a
 * stride away. What that misses has been passed: then the way back is searched until the contact is
 * found.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "region_shape.h"

#include <math.h>
#include <algorithm>
#include <type_traits>

#include "contact/contact.h"
#include "contact/vector.h"
#include "domain.h"
#include "modify.h"
#include "region.h"
#include "update.h"
#include "dem/error.h"
#include "dem/record.h"
#include "dem/text.h"

using namespace LAMMPS_NS;
using asperity::Contact;
using asperity::Faces;
using asperity::Path;
using asperity::Place;
using asperity::text;

namespace {

const char FLAT[] = " block plane prism ";
const char STYLES[] = "block cone cylinder plane prism sphere union intersect";

/* A sphere that touches a hollow face slides along it if its normal speed is a smaller share of its
 * speed (as in aspi_cylinder_find). */
const double SLIDES = 1e-6;

/* How closely a sphere that a moving part takes along keeps its distance in a step, in radii. */
const double KEEPS = 1e-6;

/* A face's curve is measured over this share of the sphere's radius. */
const double CURVE = 0.01;

/* How well a curve and a motion are known, as shares of what they do to a path. */
const double MEASURED = 1e-3;

/* Faces of one part, at most. */
const int FACES = 64;

/* Step of a search among faces that may be hidden, in radii. */
const double STRIDE = 0.5;

/* After PATIENCE steps a search takes larger ones, of HURRY radii. */
const int PATIENCE = 1000;
const double HURRY = 1e-3;

/* How far beyond a face, in distances from it, one looks whether another part begins there. */
const double BEYOND = 1e-7;

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

/* ---- what it is made of -----------------------------------------------------------------------
 */

RegionShape::RegionShape(LAMMPS *lammps, const std::string &id)
    : lammps_(lammps), id_(id), open_(false), flat_(true), speed_(0) {
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
  parts_.push_back(RegionPart(region));
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

/* The same region may have been defined anew, at another address; its motion goes on. */
void RegionShape::init() {
  const std::vector<double> record = motion_record();
  parts_.clear();
  root_.of.clear();
  open_ = false;
  flat_ = true;
  add_region(find_region(), root_);
  restore_motion(record);
}

/* ---- how it moves -----------------------------------------------------------------------------
 */

static void read_variables(LAMMPS *lammps, Region *region) {
  lammps->modify->clearstep_compute();
  region->prematch();
  lammps->modify->addstep_compute(lammps->update->ntimestep + 1);
}

void RegionShape::setup() {
  read_variables(lammps_, root_.region);
  for (RegionPart &part : parts_)
    part.settle();
}

/* A region's box may be endless; the box of the simulation is not. */
void RegionShape::begin_step() {
  const Domain *domain = lammps_->domain;
  speed_ = 0;
  bool any = false;
  for (const RegionPart &part : parts_)
    any = any || part.moves();
  if (!any)
    return;
  read_variables(lammps_, root_.region);
  for (RegionPart &part : parts_)
    if (part.moves()) {
      part.advance(lammps_->update->dt);
      speed_ = std::max(speed_, part.speed(domain->boxlo, domain->boxhi));
    }
}

double RegionShape::travel(double dt) const {
  return 1.5 * speed_ * dt; /* it may be faster at an end of the step than in the mean */
}

/* Puts the region to where it is at a share of the step. */
void RegionShape::set_share(double share) const {
  for (const RegionPart &part : parts_)
    if (part.moves())
      part.set_share(share);
}

/* Of the parts that move, for others have no rate. The regions may have been deleted since. */
std::vector<double> RegionShape::motion_record() const {
  std::vector<double> record;
  for (const RegionPart &part : parts_)
    if (part.rate()) {
      record.insert(record.end(), part.rate()->shift, part.rate()->shift + 3);
      record.push_back(part.rate()->angle);
    }
  return record;
}

void RegionShape::restore_motion(const std::vector<double> &record) {
  size_t at = 0;
  for (RegionPart &part : parts_)
    if (part.moves() && record.size() >= at + 4) {
      part.set_rate(RegionPose{{record[at], record[at + 1], record[at + 2]}, record[at + 3]});
      at += 4;
    }
}

/* ---- faces near a point -----------------------------------------------------------------------
 */

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
    for (size_t k = first; k < feet.size(); k++) {
      feet[k].part = node.part;
      feet[k].face += FACES * node.part;
      feet[k].across = !node.region->openflag && feet[k].inside == outside;
    }
    return;
  }
  for (size_t i = 0; i < node.of.size(); i++) {
    const size_t first = feet.size();
    find_feet(node.of[i], outside, x, reach, feet);
    for (size_t k = first; k < feet.size(); k++) {
      double point[3];
      if (feet[k].hidden || feet[k].across)
        continue;
      aspi_add_scaled(x, -(1 + (joins ? BEYOND : -BEYOND)) * feet[k].distance, feet[k].n, point);
      for (size_t j = 0; j < node.of.size() && !feet[k].hidden; j++)
        feet[k].hidden =
            j != i && !node.of[j].region->openflag && in_room(node.of[j], outside, point) == joins;
    }
  }
}

/* ---- without contact --------------------------------------------------------------------------
 */

/* By the nearest point of each part's faces from either side; those that are hidden count, too. */
double RegionShape::clear(const double x[3], const double v[3], double reach, double widen,
                          double most, const Faces &stays) const {
  std::vector<Foot> &feet = buffers_.feet;
  const double speed = aspi_length(v), wide = (1 + ASIDE_LENGTH) * reach;
  double steps = most, aside[3];
  aspi_add_scaled(x, reach, ASIDE, aside);
  for (const RegionPart &part : parts_) {
    feet.clear();
    part.add_feet(aside, wide + steps * (speed + widen), feet);
    for (const Foot &foot : feet) {
      if (stays.has(foot.face))
        continue;
      const double gap = foot.distance - wide;
      const double closing = widen + (foot.behind ? -aspi_dot(v, foot.n) : speed);
      if (!(gap > 0))
        return 0;
      if (closing * steps > gap)
        steps = gap / closing;
    }
  }
  return steps;
}

bool RegionShape::may_meet(const double lo[3], const double hi[3]) const {
  const double still[3] = {0, 0, 0};
  double middle[3], half[3];
  for (int d = 0; d < 3; d++) {
    half[d] = 0.5 * (hi[d] - lo[d]);
    middle[d] = lo[d] + half[d];
  }
  return clear(middle, still, aspi_length(half), 0, 1, Faces()) < 1;
}

/* ---- the first contact ------------------------------------------------------------------------
 */

/* One search along one path. */
struct RegionShape::Search {
  const RegionShape &shape;
  const Path &path;
  const double radius, tolerance;
  double fastest; /* of the sphere relative to any face */

  Search(const RegionShape &s, const Path &p, double r)
      : shape(s), path(p), radius(r), tolerance(CONTACT_TOLERANCE * r),
        fastest(aspi_length(p.v) + s.speed_) {}
  ~Search() {
    shape.set_share(1);
  }

  double share(double time) const {
    return path.share() + time / path.dt;
  }
  void look(double time, Look &l) const;
  double stride() const {
    return STRIDE * radius / fastest;
  }
  void relative(const Look &l, const Foot &foot, double v_wall[3], double v[3]) const;
  double approach(const Look &l, const Foot &foot, bool &counts) const;
  double near(const Look &l, const Foot &foot) const;
  double follow(const Look &l, const Foot &foot) const;
  double curve(const Look &l, const Foot &foot, const double v[3]) const;
  const Foot *touched(const Look &l) const;
  double reached(const Look &l, const Foot &foot) const;
  double next(const Look &l) const;
  bool is_too_far(const Look &l, const Foot *foot) const;
  bool is_kept(const Look &begin, const Foot &foot) const;
  void go_back(Look &good, Look &bad) const;
  void fill(const Look &l, const Foot &foot, Contact &contact) const;
};

void RegionShape::Search::look(double time, Look &l) const {
  l.time = time;
  aspi_add_scaled(path.x, time, path.v, l.x);
  shape.set_share(share(time));
  l.in_room = shape.open_ || shape.in_room(shape.root_, false, l.x);
  l.feet.clear();
  shape.find_feet(shape.root_, false, l.x,
                  1.001 * radius + fastest * std::max(0.0, path.left - time), l.feet);
}

/* The velocity of the foot, and of the sphere relative to it. */
void RegionShape::Search::relative(const Look &l, const Foot &foot, double v_wall[3],
                                   double v[3]) const {
  const RegionPart &part = shape.parts_[foot.part];
  double point[3];
  v_wall[0] = v_wall[1] = v_wall[2] = 0;
  if (part.moves()) {
    aspi_add_scaled(l.x, -foot.distance, foot.n, point);
    part.velocity(share(l.time), point, v_wall);
  }
  aspi_subtract(path.v, v_wall, v);
}

/* The speed toward a foot. It counts where it is more than rounding, or along a hollow face more
 * than sliding; of a sphere that slides along one, or begins its path at a moving face, where its
 * mean over the rest of the path does. */
double RegionShape::Search::approach(const Look &l, const Foot &foot, bool &counts) const {
  double v_wall[3], v[3];
  relative(l, foot, v_wall, v);
  const double speed = -aspi_dot(v, foot.n), all = aspi_length(v);
  const bool slides = foot.hollow > 0 && fabs(speed) <= SLIDES * all;
  const bool rides = shape.parts_[foot.part].moves() && !(l.time > 0);
  counts = speed > (foot.hollow > 0 ? SLIDES : CONTACT_APPROACH) * all;
  if ((slides || rides) && foot.distance - radius <= near(l, foot)) {
    const double bend = (rides ? follow(l, foot) : 0) + (slides ? curve(l, foot, v) : 0);
    const double mean = 0.5 * (path.left - l.time) * bend;
    counts = speed + mean > CONTACT_APPROACH * all + MEASURED * fabs(mean);
  }
  return speed;
}

/* How far from a face a sphere is at it: at the beginning of a path, as far as one that rides on a
 * moving part is off. */
double RegionShape::Search::near(const Look &l, const Foot &foot) const {
  return shape.parts_[foot.part].moves() && !(l.time > 0) ? KEEPS * radius : tolerance;
}

/* The acceleration along n that keeps the center at a face as that moves. */
double RegionShape::Search::follow(const Look &l, const Foot &foot) const {
  double a[3];
  if (!shape.parts_[foot.part].moves())
    return 0;
  shape.parts_[foot.part].follow(share(l.time), l.x, path.v, a);
  return aspi_dot(a, foot.n);
}

/* The acceleration along n that keeps the center at a face, by the face's curve: from the distance
 * a little way ahead. */
double RegionShape::Search::curve(const Look &l, const Foot &foot, const double v[3]) const {
  double along[3], ahead[3];
  aspi_add_scaled(v, -aspi_dot(v, foot.n), foot.n, along);
  const double speed = aspi_length(along), way = CURVE * radius;
  if (!(speed > 0))
    return 0;
  aspi_add_scaled(l.x, way / speed, along, ahead);
  std::vector<Foot> &feet = shape.buffers_.feet;
  feet.clear();
  shape.set_share(share(l.time));
  shape.find_feet(shape.root_, false, ahead, foot.distance + way, feet);
  for (const Foot &other : feet)
    if (other.face == foot.face && other.inside == foot.inside &&
        aspi_dot(other.n, foot.n) > 1 - 4 * CURVE)
      return 2 * (foot.distance - other.distance) * speed * speed / (way * way);
  return 0;
}

/* The face that is touched, or NULL: the deepest of those that the sphere approaches. */
const RegionShape::Foot *RegionShape::Search::touched(const Look &l) const {
  const Foot *deepest = NULL;
  for (const Foot &foot : l.feet) {
    bool counts;
    if (!l.in_room || foot.hidden || foot.across || !(foot.distance > 0) ||
        foot.distance - radius > near(l, foot) || (deepest && foot.distance >= deepest->distance))
      continue;
    approach(l, foot, counts);
    if (counts)
      deepest = &foot;
  }
  return deepest;
}

/* How long at least until a face is reached; where that is not known well, as the path looks bent
 * from a part that turns, no less than a stride. */
double RegionShape::Search::reached(const Look &l, const Foot &foot) const {
  bool counts;
  const double speed = approach(l, foot, counts);
  const double gap = std::max(0.0, foot.distance - (foot.across ? 0 : radius));
  const double straight = counts ? gap / speed : HUGE_VAL;
  const double bend = 2 * shape.parts_[foot.part].turn_speed() * fastest;
  const double from_axis = foot.hollow - foot.distance;
  double sure = gap / fastest;
  if (from_axis > 0) {
    const double beyond = (foot.distance - radius) * (2 * from_axis + foot.distance - radius);
    const double rate = from_axis * speed, square = fastest * fastest + bend * foot.hollow;
    const double root = sqrt(std::max(0.0, rate * rate + square * beyond));
    sure = speed > 0 ? std::max(0.0, beyond) / (rate + root) : (root - rate) / square;
    if (!(bend > 0))
      return sure;
  } else if (foot.behind) {
    if (!(bend > 0))
      return straight;
    const double root = sqrt(speed * speed + 2 * bend * gap);
    sure = speed > 0 ? 2 * gap / (speed + root) : (root - speed) / bend;
  }
  return std::max(sure, std::min(straight, stride()));
}

/* How long at least until any is. */
double RegionShape::Search::next(const Look &l) const {
  double time = HUGE_VAL;
  for (const Foot &foot : l.feet) {
    const double least = l.in_room && !foot.hidden ? 0 : stride();
    time = std::min(time, std::max(least, reached(l, foot)));
  }
  return time;
}

/* True if a look has passed a contact: it is out of the room, or deep in a face. */
bool RegionShape::Search::is_too_far(const Look &l, const Foot *foot) const {
  if (!l.in_room)
    return true;
  return foot && foot->distance - radius < -tolerance;
}

/* True if a sphere that was at a face of a moving part is in it no deeper than one that is taken
 * along may be: the next step puts it right. */
bool RegionShape::Search::is_kept(const Look &begin, const Foot &foot) const {
  bool was_there = false;
  for (const Foot &other : begin.feet)
    was_there = was_there || (other.face == foot.face && other.inside == foot.inside &&
                              other.distance - radius <= near(begin, other));
  return was_there && shape.parts_[foot.part].moves() && radius - foot.distance <= KEEPS * radius;
}

/* Between a place before the contact and one behind it, until one is at it. Along a face the
 * distance is nearly linear in time: the line through the two has its zero near the contact; each
 * third time the way is halved. */
void RegionShape::Search::go_back(Look &good, Look &bad) const {
  Look &between = shape.buffers_.between;
  for (int looks = 1; (bad.time - good.time) * fastest > 0.5 * tolerance; looks++) {
    const Foot *foot = touched(bad);
    if (foot && foot->distance - radius >= -tolerance)
      break;
    double share = 0.5;
    if (foot && looks % 3 > 0)
      for (const Foot &other : good.feet)
        if (other.face == foot->face && other.inside == foot->inside &&
            other.distance - radius > tolerance)
          share = (other.distance - radius) / (other.distance - foot->distance);
    const double middle = good.time + share * (bad.time - good.time);
    if (!(middle > good.time && middle < bad.time))
      break;
    look(middle, between);
    std::swap(!between.in_room || touched(between) ? bad : good, between);
  }
}

void RegionShape::Search::fill(const Look &l, const Foot &foot, Contact &contact) const {
  double v[3];
  const double push_out = radius - foot.distance, left = path.left - l.time;
  contact.time = l.time;
  aspi_copy(foot.n, contact.n);
  relative(l, foot, contact.v_wall, v);
  contact.piece = 0;
  contact.face = foot.face;
  aspi_add_scaled(l.x, push_out > tolerance ? push_out : 0, foot.n, contact.x);
  contact.overlapped = push_out > near(l, foot);
  contact.follow = follow(l, foot);
  contact.curve = foot.hollow > 0 ? curve(l, foot, v) : 0;
  contact.closing = -aspi_dot(v, foot.n) + 0.5 * left * (contact.follow + contact.curve);
}

bool RegionShape::find(const Path &path, double radius, double latest, Contact &contact) const {
  Search search(*this, path, radius);
  const double end = std::min(latest, path.left);
  if (!(search.fastest > 0) || !(path.left > 0))
    return false;
  Look &good = buffers_.good, &now = buffers_.now;
  search.look(0, now);
  for (int looks = 1;; looks++) {
    const Foot *foot = search.touched(now);
    if (looks == 2 && foot && now.in_room && !(now.time < end) && search.is_kept(good, *foot))
      return false;
    if (looks > 1 && good.in_room && search.is_too_far(now, foot)) {
      const double far = now.time;
      search.go_back(good, now);
      foot = search.touched(now);
      if (!foot) { /* it has left the room where there is no face */
        search.look(far, now);
        foot = search.touched(now);
      }
    }
    if (foot) {
      search.fill(now, *foot, contact);
      return true;
    }
    if (!(now.time < end))
      return false;
    double step = search.next(now);
    if (flat_ && !open_ && now.in_room && !(speed_ > 0) && now.time + step > end)
      return false;
    if (looks > PATIENCE)
      step = std::max(step, HURRY * radius / search.fastest);
    std::swap(good, now);
    search.look(std::min(end, good.time + step), now);
  }
}

bool RegionShape::under(int face, const double x[3], double reach, double n[3],
                        double v_wall[3]) const {
  std::vector<Foot> &feet = buffers_.feet;
  feet.clear();
  find_feet(root_, false, x, reach, feet);
  for (const Foot &foot : feet) {
    if (foot.face != face || foot.hidden || foot.across)
      continue;
    double point[3];
    aspi_copy(foot.n, n);
    aspi_add_scaled(x, -foot.distance, n, point);
    v_wall[0] = v_wall[1] = v_wall[2] = 0;
    if (parts_[foot.part].moves())
      parts_[foot.part].velocity(1, point, v_wall);
    return true;
  }
  return false;
}

/* ---- what sticks ------------------------------------------------------------------------------
 */

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
    if (!foot.hidden && !foot.across && foot.distance < nearest &&
        aspi_dot(foot.n, contact.n) > 1 - SAME) {
      nearest = foot.distance;
      place.piece = foot.part;
    }
  aspi_copy(contact.x, place.at);
  const RegionPart &part = parts_[place.piece];
  if (part.moves())
    part.to_body(share, place.at);
}

/* The vector is of the part as it is defined; it turns with the part that is touched. */
void RegionShape::lay(const asp_lay &lay, const Path &path, const Contact &contact,
                      double direction[3]) const {
  aspi_copy(lay.vector, direction);
  bool turns = false;
  for (const RegionPart &part : parts_)
    turns = turns || part.region()->rotateflag;
  if (!turns)
    return;
  Place place;
  stick(path, contact, place);
  parts_[place.piece].turn_vector(path.share() + contact.time / path.dt, direction);
}

void RegionShape::carry(Place &place, double, double, double x[3], double v[3]) const {
  aspi_copy(place.at, x);
  v[0] = v[1] = v[2] = 0;
  if (place.piece < 0 || place.piece >= static_cast<int>(parts_.size()))
    return;
  const RegionPart &part = parts_[place.piece];
  if (!part.moves())
    return;
  part.to_world(1, x);
  part.velocity(1, x, v);
}
