/* The first contact with a region along a path; see region_shape.h. The search goes along the
 * path from one point to the next, each time so far that no face can be reached before: a flat or
 * bulging face lies behind the plane across its nearest point, of a hollow one a chord is known. A
 * face is reached by the sphere, or, from its other side, first by the center. A part of a union
 * may hide the nearest point of a face and not the next one: where the sphere is at such a face,
 * the next look is a stride away. What that misses has been passed: then the way back is searched
 * until the contact is found.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "region_shape.h"

#include <math.h>
#include <algorithm>

#include "contact/contact.h"
#include "contact/vector.h"

using namespace LAMMPS_NS;
using asperity::APPROACH;
using asperity::AT_ONCE;
using asperity::Contact;
using asperity::Frame;
using asperity::GRAZING;
using asperity::Path;
using asperity::TOUCHING;

namespace {

/* How well a curve and a motion are known, as shares of what they do to a path. */
const double MEASURED = 1e-3;

/* Step of a search among faces that may be hidden, in radii. */
const double STRIDE = 0.5;

/* After PATIENCE steps a search takes larger ones, of HURRY radii. */
const int PATIENCE = 1000;
const double HURRY = 1e-3;

} // namespace

/* One search along one path. */
struct RegionShape::Search {
  const RegionShape &shape;
  const Path &path;
  const double radius, tolerance;
  double fastest; /* of the sphere relative to any face */

  Search(const RegionShape &s, const Path &p, double r)
      : shape(s), path(p), radius(r), tolerance(TOUCHING * r), fastest(0) {
    const double most = aspi_length(p.v) + s.speed_;
    for (const RegionPart &part : s.parts_)
      fastest = std::max(fastest, std::min(most, part.fastest(p, most)));
  }
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
  double mean_approach(const Look &l, const Foot &foot, const double v[3], double n_end[3]) const;
  double approach(const Look &l, const Foot &foot, bool &counts) const;
  double near(const Look &l, const Foot &foot) const;
  double acceleration(const Look &l, const Foot &foot) const;
  double curve(const Look &l, const Foot &foot, const double v[3]) const {
    return shape.curve(share(l.time), foot, l.x, radius, v);
  }
  const Foot *touched(const Look &l) const;
  double reached(const Look &l, const Foot &foot) const;
  double next(const Look &l) const;
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
                  (1 + 2 * AT_ONCE) * radius + fastest * std::max(0.0, path.left - time), l.feet);
}

/* The velocity of the foot, and of the sphere relative to it. */
void RegionShape::Search::relative(const Look &l, const Foot &foot, double v_wall[3],
                                   double v[3]) const {
  const RegionPart &part = shape.parts_[foot.part];
  double point[3];
  v_wall[0] = v_wall[1] = v_wall[2] = 0;
  if (part.moves()) {
    aspi_add_scaled(l.x, -foot.distance, foot.n, point);
    part.motion().velocity(share(l.time), point, v_wall);
  }
  aspi_subtract(path.v, v_wall, v);
}

/* The mean speed toward a foot, which has the velocity v from it now, until the path ends; n_end:
 * what the foot's normal is then. */
double RegionShape::Search::mean_approach(const Look &l, const Foot &foot, const double v[3],
                                          double n_end[3]) const {
  const double left = path.left - l.time;
  aspi_copy(foot.n, n_end);
  if (!shape.parts_[foot.part].moves() || !(left > 0))
    return -aspi_dot(v, foot.n);
  const asperity::Motion &motion = shape.parts_[foot.part].motion();
  const Frame now = motion.frame_at(share(l.time)), end = motion.frame_at(share(path.left));
  double n[3], way[3];
  for (int j = 0; j < 3; j++)
    n[j] = now.turn[0][j] * foot.n[0] + now.turn[1][j] * foot.n[1] + now.turn[2][j] * foot.n[2];
  end.to_world_direction(n, n_end);
  aspi_add_scaled(path.x, path.left, path.v, way);
  end.to_local(way, way);
  now.to_world(way, way);
  aspi_subtract(way, l.x, way);
  return -aspi_dot(way, foot.n) / left;
}

/* The speed toward a foot. It counts where it is more than rounding, or along a hollow face more
 * than sliding; of a sphere that slides along one, or begins its path at a moving face, where its
 * mean over the rest of the path does. */
double RegionShape::Search::approach(const Look &l, const Foot &foot, bool &counts) const {
  double v_wall[3], v[3];
  relative(l, foot, v_wall, v);
  const double speed = -aspi_dot(v, foot.n), all = aspi_length(v);
  const bool slides = foot.hollow > 0 && fabs(speed) <= GRAZING * all;
  const bool rides = shape.parts_[foot.part].moves() && !(l.time > 0);
  counts = speed > (foot.hollow > 0 ? GRAZING : APPROACH) * all;
  if ((slides || rides) && foot.distance - radius <= near(l, foot)) {
    double n_end[3];
    const double mean = (rides ? mean_approach(l, foot, v, n_end) : speed) +
                        (slides ? 0.5 * (path.left - l.time) * curve(l, foot, v) : 0);
    counts = mean > APPROACH * all + MEASURED * fabs(mean - speed);
  }
  return speed;
}

/* How far from a face a sphere is at it: at the beginning of a path, as far as one that rides on a
 * moving part is off. */
double RegionShape::Search::near(const Look &l, const Foot &foot) const {
  return shape.parts_[foot.part].moves() && !(l.time > 0) ? AT_ONCE * radius : tolerance;
}

/* The acceleration along n that keeps the center at a face as that moves. */
double RegionShape::Search::acceleration(const Look &l, const Foot &foot) const {
  double a[3];
  if (!shape.parts_[foot.part].moves())
    return 0;
  shape.parts_[foot.part].motion().acceleration(share(l.time), l.x, path.v, a);
  return aspi_dot(a, foot.n);
}

/* The face that is touched, or NULL: the deepest of those that the sphere approaches. */
const RegionShape::Foot *RegionShape::Search::touched(const Look &l) const {
  const Foot *deepest = NULL;
  for (const Foot &foot : l.feet) {
    bool counts;
    if (!l.in_room || foot.hidden || foot.wrong_side || !(foot.distance > 0) ||
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
  const double gap = std::max(0.0, foot.distance - (foot.wrong_side ? 0 : radius));
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
  } else if (foot.convex) {
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
  contact.follow = acceleration(l, foot);
  contact.curve = foot.hollow > 0 ? curve(l, foot, v) : 0;
  const double square = aspi_dot(v, v), off = aspi_dot(v, foot.n);
  contact.chord =
      asperity::chord_speed(contact.curve, sqrt(std::max(0.0, square - off * off)), left);
  contact.approach_speed = mean_approach(l, foot, v, contact.n_end) + contact.chord;
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
    const bool is_deep = foot && foot->distance - radius < -search.tolerance;
    if (looks > 1 && good.in_room && (!now.in_room || is_deep)) { /* it has passed a contact */
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
    if (!(now.time < end) || now.feet.empty())
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
