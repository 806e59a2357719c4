/* Costs of walls that no engine drives: of a grain or a body in a step, of a row of the ledger.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "alone.h"
#include "count.h"

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
const double FINE = 0.3 * R, COARSE = SIDE * GAP; /* the squares of meshes */

const char SMOOTH[] = "rebound walton 0.5 0.3 0 deposit off";
const char ROUGH[] = "surface sigma 5 rebound walton 0.5 0.3 0 deposit off";
const char STICKY[] = "rebound bons materials quartz surface_energy 1e9";

/* A mesh at z = 0 under all grains, of squares of this width with two triangles each. */
struct Plate {
  std::unique_ptr<Shape> shape;
  MeshShape *mesh;
  size_t triangles;

  explicit Plate(double width) : mesh(new MeshShape), triangles(0) {
    shape.reset(mesh);
    const double lo = -GAP, hi = SIDE * GAP;
    std::vector<ContactTriangle> all;
    std::vector<int> ids;
    for (double x = lo; x < hi; x += width)
      for (double y = lo; y < hi; y += width) {
        all.push_back({{{x, y, 0}, {x + width, y, 0}, {x + width, y + width, 0}}});
        all.push_back({{{x, y, 0}, {x + width, y + width, 0}, {x, y + width, 0}}});
        ids.push_back(static_cast<int>(triangles++));
        ids.push_back(static_cast<int>(triangles++));
      }
    mesh->set_triangles(all, ids);
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

/* Grains side by side over a wall, as an engine moves them. */
class Scene {
public:
  Scene(std::unique_ptr<Shape> shape, const char *words, const Motion &motion,
        MeshShape *mesh = NULL, size_t triangles = 0)
      : of_(std::move(shape), words, GRAINS, R, DT, triangles), mesh_(mesh), rate_(motion.rate) {
    of_.engine.least = of_.engine.most = 2 * R;
    of_.grains.spins = true;
    for (int i = 0; i < GRAINS; i++) {
      of_.grains.put(static_cast<size_t>(i),
                     {GAP * (i % SIDE), GAP * (i / SIDE), R + motion.height},
                     {motion.vx, 0, motion.vz});
      of_.grains.f[static_cast<size_t>(3 * i + 2)] = -motion.gravity;
    }
    of_.begin();
  }

  /* Counts what the wall does after the first steps. */
  void count(const char *what, int first, int steps) {
    fly(first);
    count_begin();
    fly(steps);
    count_end(what, static_cast<double>(steps) * GRAINS);
  }

private:
  void fly(int steps) {
    Grains &g = of_.grains;
    const std::vector<Stepper *> walls = g.steppers();
    for (int k = 0; k < steps; k++) {
      const double angle = rate_ * DT * static_cast<double>(++g.now);
      g.kick();
      for (size_t d = 0; d < g.x.size(); d++)
        g.x[d] += g.v[d] * DT;
      const Spheres all = g.spheres();
      count_on();
      if (mesh_ && rate_ > 0) {
        mesh_->motion().advance(turn_about(NONE, UP, angle), twist_about(NONE, UP, rate_), DT);
        mesh_->set_images(Box());
      }
      step_walls(walls, all);
      count_off();
      g.total = g.f;
      g.torque.assign(g.torque.size(), 0.);
      g.kick();
      count_on();
      end_walls(walls, g.spheres());
      count_off();
    }
  }

  GrainsAtWall of_;
  MeshShape *mesh_;
  const double rate_;
};

void count_at_plane(const char *what, const char *words, const Motion &motion, int first,
                    int steps) {
  Scene(plane(), words, motion).count(what, first, steps);
}

void count_at_mesh(const char *what, double width, const Motion &motion, int first, int steps) {
  Plate plate(width);
  Scene(std::move(plate.shape), SMOOTH, motion, plate.mesh, plate.triangles)
      .count(what, first, steps);
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
  claim_bodies(none.steppers(), bodies, MPI_COMM_WORLD);
  count_begin();
  for (int k = 1; k <= steps; k++) {
    Body &body = bodies.all[0];
    bodies.step = k;
    turn_free(body.inertia, body.angular_momentum, DT, body.axes);
    body.is_changed = false;
    count_on();
    step_walls(none.steppers(), none.spheres(), &bodies);
    end_walls(none.steppers(), none.spheres(), &bodies);
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

int main(int argc, char **argv) {
  MPI_Init(&argc, &argv);
  count_at_plane("grain at rest on a plane", SMOOTH, AT_REST, 20, 40);
  count_at_plane("grain at rest on a rough plane", ROUGH, AT_REST, 100, 40);
  count_at_mesh("grain at rest on a fine mesh", FINE, AT_REST, 20, 40);
  count_at_plane("grain stuck to a plane", STICKY, {0, 0, -0.1, GRAVITY, 0}, 20, 40);
  count_at_plane("grain far from a plane", SMOOTH, {50 * R, 1, -1, 0, 0}, 20, 200);
  count_at_plane("grain that arrives at a plane", SMOOTH, {1.5 * DT, 1, -1, 0, 0}, 1, 1);
  count_at_plane("grain that arrives at a rough plane", ROUGH, {1.5 * DT, 1, -1, 0, 0}, 1, 1);
  count_at_mesh("grain that arrives at a fine mesh", FINE, {1.5 * DT, 1, -1, 0, 0}, 1, 1);
  count_at_mesh("grain far from a mesh", COARSE, {50 * R, 1, -1, 0, 0}, 20, 200);
  count_at_mesh("grain near a mesh", COARSE, {0.5 * R, 1, 0, 0, 0}, 20, 200);
  count_at_mesh("grain near a fine mesh", FINE, {0.5 * R, 1, 0, 0, 0}, 20, 200);
  count_at_mesh("grain over a mesh that turns", COARSE, {0.5 * R, 1, 0, 0, 10}, 20, 40);
  count_at_mesh("grain at rest on a mesh that turns", COARSE, {0, 0, 0, GRAVITY, 10}, 20, 40);
  count_body("body that turns by 0.1", 0.1);
  count_body("body that turns by 3", 3);
  count_rows();
  MPI_Finalize();
  return 0;
}
