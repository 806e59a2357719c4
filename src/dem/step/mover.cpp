/* A grain or a rigid body; see mover.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/mover.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

bool is_round(const Body &body, const BodySphere &one) {
  const double of_ball = 0.4 * body.mass * one.radius * one.radius;
  bool all = body.count == 1 && aspi_length(one.arm) <= SUM_ROUNDING * one.radius;
  for (int k = 0; k < 3; k++)
    all = all && fabs(body.inertia[k] - of_ball) <= SUM_ROUNDING * of_ball;
  return all;
}

} // namespace

/* ---- what it remembers ---- */

std::vector<Rest> WallMemory::NO_RESTS;

bool WallMemory::rests_at(int64_t sphere, size_t shape, int face) const {
  for (const Rest &rest : rests())
    if (static_cast<int64_t>(rest.sphere) == sphere &&
        static_cast<size_t>(rest.shape) == shape + 1 && static_cast<int>(rest.face) == face)
      return true;
  return false;
}

void WallMemory::rest_at(int64_t sphere, size_t shape, int face) const {
  Rest made = Rest();
  made.sphere = static_cast<double>(sphere);
  made.shape = static_cast<double>(shape) + 1;
  made.face = face;
  if (rests_at(sphere, shape, face))
    return;
  own();
  set_status(Status::RESTING);
  std::vector<Rest> &all = rests();
  const auto idle = std::find_if(all.begin(), all.end(), [](const Rest &rest) {
    return !(aspi_dot(rest.push, rest.push) > 0);
  });
  if (all.size() < RESTS_MOST * spheres_)
    all.push_back(made);
  else if (idle != all.end())
    *idle = made;
}

bool WallMemory::drop_gone() const {
  std::vector<Rest> &all = rests();
  const auto last =
      std::remove_if(all.begin(), all.end(), [](const Rest &rest) { return !(rest.shape >= 1); });
  const bool any = last != all.end();
  all.erase(last, all.end());
  if (all.empty())
    set_status(Status::FREE);
  return any;
}

FacePlace *WallMemory::face_of(int64_t sphere, const double n[3]) const {
  Memory *of = rows_.find(i_);
  for (size_t k = 0; of && k < of->faces.size(); k++)
    if (aspi_dot(of->faces[k].normal, n) > SAME_WALL &&
        static_cast<int64_t>(of->faces[k].sphere) == sphere)
      return &of->faces[k];
  return NULL;
}

FacePlace &WallMemory::new_face() const {
  std::vector<FacePlace> &faces = own().faces;
  if (faces.size() < FACES_MOST * spheres_) {
    faces.push_back(FacePlace());
    return faces.back();
  }
  return *std::min_element(
      faces.begin(), faces.end(),
      [](const FacePlace &one, const FacePlace &other) { return one.time < other.time; });
}

/* ---- what it is ---- */

void Mover::set_body(const Movers &all) {
  body = &all.bodies->all[static_cast<size_t>(i)];
  mass = body->mass;
  sphere = &all.bodies->spheres[body->first];
  count = body->count;
  is_ball = is_round(*body, *sphere);
  set_axes(body->axes);
}

size_t Mover::number_of(double tag) const {
  size_t k = 0;
  while (k < count && static_cast<double>(sphere[k].tag) != tag)
    k++;
  return k;
}

size_t Mover::anchor(const Stuck &at) const {
  const size_t k = number_of(at.sphere);
  return k < count ? k : 0;
}

bool Mover::is_central(size_t k) const {
  return is_ball || aspi_length(sphere[k].arm) < NEAR * sphere[k].radius;
}

/* ---- all of them ---- */

void Movers::read_body(const Mover &mover, Instant &now) const {
  double momentum[3];
  aspi_copy(mover.body->x, now.x);
  aspi_copy(mover.body->v, now.v);
  aspi_copy(mover.body->angular_momentum, momentum);
  aspi_scale(1 / mover.mass, momentum);
  mover.spin_of(momentum, now.spin);
}

void Movers::read_body_rates(const Mover &mover, Instant &now) const {
  double torque[3];
  aspi_copy(mover.body->acceleration, now.a);
  aspi_copy(mover.body->torque, torque);
  aspi_scale(1 / mover.mass, torque);
  mover.spin_of(torque, now.alpha);
}

void Movers::place(const Mover &mover, const double x[3]) const {
  if (!mover.body) {
    aspi_copy(x, grains->x + 3 * static_cast<size_t>(mover.i));
    return;
  }
  Body &body = bodies->all[static_cast<size_t>(mover.i)];
  if (memcmp(body.x, x, sizeof body.x) == 0 && memcmp(body.axes, mover.axes, sizeof body.axes) == 0)
    return;
  body.is_changed = true;
  aspi_copy(x, body.x);
  memcpy(body.axes, mover.axes, sizeof body.axes);
}

void Movers::write_body(const Mover &mover, const double v[3], const double spin[3]) const {
  Body &body = bodies->all[static_cast<size_t>(mover.i)];
  body.is_changed = true;
  aspi_copy(v, body.v);
  mover.momentum_of(spin, body.angular_momentum);
  aspi_scale(mover.mass, body.angular_momentum);
}

void Movers::push_body(const Mover &mover, const double a[3], const double alpha[3]) const {
  double torque[3];
  Body &body = bodies->all[static_cast<size_t>(mover.i)];
  body.is_changed = true;
  aspi_add_scaled(body.acceleration, 1, a, body.acceleration);
  mover.momentum_of(alpha, torque);
  aspi_add_scaled(body.torque, mover.mass, torque, body.torque);
}

/* ---- how it turns ---- */

void Mover::arm(size_t k, double out[3]) const {
  const double *at = sphere[k].arm;
  for (int d = 0; d < 3; d++)
    out[d] = is_ball ? 0 : at[0] * axes[0][d] + at[1] * axes[1][d] + at[2] * axes[2][d];
}

void Mover::set_axes(const double to[3][3]) {
  static const int of[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (int k = 0; k < 3; k++)
    aspi_copy(to[k], axes[k]);
  for (int j = 0; j < 6; j++) {
    inverse[j] = 0;
    for (int k = 0; k < 3; k++)
      if (body->inertia[k] > 0)
        inverse[j] += mass / body->inertia[k] * axes[k][of[j][0]] * axes[k][of[j][1]];
  }
}

void Mover::turn(const double omega[3], double time) {
  double to[3][3];
  for (int k = 0; k < 3; k++)
    aspi_copy(axes[k], to[k]);
  turn_by(omega, time, to);
  set_axes(to);
}

void Mover::spin_of(const double momentum[3], double spin[3]) const {
  if (is_ball)
    for (int d = 0; d < 3; d++)
      spin[d] = momentum[d] / (0.4 * radius_ * radius_);
  else
    multiply(inverse, momentum, spin);
}

void Mover::body_momentum(const double spin[3], double momentum[3]) const {
  aspi_copy(NONE, momentum);
  for (int k = 0; k < 3; k++)
    aspi_add_scaled(momentum, body->inertia[k] / mass * aspi_dot(spin, axes[k]), axes[k], momentum);
}

double Mover::body_energy(const double v[3], const double spin[3]) const {
  double momentum[3];
  momentum_of(spin, momentum);
  return 0.5 * (aspi_dot(v, v) + aspi_dot(spin, momentum));
}

void Mover::twist(const double at[3], const double impulse[3], double spin[3]) const {
  double couple[3];
  aspi_cross(at, impulse, couple);
  if (is_ball) {
    aspi_copy(couple, spin);
    aspi_scale(2.5 / (radius_ * radius_), spin);
  } else
    multiply(inverse, couple, spin);
}

double Mover::response(const double at[3], const double n[3]) const {
  double couple[3], turned[3];
  if (is_ball)
    return 1;
  aspi_cross(at, n, couple);
  multiply(inverse, couple, turned);
  return 1 + aspi_dot(couple, turned);
}

asp_body Mover::core_body(const double at[3]) const {
  asp_body made = {1 / mass, {0, 0, 0, 0, 0, 0}, {at[0], at[1], at[2]}, {0, 0}};
  for (int j = 0; j < 6; j++)
    made.inverse_inertia[j] = inverse[j] / mass;
  return made;
}

void asperity::multiply(const double m[6], const double a[3], double out[3]) {
  const double x = a[0], y = a[1], z = a[2];
  out[0] = m[0] * x + m[3] * y + m[4] * z;
  out[1] = m[3] * x + m[1] * y + m[5] * z;
  out[2] = m[4] * x + m[5] * y + m[2] * z;
}
