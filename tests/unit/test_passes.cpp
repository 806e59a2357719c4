/* No mover passes a wall: in the nip of two cylinders, and in a box that turns by up to a quarter
 * of a turn in a step. Places are looked at in every step. What walls press through, or go over, is
 * counted, and the log says so.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "alone.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "contact/vector.h"
#include "dem/shapes/mesh.h"
#include "dem/shapes/primitive.h"

using namespace asperity;

namespace {

typedef std::unique_ptr<Shape> ShapePtr;

int failed = 0;

void judge(bool right, const char *form, ...) __attribute__((format(printf, 2, 3)));
void judge(bool right, const char *form, ...) {
  va_list values;
  va_start(values, form);
  printf(right ? "ok   " : "FAIL ");
  vprintf(form, values);
  printf("\n");
  va_end(values);
  failed += !right;
}

/* A step of grains and of bodies, on which gravity acts along -z. */
struct Flyers {
  Grains grains;
  Bodies bodies;
  double gravity;

  Flyers(size_t n, double r, double dt, double g) : grains(n, r, dt), bodies(), gravity(g) {
    grains.spins = true;
    bodies.dt = dt;
    for (size_t i = 0; i < n; i++)
      grains.f[3 * i + 2] = -g;
  }
  /* Two spheres along y, of mass 1 together. */
  void add_rod(double r, const double (&x)[3]) {
    Body body = Body();
    body.count = 2;
    body.mass = 1;
    aspi_copy(x, body.x);
    for (int k = 0; k < 2; k++)
      bodies.spheres.push_back(BodySphere{{0, (2 * k - 1) * r, 0}, r, 1, 1, k + 1});
    for (int d = 0; d < 3; d++) {
      body.axes[d][d] = 1;
      body.inertia[d] = (d == 1 ? 0.4 : 1.4) * r * r;
    }
    bodies.all.push_back(body);
  }
  void begin(const std::vector<Wall *> &walls) {
    grains.begin(walls);
    bodies.begins = true;
    bodies.step = 1;
    claim_bodies(grains.walls, bodies, MPI_COMM_WORLD);
    push();
  }
  void push() {
    for (Body &body : bodies.all) {
      const double a[3] = {0, 0, -gravity};
      aspi_copy(a, body.acceleration);
      body.torque[0] = body.torque[1] = body.torque[2] = 0;
    }
  }
  void kick() {
    grains.kick();
    for (Body &body : bodies.all) {
      aspi_add_scaled(body.v, 0.5 * bodies.dt, body.acceleration, body.v);
      aspi_add_scaled(body.angular_momentum, 0.5 * bodies.dt, body.torque, body.angular_momentum);
    }
  }
  void step() {
    bodies.step = ++grains.now;
    kick();
    for (size_t k = 0; k < grains.x.size(); k++)
      grains.x[k] += grains.v[k] * grains.dt;
    for (Body &body : bodies.all) {
      advance(body, grains.dt);
      body.is_changed = false;
    }
    step_walls(grains.walls, grains.spheres(), &bodies);
    grains.total = grains.f;
    grains.torque.assign(grains.torque.size(), 0.);
    push();
    kick();
    end_walls(grains.walls, grains.spheres(), &bodies);
    for (Wall *wall : grains.walls)
      wall->books.end_loads();
  }
};

double guarded(const Grains &grains) {
  double all = 0;
  for (const Wall *wall : grains.walls)
    all += wall->books.counter(Books::N_GUARDED);
  return all;
}

/* ---- the nip of two cylinders -----------------------------------------------------------------
 */

/* How far a mover is in two cylinders along y, by its spheres. */
double depth(const Flyers &flyers, double r, double c, double big) {
  double most = 0;
  for (size_t k = 0; k < 2; k++) {
    double at[3];
    if (flyers.bodies.all.empty())
      aspi_copy(flyers.grains.x.data(), at);
    else
      aspi_add_scaled(flyers.bodies.all[0].x, k ? r : -r, flyers.bodies.all[0].axes[1], at);
    for (int side = -1; side < 2; side += 2)
      most = std::max(most, big + r - hypot(at[0] - side * c, at[2]));
  }
  return most;
}

/* A ball, or a rod along the cylinders, falls between two of them, whose gap is less than its
 * diameter by a part of that; they may turn so that they draw it in. It stays on them, in no step
 * in one of them, and they carry its weight; not where their friction draws it in, which rigid
 * bodies cannot answer. The way of a body's spheres is known less well. */
void test_nip(double part, double dt, double friction, double turn, bool is_rod) {
  const double big = 0.2, r = 0.05, c = big + r * (1 - part), g = 9.81;
  Alone engine;
  engine.least = engine.most = 2 * r;
  std::vector<std::unique_ptr<Wall>> owned;
  std::vector<Wall *> walls;
  for (int side = -1; side < 2; side += 2) {
    const double center[3] = {side * c, 0, 0};
    owned.push_back(make_wall(engine, ShapePtr(new CylinderShape(1, center, big, 0, -side * turn)),
                              "rebound walton 0.5 " + std::to_string(friction) + " 0 deposit off"));
    walls.push_back(owned.back().get());
  }
  Flyers flyers(is_rod ? 0 : 1, r, dt, g);
  const double start[3] = {0.06 * r, 0, 0.5};
  if (is_rod)
    flyers.add_rod(r, start);
  else
    flyers.grains.put(0, {start[0], start[1], start[2]}, {0, 0, 0});
  flyers.begin(walls);
  const int steps = static_cast<int>((dt < 1e-3 ? 2 : 8) / dt);
  double deepest = 0, last[2];
  const double *x = is_rod ? flyers.bodies.all[0].x : flyers.grains.x.data();
  for (int k = 0; k < steps; k++) {
    flyers.step();
    deepest = std::max(deepest, depth(flyers, r, c, big));
    double load = 0;
    for (const Wall *wall : walls)
      load += wall->books.counter(Books::FORCE + 2);
    last[k % 2] = -load / g;
  }
  const bool carries = fabs(last[0] + last[1] - 2) < 1e-6;
  const bool is_drawn = turn * friction > 0;
  judge(deepest < (is_rod || is_drawn ? 2e-5 : 1e-6) * r && x[2] > 0 && (carries || is_drawn),
        "%s in a nip of %g, dt %g, friction %g, turn %g: at %.6f, overlap %.2g r, guarded %g, load "
        "%.9f weights",
        is_rod ? "rod" : "ball", part, dt, friction, turn, x[2], deepest / r,
        guarded(flyers.grains), 0.5 * (last[0] + last[1]));
}

/* ---- a box that turns -------------------------------------------------------------------------
 */

/* A cube of width 2. */
MeshShape *cube() {
  std::vector<ContactTriangle> all;
  for (int k = 0; k < 12; k++) {
    const int axis = k / 4, a = (axis + 1) % 3, b = (axis + 2) % 3;
    ContactTriangle triangle;
    for (int n = 0; n < 3; n++) {
      const int corner = (n + 2 * (k % 2)) % 4;
      triangle.node[n][axis] = k / 2 % 2 ? 1 : -1;
      triangle.node[n][a] = corner % 3 ? 1 : -1;
      triangle.node[n][b] = corner > 1 ? 1 : -1;
    }
    all.push_back(triangle);
  }
  MeshShape *mesh = new MeshShape;
  set_triangles(*mesh, all);
  mesh->set_images(Box());
  return mesh;
}

/* Grains in a closed box that turns about z by a part of a turn in each step, back and forth after
 * `back` steps: none is outside, or in a wall, at the end of a step. */
void test_turn(double part, int back) {
  const double r = 0.05, dt = 1e-4, about[3] = {0, 0, 1}, origin[3] = {0, 0, 0};
  Alone engine;
  engine.least = engine.most = 2 * r;
  MeshShape *mesh = cube();
  const std::unique_ptr<Wall> wall =
      make_wall(engine, ShapePtr(mesh), "rebound walton 0.8 0.3 0 deposit off", 12);
  Flyers flyers(60, r, dt, 0);
  uint64_t random = 4711;
  for (size_t i = 0; i < 60; i++) {
    double x[3];
    for (double &one : x) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      one = 1.6 * (static_cast<double>(random >> 11) / 9007199254740992.) - 0.8;
    }
    flyers.grains.put(i, {x[0], x[1], x[2]}, {100, 70, -130});
  }
  mesh->motion().settle(turn_about(origin, about, 0), true);
  flyers.begin({wall.get()});
  int outside = 0;
  double angle = 0, deepest = 0;
  for (int k = 0; k < 300; k++) {
    const double by = (back && k / back % 2 ? -2 : 2) * ASP_PI * part;
    angle += by;
    mesh->motion().advance(turn_about(origin, about, angle), twist_about(origin, about, by / dt),
                           dt);
    mesh->set_images(Box());
    flyers.step();
    for (size_t i = 0; i < 60; i++) {
      double at[3];
      mesh->motion().end().to_local(&flyers.grains.x[3 * i], at);
      const double out = std::max(fabs(at[0]), std::max(fabs(at[1]), fabs(at[2])));
      outside += out > 1;
      deepest = std::max(deepest, out - (1 - r));
    }
  }
  judge(outside == 0 && deepest < 1e-6 * r && !(guarded(flyers.grains) > 0),
        "a box that turns by 1/%g, %d steps each way: %d outside, overlap %.2g r, impacts %g, "
        "guarded %g",
        1 / part, back, outside, deepest / r, wall->books.counter(Books::N_IMPACTS),
        guarded(flyers.grains));
}

/* A large square across z. */
MeshShape *lid(double z) {
  std::vector<ContactTriangle> both(2);
  for (int t = 0; t < 2; t++)
    for (int n = 0; n < 3; n++) {
      const int corner = (n + 2 * t) % 4;
      both[t].node[n][0] = corner % 3 ? 10 : -10;
      both[t].node[n][1] = corner > 1 ? 10 : -10;
      both[t].node[n][2] = z;
    }
  MeshShape *mesh = new MeshShape;
  set_triangles(*mesh, both);
  mesh->set_images(Box());
  return mesh;
}

/* ---- a groove around a tube -------------------------------------------------------------------
 */

/* Grains that ride in the groove between a tube and a wall across it, which is tilted: each turns
 * by a tenth of a radian in a step, and none gains energy. */
void test_groove() {
  const double r = 0.05, dt = 1, tilt = 0.2, still[3] = {0, 0, 0};
  Alone engine;
  engine.least = engine.most = 2 * r;
  const char *const words = "rebound walton 0.7 0.03 0 deposit off";
  MeshShape *floor = lid(0);
  const double across[3] = {0, 1, 0};
  floor->motion().settle(turn_about(still, across, tilt), false);
  floor->set_images(Box());
  const std::unique_ptr<Wall> tube =
      make_wall(engine, ShapePtr(new CylinderShape(2, still, 1, 0, 0)), words);
  const std::unique_ptr<Wall> cap = make_wall(engine, ShapePtr(floor), words, 2);
  const size_t n = 40;
  Flyers flyers(n, r, dt, 0);
  for (size_t i = 0; i < n; i++) {
    const double a = 2 * ASP_PI * static_cast<double>(i) / n, v = 0.02 + 0.002 * i;
    const double x = (1 - r) * cos(a), y = (1 - r) * sin(a);
    flyers.grains.put(i, {x, y, r / cos(tilt) - x * tan(tilt)},
                      {-v * sin(a), v * cos(a), v * sin(a) * tan(tilt)});
  }
  flyers.begin({tube.get(), cap.get()});
  std::vector<double> least(n, 1e9);
  double gain = 0;
  for (int k = 0; k < 300; k++) {
    flyers.step();
    for (size_t i = 0; i < n; i++) {
      const double *v = &flyers.grains.v[3 * i], *w = &flyers.grains.omega[3 * i];
      const double energy = 0.5 * aspi_dot(v, v) + 0.2 * r * r * aspi_dot(w, w);
      least[i] = std::min(least[i], energy);
      gain = std::max(gain, energy / least[i] - 1);
    }
  }
  judge(gain < 1e-6, "grains in the groove of a tube: energy grows by %.2g", gain);
}

/* ---- what has to pass -------------------------------------------------------------------------
 */

/* A lid that goes down onto the floor, and the grain between them, which rests at the floor or is
 * stuck to it. */
void test_press(bool sticks) {
  Alone engine;
  const double v[3] = {0, 0, -1}, still[3] = {0, 0, 0};
  MeshShape *mesh = lid(3);
  const std::unique_ptr<Wall> floor = make_wall(engine, ShapePtr(new PlaneShape(2, 0, still)),
                                                sticks ? "rebound constant 0 0 deposit freeze"
                                                       : "rebound walton 0.5 0.3 0 deposit off");
  const std::unique_ptr<Wall> moves =
      make_wall(engine, ShapePtr(mesh), "rebound walton 0.5 0.3 0 deposit off", 2);
  Flyers flyers(1, 0.5, 0.01, sticks ? 0 : 1);
  flyers.grains.put(0, {0, 0, 0.55}, {0, 0, -0.1});
  Frame frame;
  Twist twist;
  aspi_copy(v, twist.linear);
  mesh->motion().settle(frame, true);
  flyers.begin({floor.get(), moves.get()});
  for (int k = 1; k <= 400; k++) {
    frame.shift[2] = v[2] * k * 0.01;
    mesh->motion().advance(frame, twist, 0.01);
    mesh->set_images(Box());
    flyers.step();
  }
  floor->end_run();
  moves->end_run();
  judge(guarded(flyers.grains) > 0 && engine.warned.find("may pass it") != std::string::npos,
        "a lid presses a grain that %s: guarded %g, at %g", sticks ? "is stuck" : "rests",
        guarded(flyers.grains), flyers.grains.x[2]);
}

} // namespace

int main() {
  for (double part : {0.001, 0.01, 0.2})
    for (double dt : {5e-4, 5e-3, 2e-2})
      for (double friction : {0., 0.01, 0.3})
        for (double turn : {0., 1.})
          for (bool is_rod : {false, true})
            test_nip(part, dt, friction, turn, is_rod);
  for (double steps : {60, 30, 12, 8, 5})
    for (int back : {0, 7})
      test_turn(1 / steps, back);
  test_groove();
  test_press(false);
  test_press(true);
  printf("%d rows fail\n", failed);
  return failed > 0;
}
