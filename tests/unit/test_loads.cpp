/* What walls take is what movers lose: in each step the impulse and the angular impulse of all
 * walls are the change of a mover's momenta less what forces gave, whatever the mover does there
 * and however the run is cut; and the columns of grains sum up to the totals. A wall that holds a
 * mover counts the kick from the middle of a step to that of the next.
 * test_loads [NAME]: that row alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "alone.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "contact/vector.h"
#include "dem/shapes/mesh.h"
#include "dem/shapes/primitive.h"

using namespace asperity;

namespace {

const double STILL[3] = {0, 0, 0}, R = 0.5;

typedef std::unique_ptr<Shape> ShapePtr;

ShapePtr plane(int axis, double at) {
  return ShapePtr(new PlaneShape(axis, at, STILL));
}

/* A large square through a point, with this normal. */
MeshShape *square(const double (&at)[3], const double (&normal)[3]) {
  double n[3], a[3], b[3];
  aspi_copy(normal, n);
  aspi_scale(1 / aspi_length(n), n);
  const double other[3] = {n[1], n[2], n[0] + 0.1};
  aspi_cross(n, other, a);
  aspi_scale(50 / aspi_length(a), a);
  aspi_cross(n, a, b);
  std::vector<ContactTriangle> both(2);
  for (int t = 0; t < 2; t++)
    for (int c = 0; c < 3; c++) {
      const int corner = (c + 2 * t) % 4;
      for (int d = 0; d < 3; d++)
        both[t].node[c][d] = at[d] + (corner % 3 ? a[d] : -a[d]) + (corner > 1 ? b[d] : -b[d]);
    }
  MeshShape *mesh = new MeshShape;
  set_triangles(*mesh, both);
  mesh->set_images(Box());
  return mesh;
}

/* When the run is cut, what becomes of the forces of its set-up: those of fixes behind the wall
 * come after it, a fix may set all of them anew, or the script has changed them. */
enum Cut { WHOLE, BEFORE, BEHIND, REPLACED, CHANGED };

struct Start {
  double x[3], v[3], spin[3], force[3]; /* per mass */
};

struct Row {
  const char *name, *words;
  const Start &at;
  int steps, spheres; /* 0: a grain; else a rod along x */
  void (*walls)(std::vector<ShapePtr> &);
  void (*move)(double, Frame &, Twist &); /* of the last wall, a mesh */
  Cut cut;
  double changes; /* part by which the force goes up and down */
  double turns;   /* most error of the angular impulse */
};

const double DT = 0.01;

class Scene {
public:
  explicit Scene(const Row &row)
      : row_(row), grains_(row.spheres ? 0 : 1, R, DT), mesh_(NULL), mass_(1), ahead_() {
    std::vector<ShapePtr> shapes;
    row.walls(shapes);
    if (row.move)
      mesh_ = static_cast<MeshShape *>(shapes.back().get());
    engine_.least = engine_.most = 2 * R;
    for (ShapePtr &shape : shapes) {
      const bool has_pieces = dynamic_cast<MeshShape *>(shape.get());
      owned_.push_back(make_wall(engine_, std::move(shape), row.words, has_pieces ? 2 : 0));
      walls_.push_back(owned_.back().get());
    }
    grains_.spins = true;
    move(true);
    if (row.spheres)
      make_body();
    else {
      grains_.put(0, row.at.x, row.at.v);
      std::copy(row.at.spin, row.at.spin + 3, grains_.omega.begin());
    }
    set_forces();
    grains_.begin(walls_);
    bodies_.step = 1;
    claim_bodies(grains_.walls, bodies_, MPI_COMM_WORLD);
    measure(ahead_);
  }

  /* Worst differences in this step: of the impulse, the angular impulse, and the columns, as parts
   * of what the mover has. */
  void step(double worst[3]) {
    double before[6], booked[6], given[6], x[3];
    std::copy(ahead_, ahead_ + 6, before);
    if (row_.cut != WHOLE && grains_.now % 3 == 2)
      resume();
    add_forces(before, 0.5);
    grains_.now++;
    bodies_.step = grains_.now;
    move(false);
    kick();
    for (size_t k = 0; k < grains_.x.size(); k++)
      grains_.x[k] += grains_.v[k] * DT;
    for (Body &body : bodies_.all) {
      advance(body, DT);
      body.is_changed = false;
    }
    total(-1, booked);
    step_walls(grains_.walls, grains_.spheres(), &bodies_);
    set_forces();
    kick();
    const double scale = DT / (aspi_length(before) + DT * aspi_length(row_.at.force));
    worst[2] = std::max(worst[2], scale * columns_off()); /* a fix before the walls sees these */
    end_walls(grains_.walls, grains_.spheres(), &bodies_);
    for (Wall *wall : walls_)
      wall->books.end_loads();
    worst[2] = std::max(worst[2], scale * columns_off());
    double now[6];
    total(1, booked);
    add_forces(before, 0.5);
    measure(ahead_);
    std::copy(ahead_, ahead_ + 6, now);
    aspi_copy(grains_.x.empty() ? bodies_.all[0].x : grains_.x.data(), x);
    const double speed =
        aspi_length(now) + aspi_length(before) + DT * mass_ * aspi_length(row_.at.force);
    for (int k = 0; k < 6; k++) {
      given[k] = booked[k] + now[k] - before[k];
      const double most = k < 3 ? speed : speed * (R + aspi_length(x));
      worst[k / 3] = std::max(worst[k / 3], fabs(given[k]) / most);
    }
  }

  /* By how much the columns of the grain and the total forces differ. */
  double columns_off() const {
    double most = 0;
    for (size_t w = 0; w < walls_.size() && !row_.spheres; w++)
      for (size_t d = 0; d < 3; d++)
        most = std::max(most, fabs(walls_[w]->books.counter(Books::FORCE + static_cast<int>(d)) -
                                   grains_.states[w][2 + d]));
    return most;
  }

  double height() const { /* of the grain, over the floor that it touches */
    return row_.spheres ? 0 : grains_.x[2] - R;
  }

private:
  void make_body() {
    Body body = Body();
    body.count = static_cast<size_t>(row_.spheres);
    body.mass = mass_ = row_.spheres;
    for (int k = 0; k < row_.spheres; k++) {
      const double a = R * (2 * k - row_.spheres + 1);
      bodies_.spheres.push_back(BodySphere{{a, 0, 0}, R, 1, 1, k + 1});
      body.inertia[0] += 0.4 * R * R;
      body.inertia[1] += 0.4 * R * R + a * a;
      body.inertia[2] += 0.4 * R * R + a * a;
    }
    for (int k = 0; k < 3; k++) {
      body.axes[k][k] = 1;
      body.angular_momentum[k] = body.inertia[k] * row_.at.spin[k];
    }
    aspi_copy(row_.at.x, body.x);
    aspi_copy(row_.at.v, body.v);
    bodies_.all.push_back(body);
    bodies_.dt = DT;
  }

  void move(bool first) {
    if (!mesh_)
      return;
    Frame frame;
    Twist twist;
    row_.move(static_cast<double>(grains_.now) * DT, frame, twist);
    if (first) {
      mesh_->motion().settle(frame, false);
      mesh_->motion().set_last(twist);
    } else
      mesh_->motion().advance(frame, twist, DT);
    mesh_->set_images(Box());
  }

  /* Those of now, times a factor; zero: the engine has not added them yet. */
  void set_forces(double factor = 1, bool zero = false) {
    const double part = 1 + row_.changes * sin(0.7 * static_cast<double>(grains_.now));
    for (int d = 0; d < 3; d++)
      acts_[d] = factor * part * row_.at.force[d];
    for (size_t k = 0; k < grains_.f.size(); k++)
      grains_.f[k] = acts_[k];
    grains_.total = grains_.f;
    if (zero)
      grains_.total.assign(grains_.total.size(), 0.);
    grains_.torque.assign(grains_.torque.size(), 0.);
    for (Body &body : bodies_.all) {
      aspi_copy(acts_, body.acceleration);
      aspi_copy(STILL, body.torque);
    }
  }

  void kick() {
    grains_.kick();
    for (Body &body : bodies_.all) {
      aspi_add_scaled(body.v, 0.5 * DT, body.acceleration, body.v);
      aspi_add_scaled(body.angular_momentum, 0.5 * DT, body.torque, body.angular_momentum);
    }
  }

  /* The set-up of another run. */
  void resume() {
    set_forces(row_.cut == CHANGED ? 0.4 : 1, row_.cut == BEHIND);
    for (Wall *wall : walls_)
      wall->begin_run(grains_.spheres(), 1, Box());
    bodies_.begins = true;
    bodies_.step = grains_.now + 1;
    claim_bodies(grains_.walls, bodies_, MPI_COMM_WORLD);
    push_again(grains_.walls, grains_.spheres());
    push_again(grains_.walls, bodies_);
    for (size_t k = 0; k < grains_.f.size() && row_.cut == BEHIND; k++)
      grains_.total[k] += grains_.f[k];
    if (row_.cut == REPLACED)
      set_forces();
  }

  /* Momenta with what the walls have in store for the next half kick. */
  void measure(double of[6]) const {
    double turn[3], v[3], spin[3], x[3];
    if (!row_.spheres) {
      aspi_copy(grains_.x.data(), x);
      aspi_copy(grains_.v.data(), v);
      aspi_copy(grains_.omega.data(), spin);
      aspi_scale(0.4 * R * R, spin);
      aspi_add_scaled(spin, 0.5 * DT, grains_.torque.data(), spin);
      for (int d = 0; d < 3; d++)
        v[d] += 0.5 * DT * (grains_.total[d] - grains_.f[d]);
    } else {
      const Body &body = bodies_.all[0];
      aspi_copy(body.x, x);
      aspi_copy(body.v, v);
      aspi_copy(body.angular_momentum, spin);
      aspi_add_scaled(spin, 0.5 * DT, body.torque, spin);
      for (int d = 0; d < 3; d++)
        v[d] += 0.5 * DT * (body.acceleration[d] - acts_[d]);
      aspi_scale(body.mass, v);
    }
    aspi_cross(x, v, turn);
    for (int d = 0; d < 3; d++) {
      of[d] = v[d];
      of[3 + d] = spin[d] + turn[d];
    }
  }

  /* What the forces of now give in a part of the step. */
  void add_forces(double to[6], double share) const {
    const double *x = row_.spheres ? bodies_.all[0].x : grains_.x.data();
    double p[3], turn[3];
    aspi_copy(acts_, p);
    aspi_scale(share * DT * mass_, p);
    aspi_cross(x, p, turn);
    aspi_add_scaled(to, 1, p, to);
    aspi_add_scaled(to + 3, 1, turn, to + 3);
  }

  void total(int sign, double of[6]) const {
    for (int k = 0; k < 6; k++) {
      of[k] = sign < 0 ? 0 : of[k];
      for (const Wall *wall : walls_)
        of[k] += sign * wall->books.counter(Books::IMPULSE + k);
    }
  }

  const Row &row_;
  Alone engine_;
  std::vector<std::unique_ptr<Wall>> owned_;
  std::vector<Wall *> walls_;
  Grains grains_;
  Bodies bodies_;
  MeshShape *mesh_;
  double mass_, ahead_[6], acts_[3];
};

/* ---- the table --------------------------------------------------------------------------------
 */

void floor_of(std::vector<ShapePtr> &to) {
  to.push_back(plane(2, 0));
}
void corner_of(std::vector<ShapePtr> &to) {
  floor_of(to);
  to.push_back(plane(0, -3));
}
void tilted_corner(std::vector<ShapePtr> &to) {
  to.push_back(ShapePtr(square({0, 0, 0}, {0.1, 0.05, 1})));
  to.push_back(ShapePtr(square({2, 0, 0}, {-1, 0.3, 0.4})));
}
void drum_of(std::vector<ShapePtr> &to) {
  to.push_back(ShapePtr(new CylinderShape(1, STILL, 4, 0, 0.5)));
}
void shaken_floor(std::vector<ShapePtr> &to) {
  to.push_back(ShapePtr(square({0, 0, 0}, {0, 0, 1})));
}
void pressing_plate(std::vector<ShapePtr> &to) {
  floor_of(to);
  to.push_back(ShapePtr(square({1.4, 0, 0}, {-1, 0, 0.1})));
}
void closing_plate(std::vector<ShapePtr> &to) {
  floor_of(to);
  to.push_back(ShapePtr(square({0, 0, 1.02}, {0, 0, -1})));
}
void shakes(double t, Frame &frame, Twist &twist) {
  frame.shift[2] = 0.02 * (1 - cos(30 * t));
  twist.linear[2] = 0.6 * sin(30 * t);
}
void presses(double t, Frame &frame, Twist &twist) {
  frame.shift[0] = -0.7 * t;
  twist.linear[0] = -0.7;
}
void closes(double t, Frame &frame, Twist &twist) {
  frame.shift[2] = -0.1 * t;
  twist.linear[2] = -0.1;
}

#define SMOOTH "rebound walton 0.5 0.3 0 deposit off"
#define ROUGH SMOOTH " surface rq 0.02 lambda_c 0.5"
#define STICKY "rebound constant 0 0 deposit freeze"
#define FLOW "materials quartz deposit freeze remove u_tau 100 gas_density 1.2 gas_viscosity 1.5e-5"

const double G = -9.81;

/* Steps are of the second order: a path under a force turns about a far point by dt^2 more or less
 * than the velocities of its two halves. Else, and at rest, angular impulses are exact. */
const double EXACT = 1e-12, PATH = 1e-4, JUMP = 1e-3;

const Start SLIDING = {{0, 0, R}, {0.3, 0, 0}, {0, 0, 1}, {1, 0, G}};
const Start LYING = {{0, 0, R}, {0, 0.2, 0}, {0, 0, 0.1}, {0, 0, G}};
const Start FALLING = {{0, 0, 1}, {2, 0, -5}, {0, 3, 1}, {0, 0, G}};
const Start FREE = {{0, 0, 1}, {2, 0, -5}, {0, 3, 1}, {0, 0, 0}};
const Start TO_SIDE = {{0, 0, R}, {-4, 1, 0}, {0, 0, 0}, {-1, 0, G}};
const Start TO_CORNER = {{0, 0, 0.9}, {3, 1, 0}, {0, 0, 0}, {2, 0, G}};
const Start IN_DRUM = {{0, 0, -3.4}, {1, 0.2, 0}, {0, 0, 0}, {0, 0, G}};
const Start LANDING = {{0, 0, 0.6}, {0.3, 0.2, -1}, {1, 0, 0}, {0.4, 0, G}};
const Start SETTLING = {{0, 0, R + 3e-4}, {0.3, 0.2, -0.1}, {1, 0, 0}, {0.4, 0, G}};
const Start ROD = {{0, 0, 1}, {-4, 1, 0}, {0, 1, 0}, {-1, 0, G}};
const Start ROD_LIES = {{0, 0, R}, {0, 0, 0}, {0, 0, 0}, {-1, 0, G}};

const Row ROWS[] = {
    {"rest", SMOOTH, SLIDING, 40, 0, floor_of, NULL, WHOLE, 0, EXACT},
    {"impacts", SMOOTH, FALLING, 100, 0, floor_of, NULL, WHOLE, 0, PATH},
    {"free impacts", SMOOTH, FREE, 100, 0, corner_of, NULL, WHOLE, 0, EXACT},
    {"a force that changes", SMOOTH, SLIDING, 100, 0, floor_of, NULL, WHOLE, 1.3, PATH},
    {"rest and impact", SMOOTH, TO_SIDE, 150, 0, corner_of, NULL, WHOLE, 0, PATH},
    {"rough", ROUGH, TO_SIDE, 300, 0, corner_of, NULL, WHOLE, 0, PATH},
    {"corner", SMOOTH, TO_CORNER, 200, 0, tilted_corner, NULL, WHOLE, 0, PATH},
    {"rough corner", ROUGH, TO_CORNER, 200, 0, tilted_corner, NULL, WHOLE, 0, PATH},
    {"drum", SMOOTH, IN_DRUM, 300, 0, drum_of, NULL, WHOLE, 0, PATH},
    {"shaken", SMOOTH, LANDING, 200, 0, shaken_floor, shakes, WHOLE, 0, PATH},
    {"plate", SMOOTH, LYING, 200, 0, pressing_plate, presses, WHOLE, 0, PATH},
    {"rough plate", ROUGH, LYING, 200, 0, pressing_plate, presses, WHOLE, 0, PATH},
    {"closing walls", SMOOTH, SLIDING, 80, 0, closing_plate, closes, WHOLE, 0, JUMP},
    {"stuck", STICKY, LANDING, 50, 0, floor_of, NULL, WHOLE, 1.3, EXACT},
    {"stuck and kept", STICKY, LANDING, 50, 0, floor_of, NULL, WHOLE, 0, EXACT},
    {"stuck and moved", STICKY, LANDING, 50, 0, shaken_floor, shakes, WHOLE, 0, EXACT},
    {"removed", FLOW, SETTLING, 200, 0, floor_of, NULL, WHOLE, 0, EXACT},
    {"force before", SMOOTH, SLIDING, 60, 0, floor_of, NULL, BEFORE, 0, EXACT},
    {"force behind", SMOOTH, SLIDING, 60, 0, floor_of, NULL, BEHIND, 0, EXACT},
    {"force set anew", SMOOTH, SLIDING, 60, 0, floor_of, NULL, REPLACED, 0, EXACT},
    {"force of a script", SMOOTH, SLIDING, 60, 0, floor_of, NULL, CHANGED, 0, EXACT},
    {"corner, force behind", SMOOTH, TO_SIDE, 150, 0, corner_of, NULL, BEHIND, 0, PATH},
    {"corner, of a script", SMOOTH, TO_SIDE, 150, 0, corner_of, NULL, CHANGED, 0.1, PATH},
    {"ball", SMOOTH, TO_SIDE, 150, 1, corner_of, NULL, WHOLE, 0, PATH},
    {"rod", SMOOTH, ROD, 200, 3, corner_of, NULL, WHOLE, 0, PATH},
    {"rod at rest", SMOOTH, ROD_LIES, 50, 3, floor_of, NULL, WHOLE, 0, EXACT},
    {"rod in pieces", SMOOTH, ROD_LIES, 50, 3, floor_of, NULL, BEFORE, 0, EXACT},
    {"rod, of a script", SMOOTH, ROD_LIES, 50, 3, floor_of, NULL, CHANGED, 0, EXACT},
    {"rod at a plate", SMOOTH, LYING, 200, 2, pressing_plate, presses, WHOLE, 0, PATH},
    {"rough rod", ROUGH, ROD, 200, 3, corner_of, NULL, WHOLE, 0, PATH},
    {"stuck rod", STICKY, ROD, 100, 3, corner_of, NULL, WHOLE, 0, PATH},
};

} // namespace

int main(int argc, char **argv) {
  int failed = 0;
  double all[3] = {0, 0, 0};
  for (const Row &row : ROWS) {
    if (argc > 1 && strcmp(argv[1], row.name) != 0)
      continue;
    Scene scene(row);
    double worst[3] = {0, 0, 0}, deep = 0;
    for (int k = 0; k < row.steps; k++) {
      scene.step(worst);
      if (!row.spheres && row.walls == floor_of)
        deep = std::max(deep, -scene.height());
    }
    for (int k = 0; k < 3; k++)
      all[k] = std::max(all[k], k == 1 && row.turns > EXACT ? 0 : worst[k]);
    if (worst[0] < EXACT && worst[1] < row.turns && worst[2] < EXACT && deep < 1e-9 * R)
      continue;
    printf("FAIL %-22s impulse off by %.1e, angular %.1e, columns %.1e; %.1e deep in the floor\n",
           row.name, worst[0], worst[1], worst[2], deep);
    failed++;
  }
  printf("%d rows fail; at most off by: impulse %.1e, angular %.1e, columns %.1e\n", failed, all[0],
         all[1], all[2]);
  return failed > 0;
}
