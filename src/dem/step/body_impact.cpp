/* Impacts of bodies: of one sphere, by the wall's law, or of several at a smooth wall; see
 * bodies.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <algorithm>

#include "asperity_front.h"
#include "contact/vector.h"
#include "dem/step/body_motion.h"
#include "dem/step/body_way.h"

using namespace asperity;

TouchingSphere::TouchingSphere(const Bodies &bodies, const Body &body, const BodySphere &sphere)
    : tag(sphere.tag), view() {
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

/* The particle that the law sees. lay: room for the wall's lay. */
asp_particle Way::particle(const Touch &touch, const asp_body &inverse, double lay[3]) const {
  const Setup &setup = wall(touch).setup;
  asp_particle made = asp_particle();
  made.d_p = 2 * sphere(touch).radius;
  made.pair = setup.model.pair(sphere(touch).type, shape(touch).wall_type);
  made.body = &inverse;
  spin_of(body_, made.omega);
  lay[0] = lay[1] = 0;
  lay[2] = 1;
  if (setup.model.lay().kind != ASP_LAY_NONE) {
    shape(touch).shape->lay(setup.model.lay(), touch.before, touch.contact, lay);
    made.lay = lay;
  }
  return made;
}

/* An impact that is to be counted, without its result. */
Impact Way::impact_of(const Touch &touch) {
  const Setup &setup = wall(touch).setup;
  Impact impact = Impact();
  impact.shape = touch.shape;
  impact.contact = touch.contact;
  /* A body crosses a periodic edge when its rank finds it there: the row has the place in the box.
   */
  double middle[3];
  aspi_add_scaled(setup.box.lo, 0.5, setup.box.period, middle);
  setup.box.bring_near(middle, impact.contact.x);
  velocity(impact.v1);
  aspi_subtract(impact.v1, touch.contact.v_wall, impact.v1);
  spin_of(body_, impact.omega1);
  impact.time = setup.time(static_cast<double>(bodies_.step)) - left_;
  impact.key.seed = setup.model.seed();
  impact.key.wall = setup.key;
  impact.key.tag = static_cast<uint64_t>(sphere(touch).tag);
  impact.key.impact = static_cast<uint32_t>(++memory(touch.wall).impacts);
  impact.body = body_.tag + 1;
  arm_of(body_, sphere(touch), impact.lever);
  return impact;
}

/* The load by a change of the body's velocity, and of its angular momentum. */
ContactLoad Way::load_of(const Touch &touch, const double change[3], const double turn[3],
                         const double v1[3]) const {
  const TouchingSphere one(bodies_, body_, sphere(touch));
  double arm[3];
  ContactLoad load(one.view, 0, touch.contact.piece, touch.contact.x, touch.contact.n, change, v1);
  load.particle = -1;
  aspi_subtract(body_.x, load.point, arm);
  aspi_cross(arm, load.impulse, load.couple);
  aspi_add_scaled(load.couple, -1, turn, load.couple);
  return load;
}

/* The law's result for one sphere. */
void Way::work_out(const Touch &touch, Impact &impact) {
  double lay[3];
  const asp_body inverse = inverse_of(body_, impact.lever);
  const asp_particle one = particle(touch, inverse, lay);
  bool moved;
  (find_face(touch, moved) ? asp_wall_impact_mean : asp_wall_impact)(
      law(touch), &one, impact.v1, touch.contact.n, &impact.key, &impact.result);
}

/* Gives the body what an impact has left it, counts that, and holds the body if it sticks. */
void Way::apply(const Touch &touch, const Impact &impact) {
  const double before = energy_of(body_, impact.v1);
  double change[3], momentum[3], turn[3];
  momentum_of(body_, impact.result.omega, momentum);
  aspi_subtract(impact.result.v2, impact.v1, change);
  aspi_add_scaled(body_.v, 1, change, body_.v);
  aspi_subtract(momentum, body_.angular_momentum, turn);
  aspi_copy(momentum, body_.angular_momentum);
  ContactLoad load = load_of(touch, change, turn, impact.v1);
  load.dissipated = before - energy_of(body_, impact.result.v2);
  load.eroded = body_.mass * impact.result.eroded;
  const TouchingSphere one(bodies_, body_, sphere(touch));
  wall(touch).books.count(one.view, 0, impact, &load);
  if (impact.result.outcome == ASP_DEPOSIT)
    stick(touch);
}

/* One sphere hits the wall, by the wall's law. */
void Way::hit(const Touch &touch) {
  stop_along(touch);
  Impact impact = impact_of(touch);
  work_out(touch, impact);
  meet_face(touch);
  apply(touch, impact);
}

/* A contact too slow for an impact: true if the body sticks. */
bool Way::sticks(const Touch &touch) {
  if (!wall(touch).setup.model.sticks())
    return false;
  Impact impact = impact_of(touch);
  work_out(touch, impact);
  if (impact.result.outcome == ASP_DEPOSIT)
    apply(touch, impact);
  else
    memory(touch.wall).impacts--;
  return is_stuck_;
}

/* The contact for solve_body(). In a valley the faces around the sphere act on its center. */
void Way::point_of(const Touch &touch, BodyPoint &point) const {
  aspi_copy(touch.contact.n, point.n);
  aspi_copy(touch.contact.v_wall, point.w);
  arm_of(body_, sphere(touch), point.arm);
  point.friction = touch.hold;
  if (touch.hold > 0)
    return;
  aspi_add_scaled(point.arm, -sphere(touch).radius, point.n, point.arm);
  point.friction = wall(touch).setup.model.friction(sphere(touch).type, shape(touch).wall_type);
}

/* The restitution of a sphere as if it hit alone; true if it sticks. */
bool Way::hit_alone(const Touch &touch, const Impact &impact, double &restitution) const {
  const asp_body inverse = inverse_of(body_, impact.lever);
  double lay[3], u[3], approach, turned[3];
  asp_particle one = particle(touch, inverse, lay);
  std::fill(one.omega, one.omega + 3, 0.0);
  arrives(touch, approach);
  aspi_copy(touch.contact.n, u);
  aspi_scale(-approach, u);
  asp_impact result;
  asp_wall_impact_mean(law(touch), &one, u, touch.contact.n, &impact.key, &result);
  aspi_cross(result.omega, impact.lever, turned);
  restitution =
      (aspi_dot(result.v2, touch.contact.n) + aspi_dot(turned, touch.contact.n)) / approach;
  return result.outcome == ASP_DEPOSIT;
}

/* Several spheres hit a smooth wall at one instant. Their restitution is that of the law for the
 * approach of each alone, on average; if one of them sticks, the body does. */
void Way::hit_together(const std::vector<Touch> &touches) {
  std::vector<Impact> impacts;
  points_.resize(touches.size());
  double e = 0, v[3], spin[3];
  const double none[3] = {0, 0, 0};
  velocity(v);
  spin_of(body_, spin);
  for (size_t k = 0; k < touches.size(); k++) {
    double restitution;
    point_of(touches[k], points_[k]);
    impacts.push_back(impact_of(touches[k]));
    if (hit_alone(touches[k], impacts[k], restitution)) {
      for (size_t j = 0; j < k; j++)
        memory(touches[j].wall).impacts--;
      impacts[k].key.impact = static_cast<uint32_t>(memory(touches[k].wall).impacts);
      impacts[k].result.outcome = ASP_DEPOSIT;
      impacts[k].result.hits = 1;
      apply(touches[k], impacts[k]);
      return;
    }
    e += restitution;
  }
  e = std::min(1.0, std::max(0.0, e / static_cast<double>(touches.size())));
  solve_body(inverse_of(body_, none), v, spin, points_);
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
    Impact &impact = impacts[k];
    aspi_add_scaled(impact.v1, 1, change, impact.result.v2);
    spin_of(body_, impact.result.omega);
    impact.result.hits = 1;
    ContactLoad load = load_of_point(touches[k], points_[k], impact.v1);
    load.dissipated = lost / static_cast<double>(touches.size());
    const TouchingSphere one(bodies_, body_, sphere(touches[k]));
    wall(touches[k]).books.count(one.view, 0, impact, &load);
  }
}

/* The load of one of several contacts. */
ContactLoad Way::load_of_point(const Touch &touch, const BodyPoint &point,
                               const double v1[3]) const {
  double change[3], turn[3];
  aspi_copy(point.p, change);
  aspi_scale(1 / body_.mass, change);
  aspi_cross(point.arm, point.p, turn);
  return load_of(touch, change, turn, v1);
}
