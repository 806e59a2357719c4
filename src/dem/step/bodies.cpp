/* Contacts of bodies; see bodies.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/bodies.h"

#include <math.h>
#include <algorithm>

#include "asperity_front.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/step/body_solve.h"
#include "dem/step/flight.h"

using namespace asperity;

namespace {

/* The angle by which a body turns in a stretch of its path, rad. */
const double TURN = 0.1;

/* Contacts are at one instant if the gap between them is less than this share of the radius. */
const double SAME = 1e-6;

/* Contacts of a body in a row at one instant, at most, before all are taken as sustained; and
 * twice, before its step ends. */
const int SERIES = 8;

/* The speed away from a wall that contacts which stay get, over that of their approach. */
const double CLEAR = 1e-6;

/* Faces whose normals have a smaller cosine belong to two walls. */
const double OTHER_WALL = 0.7;

/* A sphere of the body at a wall. */
struct Touch {
  size_t wall, shape, sphere;
  Path before;
  Contact contact;
};

void turn_by(const double omega[3], double time, double axes[3][3]) {
  const double rate = aspi_length(omega), angle = rate * time;
  if (!(rate > 0))
    return;
  for (int k = 0; k < 3; k++) {
    double side[3], along = aspi_dot(omega, axes[k]) / (rate * rate);
    aspi_cross(omega, axes[k], side);
    for (int d = 0; d < 3; d++)
      axes[k][d] = axes[k][d] * cos(angle) + side[d] * sin(angle) / rate +
                   omega[d] * along * (1 - cos(angle));
  }
}

/* Free flight: the midpoint rule for the axes. */
void advance(Body &body, double time) {
  double omega[3];
  Body half = body;
  spin_of(body, omega);
  turn_by(omega, 0.5 * time, half.axes);
  spin_of(half, omega);
  turn_by(omega, time, body.axes);
  aspi_add_scaled(body.x, time, body.v, body.x);
}

void arm_of(const Body &body, const BodySphere &sphere, double arm[3]) {
  for (int d = 0; d < 3; d++)
    arm[d] = sphere.arm[0] * body.axes[0][d] + sphere.arm[1] * body.axes[1][d] +
             sphere.arm[2] * body.axes[2][d];
}

/* Turns an angular velocity into the angular momentum. */
void momentum_of(const Body &body, const double omega[3], double momentum[3]) {
  for (int d = 0; d < 3; d++)
    momentum[d] = 0;
  for (int k = 0; k < 3; k++)
    aspi_add_scaled(momentum, body.inertia[k] * aspi_dot(omega, body.axes[k]), body.axes[k],
                    momentum);
}

asp_body inverse_of(const Body &body, const double arm[3]) {
  static const int of[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  asp_body made = {1 / body.mass, {0, 0, 0, 0, 0, 0}, {arm[0], arm[1], arm[2]}};
  for (int k = 0; k < 3; k++)
    for (int j = 0; j < 6 && body.inertia[k] > 0; j++)
      made.inverse_inertia[j] += body.axes[k][of[j][0]] * body.axes[k][of[j][1]] / body.inertia[k];
  return made;
}

double energy_of(const Body &body, const double v[3]) {
  double omega[3];
  spin_of(body, omega);
  return 0.5 * (body.mass * aspi_dot(v, v) + aspi_dot(omega, body.angular_momentum));
}

/* The touching sphere as one of a list, with the mass of its body. */
struct One {
  int64_t tag;
  Spheres view;
  One(const Bodies &bodies, const Body &body, const BodySphere &sphere) : tag(sphere.tag), view() {
    view.step = bodies.step;
    view.dt = bodies.dt;
    view.n = 1;
    view.mask = &sphere.mask;
    view.type = &sphere.type;
    view.tag = &tag;
    view.tag_bytes = sizeof tag;
    view.radius = &sphere.radius;
    view.mass = &body.mass;
  }
};

/* A body on its way through a step. */
class Way {
public:
  Way(const std::vector<Stepper *> &walls, Bodies &bodies, size_t number);
  void go();

private:
  void find_near();
  bool find_next();
  void search(const Body &end, double time);
  void meet(bool all_stay);
  bool arrives(const Touch &touch, double &approach) const;
  bool is_new_face(const Touch &touch, const asp_particle &particle);
  void hit(const Touch &touch);
  void hit_together(const std::vector<Touch> &touches);
  void stay();
  void point_of(const Touch &touch, BodyPoint &point) const;
  Impact impact_of(const Touch &touch);
  void velocity(double v[3]) const;
  const BodySphere &sphere(const Touch &touch) const {
    return bodies_.spheres[touch.sphere];
  }
  Stepper &wall(const Touch &touch) const {
    return *walls_[touch.wall];
  }
  const asp_wall *law(const Touch &touch) const {
    const asp_wall *of = wall(touch).setup.model.wall();
    if (!of)
      throw Error("a body came to be after the run began, and the wall's tables need the diameters "
                  "beforehand; make particles before 'run', or by a fix insert");
    return of;
  }
  const Member &shape(const Touch &touch) const {
    return wall(touch).setup.shapes[touch.shape];
  }

  const std::vector<Stepper *> &walls_;
  Bodies &bodies_;
  const size_t number_;
  Body &body_;
  const Body arrival_;  /* without walls */
  double left_, moved_; /* of the step; since the last contact */
  int hits_;            /* in this step */
  std::vector<std::pair<size_t, size_t>> near_;
  std::vector<Touch> touches_;
  std::vector<BodyPoint> points_;
};

Way::Way(const std::vector<Stepper *> &walls, Bodies &bodies, size_t number)
    : walls_(walls), bodies_(bodies), number_(number), body_(bodies.all[number]), arrival_(body_),
      left_(bodies.dt), moved_(0), hits_(0) {}

/* The shapes that the body may meet in the rest of the step. */
void Way::find_near() {
  double omega[3], reach = 0, out = 0;
  spin_of(body_, omega);
  for (size_t k = body_.first; k < body_.first + body_.count; k++) {
    const double length = aspi_length(bodies_.spheres[k].arm);
    reach = std::max(reach, length + bodies_.spheres[k].radius);
    out = std::max(out, length);
  }
  reach += left_ * (aspi_length(body_.v) + out * aspi_length(omega));
  near_.clear();
  for (size_t w = 0; w < walls_.size(); w++)
    for (size_t m = 0; m < walls_[w]->setup.shapes.size(); m++) {
      const Shape &shape = *walls_[w]->setup.shapes[m].shape;
      double lo[3], hi[3];
      for (int d = 0; d < 3; d++) {
        lo[d] = body_.x[d] - reach - shape.travel(bodies_.dt);
        hi[d] = body_.x[d] + reach + shape.travel(bodies_.dt);
      }
      if (shape.may_meet(lo, hi))
        near_.push_back(std::make_pair(w, m));
    }
}

/* The first contacts, all at one instant, in the stretch of a time that ends at `end`. */
void Way::search(const Body &end, double time) {
  touches_.clear();
  double first = time;
  for (size_t k = body_.first; k < body_.first + body_.count; k++) {
    const BodySphere &one = bodies_.spheres[k];
    double from[3], to[3];
    Touch touch;
    touch.sphere = k;
    arm_of(body_, one, from);
    arm_of(end, one, to);
    aspi_add_scaled(body_.x, 1, from, touch.before.x);
    aspi_add_scaled(end.x, 1, to, to);
    aspi_subtract(to, touch.before.x, touch.before.v);
    aspi_scale(1 / time, touch.before.v);
    touch.before.left = left_;
    touch.before.dt = bodies_.dt;
    for (const std::pair<size_t, size_t> &at : near_) {
      touch.wall = at.first;
      touch.shape = at.second;
      const double speed = aspi_length(touch.before.v), same = SAME * one.radius;
      const double latest = std::min(time, speed > 0 ? first + same / speed : time);
      if (!(one.mask & wall(touch).setup.groupbit) ||
          !shape(touch).shape->find(touch.before, one.radius, latest, touch.contact))
        continue;
      if ((first - touch.contact.time) * touch.contact.closing > same)
        touches_.clear();
      first = std::min(first, touch.contact.time);
      touches_.push_back(touch);
    }
  }
}

/* Moves the body to its next contacts, or to the end of the step: then false. */
bool Way::find_next() {
  while (left_ > 0) {
    double omega[3];
    spin_of(body_, omega);
    const double rate = aspi_length(omega);
    double time = rate * left_ > TURN ? TURN / rate : left_;
    Body end = body_;
    if (body_.is_changed || time < left_)
      advance(end, time);
    else
      end = arrival_;
    search(end, time);
    if (touches_.empty()) {
      body_ = end;
      left_ = time < left_ ? left_ - time : 0;
      moved_ += time;
      continue;
    }
    const Touch *first = &touches_[0];
    for (const Touch &touch : touches_)
      if (touch.contact.time < first->contact.time)
        first = &touch;
    time = first->contact.time;
    advance(body_, time);
    left_ = std::max(0.0, left_ - time);
    moved_ += time;
    double arm[3], at[3];
    arm_of(body_, sphere(*first), arm);
    aspi_add_scaled(body_.x, 1, arm, at);
    aspi_subtract(first->contact.x, at, at);
    aspi_add_scaled(body_.x, 1, at, body_.x);
    return true;
  }
  return false;
}

/* The velocity at this instant. */
void Way::velocity(double v[3]) const {
  aspi_add_scaled(body_.v, 0.5 * bodies_.dt - left_, body_.acceleration, v);
}

/* True for an impact, false for a contact that stays, by the criterion of step.cpp. */
bool Way::arrives(const Touch &touch, double &approach) const {
  double v[3], u[3], omega[3], arm[3], turned[3];
  velocity(v);
  spin_of(body_, omega);
  arm_of(body_, sphere(touch), arm);
  aspi_cross(omega, arm, turned);
  aspi_subtract(v, touch.contact.v_wall, u);
  aspi_add_scaled(u, 1, turned, u);
  approach = -aspi_dot(u, touch.contact.n);
  const asp_body inverse = inverse_of(body_, arm);
  double couple[3], turn[3];
  aspi_cross(arm, touch.contact.n, couple);
  multiply(inverse.inverse_inertia, couple, turn);
  /* A body that stands on another point of it falls that much faster here, at most. */
  const double more = 1 + body_.mass * aspi_dot(couple, turn);
  const double press =
      more * (touch.contact.follow - aspi_dot(body_.acceleration, touch.contact.n));
  return approach > std::max((1 + ROUNDING) * 0.5 * bodies_.dt * press, GRAZING * aspi_length(u));
}

/* True unless this sphere has met the face before; the body remembers one face. */
bool Way::is_new_face(const Touch &touch, const asp_particle &particle) {
  BodyMemory &memory = *bodies_.memory[touch.wall][number_];
  const Contact &contact = touch.contact;
  double point[3], way[3];
  aspi_add_scaled(contact.x, -sphere(touch).radius, contact.n, point);
  const bool same = memory.sphere == static_cast<double>(sphere(touch).tag) &&
                    aspi_dot(memory.n, contact.n) > OTHER_WALL;
  wall(touch).setup.box.bring_near(point, memory.at);
  aspi_subtract(point, memory.at, way);
  aspi_add_scaled(way, -aspi_dot(way, contact.n), contact.n, way);
  const double length = asp_wall_face_length(law(touch), &particle, way, contact.n);
  if (same && aspi_dot(way, way) < length * length)
    return false;
  memory.sphere = static_cast<double>(sphere(touch).tag);
  aspi_copy(point, memory.at);
  aspi_copy(contact.n, memory.n);
  return true;
}

/* An impact that is to be counted, without its result. */
Impact Way::impact_of(const Touch &touch) {
  const Setup &setup = wall(touch).setup;
  BodyMemory &memory = *bodies_.memory[touch.wall][number_];
  Impact impact = Impact();
  impact.shape = touch.shape;
  impact.contact = touch.contact;
  velocity(impact.v1);
  aspi_subtract(impact.v1, touch.contact.v_wall, impact.v1);
  spin_of(body_, impact.omega1);
  impact.time = setup.time(static_cast<double>(bodies_.step)) - left_;
  impact.key.seed = setup.model.seed();
  impact.key.wall = setup.key;
  impact.key.tag = static_cast<uint64_t>(sphere(touch).tag);
  impact.key.impact = static_cast<uint32_t>(++memory.impacts);
  impact.body = body_.tag + 1;
  arm_of(body_, sphere(touch), impact.lever);
  return impact;
}

/* One sphere hits the wall, by the wall's law. */
void Way::hit(const Touch &touch) {
  const Setup &setup = wall(touch).setup;
  Impact impact = impact_of(touch);
  double lay[3] = {0, 0, 1}, momentum[3], arm[3];
  const asp_body inverse = inverse_of(body_, impact.lever);
  asp_particle particle = asp_particle();
  particle.d_p = 2 * sphere(touch).radius;
  particle.pair = setup.model.pair(sphere(touch).type, shape(touch).wall_type);
  particle.body = &inverse;
  aspi_copy(impact.omega1, particle.omega);
  if (setup.model.lay().kind != ASP_LAY_NONE) {
    shape(touch).shape->lay(setup.model.lay(), touch.before, touch.contact, lay);
    particle.lay = lay;
  }
  (is_new_face(touch, particle) ? asp_wall_impact : asp_wall_impact_mean)(
      law(touch), &particle, impact.v1, touch.contact.n, &impact.key, &impact.result);

  const double before = energy_of(body_, impact.v1);
  momentum_of(body_, impact.result.omega, momentum);
  double p[3], turn[3];
  aspi_subtract(impact.result.v2, impact.v1, p);
  aspi_add_scaled(body_.v, 1, p, body_.v);
  aspi_subtract(momentum, body_.angular_momentum, turn);
  aspi_copy(momentum, body_.angular_momentum);
  const One one(bodies_, body_, sphere(touch));
  ContactLoad load(one.view, 0, touch.contact.piece, touch.contact.x, touch.contact.n, p,
                   impact.v1);
  aspi_subtract(body_.x, load.point, arm);
  aspi_cross(arm, load.impulse, load.couple);
  aspi_add_scaled(load.couple, -1, turn, load.couple);
  load.dissipated = before - energy_of(body_, impact.result.v2);
  load.eroded = body_.mass * impact.result.eroded;
  wall(touch).books.count(one.view, 0, impact, &load);
}

/* The contact for solve_body(). */
void Way::point_of(const Touch &touch, BodyPoint &point) const {
  aspi_copy(touch.contact.n, point.n);
  aspi_copy(touch.contact.v_wall, point.w);
  arm_of(body_, sphere(touch), point.arm);
  aspi_add_scaled(point.arm, -sphere(touch).radius, point.n, point.arm);
  point.friction = wall(touch).setup.model.friction(sphere(touch).type, shape(touch).wall_type);
}

/* Several spheres hit a smooth wall at one instant. Their restitution is that of the law for the
 * approach of each alone, on average. */
void Way::hit_together(const std::vector<Touch> &touches) {
  std::vector<Impact> impacts;
  points_.resize(touches.size());
  double e = 0, v[3], spin[3];
  velocity(v);
  spin_of(body_, spin);
  const double none[3] = {0, 0, 0};
  const asp_body inverse = inverse_of(body_, none);
  for (size_t k = 0; k < touches.size(); k++) {
    const Touch &touch = touches[k];
    const Setup &setup = wall(touch).setup;
    point_of(touch, points_[k]);
    impacts.push_back(impact_of(touch));
    asp_particle particle = asp_particle();
    asp_body alone = inverse;
    aspi_copy(impacts[k].lever, alone.lever);
    particle.d_p = 2 * sphere(touch).radius;
    particle.pair = setup.model.pair(sphere(touch).type, shape(touch).wall_type);
    particle.body = &alone;
    const double approach[3] = {-touch.contact.n[0], -touch.contact.n[1], -touch.contact.n[2]};
    double speed, u[3];
    arrives(touch, speed);
    aspi_copy(approach, u);
    aspi_scale(speed, u);
    asp_impact result;
    asp_wall_impact_mean(law(touch), &particle, u, touch.contact.n, &impacts[k].key, &result);
    double turned[3];
    aspi_cross(result.omega, impacts[k].lever, turned);
    e += (aspi_dot(result.v2, touch.contact.n) + aspi_dot(turned, touch.contact.n)) / speed;
  }
  e = std::min(1.0, std::max(0.0, e / static_cast<double>(touches.size())));
  solve_body(inverse, v, spin, points_);
  double change[3] = {0, 0, 0}, turn[3] = {0, 0, 0};
  for (BodyPoint &point : points_) {
    double couple[3];
    aspi_scale(1 + e, point.p);
    aspi_add_scaled(change, 1 / body_.mass, point.p, change);
    aspi_cross(point.arm, point.p, couple);
    aspi_add_scaled(turn, 1, couple, turn);
  }
  const double before = energy_of(body_, v);
  aspi_add_scaled(v, 1, change, v);
  aspi_add_scaled(body_.v, 1, change, body_.v);
  aspi_add_scaled(body_.angular_momentum, 1, turn, body_.angular_momentum);
  const double lost = before - energy_of(body_, v);
  for (size_t k = 0; k < touches.size(); k++) {
    const Touch &touch = touches[k];
    Impact &impact = impacts[k];
    aspi_add_scaled(impact.v1, 1, change, impact.result.v2);
    spin_of(body_, impact.result.omega);
    impact.result.hits = 1;
    const One one(bodies_, body_, sphere(touch));
    double p[3];
    aspi_copy(points_[k].p, p);
    aspi_scale(1 / body_.mass, p);
    ContactLoad load(one.view, 0, touch.contact.piece, touch.contact.x, touch.contact.n, p,
                     impact.v1);
    load.dissipated = lost / static_cast<double>(touches.size());
    wall(touch).books.count(one.view, 0, impact, &load);
  }
}

/* All contacts of this instant stay for the rest of the step. */
void Way::stay() {
  points_.resize(touches_.size());
  double spin[3];
  const double none[3] = {0, 0, 0};
  spin_of(body_, spin);
  for (size_t k = 0; k < touches_.size(); k++) {
    const Touch &touch = touches_[k];
    BodyPoint &point = points_[k];
    point_of(touch, point);
    double arm[3], ahead[3], u[3];
    arm_of(body_, sphere(touch), arm);
    aspi_cross(spin, arm, u);
    aspi_add_scaled(u, 1, body_.v, u);
    aspi_subtract(u, touch.before.v, ahead); /* by what the turn bends the path to the wall */
    const double bend = std::max(0.0, aspi_dot(ahead, point.n));
    aspi_subtract(touch.before.v, touch.contact.v_wall, u);
    aspi_add_scaled(point.w, bend + CLEAR * fabs(aspi_dot(u, point.n)), point.n, point.w);
  }
  solve_body(inverse_of(body_, none), body_.v, spin, points_);
  const double before = energy_of(body_, body_.v);
  double v1[3];
  aspi_copy(body_.v, v1);
  for (const BodyPoint &point : points_) {
    double couple[3];
    aspi_add_scaled(body_.v, 1 / body_.mass, point.p, body_.v);
    aspi_cross(point.arm, point.p, couple);
    aspi_add_scaled(body_.angular_momentum, 1, couple, body_.angular_momentum);
  }
  const double lost = before - energy_of(body_, body_.v);
  for (size_t k = 0; k < touches_.size(); k++) {
    const Touch &touch = touches_[k];
    const One one(bodies_, body_, sphere(touch));
    double p[3], u[3];
    aspi_copy(points_[k].p, p);
    aspi_scale(1 / body_.mass, p);
    aspi_subtract(v1, touch.contact.v_wall, u);
    ContactLoad load(one.view, 0, touch.contact.piece, touch.contact.x, touch.contact.n, p, u);
    load.dissipated = lost / static_cast<double>(touches_.size());
    wall(touch).books.add_load(touch.shape, load);
  }
}

/* The contacts of this instant: an impact, several at a smooth wall, or all of them stay. */
void Way::meet(bool all_stay) {
  std::vector<Touch> arriving;
  for (const Touch &touch : touches_) {
    double approach;
    if (!all_stay && arrives(touch, approach))
      arriving.push_back(touch);
  }
  if (arriving.empty())
    stay();
  else if (arriving.size() > 1 && !asp_wall_surface(law(arriving[0])))
    hit_together(arriving);
  else
    hit(arriving[0]);
  body_.is_changed = true;
}

void Way::go() {
  int series = 0;
  find_near();
  if (near_.empty())
    return;
  advance(body_, -bodies_.dt);
  while (find_next()) {
    series = moved_ > 1e-6 * bodies_.dt ? 0 : series + 1;
    moved_ = 0;
    if (series == 2 * SERIES) {
      wall(touches_[0]).books.count_guarded();
      return;
    }
    meet(series > SERIES);
    find_near();
  }
  if (!body_.is_changed)
    body_ = arrival_;
}

} // namespace

void asperity::spin_of(const Body &body, double omega[3]) {
  for (int d = 0; d < 3; d++)
    omega[d] = 0;
  for (int k = 0; k < 3; k++)
    if (body.inertia[k] > 0)
      aspi_add_scaled(omega, aspi_dot(body.angular_momentum, body.axes[k]) / body.inertia[k],
                      body.axes[k], omega);
}

void asperity::step_bodies(const std::vector<Stepper *> &walls, Bodies &bodies) {
  for (size_t b = 0; b < bodies.all.size(); b++)
    Way(walls, bodies, b).go();
}
