/* A wall without an engine: what an engine would tell it, and grains that fly by its steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <mpi.h>
#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "dem/shapes/mesh.h"
#include "dem/step/mover.h"

namespace asperity {

/* MPI, from before main() to its end. */
static const struct Session {
  Session() {
    MPI_Init(NULL, NULL);
  }
  ~Session() {
    MPI_Finalize();
  }
} session;

class Alone : public Engine {
public:
  explicit Alone(int dimension = 3) : least(1), most(1), kind{true, 1, 1}, dimension_(dimension) {}
  MPI_Comm world() const override {
    return MPI_COMM_WORLD;
  }
  std::string id() const override {
    return "wall";
  }
  std::string units() const override {
    return "si";
  }
  std::string known_units() const override {
    return "si";
  }
  int types() const override {
    return 1;
  }
  int dimension() const override {
    return dimension_;
  }
  double time() const override {
    return 0;
  }
  void warn(const std::string &what) const override {
    warned += what + "\n";
  }
  void print(const std::string &what) const override {
    printed += what + "\n";
  }
  const double *numbers(const std::string &) const override {
    return heats.data();
  }
  void diameters(double &smallest, double &largest) const override {
    smallest = least;
    largest = most;
  }
  std::vector<Kind> kinds() const override {
    return std::vector<Kind>(1, kind);
  }

  double least, most;        /* diameters */
  std::vector<double> heats; /* temperatures */
  Kind kind;
  mutable std::string warned, printed;

private:
  int dimension_;
};

typedef std::vector<std::unique_ptr<Shape>> Shapes;

/* Gives a mesh its triangles, numbered from 0. */
inline void set_triangles(MeshShape &mesh, const std::vector<ContactTriangle> &triangles) {
  mesh.build(MPI_COMM_WORLD, [&triangles](ContactTree *tree) {
    bool good = true;
    for (size_t k = 0; k < triangles.size(); k++)
      good = good && aspi_tree_add(tree, &triangles[k], static_cast<int>(k));
    return good;
  });
}

/* The wall that a script would describe so. triangles: of each of its meshes. */
inline std::unique_ptr<Wall> make_wall(const Engine &engine, Shapes shapes,
                                       const std::string &description, size_t triangles = 0) {
  std::unique_ptr<Wall> wall(new Wall(engine));
  const bool has_names = triangles > 0 || shapes.size() > 1; /* as meshes have */
  for (std::unique_ptr<Shape> &shape : shapes) {
    const size_t number = wall->setup.shapes.size() + 1;
    wall->add_shape(std::move(shape), 1, triangles,
                    has_names ? "mesh " + std::to_string(number) : "");
  }
  std::istringstream text(description);
  std::vector<std::string> words;
  for (std::string word; text >> word;)
    words.push_back(word);
  std::vector<const char *> each;
  for (const std::string &word : words)
    each.push_back(word.c_str());
  Words command(static_cast<int>(each.size()), each.data());
  wall->parse(command, "");
  return wall;
}

inline std::unique_ptr<Wall> make_wall(const Engine &engine, std::unique_ptr<Shape> shape,
                                       const std::string &description, size_t triangles = 0) {
  Shapes shapes;
  shapes.push_back(std::move(shape));
  return make_wall(engine, std::move(shapes), description, triangles);
}

/* Spheres of one size and mass 1, in velocity Verlet steps. */
struct Grains {
  double dt;
  int64_t now;
  bool spins;
  std::vector<double> x, v, omega, f, radius, mass;
  std::vector<double> total, torque; /* f and what walls have added to it */
  std::vector<int> mask, type, tag;
  std::vector<Wall *> walls;
  std::vector<std::vector<double>> states; /* of each wall */

  Grains(size_t n, double r, double step)
      : dt(step), now(0), spins(false), x(3 * n), v(3 * n), omega(3 * n), f(3 * n), radius(n, r),
        mass(n, 1), total(3 * n), torque(3 * n), mask(n, 1), type(n, 1), tag(n) {
    for (size_t i = 0; i < n; i++)
      tag[i] = static_cast<int>(i) + 1;
  }
  void put(size_t i, const double (&at)[3], const double (&speed)[3]) {
    std::copy(at, at + 3, &x[3 * i]);
    std::copy(speed, speed + 3, &v[3 * i]);
  }
  Spheres spheres() {
    return Spheres{now,
                   dt,
                   static_cast<int>(tag.size()),
                   mask.data(),
                   type.data(),
                   tag.data(),
                   4,
                   x.data(),
                   v.data(),
                   spins ? omega.data() : NULL,
                   total.data(),
                   spins ? torque.data() : NULL,
                   radius.data(),
                   mass.data()};
  }
  void begin(const std::vector<Wall *> &all) {
    walls = all;
    total = f;
    states.resize(walls.size());
    for (size_t w = 0; w < walls.size(); w++) {
      states[w].resize(tag.size() * Wall::N_STATE);
      walls[w]->rows.grow(static_cast<int>(tag.size()));
      walls[w]->init(now, dt);
      walls[w]->set_rows(states[w].data());
      walls[w]->begin_run(spheres(), 1, Box());
    }
  }
  void kick() {
    for (size_t k = 0; k < v.size(); k++) {
      v[k] += 0.5 * dt * total[k] / mass[k / 3];
      if (spins)
        omega[k] += 0.5 * dt * torque[k] / (0.4 * mass[k / 3] * radius[k / 3] * radius[k / 3]);
    }
  }
  /* The first part of a step, up to the new forces, and the second one. */
  void advance() {
    now++;
    kick();
    for (size_t k = 0; k < x.size(); k++)
      x[k] += v[k] * dt;
    step_walls(walls, spheres());
  }
  void finish() {
    total = f;
    torque.assign(torque.size(), 0.);
    kick();
    end_walls(walls, spheres());
    for (Wall *wall : walls)
      wall->books.end_loads();
  }
  void fly(int steps) {
    for (int k = 0; k < steps; k++) {
      advance();
      finish();
    }
  }
};

/* Grains at a wall of one shape. */
struct GrainsAtWall {
  Alone engine;
  std::unique_ptr<Wall> wall;
  Grains grains;

  GrainsAtWall(std::unique_ptr<Shape> shape, const std::string &description, size_t n, double r,
               double dt, size_t triangles = 0)
      : wall(make_wall(engine, std::move(shape), description, triangles)), grains(n, r, dt) {}
  void begin() {
    grains.begin({wall.get()});
  }
  double count(int k) const {
    return wall->books.counter(k);
  }
};

} // namespace asperity
