/* What walls do at the borders of steps and runs: which load they show, steps that change their
 * length, commands that move particles or take them out of the group, what the flow has taken
 * away, and particles of very different sizes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "alone.h"

#include "contact/vector.h"
#include "dem/error.h"
#include "dem/shapes/mesh.h"
#include "dem/shapes/primitive.h"
#include "dem/text.h"

#include "check.h"

using namespace asperity;

namespace {

const double STILL[3] = {0, 0, 0};
const char *const DULL = "rebound constant 0.5 0.5 deposit off";
const char *const STICKY = "rebound constant 0 0 deposit freeze";

bool near(double a, double b, double within) {
  return fabs(a - b) <= within;
}

/* A plane that counts how often a prediction asks for it. */
class CountingPlane : public PlaneShape {
public:
  explicit CountingPlane(int &calls) : PlaneShape(2, 0, STILL), calls_(calls) {}
  double clear(const Course &course, const FaceList &stays) const override {
    calls_++;
    return PlaneShape::clear(course, stays);
  }

private:
  int &calls_;
};

/* Grains of radius 1 that fall far from a plane, the last one of them of another size. */
int predictions(double last) {
  const size_t n = 640;
  int calls = 0;
  GrainsAtWall s(std::unique_ptr<Shape>(new CountingPlane(calls)), DULL, n, 1, 1e-3);
  for (size_t i = 0; i < n; i++) {
    s.grains.put(i, {3. * static_cast<double>(i), 0, 1000}, {0, 0, 0});
    s.grains.f[3 * i + 2] = -10;
  }
  s.grains.radius[n - 1] = last;
  s.begin();
  s.grains.fly(1000);
  return calls;
}

/* One small particle makes the predictions of others no shorter: of those in its block alone. */
TEST(dust_does_not_cost_others) {
  const int alike = predictions(1), dusty = predictions(1e-4);
  assert_true(alike >= 640 && dusty < alike + 2000);
}

/* A grain that rests on a plane. */
struct Resting : GrainsAtWall {
  explicit Resting(const char *law = DULL)
      : GrainsAtWall(std::unique_ptr<Shape>(new PlaneShape(2, 0, STILL)), law, 1, 0.5, 0.01) {
    grains.put(0, {0, 0, 0.5}, {0, 0, 0});
    grains.f[2] = -10;
    begin();
    grains.fly(10);
  }
  double force() const {
    return count(Books::FORCE + 2);
  }
};

/* Whenever it is asked for, the force is that of a whole step. */
TEST(force_is_of_a_whole_step) {
  Resting s;
  assert_true(near(s.force(), -10, 1e-12));
  s.grains.advance();
  assert_true(near(s.force(), -10, 1e-12));
  s.grains.finish();
  assert_true(near(s.force(), -10, 1e-12));
  /* 11 steps, and the half of a kick that is counted ahead */
  assert_true(near(s.count(Books::IMPULSE + 2), -11.5 * 0.1, 1e-12));
}

/* In the step after which the length of steps changes, and in the next one, forces are those of
 * their own length. */
TEST(steps_may_change_their_length) {
  Resting s;
  s.wall->set_dt(s.grains.now, s.grains.dt = 0.02);
  assert_true(near(s.force(), -10, 1e-12));
  s.grains.fly(2);
  assert_true(near(s.force(), -10, 1e-12));
  assert_true(near(s.wall->setup.time(static_cast<double>(s.grains.now)), 0.14, 1e-12));
}

/* In a step of 0 a grain that rests stays as it is, and weighs what it did in the step after it. */
TEST(steps_may_have_no_length) {
  Resting s;
  const double z = s.grains.x[2];
  s.wall->set_dt(s.grains.now, s.grains.dt = 0);
  s.grains.fly(2);
  assert_true(near(s.grains.x[2], z, 0));
  s.wall->set_dt(s.grains.now, s.grains.dt = 0.01);
  s.grains.fly(2);
  assert_true(near(s.force(), -10, 1e-12));
  assert_true(near(s.grains.x[2], z, 1e-12));
  assert_true(near(s.count(Books::N_IMPACTS), 0, 0));
}

/* A step that goes back in time is an error. */
TEST(steps_must_not_go_back) {
  for (double dt : {-0.01, static_cast<double>(nan(""))}) {
    Resting s;
    try {
      s.wall->set_dt(s.grains.now, dt);
      assert_true(false);
    } catch (const Error &wrong) {
      assert_says(wrong.what(), "it must be >= 0");
    }
  }
}

/* What left the group is not held any more, and the memory of it is gone. */
TEST(groups_end_rests) {
  Resting s;
  s.grains.mask[0] = 2;
  s.wall->reorder(s.grains.spheres());
  s.grains.fly(20);
  assert_true(s.grains.x[2] < 0.5 - 0.1);
  assert_true(near(s.force(), 0, 0));
  assert_true(s.wall->rows.status(0) == Status::FREE);
}

/* A stuck grain that a command has moved is free; one that is where it was stays. */
TEST(commands_free_what_they_move) {
  GrainsAtWall s(std::unique_ptr<Shape>(new PlaneShape(2, 0, STILL)), STICKY, 2, 0.5, 0.1);
  for (size_t i = 0; i < 2; i++)
    s.grains.put(i, {3. * static_cast<double>(i), 0, 0.55}, {0, 0, -1});
  s.begin();
  s.grains.fly(2);
  assert_true(s.wall->stuck() == 2);
  s.grains.x[2] += 0.3;
  s.grains.put(0, {0, 0, 0.8}, {0.1, 0, 0});
  s.wall->begin_run(s.grains.spheres(), 1, Box());
  s.wall->free_displaced(s.grains.spheres(), 0);
  assert_says(s.engine.warned.c_str(), "moved from their place: 1");
  s.grains.fly(10);
  assert_true(s.wall->stuck() == 1 && s.wall->rows.is_stuck(1));
  assert_true(near(s.grains.x[0], 0.1, 1e-12) && near(s.grains.x[3], 3, 0));
}

/* A rod of two spheres over a plane, as an engine moves it that turns bodies inexactly. */
struct Rod {
  static constexpr double R = 0.5, DT = 0.01;
  Alone engine;
  std::unique_ptr<Wall> wall;
  Grains none;
  Bodies bodies;

  Rod(const char *law, double height)
      : wall(make_wall(engine, std::unique_ptr<Shape>(new PlaneShape(2, 0, STILL)), law)),
        none(0, R, DT) {
    Body rod = Body();
    rod.count = 2;
    rod.mass = 1;
    rod.inertia[0] = 0.4 * R * R;
    rod.inertia[1] = rod.inertia[2] = 1.4 * R * R;
    rod.x[2] = height;
    for (int d = 0; d < 3; d++)
      rod.axes[d][d] = 1;
    bodies.all.push_back(rod);
    bodies.spheres = {BodySphere{{-R, 0, 0}, R, 1, 1, 1}, BodySphere{{R, 0, 0}, R, 1, 1, 2}};
    bodies.dt = DT;
    none.begin({wall.get()});
  }
  Body &body() {
    return bodies.all[0];
  }
  void begin_run() {
    bodies.begins = true;
    claim_bodies(none.walls, bodies, MPI_COMM_WORLD);
    wall->free_displaced(bodies, 0);
  }
  double count() const {
    return wall->books.counter(Books::N_IMPACTS);
  }
  void fly(int steps) {
    for (int k = 0; k < steps; k++) {
      double omega[3];
      bodies.step++;
      aspi_add_scaled(body().x, DT, body().v, body().x);
      spin_of(body(), omega);
      turn_by(omega, DT, body().axes);
      body().is_changed = false;
      step_walls(none.walls, none.spheres(), &bodies);
      end_walls(none.walls, none.spheres(), &bodies);
    }
  }
};

/* A body that meets nothing keeps the engine's turn to the bit, in the second part of a run, too.
 */
TEST(walls_turn_no_body_that_they_do_not_touch) {
  Rod s(DULL, 1.001), alone(DULL, 1000);
  for (Rod *rod : {&s, &alone}) {
    for (int d = 0; d < 3; d++)
      rod->body().angular_momentum[d] = (d + 1) * 0.3 * Rod::R * Rod::R / Rod::DT;
    rod->begin_run();
    rod->fly(20);
    rod->begin_run();
    rod->fly(20);
  }
  assert_true(near(s.count(), 0, 0));
  assert_memory_equal(s.body().axes, alone.body().axes, sizeof s.body().axes);
}

/* A stuck body that a command has moved is free, with a warning. */
TEST(commands_free_bodies_that_they_move) {
  for (double moved : {0., 0.3}) {
    Rod s(STICKY, 0.51);
    s.body().v[2] = -2;
    s.begin_run();
    s.fly(2);
    assert_true(s.wall->stuck() == 1);
    s.body().x[2] += moved;
    s.begin_run();
    s.fly(2);
    assert_true(near(s.body().x[2], 0.5 + moved, 1e-9));
    assert_true(near(s.wall->stuck(), moved > 0 ? 0 : 1, 0));
    const bool told = strstr(s.engine.warned.c_str(), "bodies that a command has moved");
    assert_true(told == (moved > 0));
  }
}

/* What rests on a floor and sticks to a wall does not show as resting any more. */
TEST(what_sticks_rests_nowhere) {
  const Alone engine;
  std::unique_ptr<Wall> floor =
      make_wall(engine, std::unique_ptr<Shape>(new PlaneShape(2, 0, STILL)), DULL);
  std::unique_ptr<Wall> side =
      make_wall(engine, std::unique_ptr<Shape>(new PlaneShape(0, 0.55, STILL)), STICKY);
  Grains grains(1, 0.5, 0.01);
  grains.put(0, {0, 0, 0.5}, {1, 0, 0});
  grains.f[2] = -10;
  grains.begin({floor.get(), side.get()});
  grains.fly(3);
  assert_true(floor->rows.status(0) == Status::RESTING);
  grains.fly(20);
  assert_true(side->rows.is_stuck(0));
  assert_true(floor->rows.status(0) == Status::FREE);
}

/* A grain that a command has put deep into a wall is put onto it, and counted. */
TEST(overlaps_at_rest_are_guarded) {
  GrainsAtWall s(std::unique_ptr<Shape>(new PlaneShape(2, 0, STILL)), DULL, 1, 0.5, 0.01);
  s.grains.put(0, {0, 0, 0.41}, {0, 0, 0});
  s.grains.f[2] = -10;
  s.begin();
  s.grains.fly(5);
  assert_true(near(s.grains.x[2], 0.5, 1e-9));
  assert_true(s.count(Books::N_GUARDED) == 1);
}

/* A deposit that the flow takes off its wall is free as soon as it moves away. */
TEST(removed_deposits_are_free) {
  GrainsAtWall s(std::unique_ptr<Shape>(new PlaneShape(2, 0, STILL)),
                 "materials quartz deposit freeze remove u_tau 100 gas_density 1.2 gas_viscosity "
                 "1.5e-5",
                 1, 2.5e-5, 1e-5);
  s.engine.least = s.engine.most = 5e-5;
  s.grains.mass[0] = 1.7e-10;
  s.grains.put(0, {0, 0, 2.6e-5}, {0, 0, -0.5});
  s.begin();
  s.grains.fly(1);
  assert_true(s.wall->stuck() == 1);
  s.grains.f[2] = 1e-9;
  for (int step = 0; step < 100000 && s.wall->stuck() > 0; step++)
    s.grains.fly(1);
  s.grains.fly(20);
  assert_true(s.wall->stuck() == 0 && s.grains.x[2] > 2.5e-5);
  assert_true(s.wall->rows.status(0) == Status::FREE);
}

/* A velocity that the engine has blown up ends the run. */
TEST(blown_up_velocities_are_told) {
  for (double v : {1e300, HUGE_VAL, nan("")}) {
    Resting s;
    s.grains.v[2] = v;
    try {
      s.grains.fly(1);
      assert_true(false);
    } catch (const Error &wrong) {
      assert_says(wrong.what(), "the velocity of particle 1 is");
    }
  }
}

/* At the apex of a pyramid, where it touches all faces, a grain comes to rest. */
TEST(pits_hold_grains) {
  const int faces = 8;
  std::vector<ContactTriangle> triangles;
  for (int k = 0; k < faces; k++) {
    ContactTriangle t = {};
    for (int j = 0; j < 2; j++) {
      const double angle = 2 * ASP_PI * (k + j + 0.1) / faces;
      t.node[1 + j][0] = cos(angle);
      t.node[1 + j][1] = sin(angle);
      t.node[1 + j][2] = 0.7;
    }
    triangles.push_back(t);
  }
  std::unique_ptr<MeshShape> mesh(new MeshShape);
  set_triangles(*mesh, triangles);
  mesh->set_images(Box());
  GrainsAtWall s(std::move(mesh), "rebound walton 0.5 0.3 0 deposit off", 1, 1e-3, 1e-4, faces);
  s.engine.least = s.engine.most = 2e-3;
  s.grains.spins = true;
  s.grains.put(0, {1e-3, 3e-4, 3e-3}, {0, 0, 0});
  s.grains.f[2] = -9.81;
  s.begin();
  s.grains.fly(8000);
  const double x[3] = {s.grains.x[0], s.grains.x[1], s.grains.x[2]};
  const double impacts = s.count(Books::N_IMPACTS);
  s.grains.fly(2000);
  aspi_subtract(&s.grains.x[0], x, s.grains.x.data());
  assert_true(aspi_length(s.grains.x.data()) < 1e-12);
  assert_true(s.count(Books::N_IMPACTS) - impacts < 1);
}

/* Fix recenter/kk shifts particles as recenter does, on a card and on the host. */
TEST(styles_are_known_without_suffix) {
  for (const char *style : {"recenter", "recenter/kk", "recenter/kk/host"})
    assert_string_equal(asperity::without_suffix(style).c_str(), "recenter");
  assert_string_equal(asperity::without_suffix("rigid/small/kk").c_str(), "rigid/small");
}

} // namespace
