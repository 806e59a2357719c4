/* The motion of a rigid body within a step; see motion.h. The exponential and the logarithm of
 * rigid motions are those of Murray, Li & Sastry 1994, "A mathematical introduction to robotic
 * manipulation", chapter 2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/shapes/motion.h"

#include <math.h>

#include "asperity_engine.h"
#include "contact/tolerances.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

namespace {

/* Below this angle (rad) series take the place of quotients that lose their digits. */
const double SMALL = 1e-2;

/* (1 - cos a)/a^2 and (a - sin a)/a^3 */
double cosine_rest(double a) {
  if (fabs(a) < SMALL)
    return 0.5 - a * a / 24 + a * a * a * a / 720;
  const double half = sin(0.5 * a);
  return 2 * half * half / (a * a);
}

double sine_rest(double a) {
  if (fabs(a) < SMALL)
    return 1.0 / 6 - a * a / 120 + a * a * a * a / 5040;
  return (a - sin(a)) / (a * a * a);
}

/* (1 - (a/2) cot(a/2))/a^2 */
double inverse_rest(double a) {
  if (fabs(a) < SMALL)
    return 1.0 / 12 + a * a / 720 + a * a * a * a / 30240;
  return (1 - 0.5 * a / tan(0.5 * a)) / (a * a);
}

/* w + p (phi x w) + q (phi x (phi x w)) */
void combine(const double phi[3], double p, double q, const double w[3], double out[3]) {
  double once[3], twice[3];
  aspi_cross(phi, w, once);
  aspi_cross(phi, once, twice);
  aspi_add_scaled(w, p, once, out);
  aspi_add_scaled(out, q, twice, out);
}

void times(const double turn[3][3], const double v[3], double out[3]) {
  for (int i = 0; i < 3; i++)
    out[i] = aspi_dot(turn[i], v);
}

/* The rotation vector of a matrix. */
void rotation_vector(const double turn[3][3], double phi[3]) {
  const double w[3] = {0.5 * (turn[2][1] - turn[1][2]), 0.5 * (turn[0][2] - turn[2][0]),
                       0.5 * (turn[1][0] - turn[0][1])};
  const double sine = aspi_length(w), cosine = 0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1);
  const double angle = atan2(sine, cosine);
  aspi_copy(w, phi);
  if (sine > 0)
    aspi_scale(angle / sine, phi);
}

/* The screw from one frame to another. */
Twist screw_between(const Frame &from, const Frame &to) {
  double turn[3][3], moved[3], d[3];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      turn[i][j] = aspi_dot(to.turn[i], from.turn[j]);
  times(turn, from.shift, moved);
  aspi_subtract(to.shift, moved, d);
  Twist screw;
  rotation_vector(turn, screw.angular);
  combine(screw.angular, -0.5, inverse_rest(aspi_length(screw.angular)), d, screw.linear);
  return screw;
}

/* Of a velocity that goes from `begin` to `end` in a step, the beginning, moved so that the mean is
 * that of the way, unless that is so to rounding. */
void shift_mean(const double begin[3], const double end[3], const double way[3], double dt,
                double start[3]) {
  double off[3];
  for (int d = 0; d < 3; d++)
    off[d] = dt > 0 ? way[d] / dt - 0.5 * (begin[d] + end[d]) : 0;
  aspi_copy(begin, start);
  if (aspi_length(off) > ROUNDING * (aspi_length(begin) + aspi_length(end)))
    aspi_add_scaled(start, 1, off, start);
}

} // namespace

Frame::Frame() : turn{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, shift{0, 0, 0} {}

void Frame::to_world(const double local[3], double world[3]) const {
  to_world_direction(local, world);
  aspi_add_scaled(world, 1, shift, world);
}

void Frame::to_world_direction(const double local[3], double world[3]) const {
  double turned[3];
  times(turn, local, turned);
  aspi_copy(turned, world);
}

void Frame::to_local(const double world[3], double local[3]) const {
  double arm[3];
  aspi_subtract(world, shift, arm);
  for (int j = 0; j < 3; j++)
    local[j] = turn[0][j] * arm[0] + turn[1][j] * arm[1] + turn[2][j] * arm[2];
}

bool Frame::is_world() const {
  const Frame world;
  bool equal = true;
  for (int i = 0; i < 3; i++) {
    equal = equal && !(shift[i] < 0 || shift[i] > 0);
    for (int j = 0; j < 3; j++)
      equal = equal && !(turn[i][j] < world.turn[i][j] || turn[i][j] > world.turn[i][j]);
  }
  return equal;
}

Twist::Twist() : angular{0, 0, 0}, linear{0, 0, 0} {}

void Twist::velocity(const double x[3], double v[3]) const {
  aspi_cross(angular, x, v);
  aspi_add_scaled(v, 1, linear, v);
}

/* Rodrigues' formula, column by column. */
Frame asperity::turn_about(const double point[3], const double axis[3], double angle) {
  const double c = cos(angle), s = sin(angle);
  Frame frame;
  double turned[3];
  for (int j = 0; j < 3; j++) {
    double across[3];
    aspi_cross(axis, Frame().turn[j], across);
    for (int i = 0; i < 3; i++)
      frame.turn[i][j] = (i == j ? c : 0) + s * across[i] + (1 - c) * axis[i] * axis[j];
  }
  frame.to_world_direction(point, turned);
  aspi_subtract(point, turned, frame.shift);
  return frame;
}

Twist asperity::twist_about(const double point[3], const double axis[3], double rate) {
  Twist twist;
  aspi_add_scaled(twist.angular, rate, axis, twist.angular);
  aspi_cross(point, twist.angular, twist.linear);
  return twist;
}

void asperity::check_turn(const char *kind, const char *name, double angle) {
  const double degrees = fabs(angle) * 180 / ASP_PI;
  if (!(degrees <= 90))
    throw Error(
        text("%s '%s' turns by %.4g degrees in a step; it must be at most 90, so that its way is "
             "known: take a shorter time step",
             kind, name, degrees));
}

Motion::Motion() : dt_(0), moves_(false), has_last_(false), in_world_(true) {}

void Motion::rest() {
  begin_ = end_;
  screw_ = end_velocity_ = start_velocity_ = gain_ = Twist();
  moves_ = has_last_ = false;
  in_world_ = end_.is_world();
}

void Motion::settle(const Frame &frame, bool goes_on) {
  const Twist last = end_velocity_;
  const bool has_last = has_last_;
  end_ = frame;
  rest();
  if (goes_on && has_last)
    set_last(last);
}

void Motion::advance(const Frame &end, const Twist &twist, double dt) {
  begin_ = end_;
  end_ = end;
  dt_ = dt;
  screw_ = screw_between(begin_, end_);
  const Twist before = has_last_ ? end_velocity_ : twist;
  end_velocity_ = twist;
  shift_mean(before.angular, twist.angular, screw_.angular, dt, start_velocity_.angular);
  shift_mean(before.linear, twist.linear, screw_.linear, dt, start_velocity_.linear);
  aspi_subtract(twist.angular, before.angular, gain_.angular);
  aspi_subtract(twist.linear, before.linear, gain_.linear);
  moves_ = has_last_ = true;
  in_world_ = false;
  start_ = screwed(0);
}

void Motion::set_last(const Twist &twist) {
  end_velocity_ = twist;
  has_last_ = true;
}

Frame Motion::frame_at(double s) const {
  return !moves_ || s >= 1 ? end_ : s > 0 ? screwed(s) : start_;
}

/* Rodrigues' formula turns a vector by the rotation vector phi. */
Frame Motion::screwed(double s) const {
  double phi[3], along[3], moved[3];
  for (int d = 0; d < 3; d++) {
    phi[d] = s * screw_.angular[d];
    along[d] = s * screw_.linear[d];
  }
  const double angle = aspi_length(phi), rest = cosine_rest(angle), sine = sine_rest(angle);
  const double sinc = angle < SMALL ? 1 - angle * angle * sine : sin(angle) / angle;
  Frame frame;
  for (int j = 0; j < 3; j++) {
    const double column[3] = {begin_.turn[0][j], begin_.turn[1][j], begin_.turn[2][j]};
    double turned[3];
    combine(phi, sinc, rest, column, turned);
    for (int i = 0; i < 3; i++)
      frame.turn[i][j] = turned[i];
  }
  combine(phi, sinc, rest, begin_.shift, moved);
  combine(phi, rest, sine, along, frame.shift);
  aspi_add_scaled(frame.shift, 1, moved, frame.shift);
  return frame;
}

Twist Motion::twist_at(double s) const {
  Twist now;
  aspi_add_scaled(start_velocity_.angular, s, gain_.angular, now.angular);
  aspi_add_scaled(start_velocity_.linear, s, gain_.linear, now.linear);
  return now;
}

void Motion::velocity(double s, const double x[3], double v[3]) const {
  v[0] = v[1] = v[2] = 0;
  if (moves_)
    twist_at(s).velocity(x, v);
}

void Motion::acceleration(double s, const double x[3], const double v[3], double a[3]) const {
  a[0] = a[1] = a[2] = 0;
  if (!moves_)
    return;
  const Twist at = twist_at(s);
  double now[3], twice[3], turned[3];
  at.velocity(x, now);
  for (int d = 0; d < 3; d++)
    twice[d] = 2 * v[d] - now[d];
  aspi_cross(at.angular, twice, turned);
  gain_.velocity(x, a);
  for (int d = 0; d < 3; d++)
    a[d] = a[d] / dt_ + turned[d];
}

void Motion::turn(double s, double axes[3][3], double omega[3]) const {
  aspi_copy(twist_at(1).angular, omega);
  if (!moves_)
    return;
  const Frame begin = frame_at(s);
  for (int k = 0; k < 3; k++) {
    double at[3];
    aspi_add_scaled(begin.shift, 1, axes[k], at);
    begin.to_local(at, at);
    end_.to_world_direction(at, axes[k]);
  }
}
