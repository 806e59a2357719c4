/* Costs of walls that no engine drives: of a grain or a body in a step, of a row of the ledger.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "alone.h"
#include "count.h"
#include "jet.h"

#include <math.h>
#include <unistd.h>

#include "contact/vector.h"
#include "dem/shapes/mesh.h"
#include "dem/shapes/primitive.h"

using namespace asperity;

namespace {

const double R = 1e-3, DT = 1e-5, GRAVITY = 9.81;
const double NONE[3] = {0, 0, 0}, UP[3] = {0, 0, 1};
const int SIDE = 10, GRAINS = SIDE * SIDE;
const double GAP = 4 * R;                         /* between grains */
const double SWING = 0.01, DRAG = 20;             /* an angle, and a rate */
const double FINE = 0.3 * R, COARSE = SIDE * GAP; /* the squares of meshes */

const char SMOOTH[] = "rebound walton 0.5 0.3 0 deposit off";
const char ROUGH[] = "surface sigma 5 rebound walton 0.5 0.3 0 deposit off";
const char STICKY[] = "rebound bons materials quartz surface_energy 1e9";

/* A mesh that counts how often it is searched: for how long a course is clear, and for a contact,
 * and how many it finds. */
class CountedMesh : public MeshShape {
public:
  double clear(const Course &course, const FaceList &stays) const override {
    clears++;
    return MeshShape::clear(course, stays);
  }
  bool find(const Path &path, double radius, double latest, Contact &contact) const override {
    const bool is_there = MeshShape::find(path, radius, latest, contact);
    finds++;
    found += is_there;
    return is_there;
  }
  mutable int clears = 0, finds = 0, found = 0;
};

/* A mesh at z = 0 from lo to hi, of squares of this width with two triangles each. */
struct Plate {
  std::unique_ptr<Shape> shape;
  CountedMesh *mesh;
  size_t triangles;

  explicit Plate(double width, double lo = -GAP, double hi = SIDE * GAP)
      : mesh(new CountedMesh), triangles(0) {
    shape.reset(mesh);
    std::vector<ContactTriangle> all;
    for (double x = lo; x < hi; x += width)
      for (double y = lo; y < hi; y += width) {
        all.push_back({{{x, y, 0}, {x + width, y, 0}, {x + width, y + width, 0}}});
        all.push_back({{{x, y, 0}, {x + width, y + width, 0}, {x, y + width, 0}}});
      }
    triangles = all.size();
    set_triangles(*mesh, all);
    mesh->set_images(Box());
  }
};

/* A closed box with two triangles on each side. */
struct Box12 {
  std::unique_ptr<Shape> shape;
  CountedMesh *mesh;
  size_t triangles;

  explicit Box12(double side) : mesh(new CountedMesh), triangles(12) {
    shape.reset(mesh);
    std::vector<ContactTriangle> all;
    for (int d = 0; d < 3; d++)
      for (int end = 0; end < 2; end++)
        for (int half = 1; half < 3; half++) {
          ContactTriangle one;
          const int corner[3] = {0, half, 3};
          for (int k = 0; k < 3; k++) {
            one.node[k][d] = end * side;
            one.node[k][(d + 1) % 3] = corner[k] % 2 * side;
            one.node[k][(d + 2) % 3] = corner[k] / 2 * side;
          }
          all.push_back(one);
        }
    set_triangles(*mesh, all);
    mesh->set_images(Box());
  }
};

std::unique_ptr<Shape> plane(double at = 0) {
  return std::unique_ptr<Shape>(new PlaneShape(2, at, NONE));
}

/* What the grains of a scene begin with, and how its mesh turns about z. */
struct Motion {
  double height, vx, vz, gravity, rate;
};
const Motion AT_REST = {0, 0, 0, GRAVITY, 0};

/* Grains over a wall, as an engine moves them. */
class Scene {
public:
  /* Side by side. */
  Scene(std::unique_ptr<Shape> shape, const char *words, const Motion &motion,
        CountedMesh *mesh = NULL, size_t triangles = 0, double least = R)
      : of_(std::move(shape), words, GRAINS, R, DT, triangles), mesh_(mesh), rate_(motion.rate) {
    of_.engine.least = 2 * least;
    of_.engine.most = 2 * R;
    of_.grains.spins = true;
    of_.grains.radius[0] = least;
    for (int i = 0; i < GRAINS; i++) {
      of_.grains.put(static_cast<size_t>(i),
                     {GAP * (i % SIDE), GAP * (i / SIDE), R + motion.height},
                     {motion.vx, 0, motion.vz});
      of_.grains.f[static_cast<size_t>(3 * i + 2)] = -motion.gravity;
    }
    of_.begin();
  }

  /* The jet. */
  Scene(std::unique_ptr<Shape> shape, const std::vector<JetGrain> &jet, CountedMesh *mesh,
        size_t triangles)
      : of_(std::move(shape), JET_LAW, jet.size(), 1, JET_DT, triangles), mesh_(mesh), rate_(0) {
    of_.engine.least = 1e-6;
    of_.engine.most = 1e-4;
    of_.grains.spins = true;
    for (size_t i = 0; i < jet.size(); i++) {
      of_.grains.put(i, jet[i].x, jet[i].v);
      of_.grains.radius[i] = jet[i].radius;
      of_.grains.mass[i] = jet[i].mass;
    }
    of_.begin();
  }

  /* Grains that do not meet each other, in a box of this side; `push` times their weight acts on
   * them, now so and now so, as if others did. The box turns to and fro. */
  Scene(Box12 box, double side, double push, double rate)
      : of_(std::move(box.shape), SMOOTH, GRAINS, R, DT, box.triangles), mesh_(box.mesh),
        rate_(rate), push_(push) {
    of_.engine.least = of_.engine.most = 2 * R;
    of_.grains.spins = true;
    for (int i = 0; i < GRAINS; i++)
      of_.grains.put(static_cast<size_t>(i),
                     {draw(R, side - R), draw(R, side - R), draw(R, side - R)}, {0, 0, 0});
    of_.begin();
  }

  /* Counts what the wall does after the first steps, and how often its mesh is searched. */
  void count(const char *what, int first, int steps) {
    const double all = static_cast<double>(steps) * static_cast<double>(of_.grains.tag.size());
    const bool moves = rate_ > 0 || push_ > 0;
    fly(first);
    if (mesh_)
      mesh_->clears = mesh_->finds = mesh_->found = 0;
    count_begin();
    fly(steps);
    count_end(what, all);
    if (!mesh_ || !(moves || mesh_->clears + mesh_->finds > 0))
      return;
    count_other(what, "courses", 1e6 * mesh_->clears / all);
    count_other(what, "searches", 1e6 * mesh_->finds / all);
    count_other(what, "found", 1e6 * mesh_->found / all);
  }

private:
  void fly(int steps) {
    Grains &g = of_.grains;
    const std::vector<Wall *> walls = g.walls;
    for (int k = 0; k < steps; k++) {
      const double phase = rate_ * g.dt * static_cast<double>(++g.now);
      const double angle = push_ > 0 ? SWING * sin(phase) : phase;
      const double speed = push_ > 0 ? SWING * rate_ * cos(phase) : rate_;
      g.kick();
      for (size_t d = 0; d < g.x.size(); d++)
        g.x[d] += g.v[d] * g.dt;
      const Spheres all = g.spheres();
      count_on();
      if (mesh_ && rate_ > 0) {
        mesh_->motion().advance(turn_about(NONE, UP, angle), twist_about(NONE, UP, speed), g.dt);
        mesh_->set_images(Box());
      }
      step_walls(walls, all);
      count_off();
      if (push_ > 0)
        push();
      g.total = g.f;
      g.torque.assign(g.torque.size(), 0.);
      g.kick();
      count_on();
      end_walls(walls, g.spheres());
      count_off();
    }
  }

  double draw(double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(numbers_()) / 2147483647.;
  }
  void push() {
    Grains &g = of_.grains;
    for (size_t d = 0; d < g.f.size(); d++)
      g.f[d] = GRAVITY * (push_ * draw(-1, 1) - (d % 3 == 2)) - DRAG * g.v[d];
  }

  GrainsAtWall of_;
  CountedMesh *mesh_;
  const double rate_;
  const double push_ = 0;
  std::minstd_rand0 numbers_;
};

void count_at_plane(const char *what, const char *words, const Motion &motion, int first,
                    int steps) {
  Scene(plane(), words, motion).count(what, first, steps);
}

/* The smallest of the grains is a hundred times smaller than the others. */
void count_beside_dust(const char *what, const Motion &motion) {
  Scene(plane(), SMOOTH, motion, NULL, 0, 0.01 * R).count(what, 20, 400);
}

void count_at_mesh(const char *what, double width, const Motion &motion, int first, int steps,
                   const char *words = SMOOTH) {
  Plate plate(width);
  Scene(std::move(plate.shape), words, motion, plate.mesh, plate.triangles)
      .count(what, first, steps);
}

/* From the first step on, which is a grain's whole life: flight, impact, flight, or rest. */
void count_jet_at(const char *what, std::unique_ptr<Shape> shape, CountedMesh *mesh = NULL,
                  size_t triangles = 0) {
  Scene(std::move(shape), jet_grains(), mesh, triangles).count(what, 0, JET_STEPS);
}

void count_jet_at_mesh(const char *what, double width) {
  Plate plate(width, JET_LO, JET_HI);
  count_jet_at(what, std::move(plate.shape), plate.mesh, plate.triangles);
}

void count_pushed(const char *what, double rate) {
  const double side = 6 * R, push = 5;
  Scene(Box12(side), side, push, rate).count(what, 2000, 2000);
}

/* A rod of two spheres that turns in front of a plane, by this angle a step, without touching it.
 */
void count_body(const char *what, double turn) {
  const int steps = 100;
  const double mass = 1e-5, side = mass * (0.4 + 1) * R * R;
  Alone engine;
  engine.least = engine.most = 2 * R;
  std::unique_ptr<Wall> wall = make_wall(engine, plane(-1.2 * R), SMOOTH);
  Grains none(0, R, DT);
  none.begin({wall.get()});
  Bodies bodies;
  bodies.dt = DT;
  bodies.spheres = {BodySphere{{-R, 0, 0}, R, 1, 1, 1}, BodySphere{{R, 0, 0}, R, 1, 1, 2}};
  Body rod = Body();
  rod.count = 2;
  rod.mass = mass;
  rod.inertia[0] = 0.4 * mass * R * R;
  rod.inertia[1] = rod.inertia[2] = side;
  for (int d = 0; d < 3; d++)
    rod.axes[d][d] = 1;
  rod.angular_momentum[2] = side * turn / DT;
  bodies.all.push_back(rod);
  claim_bodies(none.walls, bodies, MPI_COMM_WORLD);
  count_begin();
  for (int k = 1; k <= steps; k++) {
    Body &body = bodies.all[0];
    bodies.step = k;
    turn_free(body.inertia, body.angular_momentum, DT, body.axes);
    body.is_changed = false;
    count_on();
    step_walls(none.walls, none.spheres(), &bodies);
    end_walls(none.walls, none.spheres(), &bodies);
    count_off();
    bodies.begins = false;
  }
  count_end(what, steps);
}

void count_rows() {
  const int rows = 1000;
  const char path[] = "cost_rows.csv";
  unlink(path);
  Ledger ledger(MPI_COMM_WORLD, 1, path, Ledger::STOP, Ledger::N_COLUMNS);
  ledger.open("heading");
  count_begin();
  count_on();
  for (int i = 0; i < rows; i++) {
    LedgerRow row;
    for (int k = 0; k < Ledger::N_FIELDS; k++)
      row[static_cast<size_t>(k)] = i + k / 7.;
    row[Ledger::STEP] = 1;
    ledger.add_row(row);
  }
  ledger.end_step(1);
  count_off();
  count_end("ledger, a row", rows);
  unlink(path);
}

} // namespace

int main() {
  count_at_plane("grain at rest on a plane", SMOOTH, AT_REST, 20, 40);
  count_at_plane("grain at rest on a rough plane", ROUGH, AT_REST, 100, 40);
  count_at_mesh("grain at rest on a fine mesh", FINE, AT_REST, 20, 40);
  count_at_plane("grain stuck to a plane", STICKY, {0, 0, -0.1, GRAVITY, 0}, 20, 40);
  count_at_mesh("grain stuck to a mesh", COARSE, {0, 0, -0.1, GRAVITY, 0}, 20, 40, STICKY);
  count_at_plane("grain far from a plane", SMOOTH, {50 * R, 1, -1, 0, 0}, 20, 200);
  count_at_plane("grain that arrives at a plane", SMOOTH, {1.5 * DT, 1, -1, 0, 0}, 1, 1);
  count_at_plane("grain that arrives at a rough plane", ROUGH, {1.5 * DT, 1, -1, 0, 0}, 1, 1);
  count_at_mesh("grain that arrives at a fine mesh", FINE, {1.5 * DT, 1, -1, 0, 0}, 1, 1);
  count_at_mesh("grain far from a mesh", COARSE, {50 * R, 1, -1, 0, 0}, 20, 200);
  count_at_mesh("grain near a mesh", COARSE, {0.5 * R, 1, 0, 0, 0}, 20, 200);
  count_at_mesh("grain near a fine mesh", FINE, {0.5 * R, 1, 0, 0, 0}, 20, 200);
  count_at_mesh("grain over a mesh that turns", COARSE, {0.5 * R, 1, 0, 0, 10}, 20, 40);
  count_at_mesh("grain at rest on a mesh that turns", COARSE, {0, 0, 0, GRAVITY, 10}, 20, 40);
  count_jet_at("grain of a jet at a plane", plane());
  count_jet_at_mesh("grain of a jet at a mesh", 3e-3);
  count_jet_at_mesh("grain of a jet at a fine mesh", 0.268e-3);
  count_beside_dust("grain that falls beside one of dust", {50 * R, 1, 0, GRAVITY, 0});
  count_pushed("grain that is pushed about in a box", 0);
  count_pushed("grain that is pushed about in a box that turns to and fro", 60);
  count_body("body that turns by 0.1", 0.1);
  count_body("body that turns by 3", 3);
  count_rows();
  return 0;
}
