/* The motion of a rigid body within a step: the ends, a steady turn exactly, an accelerated one to
 * second order in the step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */

#include "contact/vector.h"
#include "dem/error.h"
#include "dem/shapes/motion.h"

#include "check.h"

using namespace asperity;

namespace {

/* A turn by `angle` about an axis parallel to z through (2, -1), and a shift along z. */
Frame frame_at(double angle, double z) {
  const double c = cos(angle), s = sin(angle), p = 2, q = -1;
  Frame frame;
  frame.turn[0][0] = frame.turn[1][1] = c;
  frame.turn[0][1] = -s;
  frame.turn[1][0] = s;
  frame.shift[0] = p - (c * p - s * q);
  frame.shift[1] = q - (s * p + c * q);
  frame.shift[2] = z;
  return frame;
}

Twist twist_of(double rate, double speed) {
  Twist twist;
  const double axis[3] = {2, -1, 0}, w[3] = {0, 0, rate};
  double turned[3];
  aspi_copy(w, twist.angular);
  aspi_cross(w, axis, turned);
  aspi_scale(-1, turned);
  aspi_copy(turned, twist.linear);
  twist.linear[2] += speed;
  return twist;
}

double distance(const double a[3], const double b[3]) {
  double off[3];
  aspi_subtract(a, b, off);
  return aspi_length(off);
}

const double BODY[3] = {0.3, 0.7, -0.2};

TEST(frames) {
  const Frame frame = frame_at(1.1, 0.4);
  double world[3], back[3];
  frame.to_world(BODY, world);
  frame.to_local(world, back);
  assert_true(distance(back, BODY) < 1e-15);
  assert_true(Frame().is_world() && !frame.is_world());
}

TEST(steady) {
  const double angles[] = {1e-9, 1e-4, 0.009, 0.011, 0.5, 3};
  for (double angle : angles) {
    Motion motion;
    motion.settle(frame_at(0.2, 0.1), false);
    motion.advance(frame_at(0.2 + angle, 0.1 + 0.3 * angle), twist_of(angle, 0.3 * angle), 1);
    for (int i = 0; i <= 10; i++) {
      const double s = i / 10.0;
      double is[3], should[3], v[3], v_should[3];
      motion.frame_at(s).to_world(BODY, is);
      frame_at(0.2 + s * angle, 0.1 + 0.3 * s * angle).to_world(BODY, should);
      assert_true(distance(is, should) < 1e-14);
      motion.velocity(s, is, v);
      twist_of(angle, 0.3 * angle).velocity(should, v_should);
      assert_true(distance(v, v_should) < 1e-13 * (1 + angle));
    }
  }
}

/* More than a quarter of a turn in a step is an error. */
TEST(fast_turns) {
  check_turn("mesh", "m", 1.57);
  try {
    check_turn("mesh", "m", -1.58);
    assert_true(false);
  } catch (const Error &wrong) {
    assert_says(wrong.what(), "mesh 'm' turns by 90.53 degrees in a step");
  }
}

/* x = sin(t) along z and in angle: halving the step divides the errors by four. */
TEST(second_order) {
  double before[2] = {0, 0};
  for (double dt = 0.1; dt > 0.002; dt /= 2) {
    Motion motion;
    double worst[2] = {0, 0};
    motion.settle(frame_at(sin(0.3), sin(0.3)), false);
    motion.set_last(twist_of(cos(0.3), cos(0.3)));
    for (int step = 1; step * dt <= 1.0001; step++) {
      const double end = 0.3 + step * dt;
      motion.advance(frame_at(sin(end), sin(end)), twist_of(cos(end), cos(end)), dt);
      for (int i = 0; i <= 10; i++) {
        const double t = end - dt + dt * i / 10;
        double is[3], should[3], v[3], v_should[3];
        motion.frame_at(i / 10.0).to_world(BODY, is);
        frame_at(sin(t), sin(t)).to_world(BODY, should);
        worst[0] = fmax(worst[0], distance(is, should));
        motion.velocity(i / 10.0, should, v);
        twist_of(cos(t), cos(t)).velocity(should, v_should);
        worst[1] = fmax(worst[1], distance(v, v_should));
      }
    }
    for (int k = 0; k < 2; k++) {
      if (before[k] > 0)
        assert_true(before[k] / worst[k] > 3.7 && before[k] / worst[k] < 4.3);
      before[k] = worst[k];
    }
  }
}

/* A point with the acceleration that follow() gives keeps its speed over a plane of the body, for
 * any velocity of its own: also where the body's motion is accelerated. */
TEST(follow) {
  const double dt = 1e-3, h = 1e-3, n[3] = {0.6, 0.48, 0.64}, v[3] = {0.7, -0.4, 0.3};
  const double start = 1.1, x[3] = {0.9, 0.2, -0.3};
  Motion motion;
  motion.settle(frame_at(sin(start), sin(start)), false);
  motion.set_last(twist_of(cos(start), cos(start)));
  motion.advance(frame_at(sin(start + dt), sin(start + dt)),
                 twist_of(cos(start + dt), cos(start + dt)), dt);
  double a[3], height[3], body[3], along[3];
  motion.acceleration(0, x, v, a);
  const Frame now = frame_at(sin(start), sin(start));
  for (int i = 0; i < 3; i++)
    along[i] = aspi_dot(now.turn[i], n);
  assert_true(fabs(aspi_dot(a, along)) > 0.1);
  for (int k = -1; k <= 1; k++) {
    double there[3];
    for (int d = 0; d < 3; d++)
      there[d] = x[d] + k * h * v[d] + 0.5 * k * k * h * h * aspi_dot(a, along) * along[d];
    frame_at(sin(start + k * h), sin(start + k * h)).to_local(there, body);
    height[k + 1] = aspi_dot(body, n);
  }
  assert_true(fabs(height[0] - 2 * height[1] + height[2]) < 5e-3 * h * h);
}

/* An engine that sums up places from velocities, x(t + dt) = x(t) + v(t + dt) dt: the places are
 * those of a motion of its own, half a step ahead, and velocities must be of that one. */
TEST(summed) {
  double before = 0;
  for (double dt = 0.1; dt > 0.002; dt /= 2) {
    const double size = 0.5 * dt / sin(0.5 * dt);
    Motion motion;
    double worst = 0, x = size * sin(0.3 + 0.5 * dt);
    motion.settle(frame_at(x, x), false);
    motion.set_last(twist_of(cos(0.3), cos(0.3)));
    for (int step = 1; step * dt <= 1.0001; step++) {
      const double end = 0.3 + step * dt;
      x += cos(end) * dt;
      motion.advance(frame_at(x, x), twist_of(cos(end), cos(end)), dt);
      for (int i = 0; i <= 10; i++) {
        const double t = end - dt + dt * i / 10 + 0.5 * dt;
        double should[3], v[3], v_should[3];
        frame_at(size * sin(t), size * sin(t)).to_world(BODY, should);
        motion.velocity(i / 10.0, should, v);
        twist_of(size * cos(t), size * cos(t)).velocity(should, v_should);
        worst = fmax(worst, distance(v, v_should));
      }
    }
    if (before > 0)
      assert_true(before / worst > 3.7 && before / worst < 4.3);
    before = worst;
  }
}

TEST(rest) {
  Motion motion;
  double v[3];
  assert_true(motion.in_world() && !motion.moves());
  motion.advance(frame_at(0.1, 0), twist_of(1, 0), 0.1);
  assert_true(!motion.in_world() && motion.moves());
  motion.rest();
  motion.velocity(0.5, BODY, v);
  assert_true(aspi_length(v) == 0 && !motion.moves() && !motion.in_world());
  double begin[3], end[3];
  motion.frame_at(0).to_world(BODY, begin);
  frame_at(0.1, 0).to_world(BODY, end);
  assert_true(distance(begin, end) < 1e-15);
}

} // namespace
