/* Contacts that last, of a ball: for any normals, walls' velocities and friction, what the solver
 * finds is a solution, by the conditions of contact and of Coulomb's friction at each contact. And
 * how a free body turns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/held.h"

#include "contact/vector.h"

#include "check.h"

using namespace asperity;

namespace {

uint32_t state = 4711;

/* Uniform in -1 to 1. */
double uniform() {
  state = 1664525 * state + 1013904223;
  return state / 2147483648.0 - 1;
}

void draw(double most, double a[3]) {
  for (int d = 0; d < 3; d++)
    a[d] = most * uniform();
}

/* How far the velocities are from a solution at one contact, in parts of the impulses. */
double off_by(const Held &s, double friction, double radius, const double v[3],
              const double omega[3]) {
  double across[3], u[3], along[3], p_t[3], worst = 0;
  aspi_cross(omega, s.n, across);
  aspi_subtract(v, s.w, u);
  aspi_add_scaled(u, -radius, across, u);
  const double u_n = aspi_dot(u, s.n), p_n = aspi_dot(s.p, s.n);
  aspi_add_scaled(u, -u_n, s.n, along);
  aspi_add_scaled(s.p, -p_n, s.n, p_t);
  const double slide = aspi_length(along), limit = friction * p_n;
  worst = fmax(worst, fmax(-u_n, -p_n));
  worst = fmax(worst, fmin(u_n, p_n));
  worst = fmax(worst, aspi_length(p_t) - limit);
  /* Where it slides, friction is at its limit and against the slide. */
  aspi_add_scaled(p_t, slide > 0 ? limit / slide : 0, along, p_t);
  return fmax(worst, fmin(slide, aspi_length(p_t)));
}

int run(int contacts, bool moving, double friction) {
  const double radius = 0.3, mass = 1;
  const int one = 1;
  Spheres spheres = Spheres();
  spheres.n = spheres.tag_bytes = 4;
  spheres.mask = spheres.type = &one;
  spheres.tag = &one;
  spheres.radius = &radius;
  spheres.mass = &mass;
  const Mover ball(spheres, 0);
  int solved = 0;
  for (int trial = 0; trial < 2000; trial++) {
    std::vector<Held> supports(static_cast<size_t>(contacts));
    double v[3], omega[3], sum[3], turn[3], scale = 0;
    draw(1, v);
    draw(trial % 3 == 0 ? 0 : 1 / radius, omega);
    for (Held &s : supports) {
      do
        draw(1, s.n);
      while (!(aspi_length(s.n) > 0.1 && s.n[2] > -0.5));
      aspi_scale(1 / aspi_length(s.n), s.n);
      draw(moving ? 0.3 : 0, s.w);
      s.friction = friction;
    }
    aspi_copy(v, sum);
    aspi_copy(omega, turn);
    const bool possible = solve_held(ball, supports, v, omega);
    double worst = 0;
    for (const Held &s : supports) {
      double across[3];
      aspi_cross(s.n, s.p, across);
      aspi_add_scaled(sum, 1, s.p, sum);
      aspi_add_scaled(turn, -2.5 / radius, across, turn);
      scale += aspi_length(s.p);
      if (friction > 0 && !(s.friction > 0)) /* the sweeps went round in a circle */
        worst = HUGE_VAL;
    }
    for (int d = 0; d < 3 && possible; d++) {
      assert_true(fabs(sum[d] - v[d]) <= 1e-9 * (1 + scale));
      assert_true(fabs(turn[d] - omega[d]) <= 1e-9 * (1 + scale) / radius);
    }
    for (const Held &s : supports)
      worst = fmax(worst, off_by(s, friction, radius, v, omega));
    solved += possible && worst <= 1e-4 * scale + 1e-9;
  }
  return solved;
}

/* One contact: always; two and three: nearly always, where the walls leave room. Among walls that
 * close, friction may leave no solution. */
TEST(is_a_solution) {
  const double friction[4] = {0, 0.1, 0.5, 2};
  const int two_moving[4] = {1990, 1978, 1865, 1625}, three_moving[4] = {1955, 1910, 1665, 1290};
  for (int moving = 0; moving < 2; moving++)
    for (int k = 0; k < 4; k++) {
      const int one = run(1, moving, friction[k]), two = run(2, moving, friction[k]),
                three = run(3, moving, friction[k]);
      print_message("moving %d, friction %g: solved %d, %d, %d of 2000\n", moving, friction[k], one,
                    two, three);
      assert_int_equal(one, 2000);
      assert_true(two >= (moving ? two_moving[k] : 1990));
      assert_true(three >= (moving ? three_moving[k] : 1950));
    }
}

/* In a narrow V each side carries half of the weight, whatever the friction. */
TEST(narrow_places_carry) {
  const double radius = 0.3, mass = 1;
  const int one = 1;
  Spheres spheres = Spheres();
  spheres.n = spheres.tag_bytes = 4;
  spheres.mask = spheres.type = &one;
  spheres.tag = &one;
  spheres.radius = &radius;
  spheres.mass = &mass;
  const Mover ball(spheres, 0);
  for (double friction : {0., 0.01, 0.1, 0.5})
    for (double angle : {1e-3, 0.01, 0.02, 0.04, 0.1, 0.5}) {
      std::vector<Held> sides(2);
      for (int k = 0; k < 2; k++) {
        sides[k].n[0] = k ? -cos(angle) : cos(angle);
        sides[k].n[1] = 0;
        sides[k].n[2] = sin(angle);
        sides[k].friction = friction;
      }
      double v[3] = {0, 0.01, -1}, omega[3] = {0, 0, 0};
      assert_true(solve_held(ball, sides, v, omega));
      assert_true(fabs(v[0]) < 1e-6 && fabs(v[2]) < 1e-4);
      for (const Held &side : sides)
        assert_true(fabs(side.p[2] - 0.5) < 1e-4);
    }
}

/* How the axes of a free body change. */
void rates(const double inertia[3], const double momentum[3], const double axes[9], double out[9]) {
  double omega[3] = {0, 0, 0};
  for (int k = 0; k < 3; k++)
    if (inertia[k] > 0)
      aspi_add_scaled(omega, aspi_dot(momentum, axes + 3 * k) / inertia[k], axes + 3 * k, omega);
  for (int k = 0; k < 3; k++)
    aspi_cross(omega, axes + 3 * k, out + 3 * k);
}

/* A free body of any moments turns as small steps by the rule of Runge and Kutta have it. */
TEST(turns_freely) {
  const double momentum[3] = {0.3, -1.1, 0.7};
  static const double inertia[][3] = {{1, 1, 2},      {2, 1, 1},   {0, 1, 1},
                                      {1, 1.01, 0.4}, {1, 1.5, 2}, {0.4, 1, 1.3}};
  for (const double *moments : inertia)
    for (double time : {0.05, 2.0, -30.0}) {
      const int steps = 20000;
      const double h = time / steps;
      double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, at[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
      turn_free(moments, momentum, time, axes);
      for (int n = 0; n < steps; n++) {
        double k[4][9], to[9];
        rates(moments, momentum, at, k[0]);
        for (int stage = 1; stage < 4; stage++) {
          for (int j = 0; j < 9; j++)
            to[j] = at[j] + (stage == 3 ? 1 : 0.5) * h * k[stage - 1][j];
          rates(moments, momentum, to, k[stage]);
        }
        for (int j = 0; j < 9; j++)
          at[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
      }
      for (int k = 0; k < 3; k++) {
        aspi_subtract(axes[k], at + 3 * k, at + 3 * k);
        assert_true(aspi_length(at + 3 * k) < 1e-6);
      }
    }
}

/* A body is a ball if it is one sphere about its center of mass with the moments of one. */
TEST(balls_are_found) {
  const double mass = 2, radius = 0.3, of_ball = 0.4 * mass * radius * radius;
  for (int k = 0; k < 4; k++) {
    Bodies bodies;
    bodies.spheres = {BodySphere{{k == 1 ? 0.1 : 0, 0, 0}, radius, 1, 1, 1}};
    Body one = Body();
    one.count = 1;
    one.mass = mass;
    for (int d = 0; d < 3; d++) {
      one.axes[d][d] = 1;
      one.inertia[d] = k == 2 && d == 1 ? 1.1 * of_ball : k == 3 ? 2.5 * of_ball : of_ball;
    }
    bodies.all = {one};
    const Mover mover(bodies, 0);
    assert_int_equal(mover.is_ball, k == 0);
  }
}

} // namespace
