/* Bodies that stay at walls, and the faces and valleys of rough walls that their spheres meet; see
 * bodies.h and faces.cpp, whose rules hold for each touching sphere. A body lies in a valley by the
 * energy of its whole motion along the wall, per mass; the valley acts on the center of the sphere
 * that lies there, as friction. A sphere about the center of mass does all that a particle does.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <algorithm>

#include "asperity_front.h"
#include "contact/vector.h"
#include "dem/step/body_motion.h"
#include "dem/step/body_way.h"
#include "dem/step/flight.h"

using namespace asperity;

/* How far from its wall a contact that stays is at the end of the step, in radii: beyond rounding.
 */
static const double CLEAR = 1e-9;

/* A sphere is about the center of mass if it is off by less than this share of its radius: engines
 * find the center by random points. */
static const double CENTRAL = 0.01;

/* ---- faces ------------------------------------------------------------------------------------
 */

/* The point where a sphere touches. */
static void foot_of(const Touch &touch, double radius, double point[3]) {
  aspi_add_scaled(touch.contact.x, -radius, touch.contact.n, point);
}

static FacePlace *face_of(BodyMemory &memory, double sphere, const double n[3]) {
  for (BodyFace &one : memory.faces)
    if (one.sphere == sphere && aspi_dot(one.face.normal, n) > SAME_WALL)
      return &one.face;
  return NULL;
}

/* The face that the sphere has met already; NULL: it meets a new one, to which it has `moved` along
 * the wall. */
FacePlace *Way::find_face(const Touch &touch, bool &moved) const {
  const Contact &contact = touch.contact;
  const Setup &setup = wall(touch).setup;
  moved = false;
  FacePlace *const face =
      face_of(memory(touch.wall), static_cast<double>(sphere(touch).tag), contact.n);
  if (!face || !asp_wall_surface(law(touch)))
    return NULL;
  double point[3], at[3], way[3], lay[3];
  const double none[3] = {0, 0, 0};
  const double now = setup.time(static_cast<double>(bodies_.step)) - left_;
  const asp_body inverse = inverse_of(body_, none);
  const asp_particle here = particle(touch, inverse, lay);
  foot_of(touch, sphere(touch).radius, point);
  aspi_add_scaled(face->at, now - face->time, contact.v_wall, at);
  setup.box.bring_near(point, at);
  aspi_subtract(point, at, way);
  aspi_add_scaled(way, -aspi_dot(way, contact.n), contact.n, way);
  const double length = asp_wall_face_length(law(touch), &here, way, contact.n);
  moved = aspi_dot(way, way) >= length * length;
  return moved ? NULL : face;
}

/* The body remembers the face of this contact; a new one in the place of the oldest. */
void Way::meet_face(const Touch &touch) {
  if (!asp_wall_surface(law(touch)))
    return;
  bool moved;
  const Setup &setup = wall(touch).setup;
  const double tag = static_cast<double>(sphere(touch).tag), *n = touch.contact.n;
  const double now = setup.time(static_cast<double>(bodies_.step)) - left_;
  double point[3];
  foot_of(touch, sphere(touch).radius, point);
  FacePlace *face = find_face(touch, moved);
  if (face) {
    aspi_add_scaled(face->at, now - face->time, touch.contact.v_wall, face->at);
    setup.box.bring_near(point, face->at);
  } else {
    BodyMemory &of = memory(touch.wall);
    face = face_of(of, tag, n);
    if (!face) {
      BodyFace *oldest = of.faces;
      for (BodyFace &one : of.faces)
        if (oldest->sphere > 0 && (!(one.sphere > 0) || one.face.time < oldest->face.time))
          oldest = &one;
      oldest->sphere = tag;
      face = &oldest->face;
    }
    aspi_copy(point, face->at);
    face->start = face->height = 0;
  }
  aspi_copy(n, face->normal);
  face->time = now;
}

/* ---- valleys ----------------------------------------------------------------------------------
 */

asp_key Way::next_key(const Touch &touch) {
  const Setup &setup = wall(touch).setup;
  return asp_key{setup.model.seed(), setup.stay_key, static_cast<uint64_t>(sphere(touch).tag),
                 static_cast<uint32_t>(++memory(touch.wall).draws)};
}

/* The valley behind the known face of a contact, drawn on its first use. */
const FacePlace &Way::valley(const Touch &touch, FacePlace &face) {
  if (face.start > 0)
    return face;
  double lay[3], u[3];
  const double none[3] = {0, 0, 0};
  const asp_body inverse = inverse_of(body_, none);
  const asp_particle here = particle(touch, inverse, lay);
  const asp_key key = next_key(touch);
  relative_velocity(touch, u);
  const asp_valley drawn = asp_wall_valley(law(touch), &here, u, touch.contact.n, &key);
  face.start = drawn.start;
  face.height = drawn.height;
  return face;
}

/* The energy of the motion along the wall, per mass. */
double Way::energy_along(const Touch &touch) const {
  const double *n = touch.contact.n;
  double v[3], omega[3];
  Body along = body_;
  velocity(v);
  aspi_subtract(v, touch.contact.v_wall, v);
  aspi_add_scaled(v, -aspi_dot(v, n), n, v);
  spin_of(body_, omega);
  aspi_add_scaled(omega, -aspi_dot(omega, n), n, omega);
  momentum_of(body_, omega, along.angular_momentum);
  return energy_of(along, v) / body_.mass;
}

/* The slope that the valley withstands in which the sphere lies, where `push` presses the body to
 * the wall; 0: it lies in none. */
double Way::hold_of(const Touch &touch, double push) {
  bool moved;
  const Setup &setup = wall(touch).setup;
  FacePlace *const face =
      setup.interlocks && setup.model.dissipates() ? find_face(touch, moved) : NULL;
  if (!face)
    return 0;
  const FacePlace &at = valley(touch, *face), *others[BodyMemory::FACES];
  size_t n = 0;
  for (const BodyFace &one : memory(touch.wall).faces)
    if (one.sphere > 0 && aspi_dot(one.face.normal, at.normal) <= SAME_WALL)
      others[n++] = &one.face;
  return lies_in_valley(at, others, n, energy_along(touch), push, body_.acceleration) ? at.start
                                                                                      : 0;
}

/* True if a bounce on the mean wall is lower than the wall's own heights. */
bool Way::is_low(const Touch &touch, double approach) {
  bool moved;
  const double push = -aspi_dot(body_.acceleration, touch.contact.n);
  FacePlace *const face =
      wall(touch).setup.model.dissipates() && push > 0 ? find_face(touch, moved) : NULL;
  return face && 0.5 * approach * approach < push * valley(touch, *face).height;
}

/* Changes the velocity and the angular momentum; the wall takes what is lost. */
void Way::brake(const Touch &touch, const double change[3], const double turn[3]) {
  double before[3], after[3];
  velocity(before);
  aspi_subtract(before, touch.contact.v_wall, before);
  aspi_add_scaled(before, 1, change, after);
  const double energy = energy_of(body_, before);
  aspi_add_scaled(body_.v, 1, change, body_.v);
  aspi_add_scaled(body_.angular_momentum, 1, turn, body_.angular_momentum);
  ContactLoad load = load_of(touch, change, turn, before);
  load.dissipated = energy - energy_of(body_, after);
  wall(touch).books.add_load(touch.shape, load);
}

/* True for a sphere about the center of mass. */
bool Way::is_ball(const Touch &touch) const {
  return aspi_length(sphere(touch).arm) < CENTRAL * sphere(touch).radius;
}

/* A sphere that bounces in its valley loses its motion along the wall. */
void Way::stop_along(const Touch &touch) {
  const double *n = touch.contact.n, *turn = body_.angular_momentum;
  double change[3], still[3];
  if (!is_ball(touch) || !(hold_of(touch, -aspi_dot(body_.acceleration, n)) > 0))
    return;
  velocity(change);
  aspi_subtract(touch.contact.v_wall, change, change);
  aspi_add_scaled(change, -aspi_dot(change, n), n, change);
  for (int d = 0; d < 3; d++)
    still[d] = aspi_dot(turn, n) * n[d] - turn[d];
  brake(touch, change, still);
}

/* The impact on the next face of a sphere that stays: it comes along the wall, after the mean wall
 * has taken its approach. */
bool Way::graze(const Touch &touch) {
  bool moved;
  double lay[3], arm[3], u[3], change[3], turn[3];
  const double *n = touch.contact.n;
  find_face(touch, moved);
  if (!moved)
    return false;
  meet_face(touch);
  relative_velocity(touch, u);
  arm_of(body_, sphere(touch), arm);
  const asp_body inverse = inverse_of(body_, arm);
  const double stops = -aspi_dot(u, n) / inverse_mass_at(inverse, arm, n);
  aspi_copy(n, change);
  aspi_scale(stops / body_.mass, change);
  aspi_cross(arm, n, turn);
  aspi_scale(stops, turn);
  Body along = body_;
  aspi_add_scaled(body_.angular_momentum, 1, turn, along.angular_momentum);
  velocity(u);
  aspi_subtract(u, touch.contact.v_wall, u);
  aspi_add_scaled(u, 1, change, u);
  asp_particle here = particle(touch, inverse, lay);
  spin_of(along, here.omega);
  const asp_key key = next_key(touch);
  asp_impact result;
  if (!asp_wall_impact_grazing(law(touch), &here, u, n, press(touch), &key, &result))
    return false;
  brake(touch, change, turn);
  Impact impact = impact_of(touch);
  impact.result = result;
  apply(touch, impact);
  return true;
}

/* ---- what stays -------------------------------------------------------------------------------
 */

/* The points of all contacts of this instant, with the speeds that they need. */
void Way::add_points() {
  double spin[3];
  spin_of(body_, spin);
  points_.resize(touches_.size());
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
    /* The wall's mean speed, and a little more. */
    const double least = aspi_dot(touch.before.v, point.n) + std::max(0.0, touch.contact.closing) +
                         CLEAR * sphere(touch).radius / bodies_.dt;
    aspi_add_scaled(point.w, bend + least - aspi_dot(point.w, point.n), point.n, point.w);
  }
}

/* The loads of all contacts that stay: friction takes energy where it slides, and a bounce that is
 * too low to be one. */
void Way::count_stay(const double v1[3]) {
  const double none[3] = {0, 0, 0};
  double spin[3];
  spin_of(body_, spin);
  for (size_t k = 0; k < touches_.size(); k++) {
    const Touch &touch = touches_[k];
    const BodyPoint &point = points_[k];
    double u[3], turned[3];
    aspi_subtract(v1, touch.contact.v_wall, u);
    ContactLoad load = load_of_point(touch, point, u);
    aspi_cross(spin, point.arm, turned);
    aspi_subtract(body_.v, point.w, u);
    aspi_add_scaled(u, 1, turned, u);
    aspi_add_scaled(u, -aspi_dot(u, point.n), point.n, u);
    load.dissipated = std::max(0.0, -aspi_dot(point.p, u));
    if (touch.is_low) {
      double arm[3];
      arm_of(body_, sphere(touch), arm);
      load.dissipated += 0.5 * touch.approach * touch.approach /
                         inverse_mass_at(inverse_of(body_, none), arm, point.n);
    }
    wall(touch).books.add_load(touch.shape, load);
    memory(touch.wall).stayed = static_cast<double>(bodies_.step) + 1;
  }
}

/* All contacts of this instant stay for the rest of the step. */
void Way::stay(bool in_valleys) {
  const double none[3] = {0, 0, 0};
  double spin[3], v1[3];
  for (Touch &touch : touches_) {
    meet_face(touch);
    touch.hold = in_valleys ? hold_of(touch, press(touch)) : 0;
  }
  add_points();
  spin_of(body_, spin);
  aspi_copy(body_.v, v1);
  solve_body(inverse_of(body_, none), body_.v, spin, points_);
  for (const BodyPoint &point : points_) {
    double couple[3];
    aspi_add_scaled(body_.v, 1 / body_.mass, point.p, body_.v);
    aspi_cross(point.arm, point.p, couple);
    aspi_add_scaled(body_.angular_momentum, 1, couple, body_.angular_momentum);
  }
  count_stay(v1);
  for (size_t k = 0; k < touches_.size(); k++) {
    const double *n = touches_[k].contact.n, *turn = body_.angular_momentum;
    if (!is_ball(touches_[k]) || !(touches_[k].hold > 0) || !(aspi_dot(points_[k].p, n) > 0))
      continue;
    double still[3];
    for (int d = 0; d < 3; d++)
      still[d] = aspi_dot(turn, n) * n[d] - turn[d];
    brake(touches_[k], none, still);
  }
}
